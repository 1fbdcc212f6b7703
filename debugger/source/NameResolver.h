//===- NameResolver.h - What a name in an expression means ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_NAMERESOLVER_H
#define TP_DEBUGGER_SOURCE_NAMERESOLVER_H

#include "debugger/source/Value.h"
#include "debugger/source/Variables.h"

#include "llvm/ADT/StringRef.h"

#include <optional>

namespace tp {

class DebugInformation;

/// What a name means at one place of the program, for whichever thread is
/// there.
struct BoundName {
  uint32_t Pc = 0;
  unsigned InlineDepth = 0;
  enum NameKind : uint8_t {
    Variable,
    MemberOfThis,
    /// Of the object whose `this` a lambda holds.
    MemberOfCaptured,
    Constant
  } Kind = Constant;
  /// Variable, or `this`.
  VariableInfo Info;
  /// Constant: an enumerator, a function, a constant of a class.
  Value Fixed;

  bool isFor(const FrameContext &Frame) const {
    return Frame.lookupPc() == Pc && Frame.InlineDepth == InlineDepth;
  }
};

/// Looks names up as C++ does: blocks from the inside out, the function, the
/// members of `this`, then namespaces and classes; last, what is unique
/// anywhere.
class NameResolver {
public:
  /// \p Information must outlive the resolver.
  explicit NameResolver(DebugInformation &Information)
      : Information(Information) {}

  llvm::Expected<BoundName> bind(llvm::StringRef Name,
                                 const FrameContext &Frame) const;
  llvm::Expected<Value> value(const BoundName &Bound, llvm::StringRef Name,
                              const FrameContext &Frame) const;

  /// The member \p Name of \p Object, also a static one.
  llvm::Expected<Value> member(const Value &Object, llvm::StringRef Name,
                               const FrameContext &Frame) const;
  /// The static member of a class or of its bases, if there is one.
  llvm::Expected<std::optional<Value>>
  staticMember(const Type &Record, llvm::StringRef Name,
               const FrameContext &Frame) const;

private:
  DebugInformation &Information;

  bool isMemberName(const Type &Record, llvm::StringRef Name) const;
  std::optional<Value> enumerator(llvm::StringRef Name,
                                  const FrameContext &Frame) const;
  std::optional<Value> function(llvm::StringRef Name) const;
  llvm::Expected<std::optional<Value>>
  qualifiedMember(llvm::StringRef Name, const FrameContext &Frame) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_NAMERESOLVER_H
