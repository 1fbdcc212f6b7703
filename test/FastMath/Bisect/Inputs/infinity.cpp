// An empty box has the extent -inf; the exit status says whether that is found.

__attribute__((noinline)) bool isEmpty(float lo, float hi) {
  return hi - lo == -__builtin_inff();
}

int main() {
  volatile float infinity = __builtin_inff();
  return !isEmpty(infinity, -infinity) + isEmpty(1, 2);
}
