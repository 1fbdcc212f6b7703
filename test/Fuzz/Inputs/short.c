#include "report.h"

int main(void) {
  volatile int16_t Value = 32767;
  ++Value;
  report((uint32_t)Value);
  return 0;
}
