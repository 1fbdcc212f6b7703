//===- MemoryRequests.cpp - Requests about memory and code ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/MemoryRequests.h"

#include "debugger/dap/DisassemblyView.h"

#include "llvm/ADT/bit.h"
#include "llvm/Support/Base64.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp::dap {

/// A client asks for a screenful; more is a mistake.
constexpr int64_t MaxBytes = 16 << 20;
constexpr int64_t MaxInstructions = 1 << 16;

void MemoryRequests::addTo(Dispatcher &Requests) {
  using Self = MemoryRequests;
  Requests.on("readMemory", Stage::Stopped, this, &Self::readMemory);
  Requests.on("writeMemory", Stage::Stopped, this, &Self::writeMemory);
  Requests.on("disassemble", Stage::Launched, this, &Self::disassemble);
}

Expected<MemoryRequests::Place> MemoryRequests::place(StringRef Reference,
                                                      int64_t Offset) {
  Expected<MemoryReference> Parsed = parseMemoryReference(Reference);
  if (!Parsed)
    return Parsed.takeError();
  Expected<uint32_t> Address = addressPlus(Parsed->Address, Offset);
  if (!Address)
    return Address.takeError();
  uint32_t Default = Target.LastStop ? Target.LastStop->Thread : 0;
  Expected<uint32_t> Thread =
      Target.thread(threadId(Parsed->Thread.value_or(Default)));
  if (!Thread)
    return Thread.takeError();
  return Place{*Address, &Target.Program->machine(*Thread)};
}

/// How many of the bytes from \p Address on are memory, at most as many as
/// \p Bytes, which gets them.
static size_t readableBytes(const MachineAccess &Machine, uint32_t Address,
                            MutableArrayRef<uint8_t> Bytes) {
  if (Machine.Read(Address, Bytes))
    return Bytes.size();
  size_t Good = 0;
  for (size_t Step = bit_floor(Bytes.size()); Step > 0; Step /= 2)
    while (Good + Step <= Bytes.size() &&
           Machine.Read(uint32_t(Address + Good), Bytes.slice(Good, Step)))
      Good += Step;
  return Good;
}

Response MemoryRequests::readMemory(const ReadMemoryArguments &Arguments) {
  if (Arguments.Count < 0 || Arguments.Count > MaxBytes)
    return createStringError("cannot read " + Twine(Arguments.Count) +
                             " bytes at once; at most " + Twine(MaxBytes));
  Expected<Place> From = place(Arguments.MemoryReference, Arguments.Offset);
  if (!From)
    return From.takeError();
  // Memory does not go on at address 0 behind the last one.
  uint64_t InSpace = (uint64_t(1) << 32) - From->Address;
  std::vector<uint8_t> Bytes(std::min<uint64_t>(Arguments.Count, InSpace));
  Bytes.resize(readableBytes(*From->Machine, From->Address, Bytes));
  json::Object Answer{
      {"address", addressText(From->Address)},
      {"unreadableBytes", Arguments.Count - int64_t(Bytes.size())}};
  if (!Bytes.empty())
    Answer["data"] = encodeBase64(Bytes);
  return std::move(Answer);
}

Response MemoryRequests::writeMemory(const WriteMemoryArguments &Arguments) {
  Expected<Place> To = place(Arguments.MemoryReference, Arguments.Offset);
  if (!To)
    return To.takeError();
  std::vector<char> Data;
  if (llvm::Error Problem = decodeBase64(Arguments.Data, Data))
    return std::move(Problem);
  ArrayRef<uint8_t> Bytes(reinterpret_cast<const uint8_t *>(Data.data()),
                          Data.size());
  if (!To->Machine->Write(To->Address, Bytes))
    return createStringError(Twine(Bytes.size()) + " bytes at " +
                             addressText(To->Address) +
                             " are not writable memory of the thread");
  Target.changed();
  return json::Object{{"bytesWritten", int64_t(Bytes.size())}};
}

Response MemoryRequests::disassemble(const DisassembleArguments &Arguments) {
  Expected<MemoryReference> Reference =
      parseMemoryReference(Arguments.MemoryReference);
  if (!Reference)
    return Reference.takeError();
  if (Arguments.InstructionCount < 0 ||
      Arguments.InstructionCount > MaxInstructions)
    return createStringError(
        "cannot show " + Twine(Arguments.InstructionCount) +
        " instructions at once; at most " + Twine(MaxInstructions));
  if (!isInt<33>(Arguments.Offset) || !isInt<33>(Arguments.InstructionOffset))
    return createStringError("the offset is outside of 32 bits");
  int64_t First = int64_t(Reference->Address) + Arguments.Offset;
  First = (First & ~int64_t(3)) + 4 * Arguments.InstructionOffset;
  DisassemblyView View(Target.Program->program(),
                       Target.Program->information());
  return json::Object{
      {"instructions", View.show(First, uint32_t(Arguments.InstructionCount))}};
}

} // namespace tp::dap
