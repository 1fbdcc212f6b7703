//===- ProgramStack.cpp - How much stack a program's threads get ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/ProgramStack.h"
#include "llvm-backend/clang/link/MemoryMap.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp {

static bool needsBound(ArrayRef<std::unique_ptr<ElfObject>> Objects) {
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections()) {
      if (!Section || !Section->Live || !Section->isAllocated())
        continue;
      for (const ElfType::Rela &Relocation : Section->Relocations) {
        const Symbol *Target = Object->symbol(Relocation.getSymbol(false));
        if (Target && !Target->Defined &&
            (Target->Name == StackBytesSymbol ||
             Target->Name == StackLimitSymbol))
          return true;
      }
    }
  return false;
}

ProgramStack determineStack(ArrayRef<std::unique_ptr<ElfObject>> Objects,
                            const SymbolTable &Globals, const Symbol &Entry,
                            const ElfLinkOptions &Options,
                            LinkDiagnostics &Diags) {
  ProgramStack Stack;
  const bool IsNeeded = needsBound(Objects);
  if (!IsNeeded && !Options.StackBytes && Options.MapPath.empty())
    return Stack;
  const CallGraph Graph = buildCallGraph(Objects, Globals, Entry, Diags);
  if (Diags.hasErrors())
    return Stack;
  if (!Graph.Entry) {
    Diags.error("the entry symbol " + Options.EntrySymbol +
                " is not in the program's code; name a function with "
                "-Wl,--entry=<symbol>");
    return Stack;
  }
  Stack.IsAnalyzed = true;
  Stack.Bound = boundStack(Graph);
  if (Options.StackBytes) {
    Stack.Bytes = alignTo(*Options.StackBytes, memorymap::StackAlignment);
    if (Stack.Bound.Bytes && *Stack.Bound.Bytes > *Stack.Bytes)
      Diags.warning(
          "the stack may take " + Twine(*Stack.Bound.Bytes) +
          " bytes, more than -z stack-size=" + Twine(*Options.StackBytes) +
          " allows: " + describeChain(Stack.Bound));
  } else if (IsNeeded) {
    Stack.Bytes = Stack.Bound.Bytes;
    if (!Stack.Bytes)
      Diags.error("the program asks for the local store that its stack leaves "
                  "free (freeLocalStore), but the stack has no bound:\n" +
                  Stack.Bound.Reason +
                  "\n  change that, or set a bound yourself with "
                  "-Wl,-z,stack-size=<bytes>");
  }
  return Stack;
}

} // namespace tp
