//===- Shell.cpp - What the commands share --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Shell.h"

#include "debugger/cli/Examine.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/FormatVariadic.h"

using namespace llvm;

namespace tp {

Shell::Shell(Session &Program, raw_ostream &OS)
    : Program(Program), OS(OS), Symbols(Program.program()) {}

const Backtrace &Shell::stack() {
  if (!Stack)
    Stack = Program.backtrace(Thread);
  return *Stack;
}

const Frame &Shell::frame() {
  const std::vector<Frame> &Frames = stack().Frames;
  return Frames[std::min<size_t>(FrameIndex, Frames.size() - 1)];
}

void Shell::changed() {
  Stack.reset();
  Result.HasChanged = true;
}

void Shell::select(uint32_t NewThread, unsigned NewFrame) {
  if (NewThread != Thread)
    Stack.reset();
  Thread = NewThread;
  FrameIndex = NewFrame;
}

LocationDefaults Shell::locationDefaults() {
  LocationDefaults Result;
  Result.Position = frame().Position;
  if (!Result.Position.isKnown())
    for (uint32_t F : map().findFunctions("main"))
      Result.Position = map().function(F).Declared;
  Result.Frame = &frame().Context;
  return Result;
}

Expected<Value> Shell::evaluate(StringRef Text) {
  Expected<Expression> Parsed =
      Expression::parse(Text, info(), &frame().Context);
  if (!Parsed)
    return Parsed.takeError();
  Expected<Value> Result =
      Parsed->evaluate(frame().Context, &Program.history());
  if (Parsed->hasEffects())
    changed();
  return Result;
}

Expected<uint64_t> Shell::evaluateInteger(StringRef Text) {
  Expected<Value> Result = evaluate(Text);
  if (!Result)
    return Result.takeError();
  const Type &Of = Result->type().stripped();
  if (Of.Kind == TypeKind::Array || Of.Kind == TypeKind::Function ||
      Of.isRecord())
    if (std::optional<uint32_t> Address = Result->address())
      return *Address;
  return Result->asInteger(frame().Context);
}

Expected<uint32_t> Shell::evaluateAddress(StringRef Text) {
  Expected<uint64_t> Number = evaluateInteger(Text);
  if (!Number)
    return Number.takeError();
  if (!isUInt<32>(*Number) && !isInt<32>(int64_t(*Number)))
    return createStringError("Not an address: 0x" + Twine::utohexstr(*Number));
  return uint32_t(*Number);
}

std::string Shell::print(const Value &Of, char Format) {
  PrintOptions Options = Printing;
  Options.Format = Format;
  return Program.printer().print(Of, frame().Context, Options);
}

std::string Shell::threadName(uint32_t Number) const {
  const ChipConfig &Chip = Program.chip();
  return formatv("thread {0} (TM {1}, TP {2})", Number, Number / Chip.TpsPerTm,
                 Number % Chip.TpsPerTm);
}

std::string Shell::timeName(uint64_t Time) const {
  return (Program.isFunctional() ? "instruction " : "cycle ") + utostr(Time);
}

std::string Shell::describeFrame(const Frame &Of) {
  std::string Text;
  raw_string_ostream Stream(Text);
  bool IsAtLine = !Of.Context.IsCaller && beginsLine(map(), Of.Context.Pc);
  if (!IsAtLine && !Of.Inlined && Of.Context.InlineDepth == 0)
    Stream << format_hex(Of.Context.Pc, 10) << " in ";
  if (!Of.Function) {
    Stream << "?? ()";
    return Text;
  }
  Stream << map().function(*Of.Function).QualifiedName << " (";
  ListSeparator Separator;
  for (const VariableInfo &Argument :
       info().variables().arguments(Of.Context)) {
    Expected<Value> Held = info().variables().value(Argument, Of.Context);
    Stream << Separator << Argument.Name << '=';
    if (Held)
      Stream << Program.printer().summary(*Held, Of.Context);
    else
      Stream << "<error: " << toString(Held.takeError()) << '>';
  }
  Stream << ')';
  if (Of.Position.isKnown())
    Stream << " at " << info().files().shortName(Of.Position);
  return Text;
}

void Shell::printFrame(unsigned Index) {
  OS << '#' << left_justify(utostr(Index), 3)
     << describeFrame(stack().Frames[Index]) << '\n';
}

void Shell::printSourceLine(const Frame &Of, bool WithAddress) {
  if (!Of.Position.isKnown())
    return;
  if (WithAddress && !Of.Context.IsCaller && !beginsLine(map(), Of.Context.Pc))
    OS << format_hex(Of.Context.Pc, 10) << '\t';
  OS << Of.Position.Line << '\t';
  if (std::optional<StringRef> Text = info().files().line(Of.Position))
    OS << *Text << '\n';
  else
    OS << "in " << info().files().name(Of.Position.File) << '\n';
  Listed = Of.Position;
  IsListedBehind = false;
}

void Shell::printPlace(bool WithFrame) {
  const Frame &At = frame();
  bool IsSame = Shown.Thread == Thread && Shown.Cfa == At.Cfa &&
                Shown.Function == At.Function;
  bool ShowsFrame = WithFrame || !IsSame || !At.Position.isKnown();
  if (ShowsFrame)
    OS << describeFrame(At) << '\n';
  Shown = {Thread, At.Cfa, At.Function};
  printSourceLine(At, !ShowsFrame);
}

llvm::Error Shell::printInstruction(uint32_t Pc) {
  uint8_t Bytes[4];
  if (!context().read(Pc, Bytes))
    return cannotAccess(Pc);
  OS << (Pc == stack().Frames.front().Context.Pc ? "=> " : "   ")
     << map().describeAddress(Pc) << ":\t"
     << Instructions.print(support::endian::read32le(Bytes), Pc) << '\n';
  return llvm::Error::success();
}

void Shell::printDisplay(const Display &Shown) {
  OS << Shown.Number << ": ";
  if (!Shown.Format.empty() && isMemoryFormat(Shown.Format)) {
    OS << "x/" << Shown.Format << ' ' << Shown.Text << '\n';
    if (llvm::Error E = examine(*this, Shown.Format, Shown.Text))
      OS << toString(std::move(E)) << '\n';
    return;
  }
  if (!Shown.Format.empty())
    OS << '/' << Shown.Format << ' ';
  OS << Shown.Text << " = ";
  Expected<Value> Held = evaluate(Shown.Text);
  if (Held)
    OS << print(*Held, Shown.Format.empty() ? 0 : Shown.Format.front());
  else
    OS << "<error: " << toString(Held.takeError()) << '>';
  OS << '\n';
}

void Shell::printDisplays() {
  for (const Display &Shown : Displays)
    if (Shown.Enabled)
      printDisplay(Shown);
}

} // namespace tp
