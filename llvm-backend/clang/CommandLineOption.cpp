//===- CommandLineOption.cpp - The options of a command line --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/CommandLineOption.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Option/OptTable.h"

using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

std::string CommandLineOption::text() const { return join(Words, " "); }

std::vector<CommandLineOption> splitCommandLine(ArrayRef<const char *> Words) {
  InputArgList Arguments(Words.begin(), Words.end());
  std::vector<CommandLineOption> Options;
  for (unsigned Next = 0; Next < Words.size();) {
    unsigned Begin = Next;
    std::unique_ptr<Arg> Parsed = clang::getDriverOptTable().ParseOneArg(
        Arguments, Next, opt::Visibility(ClangOption));
    // Clang's driver reports missing values.
    Next = std::min<unsigned>(Next, Words.size());
    unsigned ID = Parsed ? Parsed->getOption().getID() : OPT_UNKNOWN;
    Options.push_back({Words.slice(Begin, Next - Begin), ID});
  }
  return Options;
}

} // namespace tp
