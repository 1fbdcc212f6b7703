int doubled(int Number) { return 2 * Number; }
