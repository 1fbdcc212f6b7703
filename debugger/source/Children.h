//===- Children.h - What a value consists of --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_CHILDREN_H
#define TP_DEBUGGER_SOURCE_CHILDREN_H

#include "debugger/source/Value.h"

#include <cstdint>
#include <vector>

namespace tp {

class TypeTable;

/// How many parts children() has in all: members and bases of a structure,
/// elements of an array, what a pointer or reference points to.
uint32_t childCount(const Value &Of);

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
/// structures and unions in it; nothing if there is none.
std::optional<Value> findMember(const Value &Of, llvm::StringRef Name);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_CHILDREN_H
