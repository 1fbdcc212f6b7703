//===- EngineMedium.cpp - Engine for 128-bit resource words ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/WindowEngine.h"

namespace tp {

template std::unique_ptr<EngineImplementation>
makeEngine<unsigned __int128, false>(const ChipConfig &, const Program &,
                                     Memory &, const ResourceLayout &,
                                     std::unique_ptr<MemorySystem>);

} // namespace tp
