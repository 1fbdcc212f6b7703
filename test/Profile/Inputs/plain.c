static volatile int Sum;

/* A name that would be markup. */
__attribute__((noinline)) static void add(int Value) __asm__("</script><b>");

static void add(int Value) { Sum += Value; }

int main(void) {
  for (int I = 0; I != 10; ++I)
    add(I);
  return 0;
}
