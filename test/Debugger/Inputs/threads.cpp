#include <tp/barrier.h>
#include <tp/thread.h>

constexpr int Cells = 128;
int Cell[Cells];
int Wrong = -1;

void fill(int Index) {
  Cell[Index] = Index * 2;
  if (Index == 77)
    Cell[5] = 99;
}

int check(int Index) {
  if (Cell[Index] != Index * 2)
    Wrong = Index;
  return Cell[Index];
}

int main() {
  int Me = int(tp::threadId());
  fill(Me);
  tp::barrier();
  check(Me);
  return 0;
}
