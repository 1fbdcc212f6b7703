//===- LaunchRequest.cpp - What a launch configuration asks for -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/LaunchRequest.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp::dap {

/// What editors add to a configuration for their own use.
static bool isEditorsOwn(StringRef Attribute) {
  static constexpr StringLiteral Names[] = {
      "console",
      "debugServer",
      "internalConsoleOptions",
      "linux",
      "name",
      "osx",
      "postDebugTask",
      "preLaunchTask",
      "presentation",
      "request",
      "restart",
      "serverReadyAction",
      "suppressMultipleSessionWarning",
      "type",
      "windows",
  };
  return Attribute.starts_with("_") || Attribute.starts_with(":") ||
         is_contained(Names, Attribute);
}

/// `hostThreads` as the command line has it: `--host-threads`.
static std::string optionName(StringRef Attribute) {
  std::string Name = Attribute.size() == 1 ? "-" : "--";
  for (char C : Attribute) {
    if (isUpper(C))
      Name += '-';
    Name += toLower(C);
  }
  return Name;
}

/// A string or a number as the command line has it.
static std::optional<std::string> scalarText(const json::Value &Value) {
  if (std::optional<StringRef> Text = Value.getAsString())
    return Text->str();
  if (!Value.getAsNumber())
    return std::nullopt;
  std::string Text;
  raw_string_ostream(Text) << Value;
  return Text;
}

static Error wrongAttribute(StringRef Attribute, StringRef Expected) {
  return createStringError("launch configuration: '" + Attribute +
                           "': expected " + Expected);
}

namespace {

/// Turns the attributes into a command line.
class LaunchReader {
public:
  Expected<LaunchRequest> read(const json::Object &Attributes) {
    // In a fixed order, so that errors are always the same ones.
    std::vector<const json::Object::value_type *> Sorted;
    for (const auto &Attribute : Attributes)
      Sorted.push_back(&Attribute);
    sort(Sorted,
         [](const auto *A, const auto *B) { return A->first < B->first; });
    for (const auto *Attribute : Sorted)
      if (Error Problem = readAttribute(Attribute->first, Attribute->second))
        return Problem;
    if (Program.empty())
      return createStringError("launch configuration: 'program' is missing; "
                               "give the executable that tpcc linked");
    Result.CommandLine.push_back(Program);
    if (!ProgramArguments.empty())
      Result.CommandLine.push_back("--");
    append_range(Result.CommandLine, ProgramArguments);
    return std::move(Result);
  }

private:
  LaunchRequest Result;
  std::string Program;
  std::vector<std::string> ProgramArguments;

  Error readAttribute(StringRef Name, const json::Value &Value) {
    if (isEditorsOwn(Name))
      return Error::success();
    if (Name == "program")
      return readText(Name, Value, Program);
    if (Name == "cwd")
      return readText(Name, Value, Result.Folder);
    if (Name == "stopOnEntry")
      return readFlag(Name, Value, Result.StopOnEntry);
    if (Name == "stopAtEnd")
      return readFlag(Name, Value, Result.StopAtEnd);
    if (Name == "threadList")
      return readThreadList(Value);
    if (Name == "noDebug")
      return readFlag(Name, Value, Result.NoDebug);
    if (Name == "args")
      return readArguments(Value);
    if (Name == "sourceMap")
      return readSourceMap(Value);
    return readOption(Name, Value);
  }

  Error readText(StringRef Name, const json::Value &Value, std::string &Text) {
    std::optional<StringRef> Given = Value.getAsString();
    if (!Given)
      return wrongAttribute(Name, "a string");
    Text = Given->str();
    return Error::success();
  }

  Error readFlag(StringRef Name, const json::Value &Value, bool &Flag) {
    std::optional<bool> Given = Value.getAsBoolean();
    if (!Given)
      return wrongAttribute(Name, "true or false");
    Flag = *Given;
    return Error::success();
  }

  Error readArguments(const json::Value &Value) {
    const json::Array *List = Value.getAsArray();
    if (!List)
      return wrongAttribute("args", "a list of strings");
    for (const json::Value &Item : *List) {
      std::optional<std::string> Text = scalarText(Item);
      if (!Text)
        return wrongAttribute("args", "a list of strings");
      ProgramArguments.push_back(*Text);
    }
    return Error::success();
  }

  Error readThreadList(const json::Value &Value) {
    if (Value != "all" && Value != "grouped")
      return wrongAttribute("threadList", "'all' or 'grouped'");
    Result.GroupThreads = Value == "grouped";
    return Error::success();
  }

  Error readSourceMap(const json::Value &Value) {
    const json::Object *Map = Value.getAsObject();
    if (!Map)
      return wrongAttribute("sourceMap", "an object of strings");
    for (const auto &[From, To] : *Map) {
      std::optional<StringRef> Path = To.getAsString();
      if (!Path)
        return wrongAttribute("sourceMap", "an object of strings");
      Result.SourceMap.emplace_back(StringRef(From).str(), Path->str());
    }
    sort(Result.SourceMap);
    return Error::success();
  }

  Error readOption(StringRef Name, const json::Value &Value) {
    std::string Option = optionName(Name);
    if (std::optional<bool> Flag = Value.getAsBoolean()) {
      if (*Flag)
        Result.CommandLine.push_back(Option);
      return Error::success();
    }
    if (std::optional<std::string> Text = scalarText(Value)) {
      addOption(Option, *Text);
      return Error::success();
    }
    if (const json::Array *List = Value.getAsArray()) {
      for (const json::Value &Item : *List) {
        std::optional<std::string> Text = scalarText(Item);
        if (!Text)
          return wrongAttribute(Name, "a list of strings or numbers");
        addOption(Option, *Text);
      }
      return Error::success();
    }
    if (const json::Object *Settings = Value.getAsObject()) {
      std::vector<std::string> Texts;
      for (const auto &[Key, Setting] : *Settings) {
        std::optional<std::string> Text = scalarText(Setting);
        if (!Text)
          return wrongAttribute(Name, "an object of strings and numbers");
        Texts.push_back(StringRef(Key).str() + "=" + *Text);
      }
      sort(Texts);
      for (StringRef Text : Texts)
        addOption(Option, Text);
      return Error::success();
    }
    return wrongAttribute(Name, "a string, a number, true, false, a list or "
                                "an object");
  }

  void addOption(StringRef Option, StringRef Value) {
    Result.CommandLine.push_back(Option.str());
    Result.CommandLine.push_back(Value.str());
  }
};

} // namespace

Expected<LaunchRequest> readLaunch(const json::Value &Arguments) {
  const json::Object *Attributes = Arguments.getAsObject();
  if (!Attributes)
    return createStringError("launch: expected an object as arguments");
  return LaunchReader().read(*Attributes);
}

} // namespace tp::dap
