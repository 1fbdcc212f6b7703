// Leaves a ratio in memory.

[[gnu::used]] float result;
volatile float numerator = 5, denominator = 49;

__attribute__((noinline)) float ratio(float a, float b) { return a / b; }

extern "C" [[noreturn, gnu::used]] void run() {
  result = ratio(numerator, denominator);
  __builtin_tp_halt(0);
}

asm(".globl _start\n"
    "_start:\n"
    "  lui sp, %hi(__tp_stack_top)\n"
    "  addi sp, sp, %lo(__tp_stack_top)\n"
    "  j run\n");
