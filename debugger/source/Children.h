//===- Children.h - What a value consists of --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_CHILDREN_H
#define TP_DEBUGGER_SOURCE_CHILDREN_H

#include "debugger/source/Value.h"

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/ADT/StringRef.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// Elements that follow each other in memory.
struct Sequence {
  const Type *Element = nullptr;
  uint32_t Count = 0;
  /// The first one; invalid if Count is 0.
  Value First;

  Value at(uint32_t Index) const;
};

/// The elements of an array, a vector of the compiler or one of the library's
/// containers that keep theirs so (std::array, span, vector, string_view,
/// string, initializer_list); nothing for other types.
llvm::Expected<std::optional<Sequence>> elementsOf(const Value &Of,
                                                   const FrameContext &Frame);

/// How many parts children() has in all: members and bases of a structure,
/// elements of an array, what a pointer or reference points to.
uint32_t childCount(const Value &Of, const FrameContext &Frame);

/// Parts \p First to \p First + \p Count of a value: a structure's bases, then
/// members; an array's elements; one for a pointer or reference to something
/// that is not void or a function.
llvm::Expected<std::vector<NamedValue>> children(const Value &Of,
                                                 const FrameContext &Frame,
                                                 uint32_t First = 0,
                                                 uint32_t Count = uint32_t(-1));

/// The object that a pointer or reference points to.
llvm::Expected<Value> pointee(const Value &Of, const FrameContext &Frame);

/// The member \p Name of a structure, of its bases or of the anonymous
/// structures and unions in it; nothing if there is none. The error says why
/// a virtual base cannot be found.
llvm::Expected<std::optional<Value>>
findMember(const Value &Of, llvm::StringRef Name, const FrameContext &Frame);

/// The object \p Of or that of its bases whose class \p IsWanted; nothing if
/// there is none. Errors as findMember().
llvm::Expected<std::optional<Value>>
findBase(const Value &Of, llvm::function_ref<bool(const Type &)> IsWanted,
         const FrameContext &Frame);

/// The object \p Of as its base class \p To, or as \p To of which it is the
/// base; nothing if the classes are not related so. Errors as findMember().
llvm::Expected<std::optional<Value>>
asRelatedClass(const Value &Of, const Type &To, const FrameContext &Frame);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_CHILDREN_H
