//===- ChipFile.cpp - Reading and writing chip files ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/YAMLParser.h"

#include <algorithm>

using namespace llvm;

namespace tp {

/// True for the classes whose latency is the memory's and not a unit's.
static bool isMemoryClass(LatencyClass Class) {
  return Class == LatencyClass::Load || Class == LatencyClass::Atomic ||
         Class == LatencyClass::Store;
}

static void readMachine(YamlSection &Root, ChipConfig &Chip,
                        YamlErrors &Errors) {
  Chip.Description = Root.text("description");
  Chip.ClockGHz = Root.number("clock_ghz", 0.001, 100, 1);
  Chip.TmCount = Root.integer("tm_count", 1, MaxThreads, 1);
  Chip.TpsPerTm = Root.integer("tps_per_tm", 1, MaxTpsPerTm, 1);
  if (uint64_t(Chip.TmCount) * Chip.TpsPerTm > MaxThreads)
    Errors.add(Root.lineOf("tps_per_tm"),
               Twine(Chip.TmCount) + " TMs x " + Twine(Chip.TpsPerTm) +
                   " TPs are more than the " + Twine(MaxThreads) +
                   " threads that the simulator allows");
  Chip.FlushToZero = Root.boolean("flush_to_zero", false);
}

static void readMemories(YamlSection &Root, ChipConfig &Chip,
                         YamlErrors &Errors) {
  YamlSection Memory = Root.section("memory");
  Chip.MemoryBytes = Memory.bytes("bytes", MinMemoryBytes, MaxMemoryBytes, 16);
  Chip.MemoryLatency = Memory.integer("latency_cycles", 1, MaxLatency, 1);
  Memory.finish();

  // The window ends before anything that left the TM in it comes back.
  Chip.ArbitrationWindow = Root.integer("arbitration_window_cycles", 1,
                                        MaxLatency, 1, Presence::Required);
  if (Memory.has("latency_cycles") &&
      Chip.ArbitrationWindow > Chip.MemoryLatency)
    Errors.add(Root.lineOf("arbitration_window_cycles"),
               "'arbitration_window_cycles' is " +
                   Twine(Chip.ArbitrationWindow) +
                   "; give it at most memory.latency_cycles, which is " +
                   Twine(Chip.MemoryLatency));

  YamlSection LocalStore = Root.section("local_store");
  Chip.LocalStoreBytes =
      LocalStore.bytes("bytes", 1024, MaxLocalStoreBytes, 16);
  Chip.LocalStoreAreaMm2 = LocalStore.number("area_mm2", 0, 1000, 0);
  LocalStore.finish();

  YamlSection RegisterFile = Root.section("register_file");
  Chip.RegisterFileAreaMm2 = RegisterFile.number("area_mm2", 0, 1000, 0);
  RegisterFile.finish();

  YamlSection Icache = Root.section("icache");
  Chip.IcacheBanks = Icache.integer("banks", 1, MaxIcacheBanks, 1);
  if (!isPowerOf2_32(Chip.IcacheBanks))
    Errors.add(Icache.lineOf("banks"), "'icache.banks' is " +
                                           Twine(Chip.IcacheBanks) +
                                           "; give it a power of two");
  Chip.IcachePorts = Icache.integer("ports_per_bank", 1, MaxIcachePorts, 1);
  Chip.IcacheBytes = Icache.bytes("bytes", 64, 1 << 30, 4);
  Chip.IcacheAreaMm2 = Icache.number("area_mm2", 0, 1000, 0);
  Icache.finish();
}

static void readUnits(YamlSection &Root, ChipConfig &Chip) {
  YamlSection Units = Root.section("units");
  for (unsigned I = 0; I != NumUnits; ++I) {
    YamlSection Section = Units.section(unitName(Unit(I)));
    UnitConfig &Config = Chip.Units[I];
    Config.Count = Section.integer("count", 1, MaxUnitCount, 1);
    Config.Interval = Section.integer("interval_cycles", 1, MaxUnitInterval, 1,
                                      Presence::Optional);
    Config.AreaMm2 = Section.number("area_mm2", 0, 1000, 0);
    Section.finish();
  }
  Units.finish();

  YamlSection Latencies = Root.section("latency_cycles", Presence::Optional);
  for (unsigned I = 0; I != NumLatencyClasses; ++I) {
    LatencyClass Class = LatencyClass(I);
    Chip.Latency[I] = defaultLatency(Class);
    if (!isMemoryClass(Class))
      Chip.Latency[I] =
          Latencies.integer(latencyClassName(Class), 1, MaxLatency,
                            Chip.Latency[I], Presence::Optional);
  }
  Latencies.finish();
}

Expected<ChipConfig> parseChip(StringRef Text, StringRef FileName,
                               StringRef Name) {
  Expected<YamlValue> Tree = parseYaml(Text, FileName);
  if (!Tree)
    return Tree.takeError();
  YamlErrors Errors(FileName);
  return buildChip(*Tree, Errors, Name);
}

Expected<ChipConfig> buildChip(const YamlValue &Tree, YamlErrors &Errors,
                               StringRef Name) {
  YamlSection Root(Errors, Tree, 1, "");
  ChipConfig Chip;
  Chip.Name = Name.str();
  readMachine(Root, Chip, Errors);
  readMemories(Root, Chip, Errors);
  readUnits(Root, Chip);
  Root.finish();
  if (Error E = Errors.take())
    return E;
  return Chip;
}

std::vector<std::string> chipNames(StringRef ChipFolder) {
  std::vector<std::string> Names;
  std::error_code EC;
  for (sys::fs::directory_iterator I(ChipFolder, EC), End; I != End && !EC;
       I.increment(EC))
    if (sys::path::extension(I->path()) == ".yaml")
      Names.push_back(sys::path::stem(I->path()).str());
  llvm::sort(Names);
  return Names;
}

Expected<ChipConfig> loadChip(StringRef NameOrPath, StringRef ChipFolder) {
  SmallString<256> Path = NameOrPath;
  bool IsPath = NameOrPath.contains('/') || NameOrPath.ends_with(".yaml");
  if (!IsPath) {
    Path = ChipFolder;
    sys::path::append(Path, NameOrPath + ".yaml");
  }
  ErrorOr<std::unique_ptr<MemoryBuffer>> Buffer =
      MemoryBuffer::getFile(Path, /*IsText=*/true);
  if (!Buffer && !IsPath && !sys::fs::exists(Path))
    return createStringError(
        "there is no chip '" + NameOrPath + "' in " + ChipFolder +
        "; choose one of: " + join(chipNames(ChipFolder), ", ") +
        ", or give the path of a .yaml file");
  if (!Buffer)
    return createStringError("cannot read the chip file " + Path + ": " +
                             Buffer.getError().message());
  return parseChip((*Buffer)->getBuffer(), Path, sys::path::stem(Path));
}

void writeChip(const ChipConfig &Chip, raw_ostream &OS) {
  auto Number = [](double Value) { return format("%.9g", Value); };
  OS << "# " << Chip.Name << "\n";
  OS << "description: \"" << yaml::escape(Chip.Description) << "\"\n";
  OS << "clock_ghz: " << Number(Chip.ClockGHz) << "\n";
  OS << "tm_count: " << Chip.TmCount << "\n";
  OS << "tps_per_tm: " << Chip.TpsPerTm << "\n";
  OS << "flush_to_zero: " << (Chip.FlushToZero ? "true" : "false") << "\n";
  OS << "arbitration_window_cycles: " << Chip.ArbitrationWindow << "\n";
  OS << "memory:\n  bytes: " << Chip.MemoryBytes
     << "\n  latency_cycles: " << Chip.MemoryLatency << "\n";
  OS << "local_store:\n  bytes: " << Chip.LocalStoreBytes
     << "\n  area_mm2: " << Number(Chip.LocalStoreAreaMm2) << "\n";
  OS << "register_file:\n  area_mm2: " << Number(Chip.RegisterFileAreaMm2)
     << "\n";
  OS << "icache:\n  banks: " << Chip.IcacheBanks
     << "\n  ports_per_bank: " << Chip.IcachePorts
     << "\n  bytes: " << Chip.IcacheBytes
     << "\n  area_mm2: " << Number(Chip.IcacheAreaMm2) << "\n";
  OS << "units:\n";
  for (unsigned I = 0; I != NumUnits; ++I) {
    const UnitConfig &Config = Chip.Units[I];
    OS << "  " << unitName(Unit(I)) << ": {count: " << Config.Count
       << ", interval_cycles: " << Config.Interval
       << ", area_mm2: " << Number(Config.AreaMm2) << "}\n";
  }
  OS << "latency_cycles:\n";
  for (unsigned I = 0; I != NumLatencyClasses; ++I)
    if (!isMemoryClass(LatencyClass(I)))
      OS << "  " << latencyClassName(LatencyClass(I)) << ": " << Chip.Latency[I]
         << "\n";
}

} // namespace tp
