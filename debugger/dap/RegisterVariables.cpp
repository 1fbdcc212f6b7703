//===- RegisterVariables.cpp - A frame's registers as a list --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/RegisterVariables.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/bit.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/raw_ostream.h"

#include <limits>

using namespace llvm;

namespace tp::dap {
namespace {

/// What is common to both kinds of registers.
class RegisterFile : public VariableList {
public:
  explicit RegisterFile(const FrameContext &Frame) : Frame(Frame) {}

  Expected<std::vector<VariableRow>> rows(uint32_t Begin, uint32_t Count,
                                          ValueFormat Format) const override {
    std::vector<VariableRow> Rows;
    for (uint32_t I = Begin; I < count() && I - Begin < Count; ++I)
      Rows.push_back(row(I, Format));
    return Rows;
  }

protected:
  FrameContext Frame;

  virtual VariableRow row(uint32_t Index, ValueFormat Format) const = 0;

  /// \p Print writes the register's bits.
  VariableRow
  registerRow(unsigned Register,
              function_ref<void(raw_ostream &, uint32_t)> Print) const {
    VariableRow Row;
    Row.Name = registerName(Register);
    Row.Expression = "$" + Row.Name;
    Row.IsReadOnly = !Frame.Registers.isKnown(Register);
    if (Row.IsReadOnly) {
      Row.Value = "<not saved>";
      return Row;
    }
    raw_string_ostream OS(Row.Value);
    Print(OS, Frame.Registers.Values[Register]);
    return Row;
  }
};

class FloatRegisters : public RegisterFile {
public:
  using RegisterFile::RegisterFile;

  uint32_t count() const override { return DwarfRegisters - DwarfFirstFloat; }

protected:
  VariableRow row(uint32_t Index, ValueFormat Format) const override {
    return registerRow(
        DwarfFirstFloat + Index, [&](raw_ostream &OS, uint32_t Bits) {
          if (Format.Hex)
            OS << format("0x%08x", Bits);
          else
            OS << format("%.*g", std::numeric_limits<float>::max_digits10,
                         double(bit_cast<float>(Bits)));
        });
  }
};

/// The pc, r0 to r31, and the float registers as one row.
class AllRegisters : public RegisterFile {
public:
  using RegisterFile::RegisterFile;

  uint32_t count() const override { return DwarfFirstFloat + 2; }

protected:
  VariableRow row(uint32_t Index, ValueFormat Format) const override {
    VariableRow Row;
    if (Index == 0) {
      Row.Name = "pc";
      Row.Expression = "$pc";
      raw_string_ostream(Row.Value) << format("0x%08x", Frame.Pc);
      return Row;
    }
    if (Index == count() - 1) {
      Row.Name = "floats";
      Row.Value = "f0 to f31";
      Row.IsReadOnly = true;
      Row.Parts = std::make_shared<FloatRegisters>(Frame);
      return Row;
    }
    return registerRow(Index - 1, [&](raw_ostream &OS, uint32_t Bits) {
      OS << format("0x%08x", Bits);
      if (!Format.Hex)
        OS << format("  %d", int32_t(Bits));
    });
  }
};

} // namespace

std::shared_ptr<VariableList> registerVariables(const FrameContext &Frame) {
  return std::make_shared<AllRegisters>(Frame);
}

} // namespace tp::dap
