//===- InfinityAssumptions.cpp - Units that disagree about infinities -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/InfinityAssumptions.h"
#include "llvm/Object/ObjectFile.h"

using namespace llvm;
using namespace llvm::object;

namespace tp {

void InfinityAssumptions::add(const SmallVectorImpl<FloatingPointUnit> &Units) {
  for (const FloatingPointUnit &Unit : Units) {
    std::optional<std::string> &First =
        Unit.IsFinite ? FirstFinite : FirstHonouring;
    if (!First)
      First = Unit.SourceFile;
  }
}

void InfinityAssumptions::add(const Module &Unit) {
  add(floatingPointUnits(Unit));
}

void InfinityAssumptions::add(MemoryBufferRef Object) {
  // The ELF linker reports what is wrong with the object.
  Expected<std::unique_ptr<ObjectFile>> File =
      ObjectFile::createObjectFile(Object);
  if (!File)
    return consumeError(File.takeError());
  for (const SectionRef &Section : (*File)->sections()) {
    Expected<StringRef> Name = Section.getName();
    Expected<StringRef> Contents = Section.getContents();
    if (Name && Contents && *Name == FloatingPointUnitsSection)
      add(decodeFloatingPointUnits(*Contents));
    consumeError(Name.takeError());
    consumeError(Contents.takeError());
  }
}

void InfinityAssumptions::report(const WarningOptions &Warnings,
                                 LinkDiagnostics &Diags) const {
  if (FirstFinite && FirstHonouring)
    Diags.report(Warnings, FloatingPointWarning::MixedInfinities,
                 "'" + *FirstFinite +
                     "' is compiled as if there were no NaN and infinities, "
                     "but '" +
                     *FirstHonouring +
                     "', which may hand it some, honours them; compile both "
                     "with the same floating-point options, or '" +
                     *FirstFinite +
                     "' with '-fno-finite-math-only' behind the others");
}

} // namespace tp
