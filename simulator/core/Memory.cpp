//===- Memory.cpp - The chip's global memory ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Memory.h"

#include <sys/mman.h>

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

HostPages::~HostPages() {
  if (Pages)
    munmap(Pages, Bytes);
}

} // namespace tp
