//===- RayEvents.h - What a tracer of rays reports --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_RAYEVENTS_H
#define TP_KERNELS_COMMON_RAYEVENTS_H

#include "kernels/common/Inline.h"
#include "tp/profile.h"

namespace tp {

/// The events of RayEvents.def; the number is the profile marker.
enum class RayEvent : uint32_t {
#define TP_RAY_EVENT(Name, Marker) Name = (Marker),
#include "kernels/common/RayEvents.def"
};

/// Values of RayEvent::RayBegin.
inline constexpr uint32_t kClosestHitRay = 0;
inline constexpr uint32_t kAnyHitRay = 1;

/// Reports \p Event, a constant, with its value; takes no time on the chip.
/// With TP_NO_RAY_EVENTS defined nothing is reported.
TP_KERNEL_INLINE void rayEvent([[maybe_unused]] RayEvent Event,
                               [[maybe_unused]] uint32_t Value) {
#ifndef TP_NO_RAY_EVENTS
  switch (Event) {
#define TP_RAY_EVENT(Name, Marker)                                             \
  case RayEvent::Name:                                                         \
    return profileValue<Marker>(Value);
#include "kernels/common/RayEvents.def"
  }
#endif
}

} // namespace tp

#endif // TP_KERNELS_COMMON_RAYEVENTS_H
