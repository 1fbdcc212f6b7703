// Strings, memory, sorting and numbers from text, against the host's.
// RUN: %host_cc -w -O1 %s -o %t.host && %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int sign(int Value) { return (Value > 0) - (Value < 0); }

static int compareInts(const void *A, const void *B) {
  int X = *(const int *)A, Y = *(const int *)B;
  return (X > Y) - (X < Y);
}

static unsigned checksum(const unsigned char *Bytes, int Count) {
  unsigned Sum = 0;
  for (int I = 0; I < Count; ++I)
    Sum = Sum * 31 + Bytes[I];
  return Sum;
}

int main(void) {
  unsigned char Area[96];
  for (int From = 0; From < 9; ++From)
    for (int To = 0; To < 9; ++To)
      for (int Bytes = 0; Bytes < 40; Bytes += 3) {
        for (int I = 0; I < 96; ++I)
          Area[I] = (unsigned char)(I * 7);
        memmove(Area + To, Area + From, (size_t)Bytes);
        memcpy(Area + 48 + To, Area + From, (size_t)Bytes);
        memset(Area + 40 + From, Bytes, (size_t)(Bytes & 7));
        printf("%u %d\n", checksum(Area, 96),
               sign(memcmp(Area + From, Area + To, (size_t)Bytes)));
      }
  char Text[64] = "one two";
  strcat(Text, " three");
  printf("%s %d %d %d\n", Text, (int)strlen(Text), sign(strcmp("ab", "b")),
         sign(strncmp("abc", "abd", 2)));
  printf("%s %s %s %d\n", strchr(Text, 't'), strrchr(Text, 't'),
         strstr(Text, "two"), strchr(Text, 'z') == NULL);
  for (char *Token = strtok(Text, " "); Token; Token = strtok(NULL, " "))
    printf("<%s>", Token);
  printf("\n");
  int Numbers[200];
  unsigned State = 1;
  for (int I = 0; I < 200; ++I) {
    State = State * 1664525 + 1013904223;
    Numbers[I] = (int)(State >> 8) - 4000000;
  }
  qsort(Numbers, 200, sizeof(int), compareInts);
  for (int I = 0; I < 200; ++I)
    printf("%d ", Numbers[I]);
  int Key = Numbers[77];
  printf("\n%d\n",
         *(int *)bsearch(&Key, Numbers, 200, sizeof(int), compareInts) == Key);
  char *End;
  printf("%d %ld %d\n", atoi(" -42x"), strtol("0x1F!", &End, 0), *End);
  printf("%lld %llu\n", strtoll("-9223372036854775808", NULL, 10),
         strtoull("18446744073709551616", NULL, 10));
  printf("%d\n", errno == ERANGE);
  for (int C = 0; C < 128; ++C)
    printf("%d%d%d%d%d%d", !!isalpha(C), !!isdigit(C), !!isspace(C),
           !!ispunct(C), !!isprint(C), toupper(C));
  printf("\n%d %d\n", abs(-5), div(17, 5).rem);
  return 0;
}
