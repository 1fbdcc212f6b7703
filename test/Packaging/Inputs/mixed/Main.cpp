#include <cstdio>

extern "C" int doubled(int Number);
extern "C" int addTwo(int Number);

int main() {
  std::printf("%d\n", addTwo(doubled(20)));
  return 0;
}
