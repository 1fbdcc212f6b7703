//===- SchemaPaths.cpp - All keys that a chip file can have ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/SchemaPaths.h"

using namespace llvm;

namespace tp {
namespace {

class PathCollector : public ChipVisitor {
public:
  std::vector<SchemaPath> Paths;

  bool visitsAll() const override { return true; }

private:
  /// Of the open sections with their dots.
  std::vector<std::string> Prefixes{""};

  void add(const KeyInfo &Key) {
    Paths.push_back({Prefixes.back() + Key.Name.str(), false, Key.P, ""});
  }
  void visitInteger(const KeyInfo &Key, uint64_t &,
                    const IntegerRange &) override {
    add(Key);
  }
  void visitNumber(const KeyInfo &Key, double &, const NumberRange &) override {
    add(Key);
  }
  void visitChoice(const KeyInfo &Key, unsigned &,
                   ArrayRef<StringRef>) override {
    add(Key);
  }
  void visitText(const KeyInfo &Key, std::string &) override { add(Key); }
  bool beginSection(const SectionInfo &Section, bool) override {
    add(Section.Key);
    Paths.back().IsSection = true;
    Paths.back().Folder = Section.Folder.str();
    Prefixes.push_back(Paths.back().Text + ".");
    return true;
  }
  void endSection() override { Prefixes.pop_back(); }
};

} // namespace

std::vector<SchemaPath> schemaPaths() {
  PathCollector Collector;
  ChipConfig Chip = defaultChip();
  visitChip(Collector, Chip);
  return std::move(Collector.Paths);
}

} // namespace tp
