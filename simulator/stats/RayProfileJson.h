//===- RayProfileJson.h - A ray profile for programs ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_RAYPROFILEJSON_H
#define TP_SIMULATOR_STATS_RAYPROFILEJSON_H

#include "kernels/profile/RayProfile.h"

#include "llvm/Support/JSON.h"

namespace tp {

/// Writes the attribute `ray_profile` of the object at hand;
/// docs/statistics.md lists the names. There must be a ray.
void writeRayProfile(const RayProfile &Profile, llvm::json::OStream &Json);

} // namespace tp

#endif // TP_SIMULATOR_STATS_RAYPROFILEJSON_H
