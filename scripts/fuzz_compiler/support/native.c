//===- native.c - What a 32-bit program needs without a C library ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The native reference is a Linux program of 32 bits, whose types have the
// sizes and alignments of the TP's. It makes its own system calls, so no
// 32-bit C library has to be installed.
//
//===----------------------------------------------------------------------===//

#include <stddef.h>

enum { SystemCallExit = 1, SystemCallWrite = 4 };

int main(int ArgumentCount, char **Arguments);

static int systemCall(int Number, int First, const void *Second,
                      unsigned Third) {
  int Result;
  __asm__ volatile("int $0x80"
                   : "=a"(Result)
                   : "a"(Number), "b"(First), "c"(Second), "d"(Third)
                   : "memory");
  return Result;
}

void writeText(const char *Text, unsigned Bytes) {
  systemCall(SystemCallWrite, 1, Text, Bytes);
}

__attribute__((noreturn)) void exit(int Status) {
  systemCall(SystemCallExit, Status, NULL, 0);
  __builtin_unreachable();
}

__attribute__((noreturn)) void abort(void) { exit(134); }

typedef void (*Destructor)(void *Object);
static struct {
  Destructor Function;
  void *Object;
} Destructors[256];
static unsigned NumDestructors;

__attribute__((visibility("hidden"))) void *__dso_handle;

int __cxa_atexit(Destructor Function, void *Object, void *Handle) {
  (void)Handle;
  if (NumDestructors == sizeof(Destructors) / sizeof(Destructors[0]))
    abort();
  Destructors[NumDestructors].Function = Function;
  Destructors[NumDestructors++].Object = Object;
  return 0;
}

__attribute__((noreturn)) void __cxa_pure_virtual(void) { abort(); }

static void runDestructors(void) {
  while (NumDestructors != 0) {
    --NumDestructors;
    Destructors[NumDestructors].Function(Destructors[NumDestructors].Object);
  }
}

/// operator new(unsigned)
void *_Znwj(size_t Bytes) {
  static char Heap[1 << 20] __attribute__((aligned(16)));
  static size_t Used;
  void *Result = Heap + Used;
  Used += (Bytes + 15) / 16 * 16;
  if (Used > sizeof(Heap))
    abort();
  return Result;
}

/// operator delete(void *), with and without the size
void _ZdlPv(void *Object) { (void)Object; }
void _ZdlPvj(void *Object, size_t Bytes) {
  (void)Object;
  (void)Bytes;
}

typedef void (*Constructor)(void);
extern const Constructor __init_array_start[];
extern const Constructor __init_array_end[];

__attribute__((used, noreturn)) static void start(void) {
  for (const Constructor *Function = __init_array_start;
       Function != __init_array_end; ++Function)
    (*Function)();
  static char *Arguments[] = {"program", NULL};
  int Status = main(1, Arguments);
  runDestructors();
  exit(Status);
}

__asm__(".globl _start\n"
        "_start:\n"
        "  andl $-16, %esp\n"
        "  call start\n");

void *memcpy(void *restrict To, const void *restrict From, size_t Bytes) {
  for (size_t I = 0; I != Bytes; ++I)
    ((char *)To)[I] = ((const char *)From)[I];
  return To;
}

void *memmove(void *To, const void *From, size_t Bytes) {
  if ((char *)To <= (const char *)From)
    return memcpy(To, From, Bytes);
  while (Bytes-- != 0)
    ((char *)To)[Bytes] = ((const char *)From)[Bytes];
  return To;
}

void *memset(void *To, int Value, size_t Bytes) {
  for (size_t I = 0; I != Bytes; ++I)
    ((char *)To)[I] = (char)Value;
  return To;
}

int memcmp(const void *Left, const void *Right, size_t Bytes) {
  for (size_t I = 0; I != Bytes; ++I) {
    int Difference =
        ((const unsigned char *)Left)[I] - ((const unsigned char *)Right)[I];
    if (Difference != 0)
      return Difference;
  }
  return 0;
}
