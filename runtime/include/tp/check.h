//===- check.h - What a program tells tpsim --check -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Messages of an allocator to the checkers of a run, on profile markers that
// are kept for them. They take no time on the chip, and nothing happens on the
// host. Memory accesses do not move across them. The runtime's malloc and what
// the compiler adds for -ftp-check-objects send them; an allocator of one's own
// may, too, for blocks at multiples of 8 in memory that is not of the runtime's
// heap.
//
//===----------------------------------------------------------------------===//

#ifndef TP_CHECK_H
#define TP_CHECK_H

#include <stddef.h>
#include <stdint.h>

namespace tp {

/// A global with bytes behind it that are nobody's: up to the next multiple of
/// 8, and PaddingBytes of a CheckedObject. -ftp-check-objects makes arrays of
/// these, which have the name CheckedGlobalsSymbol.
struct CheckedGlobal {
  uint32_t Address;
  uint32_t Bytes;
};

inline constexpr char CheckedGlobalsSymbol[] = "__tp_checked_globals";

/// What the runtime's heap does for the checkers. The simulator finds the
/// symbol HeapCheckSettingsSymbol of a program that uses the heap and fills it
/// before the start; else it is 0.
struct HeapCheckSettings {
  /// Unused bytes behind each block, a multiple of 8.
  uint32_t PaddingBytes;
  /// Blocks given back are not used again until so many bytes of others have
  /// been given back after them.
  uint32_t RetiredBytes;
};

inline constexpr char HeapCheckSettingsSymbol[] = "__tp_heap_checks";

/// Profile markers that are messages.
enum class CheckMessage : uint32_t {
  /// The thread works on the allocator's own data from here on, for a request
  /// of so many bytes. May be nested.
  AllocatorEntered = 0xFF00,
  /// The request was granted at this address, or was not (0); the innermost
  /// work on the allocator is over.
  Allocated = 0xFF01,
  /// The block at this address is given back.
  Freeing = 0xFF02,
  /// The block at this address now has the bytes of the request; the innermost
  /// work on the allocator is over.
  Resized = 0xFF03,
  /// The innermost work on the allocator is over.
  AllocatorLeft = 0xFF04,
  /// The next message is about the object of the stack that the CheckedObject
  /// at this address describes.
  StackObject = 0xFF05,
  /// Its bytes, if the CheckedObject does not say it. Comes between the two.
  ObjectBytes = 0xFF08,
  /// It begins to live at this address.
  ObjectBegins = 0xFF06,
  /// It ceases to live at this address.
  ObjectEnds = 0xFF07,
};

/// An object of the stack. The bytes before and behind it are nobody's.
struct CheckedObject {
  /// VariableBytes if each message says it.
  uint32_t Bytes;
  /// Address of its name, zero-terminated.
  uint32_t Name;

  /// The object behind the padding begins at a multiple of 8.
  static constexpr uint32_t PaddingBytes = 16;
  static constexpr uint32_t VariableBytes = 0xFFFFFFFF;
};

/// Its callers are where the message comes from.
#define TP_CHECK_MESSAGE __attribute__((always_inline, nodebug)) inline

/// Sends a message of the above.
template <CheckMessage Message>
TP_CHECK_MESSAGE void tellChecker([[maybe_unused]] uint32_t Value) {
#ifdef __tp__
  __asm__ volatile("profv %0, %1"
                   :
                   : "i"(uint32_t(Message)), "r"(Value)
                   : "memory");
#endif
}

#ifdef __tp__

/// Brackets an allocator's work.
TP_CHECK_MESSAGE void allocatorEntered(size_t Bytes) {
  tellChecker<CheckMessage::AllocatorEntered>(Bytes);
}
TP_CHECK_MESSAGE void *allocated(void *Memory) {
  tellChecker<CheckMessage::Allocated>(reinterpret_cast<uint32_t>(Memory));
  return Memory;
}
TP_CHECK_MESSAGE void freeing(void *Memory) {
  tellChecker<CheckMessage::Freeing>(reinterpret_cast<uint32_t>(Memory));
}
TP_CHECK_MESSAGE void *resized(void *Memory) {
  tellChecker<CheckMessage::Resized>(reinterpret_cast<uint32_t>(Memory));
  return Memory;
}
TP_CHECK_MESSAGE void allocatorLeft() {
  tellChecker<CheckMessage::AllocatorLeft>(0);
}

#endif

#undef TP_CHECK_MESSAGE

} // namespace tp

#endif // TP_CHECK_H
