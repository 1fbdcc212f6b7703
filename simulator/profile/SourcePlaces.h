//===- SourcePlaces.h - The places of a profile -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_SOURCEPLACES_H
#define TP_SIMULATOR_PROFILE_SOURCEPLACES_H

#include "simulator/loader/Symbolizer.h"
#include "simulator/profile/Profile.h"

#include <map>
#include <string>
#include <tuple>

namespace tp {

/// Adds files, functions and frames to a profile as addresses are asked for,
/// each once.
class SourcePlaces {
public:
  /// Both must outlive this object.
  SourcePlaces(const ElfProgram &Program, Profile &Result);

  /// The innermost frame of an instruction.
  uint32_t frameOf(uint32_t Pc);
  /// The function that an instruction belongs to, not what was inlined there.
  uint32_t functionAt(uint32_t Pc);
  /// Reads the text of all files that can be read.
  void readSources();

private:
  /// A place where the absolute path of a file can be found.
  struct Mention {
    uint32_t Pc;
    /// Of the frames there, innermost first.
    size_t Frame;
  };

  std::optional<uint32_t> fileOf(const std::string &Path, Mention Where);
  uint32_t functionOf(const SourceFrame &Frame);

  Profile &Result;
  Symbolizer Symbols;
  Symbolizer AbsolutePaths;
  std::map<std::string, uint32_t> Files;
  /// Where each file was first mentioned.
  std::vector<Mention> Mentions;
  /// By name and place of the function.
  std::map<std::tuple<std::string, std::string, unsigned>, uint32_t> Functions;
  /// By function, file, line, column and the frame around it, each number plus
  /// 1 and 0 for none.
  std::map<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t, uint32_t>,
           uint32_t>
      Frames;
};

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_SOURCEPLACES_H
