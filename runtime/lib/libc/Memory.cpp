//===- Memory.cpp - Copying, filling and comparing memory -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// By words where both sides are aligned alike. Compiled with -fno-builtin, so
// that no loop becomes a call of the function that it is in.
//
//===----------------------------------------------------------------------===//

#include <stddef.h>
#include <stdint.h>

namespace {

/// May alias anything.
using Word __attribute__((may_alias)) = uint32_t;
constexpr size_t WordMask = sizeof(Word) - 1;

bool isAligned(const void *Pointer) {
  return (reinterpret_cast<uintptr_t>(Pointer) & WordMask) == 0;
}

bool alignedAlike(const void *A, const void *B) {
  return ((reinterpret_cast<uintptr_t>(A) ^ reinterpret_cast<uintptr_t>(B)) &
          WordMask) == 0;
}

} // namespace

extern "C" {

void *memcpy(void *__restrict Target, const void *__restrict Source,
             size_t Bytes) {
  char *To = static_cast<char *>(Target);
  const char *From = static_cast<const char *>(Source);
  if (alignedAlike(To, From)) {
    for (; Bytes != 0 && !isAligned(To); --Bytes)
      *To++ = *From++;
    for (; Bytes >= 4 * sizeof(Word); Bytes -= 4 * sizeof(Word)) {
      const Word *W = reinterpret_cast<const Word *>(From);
      Word A = W[0], B = W[1], C = W[2], D = W[3];
      Word *V = reinterpret_cast<Word *>(To);
      V[0] = A;
      V[1] = B;
      V[2] = C;
      V[3] = D;
      To += 4 * sizeof(Word);
      From += 4 * sizeof(Word);
    }
    for (; Bytes >= sizeof(Word); Bytes -= sizeof(Word)) {
      *reinterpret_cast<Word *>(To) = *reinterpret_cast<const Word *>(From);
      To += sizeof(Word);
      From += sizeof(Word);
    }
  }
  for (; Bytes != 0; --Bytes)
    *To++ = *From++;
  return Target;
}

void *memmove(void *Target, const void *Source, size_t Bytes) {
  char *To = static_cast<char *>(Target);
  const char *From = static_cast<const char *>(Source);
  if (reinterpret_cast<uintptr_t>(To) - reinterpret_cast<uintptr_t>(From) >=
      Bytes) {
    if (alignedAlike(To, From)) {
      for (; Bytes != 0 && !isAligned(To); --Bytes)
        *To++ = *From++;
      for (; Bytes >= sizeof(Word); Bytes -= sizeof(Word)) {
        *reinterpret_cast<Word *>(To) = *reinterpret_cast<const Word *>(From);
        To += sizeof(Word);
        From += sizeof(Word);
      }
    }
    for (; Bytes != 0; --Bytes)
      *To++ = *From++;
    return Target;
  }
  // The end of the source lies under the target: from the back.
  To += Bytes;
  From += Bytes;
  if (alignedAlike(To, From)) {
    for (; Bytes != 0 && !isAligned(To); --Bytes)
      *--To = *--From;
    for (; Bytes >= sizeof(Word); Bytes -= sizeof(Word)) {
      To -= sizeof(Word);
      From -= sizeof(Word);
      *reinterpret_cast<Word *>(To) = *reinterpret_cast<const Word *>(From);
    }
  }
  for (; Bytes != 0; --Bytes)
    *--To = *--From;
  return Target;
}

void *memset(void *Target, int Value, size_t Bytes) {
  char *To = static_cast<char *>(Target);
  char Byte = static_cast<char>(Value);
  for (; Bytes != 0 && !isAligned(To); --Bytes)
    *To++ = Byte;
  Word Pattern = static_cast<unsigned char>(Value) * 0x01010101u;
  for (; Bytes >= 4 * sizeof(Word); Bytes -= 4 * sizeof(Word)) {
    Word *V = reinterpret_cast<Word *>(To);
    V[0] = Pattern;
    V[1] = Pattern;
    V[2] = Pattern;
    V[3] = Pattern;
    To += 4 * sizeof(Word);
  }
  for (; Bytes >= sizeof(Word); Bytes -= sizeof(Word)) {
    *reinterpret_cast<Word *>(To) = Pattern;
    To += sizeof(Word);
  }
  for (; Bytes != 0; --Bytes)
    *To++ = Byte;
  return Target;
}

int memcmp(const void *A, const void *B, size_t Bytes) {
  const unsigned char *P = static_cast<const unsigned char *>(A);
  const unsigned char *Q = static_cast<const unsigned char *>(B);
  if (isAligned(P) && isAligned(Q))
    for (; Bytes >= sizeof(Word) && *reinterpret_cast<const Word *>(P) ==
                                        *reinterpret_cast<const Word *>(Q);
         Bytes -= sizeof(Word)) {
      P += sizeof(Word);
      Q += sizeof(Word);
    }
  for (; Bytes != 0; --Bytes, ++P, ++Q)
    if (*P != *Q)
      return *P - *Q;
  return 0;
}

void *memchr(const void *Memory, int Value, size_t Bytes) {
  const unsigned char *P = static_cast<const unsigned char *>(Memory);
  for (; Bytes != 0; --Bytes, ++P)
    if (*P == static_cast<unsigned char>(Value))
      return const_cast<unsigned char *>(P);
  return nullptr;
}

} // extern "C"
