//===- LocalStore.cpp - Memory that stands for local stores ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/host/HostRuntime.h"
#include "tp/local_store.h"
#include <memory>
#include <new>

namespace tp {

namespace {

constexpr std::align_val_t BufferAlignment{16};

struct DeleteBuffer {
  void operator()(char *Buffer) const {
    ::operator delete(Buffer, BufferAlignment);
  }
};

struct LocalStore {
  std::unique_ptr<char, DeleteBuffer> Buffer;
  uint32_t Bytes = 0;
};

uint32_t BytesOfEach = host::kDefaultLocalStoreBytes;
thread_local LocalStore Mine;

} // namespace

void host::setLocalStoreBytes(uint32_t Bytes) { BytesOfEach = Bytes; }

uint32_t localStoreBytes() { return BytesOfEach; }

LocalStoreSpace freeLocalStore() {
  if (!Mine.Buffer || Mine.Bytes != BytesOfEach) {
    Mine.Buffer.reset(
        static_cast<char *>(::operator new(BytesOfEach, BufferAlignment)));
    Mine.Bytes = BytesOfEach;
  }
  return {Mine.Buffer.get(), Mine.Bytes};
}

} // namespace tp
