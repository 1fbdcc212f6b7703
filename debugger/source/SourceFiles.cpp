//===- SourceFiles.cpp - The source files of a program -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/SourceFiles.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace tp {

static std::string normalized(const Twine &Path) {
  SmallString<256> Result;
  Path.toVector(Result);
  sys::path::remove_dots(Result, /*remove_dot_dot=*/true);
  return std::string(Result);
}

SourceFiles::SourceFiles() = default;
SourceFiles::~SourceFiles() = default;

SourceFileId SourceFiles::add(StringRef Name, StringRef Folder,
                              std::optional<MD5::MD5Result> Checksum) {
  SmallString<256> Path;
  if (!sys::path::is_absolute(Name))
    Path = Folder;
  sys::path::append(Path, Name);
  std::string Normal = normalized(Path);
  auto [Where, IsNew] = ByPath.try_emplace(Normal, size());
  if (IsNew) {
    File New;
    New.Name = normalized(Name);
    New.Path = std::move(Normal);
    New.Checksum = Checksum;
    Files.push_back(std::move(New));
  } else if (!Files[Where->second].Checksum) {
    Files[Where->second].Checksum = Checksum;
  }
  return Where->second;
}

std::string SourceFiles::path(SourceFileId Id) const {
  std::string Path = Files[Id].Path;
  for (const auto &[From, To] : Substitutions)
    if (StringRef(Path).starts_with(From) &&
        (From.back() == '/' || Path.size() == From.size() ||
         Path[From.size()] == '/')) {
      Path = normalized(To + StringRef(Path).drop_front(From.size()));
      break;
    }
  if (sys::fs::exists(Path))
    return Path;
  for (const std::string &Folder : Folders)
    for (StringRef Name :
         {StringRef(Files[Id].Name), sys::path::filename(Path)}) {
      SmallString<256> Candidate(Folder);
      sys::path::append(Candidate, sys::path::relative_path(Name));
      if (sys::fs::exists(Candidate))
        return normalized(Candidate);
    }
  return Path;
}

std::string SourceFiles::shortName(SourcePosition Position) const {
  return (sys::path::filename(Files[Position.File].Name) + ":" +
          Twine(Position.Line))
      .str();
}

std::vector<SourceFileId> SourceFiles::find(StringRef Name) const {
  std::string Wanted = normalized(Name);
  std::vector<SourceFileId> Result;
  for (SourceFileId Id = 0; Id != size(); ++Id) {
    StringRef Path = Files[Id].Path;
    if (Path == Wanted || path(Id) == Wanted ||
        (Path.ends_with(Wanted) &&
         Path.drop_back(Wanted.size()).ends_with("/")))
      Result.push_back(Id);
  }
  return Result;
}

void SourceFiles::load(File &F, SourceFileId Id) {
  F.Loaded = true;
  std::string Path = path(Id);
  ErrorOr<std::unique_ptr<MemoryBuffer>> Text = MemoryBuffer::getFile(Path);
  if (!Text) {
    F.LoadError = Path + ": " + Text.getError().message();
    return;
  }
  F.Text = std::move(*Text);
  StringRef Rest = F.Text->getBuffer();
  while (!Rest.empty()) {
    auto [Line, Behind] = Rest.split('\n');
    F.Lines.push_back(Line.ends_with("\r") ? Line.drop_back() : Line);
    Rest = Behind;
  }
}

Expected<ArrayRef<StringRef>> SourceFiles::text(SourceFileId Id) {
  File &F = Files[Id];
  if (!F.Loaded)
    load(F, Id);
  if (!F.Text)
    return createStringError(F.LoadError);
  return F.Lines;
}

std::optional<StringRef> SourceFiles::line(SourcePosition Position) {
  Expected<ArrayRef<StringRef>> Text = text(Position.File);
  if (!Text) {
    consumeError(Text.takeError());
    return std::nullopt;
  }
  if (Position.Line == 0 || Position.Line > Text->size())
    return std::nullopt;
  return (*Text)[Position.Line - 1];
}

bool SourceFiles::hasChanged(SourceFileId Id) {
  File &F = Files[Id];
  if (!F.Loaded)
    load(F, Id);
  if (!F.Text || !F.Checksum)
    return false;
  return MD5::hash(arrayRefFromStringRef(F.Text->getBuffer())) != *F.Checksum;
}

void SourceFiles::forgetText() {
  for (File &F : Files) {
    F.Loaded = false;
    F.Text.reset();
    F.Lines.clear();
  }
}

void SourceFiles::substitute(StringRef From, StringRef To) {
  if (From.empty())
    return;
  Substitutions.emplace_back(From, To);
  forgetText();
}

void SourceFiles::addFolder(StringRef Folder) {
  Folders.emplace_back(Folder);
  forgetText();
}

} // namespace tp
