//===- LaunchArguments.cpp - A program's arguments in its memory ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/LaunchArguments.h"

namespace tp {

/// Copies \p Bytes bytes to new memory; 0 if there is no room.
static DeviceAddress place(const void *Source, size_t Bytes, uint32_t Alignment,
                           LaunchMemory &Memory) {
  const DeviceAddress Address = Memory.allocate(Bytes, Alignment);
  if (Address)
    Memory.write(Address, Source, Bytes);
  return Address;
}

Status placeArguments(const std::vector<std::string> &Arguments,
                      LaunchMemory &Memory, LaunchBlock &Launch) {
  const Error NoRoom{"the program's arguments do not fit in the chip's memory"};
  std::vector<DeviceAddress> Pointers;
  for (const std::string &Argument : Arguments) {
    Pointers.push_back(place(Argument.c_str(), Argument.size() + 1, 1, Memory));
    if (!Pointers.back())
      return NoRoom;
  }
  Pointers.push_back(0);
  Launch.ArgumentCount = uint32_t(Arguments.size());
  Launch.Arguments =
      place(Pointers.data(), Pointers.size() * sizeof(DeviceAddress),
            sizeof(DeviceAddress), Memory);
  if (!Launch.Arguments)
    return NoRoom;
  return success();
}

} // namespace tp
