//===- Sysroot.h - Where tpcc finds headers and the runtime -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_SYSROOT_H
#define TP_LLVM_BACKEND_CLANG_SYSROOT_H

#include "llvm/ADT/StringRef.h"

#include <string>
#include <vector>

namespace tp {

/// The folders around an installed or built tpcc.
class Sysroot {
public:
  /// \param ToolPath the path of the running tpcc, its symlinks resolved.
  explicit Sysroot(llvm::StringRef ToolPath);

  /// `<folder of tpcc>/../lib/tp`.
  const std::string &root() const { return Root; }

  /// The runtime that every program is linked with unless -nostdlib says
  /// otherwise.
  std::string runtimeBitcode() const;

  /// Headers of the C library and of the TP's own interfaces.
  std::string runtimeHeaders() const;

  /// The folders of the C++ library in the order of the search: what adapts
  /// libstdc++ to the TP, then libstdc++ itself.
  std::vector<std::string> cxxHeaders() const;

  /// Clang's resource folder (the compiler's own headers).
  static std::string resourceFolder();

private:
  std::string Root;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_SYSROOT_H
