#include <cstdio>

struct Flags {
  unsigned Low : 3;
  unsigned High : 5;
} Seen;

struct Pair {
  int First, Second;
};

struct Table {
  double Scale;
  Pair Entries[3];
  const char *Name;
};

class Counted {
public:
  explicit Counted(int Count) : Count(Count) {}
  Counted(const Counted &Other) : Count(Other.Count + 100) {}

  int Count;
};

[[gnu::noinline]] Pair makePair(int Of) { return {Of, Of * Of}; }

[[gnu::noinline]] Table makeTable(int Of) {
  Table Result = {Of / 2.0, {}, "table"};
  for (int I = 0; I < 3; ++I)
    Result.Entries[I] = makePair(Of + I);
  return Result;
}

[[gnu::noinline]] Counted makeCounted(int Of) { return Counted(Of); }

[[gnu::noinline]] double half(int Of) { return Of / 2.0; }

[[gnu::noinline]] float third(int Of) { return float(Of) / 3.0f; }

/// Calls itself, so that another call has the same entry.
[[gnu::noinline]] Pair deepest(int Depth) {
  if (Depth == 0)
    return {7, 9};
  Pair Inner = deepest(Depth - 1);
  return {Inner.First + 1, Inner.Second};
}

int main() {
  volatile int Five = 5;
  Table Made = makeTable(Five);
  Counted Number = makeCounted(Five);
  double Half = half(Five);
  float Third = third(Five);
  Pair Deep = deepest(Five - 3);
  Seen.High = Number.Count;
  printf("%g %d %g %g %d %d\n", Made.Scale, Made.Entries[2].Second, Half,
         double(Third), Deep.First, int(Seen.Low + Seen.High));
  return 0;
}
