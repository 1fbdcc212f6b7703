//===- Locations.cpp - Places in a program by name ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/Locations.h"

#include "debugger/source/Expression.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {
namespace {

/// Reads one location.
class LocationReader {
public:
  LocationReader(StringRef Text, DebugInformation &Information,
                 const LocationDefaults &Defaults)
      : Text(Text.trim()), Information(Information), Map(Information.map()),
        Defaults(Defaults) {}

  Expected<std::vector<CodeLocation>> locations() {
    if (Text.empty())
      return here();
    if (Text.front() == '*')
      return address();
    auto [Files, Rest] = splitFile();
    if (std::optional<uint32_t> Line = lineNumber(Rest)) {
      if (Error E = checkFiles(Files))
        return std::move(E);
      if (Text == Rest && !Defaults.Position.isKnown())
        return createStringError(
            "No default source file; say FILE:LINE of a file that was "
            "compiled with -g.");
      return atLine(Files ? *Files : std::vector{Defaults.Position.File},
                    *Line);
    }
    if (Rest.empty() || Rest.front() == '+' || Rest.front() == '-' ||
        isDigit(Rest.front()))
      return createStringError("malformed location: '" + Text + "'");
    return function(Files, Rest);
  }

  Expected<SourcePosition> line() {
    auto [Files, Rest] = splitFile();
    if (Error E = checkFiles(Files))
      return std::move(E);
    if (std::optional<uint32_t> Line = lineNumber(Rest)) {
      if (!Files && !Defaults.Position.isKnown())
        return createStringError("No default source file.");
      return SourcePosition{Files ? Files->front() : Defaults.Position.File,
                            *Line, 0};
    }
    Expected<std::vector<uint32_t>> Found =
        !Text.empty() && Text.front() != '*'
            ? functions(Files, Rest)
            : Expected<std::vector<uint32_t>>(std::vector<uint32_t>());
    if (!Found)
      return Found.takeError();
    for (uint32_t F : *Found)
      if (Map.function(F).Declared.isKnown())
        return Map.function(F).Declared;
    Expected<std::vector<CodeLocation>> Code = locations();
    if (!Code)
      return Code.takeError();
    if (!Code->front().Position.isKnown())
      return createStringError("No line number information available for " +
                               Map.describeAddress(Code->front().Address));
    return Code->front().Position;
  }

private:
  StringRef Text;
  DebugInformation &Information;
  const SourceMap &Map;
  const LocationDefaults &Defaults;

  using FileList = std::optional<std::vector<SourceFileId>>;

  CodeLocation at(uint32_t Address) const {
    const LineRange *Line = Map.lineAt(Address);
    return {Address, Line ? Line->Position : SourcePosition(), std::nullopt};
  }

  CodeLocation atBody(uint32_t Function) const {
    CodeLocation Result = at(Map.function(Function).Body);
    Result.Function = Function;
    for (const InlinedCall &Call : Map.callsAt(Result.Address))
      if (Call.Function == Function && Call.Position.isKnown())
        Result.Position = Call.Position;
    return Result;
  }

  Expected<std::vector<CodeLocation>> here() {
    if (!Defaults.Frame)
      return createStringError("No default breakpoint address now.");
    return std::vector{at(Defaults.Frame->Pc)};
  }

  Expected<std::vector<CodeLocation>> address() {
    Expected<Expression> Parsed =
        Expression::parse(Text.drop_front(), Information, Defaults.Frame);
    if (!Parsed)
      return Parsed.takeError();
    FrameContext Nowhere;
    MachineAccess None;
    None.Read = [](uint32_t, MutableArrayRef<uint8_t>) { return false; };
    Nowhere.Machine = &None;
    const FrameContext &Frame = Defaults.Frame ? *Defaults.Frame : Nowhere;
    Expected<Value> Result = Parsed->evaluate(Frame);
    if (!Result)
      return Result.takeError();
    if (Result->type().stripped().Kind == TypeKind::Function)
      if (std::optional<uint32_t> Address = Result->address())
        return std::vector{at(*Address)};
    Expected<uint64_t> Address = Result->asInteger(Frame);
    if (!Address)
      return Address.takeError();
    if (*Address > UINT32_MAX || *Address % 4 != 0)
      return createStringError("Not the address of an instruction: 0x" +
                               Twine::utohexstr(*Address));
    return std::vector{at(uint32_t(*Address))};
  }

