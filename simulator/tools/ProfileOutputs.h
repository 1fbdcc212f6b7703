//===- ProfileOutputs.h - What is written of a profile ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_PROFILEOUTPUTS_H
#define TP_SIMULATOR_TOOLS_PROFILEOUTPUTS_H

#include "simulator/profile/Profile.h"
#include "simulator/tools/Options.h"

#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Writes the files that \p Request names.
llvm::Error writeProfileFiles(const Profile &Data,
                              const ProfileRequest &Request);

/// Writes files and, to standard output, the table of the profile that
/// Request.Input is.
llvm::Error showProfile(const ProfileRequest &Request);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_PROFILEOUTPUTS_H
