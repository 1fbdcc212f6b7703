//===- InputFiles.cpp - Reads objects, bitcode and archives ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/InputFiles.h"
#include "llvm/BinaryFormat/Magic.h"
#include "llvm/Bitcode/BitcodeReader.h"
#include "llvm/Object/ModuleSymbolTable.h"
#include "llvm/Object/SymbolicFile.h"

using namespace llvm;
using namespace llvm::object;

namespace tp {

void InputFiles::noteSymbol(StringRef Name, bool IsDefined) {
  if (IsDefined) {
    Defined.insert(Name);
    Missing.erase(Name);
  } else if (!Defined.contains(Name)) {
    Missing.insert(Name);
  }
}

void InputFiles::noteSymbols(const Module &Unit) {
  for (const GlobalValue &Global : Unit.global_values())
    if (!Global.hasLocalLinkage() && !Global.hasExternalWeakLinkage())
      noteSymbol(Global.getName(), !Global.isDeclaration());
  ModuleSymbolTable::CollectAsmSymbols(
      Unit, [&](StringRef Name, BasicSymbolRef::Flags Flags) {
        noteSymbol(Name, !(Flags & BasicSymbolRef::SF_Undefined));
      });
}

void InputFiles::add(LinkInput Input) {
  if (Input.Unit) {
    noteSymbols(*Input.Unit);
    Units.push_back({std::move(Input.Name), std::move(Input.Unit)});
    return;
  }
  auto Buffer = MemoryBuffer::getFile(Input.Path, /*IsText=*/false,
                                      /*RequiresNullTerminator=*/false);
  if (std::error_code Failure = Buffer.getError()) {
    Diags.error("cannot read '" + Input.Path + "': " + Failure.message());
    return;
  }
  MemberNames.push_back(std::make_unique<std::string>(Input.Name));
  MemoryBufferRef Contents((*Buffer)->getBuffer(), *MemberNames.back());
  Buffers.push_back(std::move(*Buffer));
  if (identify_magic(Contents.getBuffer()) == file_magic::archive)
    addArchive(Contents, Input.WholeArchive);
  else
    addBuffer(Contents);
}

void InputFiles::addBuffer(MemoryBufferRef Buffer) {
  switch (identify_magic(Buffer.getBuffer())) {
  case file_magic::bitcode:
    return addBitcode(Buffer);
  case file_magic::elf:
  case file_magic::elf_relocatable:
  case file_magic::elf_executable:
  case file_magic::elf_shared_object:
  case file_magic::elf_core:
    return addObject(Buffer);
  default:
    Diags.error(Buffer.getBufferIdentifier() +
                ": is no object, bitcode or archive; name a source file by "
                "its usual ending or use -x <language>");
  }
}

void InputFiles::addBitcode(MemoryBufferRef Buffer) {
  Expected<std::unique_ptr<Module>> Unit = parseBitcodeFile(Buffer, Context);
  if (!Unit) {
    Diags.error(Buffer.getBufferIdentifier() + ": " +
                toString(Unit.takeError()));
    return;
  }
  noteSymbols(**Unit);
  Units.push_back({Buffer.getBufferIdentifier().str(), std::move(*Unit)});
}

void InputFiles::addObject(MemoryBufferRef Buffer) {
  Objects.push_back(Buffer);
  // The ELF linker reports what is wrong with the object.
  Expected<std::unique_ptr<SymbolicFile>> File =
      SymbolicFile::createSymbolicFile(Buffer);
  if (!File) {
    consumeError(File.takeError());
    return;
  }
  for (const BasicSymbolRef &Symbol : (*File)->symbols()) {
    Expected<uint32_t> Flags = Symbol.getFlags();
    std::string Name;
    raw_string_ostream Stream(Name);
    if (!Flags) {
      consumeError(Flags.takeError());
      continue;
    }
    if (Error Failure = Symbol.printName(Stream)) {
      consumeError(std::move(Failure));
      continue;
    }
    if (!(*Flags & BasicSymbolRef::SF_Global))
      continue;
    bool IsDefined = !(*Flags & BasicSymbolRef::SF_Undefined);
    MentionedByObjects.insert(Name);
    if (IsDefined && !(*Flags & BasicSymbolRef::SF_Weak))
      DefinedByObjects.try_emplace(Name, Buffer.getBufferIdentifier());
    if (IsDefined || !(*Flags & BasicSymbolRef::SF_Weak))
      noteSymbol(Name, IsDefined);
  }
}

//===----------------------------------------------------------------------===//
// Archives
//===----------------------------------------------------------------------===//

std::vector<std::string> InputFiles::definitionsOf(MemoryBufferRef Buffer) {
  std::vector<std::string> Names;
  Expected<std::unique_ptr<SymbolicFile>> File =
      SymbolicFile::createSymbolicFile(
          Buffer, identify_magic(Buffer.getBuffer()), &Context);
  if (!File) {
    Diags.error(Buffer.getBufferIdentifier() + ": " +
                toString(File.takeError()));
    return Names;
  }
  for (const BasicSymbolRef &Symbol : (*File)->symbols()) {
    uint32_t Flags = cantFail(Symbol.getFlags());
    if (!(Flags & BasicSymbolRef::SF_Global) ||
        Flags & BasicSymbolRef::SF_Undefined)
      continue;
    raw_string_ostream Stream(Names.emplace_back());
    cantFail(Symbol.printName(Stream));
  }
  return Names;
}

void InputFiles::addArchive(MemoryBufferRef Buffer, bool Whole) {
  StringRef ArchiveName = Buffer.getBufferIdentifier();
  auto Report = [&](Error Failure) {
    Diags.error(ArchiveName + ": " + toString(std::move(Failure)));
  };
  Expected<std::unique_ptr<Archive>> File = Archive::create(Buffer);
  if (!File)
    return Report(File.takeError());
  Error Failure = Error::success();
  for (const Archive::Child &Child : (*File)->children(Failure)) {
    Expected<MemoryBufferRef> Contents = Child.getMemoryBufferRef();
    if (!Contents) {
      Report(Contents.takeError());
      continue;
    }
    MemberNames.push_back(std::make_unique<std::string>(
        (ArchiveName + "(" + Contents->getBufferIdentifier() + ")").str()));
    MemoryBufferRef Named(Contents->getBuffer(), *MemberNames.back());
    if (Whole)
      addBuffer(Named);
    else
      Members.push_back({*MemberNames.back(), Named, definitionsOf(Named)});
  }
  if (Failure)
    return Report(std::move(Failure));
  Archives.push_back(std::move(*File));
}

void InputFiles::resolveArchives() {
  for (bool Changed = true; Changed;) {
    Changed = false;
    for (Member &Candidate : Members) {
      if (Candidate.Taken ||
          none_of(Candidate.Definitions, [&](const std::string &Name) {
            return Missing.contains(Name);
          }))
        continue;
      Candidate.Taken = Changed = true;
      addBuffer(Candidate.Buffer);
    }
  }
}

} // namespace tp
