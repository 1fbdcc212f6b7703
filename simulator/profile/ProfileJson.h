//===- ProfileJson.h - A profile as a file ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_PROFILEJSON_H
#define TP_SIMULATOR_PROFILE_PROFILEJSON_H

#include "simulator/profile/Profile.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Raised when a name in the JSON changes its meaning or goes away.
inline constexpr int ProfileFormatVersion = 1;

/// Writes a profile as JSON; docs/profile.schema.json describes the names. The
/// text depends on the simulation and the sources only.
void writeProfile(const Profile &Data, llvm::raw_ostream &OS);

/// Reads what writeProfile() wrote. Errors begin with \p Name and say what is
/// wrong at which place.
llvm::Expected<Profile> parseProfile(llvm::StringRef Text,
                                     llvm::StringRef Name);

/// Likewise, from a file.
llvm::Expected<Profile> readProfile(const std::string &Path);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_PROFILEJSON_H
