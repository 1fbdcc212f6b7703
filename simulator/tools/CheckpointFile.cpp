//===- CheckpointFile.cpp - The state of a run in a file ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/CheckpointFile.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Compression.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/xxhash.h"

#include <optional>

using namespace llvm;

namespace tp {

/// The last character is the version of the format.
static constexpr StringRef Magic = "TPCHKPT2";

namespace {

enum class Packing : uint64_t { None, Zlib, Zstd };

/// What follows the hash.
class Body {
public:
  void word(uint64_t Value) {
    char Bytes[sizeof(Value)];
    support::endian::write64le(Bytes, Value);
    Text.append(Bytes, sizeof(Bytes));
  }
  void text(StringRef Value) {
    word(Value.size());
    Text += Value;
  }
  StringRef all() const { return Text; }

private:
  std::string Text;
};

/// Reads it, or fails for good where it ends too early.
class BodyReader {
public:
  explicit BodyReader(StringRef Rest) : Rest(Rest) {}

  std::optional<uint64_t> word() {
    if (Rest.size() < sizeof(uint64_t))
      return std::nullopt;
    uint64_t Value = support::endian::read64le(Rest.data());
    Rest = Rest.drop_front(sizeof(Value));
    return Value;
  }
  std::optional<StringRef> text() {
    std::optional<uint64_t> Size = word();
    if (!Size || *Size > Rest.size())
      return std::nullopt;
    StringRef Value = Rest.take_front(*Size);
    Rest = Rest.drop_front(*Size);
    return Value;
  }

private:
  StringRef Rest;
};

} // namespace

static uint64_t hashOf(StringRef Text) {
  return xxh3_64bits(arrayRefFromStringRef(Text));
}

static std::string textOf(const RunIdentity &Identity) {
  std::string Text;
  for (const auto &[Name, Value] : Identity)
    Text += (Twine(Name) + "\t" + Value + "\n").str();
  return Text;
}

static Packing choosePacking() {
  if (compression::zstd::isAvailable())
    return Packing::Zstd;
  return compression::zlib::isAvailable() ? Packing::Zlib : Packing::None;
}

static void pack(Packing How, ArrayRef<uint8_t> State,
                 SmallVectorImpl<uint8_t> &Packed) {
  switch (How) {
  case Packing::None:
    Packed.append(State.begin(), State.end());
    break;
  case Packing::Zlib:
    compression::zlib::compress(State, Packed,
                                compression::zlib::BestSpeedCompression);
    break;
  case Packing::Zstd:
    compression::zstd::compress(State, Packed,
                                compression::zstd::BestSpeedCompression);
    break;
  }
}

llvm::Error writeCheckpoint(StringRef Path, const RunIdentity &Identity,
                            ArrayRef<uint8_t> State) {
  Packing How = choosePacking();
  SmallVector<uint8_t, 0> Packed;
  pack(How, State, Packed);
  Body Contents;
  Contents.text(textOf(Identity));
  Contents.word(uint64_t(How));
  Contents.word(State.size());
  Contents.text(toStringRef(Packed));
  char Hash[sizeof(uint64_t)];
  support::endian::write64le(Hash, hashOf(Contents.all()));
  llvm::Error E = writeToOutput(Path, [&](raw_ostream &OS) {
    OS << Magic << StringRef(Hash, sizeof(Hash)) << Contents.all();
    return llvm::Error::success();
  });
  if (E)
    return createStringError("cannot write the checkpoint " + Path + ": " +
                             toString(std::move(E)));
  return llvm::Error::success();
}

/// Fails if the run that made the checkpoint is not the one that wants it.
static llvm::Error checkIdentity(StringRef Path, StringRef Saved,
                                 const RunIdentity &Identity) {
  SmallVector<StringRef> Lines;
  Saved.split(Lines, '\n', -1, /*KeepEmpty=*/false);
  if (Lines.size() != Identity.size())
    return createStringError(Path + ": made by another version of tpsim");
  for (auto [Line, Wanted] : zip_equal(Lines, Identity)) {
    auto [Name, Value] = Line.split('\t');
    if (Name != Wanted.first)
      return createStringError(Path + ": made by another version of tpsim");
    if (Value != Wanted.second)
      return createStringError(Path + ": made by another run: its " + Name +
                               " is '" + Value + "', this run's is '" +
                               Wanted.second +
                               "'; restore it with what it was made with");
  }
  return llvm::Error::success();
}

static llvm::Error unpack(Packing How, ArrayRef<uint8_t> Packed, uint64_t Size,
                          std::vector<uint8_t> &State) {
  State.resize(Size);
  size_t Bytes = Size;
  switch (How) {
  case Packing::None:
    if (Packed.size() != Size)
      return createStringError("its size is wrong");
    std::copy(Packed.begin(), Packed.end(), State.begin());
    return llvm::Error::success();
  case Packing::Zlib:
    if (!compression::zlib::isAvailable())
      return createStringError("it is compressed by zlib, which this tpsim "
                               "lacks");
    return compression::zlib::decompress(Packed, State.data(), Bytes);
  case Packing::Zstd:
    if (!compression::zstd::isAvailable())
      return createStringError("it is compressed by zstd, which this tpsim "
                               "lacks");
    return compression::zstd::decompress(Packed, State.data(), Bytes);
  }
  return createStringError("its compression is unknown");
}

Expected<std::vector<uint8_t>> readCheckpoint(StringRef Path,
                                              const RunIdentity &Identity) {
  ErrorOr<std::unique_ptr<MemoryBuffer>> File =
      MemoryBuffer::getFile(Path, /*IsText=*/false,
                            /*RequiresNullTerminator=*/false);
  if (std::error_code EC = File.getError())
    return createStringError("cannot read the checkpoint " + Path + ": " +
                             EC.message());
  StringRef Contents = (*File)->getBuffer();
  StringRef Kind = Magic.drop_back();
  if (!Contents.starts_with(Kind))
    return createStringError(Path + ": not a checkpoint of tpsim");
  if (!Contents.consume_front(Magic))
    return createStringError(Path +
                             ": a checkpoint of another version of tpsim");
  StringRef Damaged = ": the checkpoint is damaged; take an older one";
  BodyReader Header(Contents);
  std::optional<uint64_t> Hash = Header.word();
  if (!Hash || *Hash != hashOf(Contents.drop_front(sizeof(uint64_t))))
    return createStringError(Path + Damaged);
  std::optional<StringRef> Saved = Header.text();
  std::optional<uint64_t> How = Header.word();
  std::optional<uint64_t> Size = Header.word();
  std::optional<StringRef> Packed = Header.text();
  if (!Saved || !How || !Size || !Packed)
    return createStringError(Path + Damaged);
  if (llvm::Error E = checkIdentity(Path, *Saved, Identity))
    return E;
  std::vector<uint8_t> State;
  if (llvm::Error E =
          unpack(Packing(*How), arrayRefFromStringRef(*Packed), *Size, State))
    return createStringError("cannot read the checkpoint " + Path + ": " +
                             toString(std::move(E)));
  return State;
}

} // namespace tp
