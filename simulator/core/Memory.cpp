//===- Memory.cpp - The chip's global memory ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

namespace tp {

HostPages::HostPages(size_t Bytes) {
  if (Bytes == 0)
    return;
  void *Mapping = mmap(nullptr, Bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (Mapping == MAP_FAILED)
    return;
  Pages = static_cast<uint8_t *>(Mapping);
  this->Bytes = Bytes;
}

/// What is saved or not at a time: a page of most hosts.
static constexpr size_t PageBytes = 4096;

/// Which of the \p Count pages from \p Begin on the host has: the others are
/// zeros, and looking at them would cost a page each. All of them if the host
/// does not tell.
static std::vector<bool> touchedPages(const uint8_t *Begin, size_t Count) {
  constexpr uint64_t PresentOrSwapped = uint64_t(3) << 62;
  std::vector<bool> Touched(Count, true);
  if (sysconf(_SC_PAGESIZE) != PageBytes)
    return Touched;
  int File = open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
  if (File < 0)
    return Touched;
  std::vector<uint64_t> Entries(std::min<size_t>(Count, 1 << 16));
  uint64_t FirstPage = reinterpret_cast<uintptr_t>(Begin) / PageBytes;
  for (size_t Done = 0; Done != Count;) {
    size_t Wanted = std::min(Entries.size(), Count - Done) * sizeof(uint64_t);
    ssize_t Read = pread(File, Entries.data(), Wanted,
                         off_t((FirstPage + Done) * sizeof(uint64_t)));
    if (Read < ssize_t(sizeof(uint64_t)))
      break;
    for (size_t I = 0; I != size_t(Read) / sizeof(uint64_t); ++I)
      Touched[Done++] = (Entries[I] & PresentOrSwapped) != 0;
  }
  close(File);
  return Touched;
}

static bool isAllZero(const uint8_t *Begin, size_t Bytes) {
  return std::all_of(Begin, Begin + Bytes, [](uint8_t Byte) { return !Byte; });
}

void HostPages::serialize(Archive &A) {
  constexpr uint64_t NoPage = ~uint64_t(0);
  size_t Count = (Bytes + PageBytes - 1) / PageBytes;
  auto sizeOf = [&](uint64_t Page) {
    return std::min(PageBytes, Bytes - Page * PageBytes);
  };
  std::vector<bool> Touched = touchedPages(Pages, Count);
  if (A.isRestoring()) {
    for (uint64_t Page = 0; Page != Count; ++Page)
      if (Touched[Page])
        std::memset(Pages + Page * PageBytes, 0, sizeOf(Page));
    uint64_t Page, Next = 0;
    for (; A(Page), Page >= Next && Page < Count; Next = Page + 1)
      A.bytes(Pages + Page * PageBytes, sizeOf(Page));
    return;
  }
  for (uint64_t Page = 0; Page != Count; ++Page) {
    uint8_t *Begin = Pages + Page * PageBytes;
    if (!Touched[Page] || isAllZero(Begin, sizeOf(Page)))
      continue;
    A(Page);
    A.bytes(Begin, sizeOf(Page));
  }
  uint64_t End = NoPage;
  A(End);
}

HostPages::~HostPages() {
  if (Pages)
    munmap(Pages, Bytes);
}

} // namespace tp
