//===- Strings.c - Loops over text ----------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

int compareStrings(const char *A, const char *B) {
  while (*A && *A == *B) {
    ++A;
    ++B;
  }
  return (unsigned char)*A - (unsigned char)*B;
}

int parseDecimal(const char *Text) {
  int Value = 0, IsNegative = 0;
  while (*Text == ' ')
    ++Text;
  if (*Text == '-') {
    IsNegative = 1;
    ++Text;
  }
  for (; *Text >= '0' && *Text <= '9'; ++Text)
    Value = Value * 10 + (*Text - '0');
  return IsNegative ? -Value : Value;
}

char *printDecimal(unsigned Value, char *End) {
  *--End = 0;
  do {
    *--End = (char)('0' + Value % 10);
    Value /= 10;
  } while (Value != 0);
  return End;
}
