//===- ObjectPlace.h - An address beside an object, in words ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_OBJECTPLACE_H
#define TP_SIMULATOR_CHECK_OBJECTPLACE_H

#include <cstdint>
#include <string>

namespace tp {

/// Such as "1 byte" and "40 bytes".
std::string inBytes(uint64_t Count);

/// Where \p Address lies seen from the object \p Name: "at the start of",
/// "8 bytes into", "right behind", "4 bytes before", and the name with the
/// object's size.
std::string describePlace(uint32_t Address, uint32_t Begin, uint64_t Bytes,
                          const std::string &Name);

} // namespace tp

#endif // TP_SIMULATOR_CHECK_OBJECTPLACE_H
