//===- ElfProgram.h - A TP program as an ELF file ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_LOADER_ELFPROGRAM_H
#define TP_SIMULATOR_LOADER_ELFPROGRAM_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Object/ObjectFile.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/MemoryBuffer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A part of the program's image in global memory.
struct Segment {
  uint32_t Address = 0;
  /// Bytes in memory; those after the end of Contents are zero.
  uint32_t Size = 0;
  llvm::ArrayRef<uint8_t> Contents;
  bool Executable = false;

  uint64_t end() const { return uint64_t(Address) + Size; }
};

/// A part of the program's text.
struct AddressRange {
  uint32_t Begin = 0;
  uint32_t End = 0;
};

/// A load or store that is atomic, or an atomic instruction that is not meant
/// for its whole word.
struct AtomicAccess {
  uint32_t Address = 0;
  /// A load with the order of an acquire operation.
  bool Acquires = false;
  /// Of the word only those bytes are meant that change.
  bool IsPartOfWord = false;
};

/// An executable that has been checked: everything in it can be used as it is.
class ElfProgram {
public:
  /// Reads and checks the executable \p Path. Errors begin with the path and
  /// say what to do: not an ELF file, cut off, for another machine, not
  /// linked, segments that overlap, an entry outside the code.
  static llvm::Expected<ElfProgram> load(llvm::StringRef Path);

  /// Checks that the image fits into a global memory that ends at
  /// \p MemoryBytes, and the stack, if it has a limit, into a local store of
  /// \p LocalStoreBytes.
  llvm::Error checkFits(uint64_t MemoryBytes, uint32_t LocalStoreBytes) const;

  const std::string &path() const { return Path; }
  uint32_t entry() const { return Entry; }
  llvm::ArrayRef<Segment> segments() const { return Segments; }
  /// The one executable segment.
  const Segment &text() const { return Segments[TextIndex]; }
  /// First address behind all segments.
  uint64_t imageEnd() const;
  /// Address of a symbol of the file's symbol table.
  std::optional<uint32_t> symbol(llvm::StringRef Name) const;
  /// The lowest address that the stack may reach, of a program that asks the
  /// linker for it.
  std::optional<uint32_t> stackLimit() const;
  /// The functions that were compiled with floating-point checks.
  llvm::ArrayRef<AddressRange> floatChecked() const { return FloatChecked; }
  /// What the compiler says of atomic accesses in the code.
  llvm::ArrayRef<AtomicAccess> atomicAccesses() const { return AtomicAccesses; }
  /// The whole file, for debug information.
  const llvm::object::ObjectFile &object() const { return *Object; }

private:
  std::string Path;
  std::unique_ptr<llvm::MemoryBuffer> Buffer;
  std::unique_ptr<llvm::object::ObjectFile> Object;
  uint32_t Entry = 0;
  std::vector<Segment> Segments;
  size_t TextIndex = 0;
  llvm::StringMap<uint32_t> Symbols;
  std::vector<AddressRange> FloatChecked;
  std::vector<AtomicAccess> AtomicAccesses;

  llvm::Error readHeader();
  llvm::Error readSegments();
  llvm::Error readSymbols();
  llvm::Error readFloatChecked();
  llvm::Error readAtomicAccesses();
  /// The words of a section that lists entries of so many; none without it.
  llvm::Expected<llvm::ArrayRef<llvm::support::ulittle32_t>>
  readWords(llvm::StringRef SectionName, size_t EntryWords) const;
  llvm::Error error(const llvm::Twine &What) const;
};

} // namespace tp

#endif // TP_SIMULATOR_LOADER_ELFPROGRAM_H
