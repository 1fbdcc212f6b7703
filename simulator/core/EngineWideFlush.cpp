//===- EngineWideFlush.cpp - Engine for wide resource words, flush to zero ===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/WindowEngine.h"

namespace tp {

template std::unique_ptr<EngineImplementation>
makeEngine<WideWord, true>(const ChipConfig &, const Program &, Memory &,
                           const ResourceLayout &,
                           std::unique_ptr<MemorySystem>);

} // namespace tp
