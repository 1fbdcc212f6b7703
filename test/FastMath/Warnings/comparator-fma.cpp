// Contraction: what may be fused depends on the options, on the processor and
// on who chooses what to fuse.

// Stock clang fuses within a statement by default, where it can.
// DEFINE: %{stock} = clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// DEFINE:   -fsyntax-only
// RUN: %{stock} --target=x86_64-linux-gnu -mfma -Xclang -verify=within %s
// RUN: %{stock} --target=aarch64-linux-gnu -Xclang -verify=within %s
// RUN: %{stock} --target=riscv64-linux-gnu -Xclang -verify=within %s
// RUN: %{stock} --target=x86_64-linux-gnu -mfma -ffp-contract=fast \
// RUN:   -Xclang -verify=within,across %s
// RUN: %{stock} --target=x86_64-linux-gnu -mfma -ffp-contract=off \
// RUN:   -Xclang -verify=silent %s
// RUN: %{stock} --target=x86_64-linux-gnu -Xclang -verify=silent %s
// RUN: %{stock} --target=riscv64-linux-gnu -march=rv64imac \
// RUN:   -Xclang -verify=silent %s

// The canonicalizer never fuses one of two products that are subtracted.
// RUN: tpcc -mfma -ffp-contract=on -fsyntax-only -Xclang -verify=canonical %s
// RUN: tpcc -mfma -ffp-contract=on -mllvm -tp-fp-canonicalize=0 \
// RUN:   -fsyntax-only -Xclang -verify=within %s
// RUN: tpcc -mno-fma -ffp-contract=on -mllvm -tp-fp-canonicalize=0 \
// RUN:   -fsyntax-only -Xclang -verify=silent %s
// RUN: %{stock} --target=x86_64-linux-gnu -mfma \
// RUN:   -fpass-plugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -Xclang -verify=canonical %s
// silent-no-diagnostics

struct Point {
  float X, Y, Key;
};
template <class Iterator, class Compare>
void sort(Iterator First, Iterator Last, Compare Less) {
  Less(*First, *Last);
}
inline float key(Point P) { return P.X * P.Y; }

void use(Point *P, int N) {
  sort(P, P + N, [](Point A, Point B) { // within-note {{chosen here}} within-note {{'#pragma clang fp contract(off)' first}}
    return A.X * B.Y - A.Y * B.X > 0; // within-warning {{'sort' orders by the sign of this rounded result of two elements: an operand may be fused into it unrounded, so that an element may come before itself [-Wtp-fp-comparator]}}
  });
  sort(P, P + N, [](Point A, Point B) { // within-note {{chosen here}} within-note {{compare a key}} canonical-note {{chosen here}} canonical-note {{compare a key}}
    return A.Key - B.X * B.Y > 0; // within-warning {{an operand may be fused}} canonical-warning {{an operand may be fused}}
  });
  // In statements of their own, products are rounded but for the fast mode.
  sort(P, P + N, [](Point A, Point B) { // across-note {{chosen here}} across-note {{compare a key}}
    float Left = A.X * B.Y;
    float Right = A.Y * B.X;
    return Left - Right > 0; // across-warning {{an operand may be fused}}
  });
  sort(P, P + N, [](Point A, Point B) { // across-note {{chosen here}} across-note {{compare a key}}
    return key(A) - key(B) < 0; // across-warning {{an operand may be fused}}
  });
  sort(P, P + N, [](Point A, Point B) {
#pragma clang fp contract(off)
    return A.X * B.Y - A.Y * B.X > 0;
  });
}
