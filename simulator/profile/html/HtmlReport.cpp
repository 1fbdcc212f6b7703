//===- HtmlReport.cpp - A profile as a page to look at --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/html/HtmlReport.h"

#include "simulator/profile/ProfileJson.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {

/// The page, with a mark where the data belongs.
static constexpr unsigned char PageBytes[] = {
#include "simulator/profile/html/Page.inc"
};
static constexpr StringRef DataMark = "@DATA@";

/// The profile's JSON without spaces.
static std::string compactJson(const Profile &Data) {
  std::string Text;
  raw_string_ostream Stream(Text);
  writeProfile(Data, Stream);
  return formatv("{0}", cantFail(json::parse(Text))).str();
}

void writeHtmlReport(const Profile &Data, raw_ostream &OS) {
  StringRef Page(reinterpret_cast<const char *>(PageBytes), sizeof(PageBytes));
  auto [Before, After] = Page.split(DataMark);
  OS << Before;
  // In a script element only `<` could be taken for markup; in JSON it occurs
  // in strings only.
  for (char C : compactJson(Data))
    if (C == '<')
      OS << "\\u003c";
    else
      OS << C;
  OS << After;
}

} // namespace tp
