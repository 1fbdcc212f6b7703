//===- MemoryDump.cpp - Writes variables of a finished run ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/MemoryDump.h"

#include "llvm/Demangle/Demangle.h"
#include "llvm/Object/ELFObjectFile.h"
#include "llvm/Support/FileSystem.h"

using namespace llvm;

namespace tp {

static bool isNamed(const object::ELFSymbolRef &Symbol, StringRef Wanted) {
  Expected<StringRef> Name = Symbol.getName();
  if (!Name) {
    consumeError(Name.takeError());
    return false;
  }
  return *Name == Wanted || demangle(*Name) == Wanted;
}

Expected<MemoryDump> locate(const MemoryDumpRequest &Request,
                            const ElfProgram &Program, const Memory &Global) {
  auto Fail = [&](const Twine &What) {
    return createStringError(Program.path() + ": --dump-memory '" +
                             Request.Symbol + "': " + What);
  };
  for (const object::ELFSymbolRef Symbol : Program.object().symbols()) {
    if (Symbol.getELFType() != ELF::STT_OBJECT ||
        !isNamed(Symbol, Request.Symbol))
      continue;
    Expected<uint64_t> Address = Symbol.getAddress();
    if (!Address)
      return Address.takeError();
    if (!Global.contains(*Address, Symbol.getSize()))
      return Fail("the variable does not lie in global memory");
    return MemoryDump{Request.Path, uint32_t(*Address), Symbol.getSize()};
  }
  return Fail("the program has no such variable; one marked [[gnu::used]] "
              "stays in it");
}

llvm::Error write(const MemoryDump &Dump, const Memory &Global) {
  std::error_code EC;
  raw_fd_ostream File(Dump.Path, EC);
  if (!EC) {
    File.write(reinterpret_cast<const char *>(Global.data() + Dump.Address),
               Dump.Bytes);
    File.close();
    EC = File.error();
    File.clear_error();
  }
  if (EC)
    return createStringError("cannot write " + Dump.Path + ": " + EC.message());
  return llvm::Error::success();
}

} // namespace tp
