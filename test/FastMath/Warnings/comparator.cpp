// Comparators that read the sign of a rounded result of both their arguments,
// where it may be regrouped.

// RUN: tpcc -ffast-math -fsyntax-only -Xclang -verify=expected,canonical %s
// RUN: tpcc -ffast-math -mllvm -tp-fp-canonicalize=0 -fsyntax-only \
// RUN:   -Xclang -verify=expected,stock %s
// RUN: clang++ -std=c++20 -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -ffast-math -fsyntax-only -Xclang -verify=expected,stock %s

// Without regrouping, and without hardware that fuses, each sign is right.
// RUN: tpcc -fsyntax-only -Xclang -verify=silent %s
// RUN: tpcc -ftp-fp=strict -fsyntax-only -Xclang -verify=silent %s
// RUN: clang++ -std=c++20 -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   --target=x86_64-linux-gnu -fsyntax-only -Xclang -verify=silent %s
// silent-no-diagnostics

struct Point {
  float X, Y, Z;
};
template <class Iterator, class Compare>
void sort(Iterator First, Iterator Last, Compare Less) {
  Less(*First, *Last);
}
template <class Iterator, class Compare>
Iterator max_element(Iterator First, Iterator Last, Compare Less) {
  return Less(*First, *Last) ? Last : First;
}
extern "C" void qsort(void *, decltype(sizeof 0), decltype(sizeof 0),
                      int (*)(const void *, const void *));

//===----------------------------------------------------------------------===//
// Hazards
//===----------------------------------------------------------------------===//

bool angle(const Point &A, const Point &B) { // expected-note {{compare a key computed from each element alone, or write '#pragma clang fp contract(off) reassociate(off) reciprocal(off)' first in this function}}
  return A.X * B.Y - A.Y * B.X > 0; // stock-warning {{'sort' orders by the sign of this rounded result of two elements: its operands may be regrouped, so that an element may come before itself [-Wtp-fp-comparator]}} canonical-warning {{its operands may be regrouped, so that elements that are nearly equal may change places [-Wtp-fp-comparator]}}
}
static float cross(Point A, Point B) { // expected-note {{compare a key}}
  return A.X * B.Y - A.Y * B.X; // expected-warning {{'sort' orders by the sign of this rounded result}}
}
static float length(const Point &P) { return P.X * P.X + P.Y * P.Y; }

static int compareVoid(const void *A, const void *B) { // expected-note {{compare a key}}
  const auto *Left = static_cast<const Point *>(A);
  const auto *Right = static_cast<const Point *>(B);
  float Sign = Left->X * Right->Y - Left->Y * Right->X; // expected-warning {{'qsort' orders by the sign}}
  return Sign < 0 ? -1 : Sign > 0;
}
static int compareLengths(const void *A, const void *B) { // expected-note {{compare a key}}
  return length(*(const Point *)A) - length(*(const Point *)B); // expected-warning {{'qsort' orders by the sign}}
}

struct ByAngle {
  bool operator()(Point A, Point B) const { // expected-note {{compare a key}}
    return 0 < A.X * B.Y - A.Y * B.X; // expected-warning {{'max_element' orders by the sign}}
  }
};

void hazards(Point *P, int N, const Point *Origin, int *Order) {
  sort(P, P + N, angle); // expected-note {{the order of 'sort' is chosen here}}
  sort(P, P + N, [](Point A, Point B) { return cross(A, B) < 0; }); // expected-note {{chosen here}}
  sort(P, P + N, [](auto A, auto B) { return length(A) - length(B) < 0; }); // expected-warning {{'sort' orders by the sign}} expected-note {{chosen here}} expected-note {{compare a key}}
  qsort(P, N, sizeof(Point), compareVoid);    // expected-note {{chosen here}}
  qsort(P, N, sizeof(Point), &compareLengths); // expected-note {{chosen here}}
  max_element(P, P + N, ByAngle()); // expected-note {{chosen here}}
  auto Weighted = [K = 2.0f](const Point &A, const Point &B) { // expected-note {{compare a key}}
    float Difference = A.X * K - B.X * K; // expected-warning {{'sort' orders by the sign}}
    if (Difference != 0)
      return Difference < 0;
    return A.Y < B.Y;
  };
  sort(P, P + N, Weighted); // expected-note {{chosen here}}
  sort(Order, Order + N, [&](int A, int B) { // expected-note {{chosen here}} expected-note {{compare a key}}
    return (P[A].X + P[A].Y) - (P[B].X + P[B].Y) < 0; // expected-warning {{'sort' orders by the sign}}
  });
  sort(P, P + N, [](const Point &A, const Point &B) { // expected-note {{chosen here}} expected-note {{compare a key}}
    return (A.X - B.X) + (A.Y - B.Y) > 0; // expected-warning {{'sort' orders by the sign}}
  });
  sort(P, P + N, [](Point A, Point B) { // expected-note {{chosen here}}
    auto Determinant = [&] { // expected-note {{compare a key}}
      return A.X * B.Y - A.Y * B.X; // expected-warning {{'sort' orders by the sign}}
    };
    return Determinant() > 0;
  });
  sort(P, P + N, [](Point A, Point B) { // expected-note {{chosen here}} expected-note {{compare a key}}
    auto [X, Y, Z] = A;
    return X * B.Y - Y * B.X > 0; // expected-warning {{'sort' orders by the sign}}
  });
}

//===----------------------------------------------------------------------===//
// Sound orders
//===----------------------------------------------------------------------===//

static Point subtract(Point A, Point B) {
  return {A.X - B.X, A.Y - B.Y, A.Z - B.Z};
}
static float dot(Point A, Point B) {
  return A.X * B.X + A.Y * B.Y + A.Z * B.Z;
}
void sound(Point *P, int N, Point Axis, const float *Keys, int *Order) {
  // One key from each element.
  sort(P, P + N, [](Point A, Point B) { return length(A) < length(B); });
  sort(P, P + N, [&](Point A, Point B) { return dot(A, Axis) > dot(B, Axis); });
  sort(P, P + N, [](auto A, auto B) { return A.X / A.Y < B.X / B.Y; });
  sort(Order, Order + N, [&](int A, int B) { return Keys[A] < Keys[B]; });
  // A difference has the right sign, and what keeps the sign does too.
  sort(P, P + N, [](Point A, Point B) { return A.X - B.X < 0; });
  sort(P, P + N, [](Point A, Point B) { return (A.X - B.X) * 2 < 0; });
  sort(P, P + N, [&](Point A, Point B) {
    return dot(subtract(A, B), Axis) < 0;
  });
  // Kept as written.
  sort(P, P + N, [](Point A, Point B) {
#pragma clang fp reassociate(off) reciprocal(off) contract(off)
    return A.X * B.Y - A.Y * B.X > 0;
  });
  // Integers.
  sort(Order, Order + N, [](int A, int B) { return A * 3 - B * 3 < 0; });
}
// Not an order.
float area(Point A, Point B) { return cross(A, B) > 0 ? 1.0f : 0.0f; }
template <class Function> void forEach(Point *, int, Function) {}
void other(Point *P) {
  forEach(P, 3, [](Point A, Point B) { return A.X * B.Y - A.Y * B.X > 0; });
}
