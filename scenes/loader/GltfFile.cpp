//===- GltfFile.cpp - Parsing of glTF files through tinygltf --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/loader/GltfFile.h"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>

namespace tp {

static ErrorOr<std::vector<unsigned char>> readFile(const std::string &Path) {
  const std::unique_ptr<FILE, int (*)(FILE *)> File(
      std::fopen(Path.c_str(), "rb"), std::fclose);
  if (!File)
    return Error{Path + ": " + std::strerror(errno)};
  std::vector<unsigned char> Bytes;
  unsigned char Chunk[1 << 16];
  size_t Count;
  do {
    Count = std::fread(Chunk, 1, sizeof(Chunk), File.get());
    Bytes.insert(Bytes.end(), Chunk, Chunk + Count);
  } while (Count == sizeof(Chunk));
  if (std::ferror(File.get()))
    return Error{Path + ": " + std::strerror(errno)};
  if (Bytes.empty())
    return Error{Path + ": the file is empty"};
  if (Bytes.size() > UINT_MAX)
    return Error{Path + ": the file is larger than 4 GiB"};
  return Bytes;
}

static std::string folderOf(const std::string &Path) {
  const size_t Slash = Path.rfind('/');
  return Slash == std::string::npos ? "." : Path.substr(0, Slash + 1);
}

/// Makes one line of what tinygltf reports as several.
static std::string joinLines(std::string Text) {
  while (!Text.empty() && (Text.back() == '\n' || Text.back() == ' '))
    Text.pop_back();
  for (size_t At; (At = Text.find('\n')) != std::string::npos;)
    Text.replace(At, 1, "; ");
  return Text;
}

static bool ignoreImage(tinygltf::Image *, int, std::string *, std::string *,
                        int, int, const unsigned char *, int, void *) {
  return true;
}

ErrorOr<tinygltf::Model> readGltf(const std::string &Path) {
  ErrorOr<std::vector<unsigned char>> Bytes = readFile(Path);
  if (!Bytes)
    return Bytes.takeError();

  const bool IsBinary =
      Bytes->size() >= 4 && std::memcmp(Bytes->data(), "glTF", 4) == 0;
  const auto Size = static_cast<unsigned>(Bytes->size());
  tinygltf::TinyGLTF Parser;
  Parser.SetImageLoader(ignoreImage, nullptr);
  tinygltf::Model Model;
  std::string Failure, Warning;
  bool Parsed = false;
  try {
    Parsed = IsBinary ? Parser.LoadBinaryFromMemory(&Model, &Failure, &Warning,
                                                    Bytes->data(), Size,
                                                    folderOf(Path))
                      : Parser.LoadASCIIFromString(
                            &Model, &Failure, &Warning,
                            reinterpret_cast<const char *>(Bytes->data()), Size,
                            folderOf(Path));
  } catch (const std::exception &Exception) {
    Failure = Exception.what();
  }
  // The parser reports some errors and still says that all is well.
  if (Parsed && Failure.empty())
    return Model;
  if (Failure.empty())
    Failure = "not a glTF file";
  return Error{Path + ": " + (IsBinary ? "binary glTF: " : "glTF: ") +
               joinLines(Failure)};
}

std::string describe(const char *Kind, size_t Index, const std::string &Name) {
  std::string Words = std::string(Kind) + ' ' + std::to_string(Index);
  if (!Name.empty())
    Words += " \"" + Name + '"';
  return Words;
}

} // namespace tp
