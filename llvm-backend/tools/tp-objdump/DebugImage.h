//===- DebugImage.h - An object laid out for its debug info -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_DEBUGIMAGE_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_DEBUGIMAGE_H

#include "llvm-backend/tools/tp-objdump/ObjectInput.h"

namespace tp {

/// A file whose debugging information LLVM's symbolizer can read. An executable
/// is that already. In an object all sections begin at 0 and the debug sections
/// are full of relocations, which LLVM cannot resolve for the TP; here it is a
/// copy with sections at addresses of their own and relocated debug sections.
class DebugImage {
public:
  explicit DebugImage(const ObjectInput &Input);

  const llvm::object::ObjectFile &file() const;

  /// Address in the image of a place in a section of the file.
  uint32_t addressOf(const Section &Section, uint32_t Address) const;

private:
  void layOut();
  void relocate(const Section &Section);

  const ObjectInput &Input;
  std::unique_ptr<llvm::WritableMemoryBuffer> Copy;
  std::unique_ptr<llvm::object::ELF32LEObjectFile> CopiedFile;
  /// By index of the section; empty for an executable.
  std::vector<uint32_t> Bases;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_DEBUGIMAGE_H
