#include "tp/thread.h"
#include <algorithm>
#include <cstdio>
#include <vector>

int main() {
  std::vector<int> Numbers = {3, 1, 2};
  std::sort(Numbers.begin(), Numbers.end());
  if (tp::threadId() == 0)
    std::printf("sorted: %d %d %d\n", Numbers[0], Numbers[1], Numbers[2]);
  return 0;
}
