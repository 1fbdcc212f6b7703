//===- String.cpp - Zero-terminated strings -------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include <stdlib.h>
#include <string.h>

namespace {

thread_local char *NextToken;

bool contains(const char *Set, char Character) {
  for (; *Set != '\0'; ++Set)
    if (*Set == Character)
      return true;
  return false;
}

} // namespace

extern "C" {

size_t strlen(const char *Text) {
  size_t Bytes = 0;
  while (Text[Bytes] != '\0')
    ++Bytes;
  return Bytes;
}

size_t strnlen(const char *Text, size_t Limit) {
  size_t Bytes = 0;
  while (Bytes != Limit && Text[Bytes] != '\0')
    ++Bytes;
  return Bytes;
}

char *stpcpy(char *__restrict Target, const char *__restrict Source) {
  while ((*Target = *Source++) != '\0')
    ++Target;
  return Target;
}

char *strcpy(char *__restrict Target, const char *__restrict Source) {
  stpcpy(Target, Source);
  return Target;
}

char *strncpy(char *__restrict Target, const char *__restrict Source,
              size_t Bytes) {
  size_t I = 0;
  for (; I != Bytes && Source[I] != '\0'; ++I)
    Target[I] = Source[I];
  for (; I != Bytes; ++I)
    Target[I] = '\0';
  return Target;
}

char *strcat(char *__restrict Target, const char *__restrict Source) {
  stpcpy(Target + strlen(Target), Source);
  return Target;
}

char *strncat(char *__restrict Target, const char *__restrict Source,
              size_t Bytes) {
  char *To = Target + strlen(Target);
  for (; Bytes != 0 && *Source != '\0'; --Bytes)
    *To++ = *Source++;
  *To = '\0';
  return Target;
}

int strcmp(const char *A, const char *B) {
  for (; *A != '\0' && *A == *B; ++A)
    ++B;
  return static_cast<unsigned char>(*A) - static_cast<unsigned char>(*B);
}

int strncmp(const char *A, const char *B, size_t Bytes) {
  for (; Bytes != 0; --Bytes, ++A, ++B)
    if (*A != *B || *A == '\0')
      return static_cast<unsigned char>(*A) - static_cast<unsigned char>(*B);
  return 0;
}

int strcoll(const char *A, const char *B) { return strcmp(A, B); }

char *strchr(const char *Text, int Character) {
  for (;; ++Text) {
    if (*Text == static_cast<char>(Character))
      return const_cast<char *>(Text);
    if (*Text == '\0')
      return nullptr;
  }
}

char *strrchr(const char *Text, int Character) {
  const char *Last = nullptr;
  for (;; ++Text) {
    if (*Text == static_cast<char>(Character))
      Last = Text;
    if (*Text == '\0')
      return const_cast<char *>(Last);
  }
}

char *strstr(const char *Text, const char *Part) {
  size_t Bytes = strlen(Part);
  for (;; ++Text) {
    if (strncmp(Text, Part, Bytes) == 0)
      return const_cast<char *>(Text);
    if (*Text == '\0')
      return nullptr;
  }
}

size_t strspn(const char *Text, const char *Set) {
  size_t Bytes = 0;
  while (Text[Bytes] != '\0' && contains(Set, Text[Bytes]))
    ++Bytes;
  return Bytes;
}

size_t strcspn(const char *Text, const char *Set) {
  size_t Bytes = 0;
  while (Text[Bytes] != '\0' && !contains(Set, Text[Bytes]))
    ++Bytes;
  return Bytes;
}

char *strpbrk(const char *Text, const char *Set) {
  Text += strcspn(Text, Set);
  return *Text != '\0' ? const_cast<char *>(Text) : nullptr;
}

char *strtok_r(char *__restrict Text, const char *__restrict Separators,
               char **__restrict Next) {
  if (!Text)
    Text = *Next;
  Text += strspn(Text, Separators);
  if (*Text == '\0') {
    *Next = Text;
    return nullptr;
  }
  char *End = Text + strcspn(Text, Separators);
  if (*End != '\0')
    *End++ = '\0';
  *Next = End;
  return Text;
}

char *strtok(char *__restrict Text, const char *__restrict Separators) {
  return strtok_r(Text, Separators, &NextToken);
}

char *strndup(const char *Text, size_t Limit) {
  size_t Bytes = strnlen(Text, Limit);
  char *Copy = static_cast<char *>(malloc(Bytes + 1));
  if (!Copy)
    return nullptr;
  memcpy(Copy, Text, Bytes);
  Copy[Bytes] = '\0';
  return Copy;
}

char *strdup(const char *Text) { return strndup(Text, ~size_t(0)); }

} // extern "C"
