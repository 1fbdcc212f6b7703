  frobnicate r1
