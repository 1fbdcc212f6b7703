//===- Stdio.cpp - Formatted output in whole lines ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each thread gathers its text until a line is complete and hands whole lines
// to the host in one call, so that the lines of many threads stay whole. What
// is left goes out when the thread ends.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/crt/ThreadExit.h"
#include "runtime/lib/libc/Format.h"
#include "tp/host_call.h"
#include "tp/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct __tp_file {
  int Descriptor;
};

namespace tp {

namespace {

/// Of a write to the host.
constexpr unsigned MaxWriteBytes = 4096;
constexpr unsigned NumFiles = 2;

/// Starts small in the thread's local store; longer lines move to the heap.
struct LineBuffer {
  ThreadExit AtExit;
  char *Heap;
  uint16_t Capacity;
  uint16_t Bytes;
  char Local[96];

  char *text() { return Heap ? Heap : Local; }
};

thread_local LineBuffer Buffers[NumFiles];

LineBuffer &bufferOf(FILE *File) { return Buffers[File == stderr]; }

void emit(FILE *File, const char *Text, unsigned Bytes) {
  __builtin_tp_hostcall(kHostCallWrite, static_cast<unsigned>(File->Descriptor),
                        deviceAddress(Text), Bytes);
}

void flush(FILE *File) {
  LineBuffer &B = bufferOf(File);
  if (B.Bytes != 0)
    emit(File, B.text(), B.Bytes);
  B.Bytes = 0;
}

void prepare(FILE *File, LineBuffer &B) {
  if (B.AtExit.Function)
    return;
  B.AtExit.Function = [](void *Argument) {
    FILE *Ending = static_cast<FILE *>(Argument);
    bufferOf(Ending).AtExit.Function = nullptr;
    flush(Ending);
  };
  B.AtExit.Argument = File;
  atThreadExit(B.AtExit);
  if (!B.Heap)
    B.Capacity = sizeof(B.Local);
}

/// Makes room for one more byte at least.
void grow(FILE *File, LineBuffer &B) {
  if (B.Capacity < MaxWriteBytes) {
    unsigned Capacity = B.Heap ? B.Capacity * 2u : 256;
    char *Larger = static_cast<char *>(malloc(Capacity));
    if (Larger) {
      memcpy(Larger, B.text(), B.Bytes);
      free(B.Heap);
      B.Heap = Larger;
      B.Capacity = static_cast<uint16_t>(Capacity);
      return;
    }
  }
  flush(File);
}

void put(FILE *File, const char *Text, unsigned Bytes) {
  LineBuffer &B = bufferOf(File);
  prepare(File, B);
  bool Complete = false;
  for (unsigned I = 0; I != Bytes; ++I) {
    if (B.Bytes == B.Capacity)
      grow(File, B);
    B.text()[B.Bytes++] = Text[I];
    Complete |= Text[I] == '\n';
  }
  if (!Complete)
    return;
  // Everything up to the last line's end goes out; the rest moves to the front.
  unsigned Whole = B.Bytes;
  while (Whole != 0 && B.text()[Whole - 1] != '\n')
    --Whole;
  if (Whole == 0)
    return;
  emit(File, B.text(), Whole);
  memmove(B.text(), B.text() + Whole, B.Bytes - Whole);
  B.Bytes = static_cast<uint16_t>(B.Bytes - Whole);
}

struct FileSink : TextSink {
  FILE *File;
};

struct MemorySink : TextSink {
  char *Next;
  char *End;
};

} // namespace

} // namespace tp

using namespace tp;

extern "C" {

static FILE StandardOutput = {1};
static FILE StandardError = {2};
FILE *const stdout = &StandardOutput;
FILE *const stderr = &StandardError;

int vfprintf(FILE *File, const char *Format, va_list Arguments) {
  FileSink Sink;
  Sink.Write = [](TextSink &S, const char *Text, unsigned Bytes) {
    put(static_cast<FileSink &>(S).File, Text, Bytes);
  };
  Sink.File = File;
  return formatText(Sink, Format, Arguments);
}

int fprintf(FILE *File, const char *Format, ...) {
  va_list Arguments;
  va_start(Arguments, Format);
  int Count = vfprintf(File, Format, Arguments);
  va_end(Arguments);
  return Count;
}

int vprintf(const char *Format, va_list Arguments) {
  return vfprintf(stdout, Format, Arguments);
}

int printf(const char *Format, ...) {
  va_list Arguments;
  va_start(Arguments, Format);
  int Count = vfprintf(stdout, Format, Arguments);
  va_end(Arguments);
  return Count;
}

int vsnprintf(char *Buffer, size_t Bytes, const char *Format,
              va_list Arguments) {
  MemorySink Sink;
  Sink.Write = [](TextSink &S, const char *Text, unsigned Count) {
    MemorySink &Memory = static_cast<MemorySink &>(S);
    for (unsigned I = 0; I != Count && Memory.Next != Memory.End; ++I)
      *Memory.Next++ = Text[I];
  };
  Sink.Next = Buffer;
  Sink.End = Bytes != 0 ? Buffer + (Bytes - 1) : Buffer;
  int Count = formatText(Sink, Format, Arguments);
  if (Bytes != 0)
    *Sink.Next = '\0';
  return Count;
}

int snprintf(char *Buffer, size_t Bytes, const char *Format, ...) {
  va_list Arguments;
  va_start(Arguments, Format);
  int Count = vsnprintf(Buffer, Bytes, Format, Arguments);
  va_end(Arguments);
  return Count;
}

int vsprintf(char *Buffer, const char *Format, va_list Arguments) {
  return vsnprintf(Buffer, 0x7FFFFFFF, Format, Arguments);
}

int sprintf(char *Buffer, const char *Format, ...) {
  va_list Arguments;
  va_start(Arguments, Format);
  int Count = vsprintf(Buffer, Format, Arguments);
  va_end(Arguments);
  return Count;
}

int fputc(int Character, FILE *File) {
  char Text = static_cast<char>(Character);
  put(File, &Text, 1);
  return static_cast<unsigned char>(Text);
}

int putc(int Character, FILE *File) { return fputc(Character, File); }

int putchar(int Character) { return fputc(Character, stdout); }

int fputs(const char *Text, FILE *File) {
  put(File, Text, strlen(Text));
  return 0;
}

int puts(const char *Text) {
  fputs(Text, stdout);
  fputc('\n', stdout);
  return 0;
}

size_t fwrite(const void *Data, size_t Bytes, size_t Count, FILE *File) {
  put(File, static_cast<const char *>(Data), Bytes * Count);
  return Count;
}

int fflush(FILE *File) {
  if (File) {
    flush(File);
    return 0;
  }
  flush(stdout);
  flush(stderr);
  return 0;
}

void __tp_assert_fail(const char *Condition, const char *File, int Line,
                      const char *Function) {
  char Digits[11];
  char *Number = Digits + sizeof(Digits);
  *--Number = '\0';
  for (; Line > 0; Line /= 10)
    *--Number = static_cast<char>('0' + Line % 10);
  // A kernel with assertions shall not need the stack of printf.
  const char *const Parts[] = {File,      ":",          Number,
                               ": ",      Function,     ": Assertion `",
                               Condition, "' failed.\n"};
  for (const char *Part : Parts)
    fputs(Part, stderr);
  abort();
}

} // extern "C"
