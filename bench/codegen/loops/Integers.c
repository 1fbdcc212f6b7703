//===- Integers.c - Loops over bits and numbers ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

unsigned greatestCommonDivisor(unsigned A, unsigned B) {
  while (B != 0) {
    unsigned Rest = A % B;
    A = B;
    B = Rest;
  }
  return A;
}

unsigned crc32(const unsigned char *Bytes, unsigned Count) {
  unsigned Crc = ~0u;
  for (unsigned I = 0; I < Count; ++I) {
    Crc ^= Bytes[I];
    for (int Bit = 0; Bit < 8; ++Bit)
      Crc = (Crc >> 1) ^ (Crc & 1 ? 0xedb88320u : 0);
  }
  return ~Crc;
}

unsigned hashFNV1a(const unsigned char *Bytes, unsigned Count) {
  unsigned Hash = 2166136261u;
  for (unsigned I = 0; I < Count; ++I)
    Hash = (Hash ^ Bytes[I]) * 16777619u;
  return Hash;
}

unsigned collatzSteps(unsigned Number) {
  unsigned Steps = 0;
  while (Number > 1) {
    Number = Number & 1 ? 3 * Number + 1 : Number / 2;
    ++Steps;
  }
  return Steps;
}

void sieve(unsigned char *IsComposite, unsigned Count) {
  for (unsigned I = 2; I * I < Count; ++I)
    if (!IsComposite[I])
      for (unsigned J = I * I; J < Count; J += I)
        IsComposite[J] = 1;
}
