//===- CompareRuns.h - tpsim --compare --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_COMPARERUNS_H
#define TP_SIMULATOR_TOOLS_COMPARERUNS_H

#include "simulator/tools/Options.h"

namespace tp {

/// Compares the two runs that \p Request names: a table on standard output, and
/// JSON if asked for. If that goes to standard output there is no table.
llvm::Error compareRuns(const ComparisonRequest &Request);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_COMPARERUNS_H
