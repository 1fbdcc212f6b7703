//===- ChipWriter.cpp - Writing chip files --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"
#include "simulator/chip/ChipSchema.h"

#include "llvm/Support/Format.h"
#include "llvm/Support/YAMLParser.h"

using namespace llvm;

namespace tp {
namespace {

class Writer : public ChipVisitor {
public:
  explicit Writer(raw_ostream &OS) : OS(OS) {}

private:
  raw_ostream &OS;
  unsigned Depth = 0;
  /// Within a section on one line, and whether it has a key already.
  bool OnOneLine = false;
  bool HasKey = false;

  raw_ostream &key(StringRef Name) {
    if (!OnOneLine)
      OS.indent(2 * Depth);
    else if (HasKey)
      OS << ", ";
    HasKey = true;
    return OS << Name << ":";
  }
  void endKey() {
    if (!OnOneLine)
      OS << '\n';
  }

  void visitInteger(const KeyInfo &Key, uint64_t &Value,
                    const IntegerRange &) override {
    key(Key.Name) << ' ' << Value;
    endKey();
  }
  void visitNumber(const KeyInfo &Key, double &Value,
                   const NumberRange &) override {
    key(Key.Name) << ' ' << format("%.9g", Value);
    endKey();
  }
  void visitChoice(const KeyInfo &Key, unsigned &Value,
                   ArrayRef<StringRef> Names) override {
    key(Key.Name) << ' ' << Names[Value];
    endKey();
  }
  void visitText(const KeyInfo &Key, std::string &Value) override {
    key(Key.Name) << " \"" << yaml::escape(Value) << '"';
    endKey();
  }
  bool beginSection(const SectionInfo &Section, bool HasValue) override {
    if (!HasValue)
      return false;
    key(Section.Key.Name);
    OnOneLine = Section.OneLine;
    if (OnOneLine) {
      OS << " {";
      HasKey = false;
    } else {
      OS << '\n';
      ++Depth;
    }
    return true;
  }
  void endSection() override {
    if (OnOneLine)
      OS << "}\n";
    else
      --Depth;
    OnOneLine = false;
  }
};

} // namespace

void writeChip(const ChipConfig &Chip, raw_ostream &OS) {
  OS << "# " << Chip.Name << "\n";
  Writer W(OS);
  ChipConfig Copy = Chip;
  visitChip(W, Copy);
}

} // namespace tp
