// The algorithms and containers of the standard library.

// RUN: tpcc -std=c++20 -ffast-math -fsyntax-only -Xclang -verify %s
// RUN: clang++ -std=c++20 -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -ffast-math -fsyntax-only -Xclang -verify %s

#include <algorithm>
#include <compare>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <vector>

struct Point {
  float X, Y;
};

struct ByAngle {
  bool operator()(const Point &A, const Point &B) const { // expected-note {{compare a key}}
    return A.X * B.Y - A.Y * B.X > 0; // expected-warning {{'set' orders by the sign}}
  }
};
struct ByAngle2 {
  bool operator()(const Point &A, const Point &B) const { // expected-note {{compare a key}}
    return A.X * B.Y - A.Y * B.X > 0; // expected-warning {{'map' orders by the sign}}
  }
};
static bool less(const Point &A, const Point &B) { // expected-note {{compare a key}}
  return A.X * B.Y - A.Y * B.X > 0; // expected-warning {{'nth_element' orders by the sign}}
}

// Elements that order themselves.
struct Member {
  float X, Y;
  bool operator<(const Member &Other) const { // expected-note {{compare a key}}
    return X * Other.Y - Y * Other.X < 0; // expected-warning {{'sort' orders by the sign}}
  }
};
struct Friend {
  float X, Y;
  friend bool operator<(Friend A, Friend B) { // expected-note {{compare a key}}
    return A.X * B.Y - A.Y * B.X < 0; // expected-warning {{'max_element' orders by the sign}}
  }
};
struct Free {
  float X, Y;
};
bool operator<(const Free &A, const Free &B) { // expected-note {{compare a key}}
  return A.X * B.Y - A.Y * B.X < 0; // expected-warning {{'priority_queue' orders by the sign}}
}
struct ThreeWay {
  float X, Y;
  auto operator<=>(const ThreeWay &Other) const { // expected-note {{compare a key}}
    return X * Other.Y - Y * Other.X <=> 0.0f; // expected-warning {{'make_heap' orders by the sign}}
  }
};

void use(std::vector<Point> &Points, std::vector<Member> &Members,
         Friend *Friends, std::vector<ThreeWay> &ThreeWays) {
  std::set<Point, ByAngle> Set;     // expected-note {{the order of 'set' is chosen here}}
  std::map<Point, int, ByAngle2> Map; // expected-note {{chosen here}}
  std::priority_queue<Free> Queue;  // expected-note {{chosen here}}
  std::sort(Members.begin(), Members.end()); // expected-note {{chosen here}}
  std::max_element(Friends, Friends + 9);    // expected-note {{chosen here}}
  std::make_heap(ThreeWays.begin(), ThreeWays.end()); // expected-note {{chosen here}}
  bool (*Pointer)(const Point &, const Point &) = &less;
  std::nth_element(Points.begin(), Points.begin(), Points.end(), Pointer); // expected-note {{chosen here}}
  std::function<bool(Point, Point)> Function = [](Point A, Point B) { // expected-note {{compare a key}}
    return A.X * B.Y - A.Y * B.X > 0; // expected-warning {{'sort' orders by the sign}}
  };
  std::sort(Points.begin(), Points.end(), Function); // expected-note {{chosen here}}
  std::ranges::sort(Points, [](const Point &A, const Point &B) { // expected-note {{chosen here}} expected-note {{compare a key}}
    return A.X * B.Y - A.Y * B.X > 0; // expected-warning {{'sort' orders by the sign}}
  });
  std::multiset<Point, bool (*)(const Point &, const Point &)> Ordered(
      [](const Point &A, const Point &B) { return A.X < B.X; });
  (void)std::lower_bound(Points.begin(), Points.end(), 1.0f,
                         [](const Point &A, float B) { return A.X < B; });
  std::set<float> Numbers;
  std::map<int, Point> Values;
}
