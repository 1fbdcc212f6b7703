//===- HtmlReport.h - A profile as a page to look at ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_HTML_HTMLREPORT_H
#define TP_SIMULATOR_PROFILE_HTML_HTMLREPORT_H

#include "simulator/profile/Profile.h"

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Writes one HTML file that shows \p Data in a browser and needs nothing else,
/// neither other files nor a network.
void writeHtmlReport(const Profile &Data, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_HTML_HTMLREPORT_H
