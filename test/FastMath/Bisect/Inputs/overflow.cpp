// Signed overflow, which the optimizer takes for impossible.

__attribute__((noinline)) bool canGrow(int size, int by) {
  return size + by > size;
}

int main() {
  volatile int most = 0x7fffffff;
  return canGrow(most, 1);
}
