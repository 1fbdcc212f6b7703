//===- ProfileNames.h - Names of what a profile counts ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_PROFILENAMES_H
#define TP_SIMULATOR_PROFILE_PROFILENAMES_H

#include "simulator/profile/Profile.h"

#include "llvm/ADT/StringRef.h"

#include <optional>
#include <string>

namespace tp {

/// Name of a level of memory in JSON, e.g. `l2`.
const char *levelName(ServedBy Level);

/// The level or loss of a name in JSON.
std::optional<ServedBy> findLevel(llvm::StringRef Name);
std::optional<Loss> findLoss(llvm::StringRef Name);

/// `function`, or what stands for one of which nothing is known.
std::string nameOf(const ProfileFunction &Function);

/// A demangled name without template arguments and parameters.
std::string shortName(llvm::StringRef Name);

/// `file:line` of a frame, as much as is known; the file without its
/// directory.
std::string placeOf(const Profile &Data, const ProfileFrame &Frame);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_PROFILENAMES_H
