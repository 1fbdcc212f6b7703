//===- ValuePrinter.cpp - Values as text ---------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/ValuePrinter.h"

#include "debugger/source/Arithmetic.h"
#include "debugger/source/Children.h"
#include "debugger/source/NameIndex.h"
#include "debugger/source/SourceMap.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/bit.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp {

/// Prints one value.
class ValuePrinter::Writer {
public:
  Writer(const SourceMap &Map, const FrameContext &Frame,
         const PrintOptions &Options)
      : Map(Map), Frame(Frame), Options(Options), OS(Text) {}

  std::string run(const Value &Of) {
    if (Of.type().isPointer() && Options.Format == 0 && !isText(Of) &&
        !Of.isOptimizedOut())
      OS << '(' << Of.type().Name << ") ";
    value(Of, 0);
    return std::move(Text);
  }

private:
  const SourceMap &Map;
  const FrameContext &Frame;
  const PrintOptions &Options;
  std::string Text;
  raw_string_ostream OS;

  static bool isCharacterLike(const Type &Element) {
    return Element.isCharacter() && Element.stripped().Size == 1;
  }
  static bool isText(const Value &Of) {
    const Type &Plain = Of.type().stripped();
    return Plain.Kind == TypeKind::Pointer && isCharacterLike(*Plain.Target);
  }

  void problem(Error E) {
    std::string Message = toString(std::move(E));
    if (StringRef(Message).ends_with("optimized out"))
      OS << "<optimized out>";
    else
      OS << "<error: " << Message << ">";
  }

  void newLine(unsigned Depth) {
    if (Options.Pretty)
      OS << '\n', OS.indent(2 * Depth);
  }

  void value(const Value &Of, unsigned Depth);
  void scalar(const Value &Of);
  void formatted(const Value &Of);
  void enumeration(const Type &Plain, uint64_t Number);
  void pointer(const Value &Of, uint64_t Address);
  void reference(const Value &Of, unsigned Depth);
  void record(const Value &Of, unsigned Depth);
  void sequence(const Sequence &Elements, unsigned Depth);
  bool characters(const Sequence &Elements);
  void stringAt(uint32_t Address);
  bool isRepeated(const Sequence &Elements, uint32_t Index, uint32_t Next,
                  unsigned Depth);
  std::string element(const Sequence &Elements, uint32_t Index, unsigned Depth);
};

void ValuePrinter::Writer::value(const Value &Of, unsigned Depth) {
  const Type &Plain = Of.type().stripped();
  if (Plain.Kind == TypeKind::Incomplete) {
    OS << "<incomplete type>";
    return;
  }
  if (Plain.Kind == TypeKind::Void) {
    OS << "void";
    return;
  }
  if (Plain.Kind == TypeKind::Function) {
    OS << '{' << Plain.Name << "} ";
    if (std::optional<uint32_t> Address = Of.address())
      OS << Map.describeAddress(*Address);
    return;
  }
  if (Of.isOptimizedOut() && Plain.Size) {
    OS << "<optimized out>";
    return;
  }
  if (Plain.isReference())
    return reference(Of, Depth);
  Expected<std::optional<Sequence>> Elements = elementsOf(Of, Frame);
  if (!Elements)
    return problem(Elements.takeError());
  if (const std::optional<Sequence> &List = *Elements)
    return sequence(*List, Depth);
  if (Plain.isRecord())
    return record(Of, Depth);
  if (Options.Format)
    return formatted(Of);
  scalar(Of);
}

void ValuePrinter::Writer::formatted(const Value &Of) {
  if (Options.Format == 's' && isText(Of))
    return scalar(Of);
  if (Options.Format == 'd' || Options.Format == 'u' || Options.Format == 'c') {
    // A floating-point value is converted, as a cast does it.
    if (Of.type().stripped().Kind == TypeKind::Float) {
      Expected<double> Number = Of.asReal(Frame);
      if (!Number)
        return problem(Number.takeError());
      uint64_t Whole = realToInteger(*Number, 8, /*IsSigned=*/true);
      uint8_t Bytes[8];
      for (unsigned I = 0; I != 8; ++I)
        Bytes[I] = uint8_t(Whole >> (8 * I));
      OS << formatNumber(Bytes, Options.Format, Map);
      return;
    }
  }
  Expected<SmallVector<uint8_t, 16>> Bytes = Of.bytes(Frame);
  if (!Bytes)
    return problem(Bytes.takeError());
  if (Bytes->size() > 8 || (Options.Format == 'f' && Bytes->size() < 4))
    return scalar(Of);
  char Format = Options.Format == 's' ? 'd' : Options.Format;
  OS << formatNumber(*Bytes, Format, Map);
}

