//===- RayProfileText.h - A ray profile for people --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PROFILE_RAYPROFILETEXT_H
#define TP_KERNELS_PROFILE_RAYPROFILETEXT_H

#include "kernels/profile/RayProfile.h"

#include <string>

namespace tp {

/// A few lines: what rays visit and read from memory and, if there is a cache,
/// what became of it.
std::string describe(const RayProfile &Profile);

} // namespace tp

#endif // TP_KERNELS_PROFILE_RAYPROFILETEXT_H
