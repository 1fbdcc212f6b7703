//===- YamlTree.cpp - A YAML document with line numbers -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/YamlTree.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Support/YAMLParser.h"

using namespace llvm;

namespace tp {
namespace {

/// Converts LLVM's streamed nodes to a tree and keeps the first error.
class TreeBuilder {
public:
  TreeBuilder(StringRef Text, StringRef FileName)
      : FileName(FileName), Stream(MemoryBufferRef(Text, FileName), Sources,
                                   /*ShowColors=*/false) {
    Sources.setDiagHandler(
        [](const SMDiagnostic &Diagnostic, void *Context) {
          auto *Builder = static_cast<TreeBuilder *>(Context);
          Builder->error(std::max(Diagnostic.getLineNo(), 1),
                         Diagnostic.getMessage());
        },
        this);
  }

  Expected<YamlValue> build() {
    YamlValue Root;
    yaml::document_iterator Document = Stream.begin();
    yaml::Node *Node = Document == Stream.end() ? nullptr : Document->getRoot();
    if (Node && !isa<yaml::NullNode>(Node)) {
      Root = convert(Node);
      if (Root.Is != YamlValue::Kind::Mapping)
        error(Root.Line, "expected `key: value` lines");
      if (Message.empty() && ++Document != Stream.end())
        error(Root.Line, "the file holds more than one document");
    } else {
      error(1, "the file is empty; expected `key: value` lines");
    }
    if (Stream.failed())
      error(1, "not a YAML file");
    if (!Message.empty())
      return createStringError(Message);
    return Root;
  }

private:
  StringRef FileName;
  SourceMgr Sources;
  yaml::Stream Stream;
  std::string Message;

  void error(unsigned Line, const Twine &What) {
    if (Message.empty())
      Message = (FileName + ":" + Twine(Line) + ": " + What).str();
  }

  unsigned lineOf(const yaml::Node *Node) {
    SMLoc Location = Node->getSourceRange().Start;
    return Location.isValid() ? Sources.getLineAndColumn(Location).first : 1;
  }

  YamlValue convert(yaml::Node *Node) {
    YamlValue Value;
    Value.Line = lineOf(Node);
    if (auto *Scalar = dyn_cast<yaml::ScalarNode>(Node)) {
      SmallString<64> Storage;
      Value.Text = Scalar->getValue(Storage).str();
    } else if (auto *Block = dyn_cast<yaml::BlockScalarNode>(Node)) {
      Value.Text = Block->getValue().rtrim('\n').str();
    } else if (auto *Mapping = dyn_cast<yaml::MappingNode>(Node)) {
      Value.Is = YamlValue::Kind::Mapping;
      for (yaml::KeyValueNode &Pair : *Mapping)
        addEntry(Value, Pair);
    } else if (auto *Sequence = dyn_cast<yaml::SequenceNode>(Node)) {
      Value.Is = YamlValue::Kind::Sequence;
      Sequence->skip();
    } else if (isa<yaml::AliasNode>(Node)) {
      error(Value.Line, "aliases (`*name`) are not understood here");
    }
    return Value;
  }

  void addEntry(YamlValue &Mapping, yaml::KeyValueNode &Pair) {
    auto *Key = dyn_cast_or_null<yaml::ScalarNode>(Pair.getKey());
    if (!Key) {
      error(lineOf(&Pair), "expected a plain word as key");
      Pair.skip();
      return;
    }
    YamlEntry Entry;
    SmallString<64> Storage;
    Entry.Key = Key->getValue(Storage).str();
    Entry.Line = lineOf(Key);
    for (const YamlEntry &Earlier : Mapping.Entries)
      if (Earlier.Key == Entry.Key)
        error(Entry.Line, "key '" + Entry.Key +
                              "' is given twice; the first is on line " +
                              Twine(Earlier.Line));
    if (yaml::Node *Value = Pair.getValue()) {
      Entry.Value = convert(Value);
      if (isa<yaml::NullNode>(Value))
        Entry.Value.Line = Entry.Line;
    }
    Mapping.Entries.push_back(std::move(Entry));
  }
};

} // namespace

YamlEntry *YamlValue::find(StringRef Key) {
  for (YamlEntry &Entry : Entries)
    if (Entry.Key == Key)
      return &Entry;
  return nullptr;
}

YamlEntry *findPath(YamlValue &Mapping, StringRef Path) {
  auto [Key, Rest] = Path.split('.');
  YamlEntry *Entry = Mapping.find(Key);
  return Entry && !Rest.empty() ? findPath(Entry->Value, Rest) : Entry;
}

void shiftLines(YamlValue &Value, unsigned Offset) {
  Value.Line += Offset;
  for (YamlEntry &Entry : Value.Entries) {
    Entry.Line += Offset;
    shiftLines(Entry.Value, Offset);
  }
}

Expected<YamlValue> parseYaml(StringRef Text, StringRef FileName) {
  return TreeBuilder(Text, FileName).build();
}

} // namespace tp
