// What printf writes on the chip is what the host's writes.
// RUN: %host_cc -w -O1 %s -o %t.host && %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <limits.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  printf("%d %i %u %x %X %o\n", -1, INT_MIN, 4000000000u, 48879, 48879, 8);
  printf("[%5d][%-5d][%05d][%+d][% d][%.3d][%8.3d]\n", 42, 42, 42, 42, 42, 7,
         7);
  printf("[%#x][%#o][%#X][%#10x][%-#10x]\n", 255, 8, 255, 255, 255);
  printf("%hhd %hhu %hd %hu\n", 300, 300, 70000, 70000);
  printf("%lld %llu %llx %lld\n", -1234567890123456789LL,
         18446744073709551615ULL, 0xfedcba9876543210ULL,
         -9223372036854775807LL - 1);
  printf("%zu %td\n", (size_t)123, (char *)8 - (char *)4);
  printf("[%s][%10s][%-10s][%.2s][%c][%%]\n", "text", "text", "text", "text",
         'c');
  printf("%f %e %g %a\n", 3.14159265358979, 31415.9265, 0.0000314159, 1.5);
  printf("%.0f %.1f %.2f %.20f\n", 0.5, 0.25, 2.675, 0.1);
  printf("%g %g %g %g %g\n", 1e100, 1e-100, 100000.0, 1000000.0, 0.0);
  printf("%.17g %.3e %12.4f|%-12.4f|%+.2f\n", 0.1, 123456.0, -2.5, -2.5, 2.5);
  printf("%f %F %e %g\n", 1.0 / 0.0, -1.0 / 0.0, 1e308, 4.9e-324);
  printf("%*d|%-*d|%.*f\n", 6, 42, 6, 42, 2, 1.0 / 3);
  printf("no newline yet, ");
  putchar('c');
  puts(" and the end");
  char Buffer[16];
  int Count = snprintf(Buffer, sizeof(Buffer), "%s", "longer than the buffer");
  printf("%d <%s>\n", Count, Buffer);
  sprintf(Buffer, "%d-%d", 1, 2);
  printf("%s %d\n", Buffer, (int)strlen(Buffer));
  for (int I = 0; I < 200; ++I)
    printf("%d,", I);
  fputs("a long line's end\n", stdout);
  printf("the last line has no newline");
  return 0;
}
