//===- BodyLibrary.cpp - The instructions' bodies as bitcode --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/BodyLibrary.h"

#include "llvm/Bitcode/BitcodeReader.h"

using namespace llvm;

namespace tp {

Expected<std::unique_ptr<Module>>
BodyLibrary::instantiate(LLVMContext &Context) const {
  StringRef Bytes(reinterpret_cast<const char *>(Bitcode.data()),
                  Bitcode.size());
  Expected<std::unique_ptr<Module>> Result =
      getLazyBitcodeModule(MemoryBufferRef(Bytes, "steps"), Context);
  if (!Result)
    return Result.takeError();
  for (Function &F : **Result)
    if (!F.isDeclaration()) {
      F.setComdat(nullptr);
      F.setLinkage(GlobalValue::InternalLinkage);
    }
  return Result;
}

std::string stepName(Opcode Op, Subnormals Mode) {
  static constexpr const char *Names[] = {
#define TP_NAME(NAME) #NAME,
      TP_EACH_OPCODE(TP_NAME)
#undef TP_NAME
  };
  static constexpr const char *Modes[] = {"tpKeep", "tpFlush", "tpTrap"};
  return std::string(Modes[unsigned(Mode)]) + Names[unsigned(Op)];
}

const BodyLibrary &cycleSteps() {
  alignas(8) static constexpr unsigned char Bitcode[] = {
#include "simulator/jit/StepsBitcode.inc"
  };
  static const BodyLibrary Library(Bitcode);
  return Library;
}

} // namespace tp
