//===- FloatingPointResolver.h - Which option decides what ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_FLOATINGPOINTRESOLVER_H
#define TP_LLVM_BACKEND_CLANG_FLOATINGPOINTRESOLVER_H

#include "llvm-backend/clang/CommandLineOption.h"
#include "llvm-backend/clang/FloatingPointSettings.h"

#include <optional>
#include <string>

namespace tp {

/// Finds out how command lines treat floating point: asks clang's driver for
/// the front end's arguments and the front end for what they mean.
class FloatingPointResolver {
public:
  explicit FloatingPointResolver(std::string ToolPath)
      : ToolPath(std::move(ToolPath)) {}

  /// The settings under \p Options, before translation of tpcc's own.
  /// \returns nothing if the options are wrong or incomplete.
  std::optional<FloatingPointSettings>
  resolve(llvm::ArrayRef<CommandLineOption> Options) const;

  /// As above, with \p More words behind \p Options.
  std::optional<FloatingPointSettings>
  resolve(llvm::ArrayRef<CommandLineOption> Options,
          llvm::ArrayRef<const char *> More) const;

private:
  std::string ToolPath;
};

/// The settings of a command line, and for each the option that decided it.
struct FloatingPointDecisions {
  FloatingPointSettings Settings;
  /// Index of the last option that sets the property, if any does.
  std::array<std::optional<size_t>, NumFloatingPointProperties> Deciders;

  std::optional<size_t> decider(FloatingPointProperty Property) const {
    return Deciders[static_cast<size_t>(Property)];
  }
};

/// Finds what \p Options decide, by resolving the command line option by
/// option.
/// \returns nothing if the options are wrong.
std::optional<FloatingPointDecisions>
decideFloatingPoint(const FloatingPointResolver &Resolver,
                    llvm::ArrayRef<CommandLineOption> Options);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_FLOATINGPOINTRESOLVER_H
