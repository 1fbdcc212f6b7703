//===- EngineNarrowFlush.cpp - Engine for 64-bit words, flush to zero -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/WindowEngine.h"

namespace tp {

template std::unique_ptr<EngineImplementation>
makeEngine<uint64_t, true>(const ChipConfig &, const Program &, Memory &,
                           const ResourceLayout &,
                           std::unique_ptr<MemorySystem>);

} // namespace tp
