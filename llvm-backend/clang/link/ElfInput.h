//===- ElfInput.h - Sections and symbols of the linker's inputs -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_ELFINPUT_H
#define TP_LLVM_BACKEND_CLANG_LINK_ELFINPUT_H

#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Object/ELF.h"
#include "llvm/Support/MemoryBufferRef.h"

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace tp {

using ElfType = llvm::object::ELF32LE;

class ElfObject;
struct OutputSection;

/// A section of one object.
struct InputSection {
  ElfObject *File = nullptr;
  llvm::StringRef Name;
  uint32_t Type = 0;
  uint32_t Flags = 0;
  uint32_t Alignment = 1;
  uint32_t Size = 0;
  /// Empty for a section without bytes in the file (.bss).
  llvm::ArrayRef<uint8_t> Bytes;
  llvm::ArrayRef<ElfType::Rela> Relocations;
  /// Whether it reaches the program; garbage collection decides.
  bool Live = false;
  OutputSection *Output = nullptr;
  uint32_t OutputOffset = 0;

  bool isAllocated() const { return Flags & llvm::ELF::SHF_ALLOC; }
  bool isThreadLocal() const { return Flags & llvm::ELF::SHF_TLS; }
  bool isCode() const { return Flags & llvm::ELF::SHF_EXECINSTR; }
  bool isZeroFilled() const { return Type == llvm::ELF::SHT_NOBITS; }
  /// The address of the section's byte \p Offset; for a section that is not
  /// loaded, its place in the output section.
  uint32_t address(uint32_t Offset) const;
};

/// A symbol: local to one object, or shared by all.
struct Symbol {
  llvm::StringRef Name;
  /// The defining object; null if undefined or defined by the linker.
  ElfObject *File = nullptr;
  /// Null if undefined or absolute.
  InputSection *Section = nullptr;
  uint32_t Value = 0;
  uint32_t Size = 0;
  uint8_t Type = llvm::ELF::STT_NOTYPE;
  uint8_t Binding = llvm::ELF::STB_GLOBAL;
  uint8_t Visibility = llvm::ELF::STV_DEFAULT;
  bool Defined = false;
  /// A tentative definition of Size bytes with alignment Value.
  bool Common = false;
  /// Whether all references are weak, so that it need not be defined.
  bool WeaklyReferenced = true;

  bool isWeak() const { return Binding == llvm::ELF::STB_WEAK; }
  uint32_t address() const;
};

/// The global symbols of a program.
class SymbolTable {
public:
  /// The symbol \p Name, made if it is new.
  Symbol &get(llvm::StringRef Name);
  /// Null if no object names it.
  Symbol *find(llvm::StringRef Name) const;

  /// Takes a definition from an object: the first strong one wins, then common
  /// ones (the largest), then weak ones.
  void define(const Symbol &Definition, LinkDiagnostics &Diags);

  /// In the order in which the names first appeared.
  const std::deque<Symbol> &symbols() const { return Symbols; }
  std::deque<Symbol> &symbols() { return Symbols; }

private:
  std::deque<Symbol> Symbols;
  llvm::StringMap<Symbol *> ByName;
};

/// One relocatable object of the TP.
class ElfObject {
public:
  /// Reads the object \p Buffer; its definitions go to \p Globals.
  /// \p ComdatGroups are the groups that earlier objects have brought.
  /// \returns null after an error.
  static std::unique_ptr<ElfObject> read(llvm::MemoryBufferRef Buffer,
                                         llvm::StringRef DisplayName,
                                         SymbolTable &Globals,
                                         llvm::StringSet<> &ComdatGroups,
                                         LinkDiagnostics &Diags);

  const std::string &name() const { return Name; }
  const std::vector<std::unique_ptr<InputSection>> &sections() const {
    return Sections;
  }
  /// Symbol number \p Index of the object's table; null for number 0.
  Symbol *symbol(uint32_t Index) const {
    return Index < Symbols.size() ? Symbols[Index] : nullptr;
  }
  size_t symbolCount() const { return Symbols.size(); }
  const std::deque<Symbol> &locals() const { return Locals; }

  /// `name:(function+0x10)`: where byte \p Offset of \p Section is, for
  /// messages.
  std::string describePlace(const InputSection &Section, uint32_t Offset) const;
  /// The symbol that contains byte \p Offset of \p Section, or null.
  const Symbol *enclosingSymbol(const InputSection &Section,
                                uint32_t Offset) const;
  /// Makes the section that holds a common symbol.
  InputSection *addCommonSection(Symbol &Definition);

private:
  using File = llvm::object::ELFFile<ElfType>;

  explicit ElfObject(llvm::StringRef Name) : Name(Name) {}
  llvm::Error readAll(const File &Elf, SymbolTable &Globals,
                      llvm::StringSet<> &ComdatGroups, LinkDiagnostics &Diags);
  llvm::Error readSections(const File &Elf, llvm::StringSet<> &ComdatGroups);
  llvm::Error decompress(InputSection &Section);
  llvm::Error readGroup(const File &Elf, const ElfType::Shdr &Header,
                        llvm::StringSet<> &ComdatGroups,
                        std::vector<bool> &Dropped);
  llvm::Error readSymbols(const File &Elf, SymbolTable &Globals,
                          LinkDiagnostics &Diags);

  std::string Name;
  /// By section number; null for sections that the linker drops or consumes.
  std::vector<std::unique_ptr<InputSection>> Sections;
  std::vector<Symbol *> Symbols;
  std::deque<Symbol> Locals;
  /// The bytes of sections that are compressed in the file.
  std::deque<llvm::SmallVector<uint8_t, 0>> Decompressed;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_ELFINPUT_H
