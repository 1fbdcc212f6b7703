//===- StackFiles.h - Profiles for viewers of stacks ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_STACKFILES_H
#define TP_SIMULATOR_PROFILE_STACKFILES_H

#include "simulator/profile/Profile.h"

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Writes a line for each stack: its functions from the outermost on,
/// separated by `;`, a space, its thread-cycles. The innermost frame is
/// `[issued]` or a loss. For flamegraph.pl, inferno and the like.
void writeFoldedStacks(const Profile &Data, llvm::raw_ostream &OS);

/// Writes a file for https://www.speedscope.app: thread-cycles by stack, in
/// one profile all of them, in others those issued and those of each loss.
void writeSpeedscope(const Profile &Data, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_STACKFILES_H
