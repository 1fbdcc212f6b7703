//===- ObjectInput.h - A TP object or executable ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_OBJECTINPUT_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_OBJECTINPUT_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Object/ELFObjectFile.h"
#include "llvm/Support/Error.h"
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// A symbol with a name; section and file symbols included.
struct Symbol {
  llvm::StringRef Name;
  /// Offset in the section in an object, address in an executable.
  uint32_t Value;
  uint32_t Size;
  uint8_t Type;
  uint8_t Binding;
  /// Index of the section, or one of the special indices (ELF::SHN_*).
  uint32_t Section;
};

struct Relocation {
  /// Offset in the section.
  uint32_t Offset;
  uint32_t Type;
  int32_t Addend;
  /// Index into ObjectInput::symbols(), if there is a symbol.
  std::optional<size_t> SymbolIndex;
};

struct Section {
  llvm::StringRef Name;
  uint32_t Index;
  uint32_t Address;
  uint32_t Size;
  uint32_t Type;
  uint32_t Flags;
  /// Nothing for sections without bytes in the file.
  llvm::ArrayRef<uint8_t> Contents;
  /// By offset.
  std::vector<Relocation> Relocations;

  bool isCode() const;
};

/// The sections, symbols and relocations of a TP ELF file, all checked to lie
/// in the file.
class ObjectInput {
public:
  /// Errors are about the file itself; the caller names it.
  static llvm::Expected<ObjectInput> open(llvm::StringRef Path);

  llvm::ArrayRef<Section> sections() const { return Sections; }
  llvm::ArrayRef<Symbol> symbols() const { return Symbols; }
  /// Whether it still has to be linked.
  bool isRelocatable() const;
  const llvm::object::ELF32LEObjectFile &file() const { return *File; }

  /// The symbols at each address of a section, without section symbols;
  /// functions and globals first.
  using SymbolsByAddress = std::multimap<uint32_t, const Symbol *>;
  const SymbolsByAddress &symbolsOf(const Section &Section) const;

  /// `<symbol+0x8>` for an address of the section, or an empty string if no
  /// symbol stands at or before it.
  std::string nameOf(const Section &Section, uint32_t Address) const;
  /// The section that holds an address of an executable, or null.
  const Section *sectionAt(uint32_t Address) const;
  /// A relocation's target as `symbol+0x8`.
  std::string targetOf(const Relocation &Relocation) const;

private:
  llvm::Error readSymbols();
  llvm::Error readSections();

  std::unique_ptr<llvm::MemoryBuffer> Buffer;
  std::unique_ptr<llvm::object::ELF32LEObjectFile> File;
  std::vector<Section> Sections;
  std::vector<Symbol> Symbols;
  std::map<uint32_t, SymbolsByAddress> SymbolsBySection;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_OBJECTINPUT_H