  /// The part before a colon that names a file, and the rest.
  std::pair<FileList, StringRef> splitFile() {
    for (size_t Colon = Text.rfind(':'); Colon != StringRef::npos;
         Colon = Text.take_front(Colon).rfind(':')) {
      bool IsScope = (Colon > 0 && Text[Colon - 1] == ':') ||
                     Text.substr(Colon + 1).starts_with(":");
      if (IsScope)
        continue;
      StringRef Rest = Text.substr(Colon + 1).trim();
      return {Information.files().find(Text.take_front(Colon).trim()), Rest};
    }
    return {std::nullopt, Text};
  }

  std::optional<uint32_t> lineNumber(StringRef Number) const {
    uint32_t Line;
    if (!Number.getAsInteger(10, Line))
      return Line;
    StringRef Offset = Number;
    if (Offset.consume_front("+") && !Offset.getAsInteger(10, Line))
      return Defaults.Position.Line + Line;
    Offset = Number;
    if (Offset.consume_front("-") && !Offset.getAsInteger(10, Line) &&
        Line < Defaults.Position.Line)
      return Defaults.Position.Line - Line;
    return std::nullopt;
  }

  Error checkFiles(const FileList &Files) const {
    if (!Files || !Files->empty())
      return Error::success();
    return createStringError("No source file named " +
                             Text.take_front(Text.find(':')) + ".");
  }

  Expected<std::vector<CodeLocation>> atLine(ArrayRef<SourceFileId> Files,
                                             uint32_t Line) {
    std::vector<CodeLocation> Result;
    for (SourceFileId File : Files)
      for (const LineStop &Stop : Map.stopsAtLine(File, Line))
        Result.push_back({Stop.Address, Stop.Position, std::nullopt});
    if (Result.empty())
      return createStringError("No line " + Twine(Line) + " in file \"" +
                               Information.files().name(Files.front()) + "\".");
    return unique(std::move(Result));
  }

  Expected<std::vector<uint32_t>> functions(const FileList &Files,
                                            StringRef Name) {
    if (Error E = checkFiles(Files))
      return std::move(E);
    std::vector<uint32_t> Found = Map.findFunctions(Name);
    if (Files)
      erase_if(Found, [&](uint32_t F) {
        return !is_contained(*Files, Map.function(F).Declared.File);
      });
    if (Found.empty())
      return createStringError(
          "Function \"" + Name + "\" not defined" +
          (Files ? " in \"" + Information.files().name(Files->front()) + "\""
                 : Twine()) +
          ".");
    return Found;
  }

  Expected<std::vector<CodeLocation>> function(const FileList &Files,
                                               StringRef Name) {
    Expected<std::vector<uint32_t>> Found = functions(Files, Name);
    if (!Found)
      return Found.takeError();
    std::vector<CodeLocation> Result;
    for (uint32_t F : *Found)
      Result.push_back(atBody(F));
    return unique(std::move(Result));
  }

  static std::vector<CodeLocation> unique(std::vector<CodeLocation> List) {
    sort(List, [](const CodeLocation &A, const CodeLocation &B) {
      return A.Address < B.Address;
    });
    List.erase(std::unique(List.begin(), List.end(),
                           [](const CodeLocation &A, const CodeLocation &B) {
                             return A.Address == B.Address;
                           }),
               List.end());
    return List;
  }
};

} // namespace

Expected<std::vector<CodeLocation>>
findLocations(StringRef Text, DebugInformation &Information,
              const LocationDefaults &Defaults) {
  return LocationReader(Text, Information, Defaults).locations();
}

Expected<SourcePosition> findLine(StringRef Text, DebugInformation &Information,
                                  const LocationDefaults &Defaults) {
  return LocationReader(Text, Information, Defaults).line();
}

bool beginsLine(const SourceMap &Map, uint32_t Pc) {
  const LineRange *Line = Map.lineAt(Pc);
  if (!Line || !Line->Position.isKnown() || Line->Begin != Pc)
    return false;
  const LineRange *Before = Map.lineAt(Pc - 4);
  return !Before || Before->Position.File != Line->Position.File ||
         Before->Position.Line != Line->Position.Line ||
         Map.functionAt(Pc - 4) != Map.functionAt(Pc);
}

} // namespace tp
