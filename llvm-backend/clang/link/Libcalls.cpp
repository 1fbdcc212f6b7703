//===- Libcalls.cpp - Functions that the compiler calls by itself ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/Libcalls.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Analysis/TargetLibraryInfo.h"
#include "llvm/IR/RuntimeLibcalls.h"
#include "llvm/TargetParser/Triple.h"

using namespace llvm;

namespace tp {

static StringSet<> codeGeneratorCalls() {
  StringSet<> Names;
  for (RTLIB::LibcallImpl Implementation : RTLIB::libcall_impls())
    Names.insert(
        RTLIB::RuntimeLibcallsInfo::getLibcallImplName(Implementation));
  return Names;
}

bool isLibraryFunction(StringRef Name) {
  static const StringSet<> CodeGeneratorCalls = codeGeneratorCalls();
  static const TargetLibraryInfoImpl Library{Triple(llvm::TPTriple)};
  LibFunc Function;
  return CodeGeneratorCalls.contains(Name) ||
         Library.getLibFunc(Name, Function);
}

} // namespace tp