void ValuePrinter::Writer::enumeration(const Type &Plain, uint64_t Number) {
  for (const Enumerator &Named : Plain.Enumerators)
    if (uint64_t(Named.Value) == Number) {
      StringRef Scope = Plain.Name;
      if (!Plain.IsScoped) {
        Scope = Scope.drop_back(lastComponent(Scope).size());
        Scope.consume_back("::");
      }
      if (!Scope.empty() && !Scope.starts_with("("))
        OS << Scope << "::";
      OS << Named.Name;
      return;
    }
  std::string Flags;
  uint64_t Rest = Number;
  for (const Enumerator &Named : Plain.Enumerators) {
    uint64_t Bit = uint64_t(Named.Value);
    if (Bit && isPowerOf2_64(Bit) && (Rest & Bit)) {
      Flags += (Flags.empty() ? "" : " | ") + Named.Name;
      Rest &= ~Bit;
    }
  }
  if (!Flags.empty() && Rest == 0)
    OS << '(' << Flags << ')';
  else if (Plain.isSigned())
    OS << int64_t(Number);
  else
    OS << Number;
}

void ValuePrinter::Writer::stringAt(uint32_t Address) {
  std::string Characters;
  while (Characters.size() < Options.MaxElements) {
    uint8_t Byte;
    if (!Frame.read(Address + uint32_t(Characters.size()), Byte)) {
      if (Characters.empty())
        OS << ' ', problem(cannotAccess(Address));
      else
        OS << ' ' << quoted(Characters) << "...";
      return;
    }
    if (Byte == 0) {
      OS << ' ' << quoted(Characters);
      return;
    }
    Characters += char(Byte);
  }
  OS << ' ' << quoted(Characters) << "...";
}

void ValuePrinter::Writer::pointer(const Value &Of, uint64_t Address) {
  OS << "0x" << utohexstr(Address, true);
  if (Address == 0)
    return;
  if (isText(Of) && (Options.Format == 0 || Options.Format == 's')) {
    stringAt(uint32_t(Address));
    return;
  }
  if (std::optional<std::string> Symbol = Map.symbolAt(uint32_t(Address)))
    OS << " <" << *Symbol << '>';
}

void ValuePrinter::Writer::scalar(const Value &Of) {
  const Type &Plain = Of.type().stripped();
  if (Plain.Size > 8) {
    Expected<SmallVector<uint8_t, 16>> Bytes = Of.bytes(Frame);
    if (!Bytes)
      return problem(Bytes.takeError());
    OS << "0x";
    for (uint8_t Byte : reverse(*Bytes))
      OS << utohexstr(Byte, true, 2);
    return;
  }
  Expected<uint64_t> Number = Of.asInteger(Frame);
  if (!Number)
    return problem(Number.takeError());
  switch (Plain.Kind) {
  case TypeKind::Boolean:
    if (*Number <= 1)
      OS << (*Number ? "true" : "false");
    else
      OS << *Number;
    break;
  case TypeKind::Character:
    if (Of.type().isSigned())
      OS << int64_t(*Number);
    else
      OS << *Number;
    OS << ' '
       << quotedCharacter(
              uint32_t(*Number & maskTrailingOnes<uint64_t>(8 * Plain.Size)));
    break;
  case TypeKind::Signed:
    OS << int64_t(*Number);
    break;
  case TypeKind::Float:
    if (Expected<double> Real = Of.asReal(Frame))
      OS << formatReal(*Real, Plain.Size);
    else
      problem(Real.takeError());
    break;
  case TypeKind::Enumeration:
    enumeration(Plain, *Number);
    break;
  case TypeKind::Pointer:
  case TypeKind::NullPointer:
    pointer(Of, *Number);
    break;
  case TypeKind::MemberPointer:
    OS << (int32_t(*Number) == -1 ? std::string("NULL")
                                  : std::to_string(int32_t(*Number)));
    break;
  default:
    OS << *Number;
    break;
  }
}

void ValuePrinter::Writer::reference(const Value &Of, unsigned Depth) {
  Expected<uint64_t> Address = Of.asInteger(Frame);
  if (!Address)
    return problem(Address.takeError());
  OS << "@0x" << utohexstr(*Address, true);
  if (Depth >= Options.MaxDepth)
    return;
  OS << ": ";
  Expected<Value> Target = pointee(Of, Frame);
  if (!Target)
    return problem(Target.takeError());
  value(*Target, Depth + 1);
}

