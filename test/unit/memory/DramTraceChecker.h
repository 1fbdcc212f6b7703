//===- DramTraceChecker.h - DRAM commands against all timing rules *- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_MEMORY_DRAMTRACECHECKER_H
#define TP_TEST_UNIT_MEMORY_DRAMTRACECHECKER_H

#include "simulator/memory/dram/DramDevice.h"

#include <string>
#include <vector>

namespace tp {

/// Every broken rule in a channel's commands, as a line each. Looks at each
/// pair of commands, as the data sheets state the rules, and knows nothing of
/// how the channel keeps them.
std::vector<std::string> brokenRules(const DramConfig &Config,
                                     const std::vector<DramCommand> &Commands);

} // namespace tp

#endif // TP_TEST_UNIT_MEMORY_DRAMTRACECHECKER_H
