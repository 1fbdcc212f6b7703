//===- ChipChecks.cpp - Whether the values of a chip fit together ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipChecks.h"

#include "simulator/chip/ChipLimits.h"
#include "simulator/chip/MinimumRoundTrip.h"
#include "simulator/memory/dram/DramAddressMapping.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp {
namespace {

class Checker {
public:
  Checker(const ChipConfig &Chip, const YamlValue &Tree, YamlErrors &Errors)
      : Chip(Chip), Tree(Tree), Errors(Errors) {}

  void check() {
    if (Chip.L1)
      checkCache("l1", *Chip.L1);
    if (Chip.L2)
      checkCache("l2", *Chip.L2);
    if (Chip.Dram)
      checkDram(*Chip.Dram);
    checkIcache();
    if (Errors.empty())
      checkWindow();
    if (uint64_t(Chip.TmCount) * Chip.TpsPerTm > MaxThreads)
      bad("tm.tps", Twine(Chip.TmCount) + " TMs x " + Twine(Chip.TpsPerTm) +
                        " TPs are more than the " + Twine(MaxThreads) +
                        " threads that the simulator allows");
  }

private:
  const ChipConfig &Chip;
  const YamlValue &Tree;
  YamlErrors &Errors;

  void bad(StringRef Path, const Twine &What) {
    const YamlEntry *Entry = findPath(Tree, Path);
    // A key that was left out is its section's.
    if (!Entry)
      Entry = findPath(Tree, Path.rsplit('.').first);
    Errors.add(Entry ? Entry->Value.Line : Tree.Line, What);
  }
  void badValue(StringRef Path, uint64_t Value, const Twine &Wanted) {
    bad(Path, "'" + Path + "' is " + Twine(Value) + "; give it " + Wanted);
  }

  void checkCache(const std::string &Name, const CacheConfig &Cache) {
    uint64_t SetBytes = uint64_t(Cache.LineBytes) * Cache.Ways;
    if (Cache.Bytes % SetBytes || !isPowerOf2_64(Cache.Bytes / SetBytes))
      badValue(Name + ".bytes", Cache.Bytes,
               "ways x line_bytes x a power of two, as " + Twine(SetBytes) +
                   " or " + Twine(4 * SetBytes));
    if (Cache.SectorBytes > Cache.LineBytes)
      badValue(Name + ".sector_bytes", Cache.SectorBytes,
               "at most " + Name + ".line_bytes, which is " +
                   Twine(Cache.LineBytes));
    if (Cache.LineBytes > MaxSectorsPerLine * Cache.SectorBytes)
      badValue(Name + ".sector_bytes", Cache.SectorBytes,
               "at least " + Name + ".line_bytes / " +
                   Twine(MaxSectorsPerLine) + ", which is " +
                   Twine(Cache.LineBytes / MaxSectorsPerLine));
  }

  void checkIcache() {
    if (Chip.IcacheMissKind == IcacheMisses::Never)
      return;
    uint64_t SetBytes = uint64_t(Chip.IcacheLineBytes) * Chip.IcacheWays;
    if (Chip.IcacheBytes % SetBytes)
      badValue("icache.bytes", Chip.IcacheBytes,
               "a multiple of line_bytes x ways, which is " + Twine(SetBytes));
    if (Chip.IcacheMissKind == IcacheMisses::Memory && !Chip.hasMemorySystem())
      bad("icache.misses", "'icache.misses' is 'memory', but the chip has "
                           "neither caches nor DRAM; give it fixed");
    if (Chip.IcacheMissKind == IcacheMisses::Fixed &&
        Chip.IcacheMissLatency < Chip.ArbitrationWindow)
      badValue("icache.miss_latency_cycles", Chip.IcacheMissLatency,
               "at least arbitration_window_cycles, which is " +
                   Twine(Chip.ArbitrationWindow));
  }

  void checkDram(const DramConfig &Dram) {
    if (Dram.RowBytes % Dram.BurstBytes)
      badValue("memory.dram.row_bytes", Dram.RowBytes,
               "a multiple of burst_bytes, which is " + Twine(Dram.BurstBytes));
    if (Dram.BankGroups * Dram.BanksPerGroup > MaxDramBanks)
      badValue("memory.dram.banks_per_group", Dram.BanksPerGroup,
               "at most " + Twine(MaxDramBanks / Dram.BankGroups) + " with " +
                   Twine(Dram.BankGroups) + " bank groups");
    if (Dram.WriteHighMark > Dram.WriteQueueEntries)
      badValue("memory.dram.queue.write_high_mark", Dram.WriteHighMark,
               "at most write_entries, which is " +
                   Twine(Dram.WriteQueueEntries));
    if (Dram.WriteLowMark >= Dram.WriteHighMark)
      badValue("memory.dram.queue.write_low_mark", Dram.WriteLowMark,
               "less than write_high_mark, which is " +
                   Twine(Dram.WriteHighMark));
    auto AtLeast = [&](StringRef Key, uint32_t Value, StringRef LowerKey,
                       uint32_t Lower) {
      if (Value < Lower)
        badValue(("memory.dram." + Key).str(), Value,
                 "at least " + LowerKey + ", which is " + Twine(Lower));
    };
    AtLeast("ticks.ccd_short", Dram.CcdShortTicks, "burst_ticks",
            Dram.BurstTicks);
    AtLeast("ticks.ccd_long", Dram.CcdLongTicks, "ccd_short",
            Dram.CcdShortTicks);
    AtLeast("ticks.rrd_long", Dram.RrdLongTicks, "rrd_short",
            Dram.RrdShortTicks);
    AtLeast("ticks.wtr_long", Dram.WtrLongTicks, "wtr_short",
            Dram.WtrShortTicks);
    AtLeast("ticks.ras", Dram.RasTicks, "rcd_read", Dram.RcdReadTicks);
    std::string WrongMapping = checkAddressMapping(Dram);
    if (!WrongMapping.empty())
      bad("memory.dram.address_mapping",
          "'memory.dram.address_mapping': " + WrongMapping);
    else if (Chip.MemoryBytes > dramCapacityBytes(Dram))
      badValue("memory.bytes", Chip.MemoryBytes,
               "at most what the DRAM holds, which is " +
                   Twine(dramCapacityBytes(Dram)));
    if (Dram.RefiTicks)
      AtLeast("ticks.refi", Dram.RefiTicks, "rfc + 1", Dram.RfcTicks + 1);
  }

  /// The window ends before anything that left the TM in it comes back.
  void checkWindow() {
    uint64_t Longest = minimumRoundTrip(Chip);
    if (Chip.ArbitrationWindow > Longest)
      badValue("arbitration_window_cycles", Chip.ArbitrationWindow,
               (Chip.hasMemorySystem()
                    ? "at most the shortest round trip to memory, which is "
                    : "at most memory.latency_cycles, which is ") +
                   Twine(Longest));
  }
};

} // namespace

void checkChip(const ChipConfig &Chip, const YamlValue &Tree,
               YamlErrors &Errors) {
  Checker(Chip, Tree, Errors).check();
}

} // namespace tp
