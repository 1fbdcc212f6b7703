//===- Stdlib.cpp - Numbers from text, sorting, pseudo-random numbers -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

namespace {

thread_local uint32_t RandomState = 1;

unsigned digitValue(char Character) {
  if (Character >= '0' && Character <= '9')
    return static_cast<unsigned>(Character - '0');
  char Lower = static_cast<char>(Character | 0x20);
  if (Lower >= 'a' && Lower <= 'z')
    return static_cast<unsigned>(Lower - 'a' + 10);
  return 99;
}

struct ParsedInteger {
  bool Negative = false;
  bool Overflow = false;
  uint64_t Magnitude = 0;
};

/// Reads an integer of at most \p Limit in magnitude, or, for the negative
/// numbers of a signed type, one more. Sets errno beyond that.
ParsedInteger parseInteger(const char *Text, char **End, int Base,
                           uint64_t Limit, bool Signed) {
  ParsedInteger Result;
  const char *Start = Text;
  while (isspace(static_cast<unsigned char>(*Text)))
    ++Text;
  if (*Text == '-' || *Text == '+')
    Result.Negative = *Text++ == '-';
  if ((Base == 0 || Base == 16) && Text[0] == '0' && (Text[1] | 0x20) == 'x' &&
      digitValue(Text[2]) < 16) {
    Text += 2;
    Base = 16;
  }
  if (Base == 0)
    Base = *Text == '0' ? 8 : 10;
  if (Signed && Result.Negative)
    ++Limit;
  unsigned UBase = static_cast<unsigned>(Base);
  bool Any = false;
  for (unsigned Digit; (Digit = digitValue(*Text)) < UBase; ++Text) {
    Any = true;
    uint64_t Next;
    if (__builtin_mul_overflow(Result.Magnitude, uint64_t(UBase), &Next) ||
        __builtin_add_overflow(Next, uint64_t(Digit), &Next) || Next > Limit) {
      Result.Overflow = true;
      Next = Limit;
    }
    Result.Magnitude = Next;
  }
  if (Result.Overflow) {
    Result.Magnitude = Limit;
    errno = ERANGE;
  }
  if (End)
    *End = const_cast<char *>(Any ? Text : Start);
  return Result;
}

template <typename T> T parseSigned(const char *Text, char **End, int Base) {
  constexpr uint64_t Limit = (~uint64_t(0) >> 1) >> (64 - 8 * sizeof(T));
  ParsedInteger P = parseInteger(Text, End, Base, Limit, true);
  return static_cast<T>(P.Negative ? -P.Magnitude : P.Magnitude);
}

template <typename T> T parseUnsigned(const char *Text, char **End, int Base) {
  constexpr uint64_t Limit = ~uint64_t(0) >> (64 - 8 * sizeof(T));
  ParsedInteger P = parseInteger(Text, End, Base, Limit, false);
  return static_cast<T>(P.Negative && !P.Overflow ? -P.Magnitude : P.Magnitude);
}

void swapElements(char *A, char *B, size_t Bytes) {
  for (; Bytes != 0; --Bytes) {
    char T = *A;
    *A++ = *B;
    *B++ = T;
  }
}

} // namespace

extern "C" {

int abs(int Value) { return Value < 0 ? -Value : Value; }
long labs(long Value) { return Value < 0 ? -Value : Value; }
long long llabs(long long Value) { return Value < 0 ? -Value : Value; }

div_t div(int A, int B) { return {A / B, A % B}; }
ldiv_t ldiv(long A, long B) { return {A / B, A % B}; }
lldiv_t lldiv(long long A, long long B) { return {A / B, A % B}; }

intmax_t imaxabs(intmax_t Value) { return Value < 0 ? -Value : Value; }
imaxdiv_t imaxdiv(intmax_t A, intmax_t B) { return {A / B, A % B}; }

intmax_t strtoimax(const char *__restrict Text, char **__restrict End,
                   int Base) {
  return parseSigned<intmax_t>(Text, End, Base);
}

uintmax_t strtoumax(const char *__restrict Text, char **__restrict End,
                    int Base) {
  return parseUnsigned<uintmax_t>(Text, End, Base);
}

long strtol(const char *__restrict Text, char **__restrict End, int Base) {
  return parseSigned<long>(Text, End, Base);
}

unsigned long strtoul(const char *__restrict Text, char **__restrict End,
                      int Base) {
  return parseUnsigned<unsigned long>(Text, End, Base);
}

long long strtoll(const char *__restrict Text, char **__restrict End,
                  int Base) {
  return parseSigned<long long>(Text, End, Base);
}

unsigned long long strtoull(const char *__restrict Text, char **__restrict End,
                            int Base) {
  return parseUnsigned<unsigned long long>(Text, End, Base);
}

int atoi(const char *Text) {
  return static_cast<int>(strtol(Text, nullptr, 10));
}
long atol(const char *Text) { return strtol(Text, nullptr, 10); }
long long atoll(const char *Text) { return strtoll(Text, nullptr, 10); }

/// Heap sort: in place, without recursion, n log n steps for any input.
void qsort(void *Elements, size_t Count, size_t Bytes,
           int (*Compare)(const void *, const void *)) {
  char *Base = static_cast<char *>(Elements);
  size_t Start = Count / 2;
  size_t End = Count;
  while (End > 1) {
    if (Start != 0) {
      --Start;
    } else {
      --End;
      swapElements(Base, Base + End * Bytes, Bytes);
    }
    for (size_t Parent = Start;;) {
      size_t Child = 2 * Parent + 1;
      if (Child >= End)
        break;
      if (Child + 1 < End &&
          Compare(Base + Child * Bytes, Base + (Child + 1) * Bytes) < 0)
        ++Child;
      if (Compare(Base + Parent * Bytes, Base + Child * Bytes) >= 0)
        break;
      swapElements(Base + Parent * Bytes, Base + Child * Bytes, Bytes);
      Parent = Child;
    }
  }
}

void *bsearch(const void *Key, const void *Elements, size_t Count, size_t Bytes,
              int (*Compare)(const void *, const void *)) {
  const char *Base = static_cast<const char *>(Elements);
  while (Count != 0) {
    const char *Middle = Base + Count / 2 * Bytes;
    int Order = Compare(Key, Middle);
    if (Order == 0)
      return const_cast<char *>(Middle);
    if (Order > 0) {
      Base = Middle + Bytes;
      --Count;
    }
    Count /= 2;
  }
  return nullptr;
}

/// Each thread has its own sequence: Marsaglia's 32-bit xorshift.
int rand(void) {
  uint32_t State = RandomState;
  State ^= State << 13;
  State ^= State >> 17;
  State ^= State << 5;
  RandomState = State;
  return static_cast<int>(State >> 1);
}

void srand(unsigned Seed) { RandomState = Seed != 0 ? Seed : 1; }

/// A TP has no environment.
char *getenv(const char *) { return nullptr; }

thread_local int __tp_errno = 0;
int *__tp_errno_location(void) { return &__tp_errno; }

} // extern "C"
