//===- Layout.h - Addresses of a program's sections -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_LAYOUT_H
#define TP_LLVM_BACKEND_CLANG_LINK_LAYOUT_H

#include "llvm-backend/clang/link/ElfInput.h"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// Where a section goes; also the order of sections in memory.
enum class SectionClass {
  Code,
  ReadOnly,
  InitArray,
  FiniArray,
  Data,
  /// Lies in the local store; its initial bytes lie in global memory.
  ThreadLocalData,
  ZeroFilled,
  ThreadLocalZeroFilled,
  /// Not in memory (debug data).
  NotLoaded,
};

/// A section of the program.
struct OutputSection {
  std::string Name;
  SectionClass Class = SectionClass::NotLoaded;
  uint32_t Type = 0;
  uint32_t Flags = 0;
  uint32_t Alignment = 1;
  uint32_t Size = 0;
  /// Where the program sees the section; 0 if it is not loaded.
  uint32_t Address = 0;
  /// Where the section's bytes are loaded: Address, but for .tdata the place of
  /// the initial values in global memory.
  uint32_t LoadAddress = 0;
  std::vector<InputSection *> Inputs;

  bool isZeroFilled() const { return Type == llvm::ELF::SHT_NOBITS; }
};

/// A program laid out in memory.
struct Layout {
  /// In the order of the file.
  std::vector<std::unique_ptr<OutputSection>> Sections;

  uint32_t ThreadLocalBegin = 0;
  uint32_t ThreadLocalDataImage = 0;
  uint32_t ThreadLocalDataSize = 0;
  uint32_t ThreadLocalZeroFilledSize = 0;
  uint32_t ThreadLocalAlignment = 1;
  /// The first address behind the program in global memory.
  uint32_t ImageEnd = 0;

  /// Null if the program has no such section.
  const OutputSection *find(llvm::StringRef Name) const;
};

/// Gathers the live sections of \p Objects into output sections and gives them
/// addresses (see MemoryMap.h). Reports a program that does not fit.
Layout layOut(llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
              LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_LAYOUT_H
