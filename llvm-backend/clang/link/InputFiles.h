//===- InputFiles.h - Reads objects, bitcode and archives -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_INPUTFILES_H
#define TP_LLVM_BACKEND_CLANG_LINK_INPUTFILES_H

#include "llvm-backend/clang/link/ProgramLinker.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Object/Archive.h"

namespace tp {

/// What a link consists of, sorted by kind. Archives give the members that
/// define what is missing, in any order of the command line.
class InputFiles {
public:
  InputFiles(llvm::LLVMContext &Context, LinkDiagnostics &Diags)
      : Context(Context), Diags(Diags) {}

  void add(LinkInput Input);
  /// Takes members of archives until they resolve nothing any more.
  void resolveArchives();

  struct NamedUnit {
    std::string Name;
    std::unique_ptr<llvm::Module> Unit;
  };
  std::vector<NamedUnit> Units;
  /// The identifiers of the buffers are the names in messages.
  std::vector<llvm::MemoryBufferRef> Objects;

  /// All names that objects mention.
  llvm::StringSet<> MentionedByObjects;
  /// The names that objects define, with the name of the first such object.
  llvm::StringMap<std::string> DefinedByObjects;

private:
  struct Member {
    std::string Name;
    llvm::MemoryBufferRef Buffer;
    std::vector<std::string> Definitions;
    bool Taken = false;
  };

  void addBuffer(llvm::MemoryBufferRef Buffer);
  void addBitcode(llvm::MemoryBufferRef Buffer);
  void addObject(llvm::MemoryBufferRef Buffer);
  void addArchive(llvm::MemoryBufferRef Buffer, bool Whole);
  void noteSymbol(llvm::StringRef Name, bool IsDefined);
  void noteSymbols(const llvm::Module &Unit);
  std::vector<std::string> definitionsOf(llvm::MemoryBufferRef Buffer);

  llvm::LLVMContext &Context;
  LinkDiagnostics &Diags;
  std::vector<std::unique_ptr<llvm::MemoryBuffer>> Buffers;
  std::vector<std::unique_ptr<llvm::object::Archive>> Archives;
  std::vector<Member> Members;
  std::vector<std::unique_ptr<std::string>> MemberNames;
  llvm::StringSet<> Defined, Missing;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_INPUTFILES_H