void ValuePrinter::Writer::record(const Value &Of, unsigned Depth) {
  if (Depth >= Options.MaxDepth) {
    OS << "{...}";
    return;
  }
  Expected<std::vector<NamedValue>> Parts = children(Of, Frame);
  if (!Parts)
    return problem(Parts.takeError());
  OS << '{';
  bool IsFirst = true;
  for (const NamedValue &Part : *Parts) {
    const Type &Inner = Part.Of.type().stripped();
    if (Part.IsBase && Inner.isRecord() && Inner.Members.empty())
      continue;
    if (!IsFirst)
      OS << (Options.Pretty ? "," : ", ");
    IsFirst = false;
    newLine(Depth + 1);
    if (Part.IsBase)
      OS << '<' << Part.Name << "> = ";
    else if (!Part.Name.empty())
      OS << Part.Name << " = ";
    value(Part.Of, Depth + 1);
  }
  if (!IsFirst)
    newLine(Depth);
  OS << '}';
}

/// A string up to its last zeros; false if it is no text.
bool ValuePrinter::Writer::characters(const Sequence &Elements) {
  if (!isCharacterLike(*Elements.Element) ||
      (Options.Format != 0 && Options.Format != 's'))
    return false;
  uint32_t Count = std::min(Elements.Count, Options.MaxElements);
  std::string Characters;
  for (uint32_t I = 0; I != Count; ++I) {
    Expected<uint64_t> Number = Elements.at(I).asInteger(Frame);
    if (!Number) {
      problem(Number.takeError());
      return true;
    }
    Characters += char(*Number);
  }
  bool IsCut = Count < Elements.Count;
  size_t Last = Characters.find_last_not_of('\0');
  if (!IsCut)
    Characters.resize(Last == std::string::npos ? 0 : Last + 1);
  OS << quoted(Characters) << (IsCut ? "..." : "");
  return true;
}

/// Whether two elements print the same: their bytes tell faster than their
/// text.
bool ValuePrinter::Writer::isRepeated(const Sequence &Elements, uint32_t Index,
                                      uint32_t Next, unsigned Depth) {
  Expected<SmallVector<uint8_t, 16>> A = Elements.at(Index).bytes(Frame);
  Expected<SmallVector<uint8_t, 16>> B = Elements.at(Next).bytes(Frame);
  if (A && B)
    return *A == *B;
  consumeError(joinErrors(A.takeError(), B.takeError()));
  return element(Elements, Index, Depth) == element(Elements, Next, Depth);
}

std::string ValuePrinter::Writer::element(const Sequence &Elements,
                                          uint32_t Index, unsigned Depth) {
  Writer Inner(Map, Frame, Options);
  Inner.value(Elements.at(Index), Depth + 1);
  return std::move(Inner.Text);
}

void ValuePrinter::Writer::sequence(const Sequence &Elements, unsigned Depth) {
  if (characters(Elements))
    return;
  if (Depth >= Options.MaxDepth) {
    OS << "{...}";
    return;
  }
  OS << '{';
  uint32_t Printed = 0, Index = 0;
  // Arrays of arrays may have many elements in all.
  constexpr size_t MaxText = 1 << 18;
  while (Index < Elements.Count && Printed < Options.MaxElements &&
         Text.size() < MaxText) {
    std::string Element = element(Elements, Index, Depth);
    uint32_t Same = 1;
    // Elements of a huge array are not all read to count them.
    constexpr uint32_t MaxRepeats = 100000;
    while (Index + Same < Elements.Count && Same < MaxRepeats &&
           isRepeated(Elements, Index, Index + Same, Depth))
      ++Same;
    bool IsRun = Same >= Options.RepeatThreshold;
    uint32_t Times = IsRun ? 1 : std::min(Same, Options.MaxElements - Printed);
    for (uint32_t I = 0; I != Times; ++I) {
      if (Printed != 0 || I != 0)
        OS << ", ";
      OS << Element;
    }
    if (IsRun)
      OS << " <repeats " << Same << " times>";
    Printed += IsRun ? Options.RepeatThreshold : Times;
    Index += IsRun ? Same : Times;
  }
  if (Index < Elements.Count)
    OS << "...";
  OS << '}';
}

std::string ValuePrinter::print(const Value &Of, const FrameContext &Frame,
                                const PrintOptions &Options) const {
  return Writer(Map, Frame, Options).run(Of);
}

std::string ValuePrinter::summary(const Value &Of,
                                  const FrameContext &Frame) const {
  PrintOptions Options;
  Options.MaxDepth = 2;
  Options.MaxElements = 8;
  std::string Text = Writer(Map, Frame, Options).run(Of);
  constexpr size_t MaxLength = 120;
  if (Text.size() > MaxLength) {
    Text.resize(MaxLength - 3);
    Text += "...";
  }
  return Text;
}

} // namespace tp
