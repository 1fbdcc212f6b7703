//===- ChipSchema.cpp - The keys of a chip file ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipSchema.h"

#include "simulator/chip/ChipLimits.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp {
static constexpr Presence Optional = Presence::Optional;

static constexpr IntegerRange bytesUpTo(uint64_t Max) {
  return {1, Max, 1, /*PowerOfTwo=*/true, /*IsBytes=*/true};
}

/// True for the classes whose latency is the memory's and not a unit's.
static bool isMemoryClass(LatencyClass Class) {
  return Class == LatencyClass::Load || Class == LatencyClass::Atomic ||
         Class == LatencyClass::Store;
}

namespace {

/// Hands the parts of a chip to a visitor.
class ChipKeys {
public:
  ChipKeys(ChipVisitor &V, ChipConfig &C) : V(V), C(C) {}

  void visit() {
    V.text({"description", "free text", Optional}, C.Description);
    V.number({"clock_ghz", "the chip's clock in GHz"}, C.ClockGHz,
             {0.001, 100});
    V.section({{"tm", "the thread multiprocessors"}}, [&] {
      V.integer({"count", "TMs of the chip"}, C.TmCount, {1, MaxThreads});
      V.integer({"tps", "thread processors in each TM; at most 2^20 in all"},
                C.TpsPerTm, {1, MaxTpsPerTm});
    });
    V.choice({"flush_to_zero", "subnormal floats become zero", Optional},
             C.FlushToZero, {"false", "true"});
    V.integer({"arbitration_window_cycles",
               "the priority among a TM's TPs is fixed for so many cycles, "
               "then rotates by one TP; no longer than the shortest round trip "
               "to memory (docs/memory-system.md)"},
              C.ArbitrationWindow, {1, MaxLatency});
    visitInnerMemories();
    visitOuterMemories();
    visitUnits();
    visitTechnology();
  }

private:
  ChipVisitor &V;
  ChipConfig &C;

  void visitInnerMemories() {
    V.section({{"local_store", "stack and `thread_local` of each TP"}}, [&] {
      V.integer({"bytes", "size, of each TP"}, C.LocalStoreBytes,
                {1024, MaxLocalStoreBytes, 16, false, true});
    });
    V.section({{"icache", "instruction cache of each TM"}}, [&] {
      V.integer(
          {"banks", "the bank of an instruction is (address / 4) mod banks"},
          C.IcacheBanks, {1, MaxIcacheBanks, 1, /*PowerOfTwo=*/true});
      V.integer({"ports_per_bank", "fetches that a bank serves in a cycle"},
                C.IcachePorts, {1, MaxIcachePorts});
      V.integer({"bytes", "size"}, C.IcacheBytes,
                {64, 1 << 30, 4, false, true});
      V.choice({"misses",
                "`never`: it has the whole program; `fixed`: lines come after "
                "`miss_latency_cycles`; `memory`: from the level behind the L1",
                Optional},
               C.IcacheMissKind, {"never", "fixed", "memory"});
      V.integer({"line_bytes", "bytes that share a tag", Optional},
                C.IcacheLineBytes, {4, 1024, 1, true, true});
      V.integer({"ways", "lines of a set", Optional}, C.IcacheWays,
                {1, MaxCacheWays});
      V.integer({"miss_latency_cycles",
                 "from a miss to its line, if `misses` is `fixed`; at least "
                 "the arbitration window",
                 Optional},
                C.IcacheMissLatency, {1, MaxLatency});
    });
    V.integer({"store_buffer_entries",
               "stores of a TP that can be under way at once; only of chips "
               "with caches or DRAM",
               Optional},
              C.StoreBufferEntries, {1, MaxStoreBufferEntries});
  }

  void visitCache(CacheConfig &Cache) {
    V.integer({"bytes", "size"}, Cache.Bytes,
              {64, MaxCacheBytes, 1, false, true});
    V.integer({"line_bytes", "bytes that share a tag"}, Cache.LineBytes,
              bytesUpTo(MaxLineBytes));
    V.integer({"sector_bytes", "bytes that are fetched at once", Optional},
              Cache.SectorBytes,
              {MinSectorBytes, MaxLineBytes, 1, /*PowerOfTwo=*/true,
               /*IsBytes=*/true});
    V.integer({"ways", "lines of a set"}, Cache.Ways, {1, MaxCacheWays});
    V.integer({"banks", "banks, each of which serves a request a cycle"},
              Cache.Banks, {1, MaxCacheBanks, 1, /*PowerOfTwo=*/true});
    V.integer({"bank_bytes",
               "the bank of an address is (address / bank_bytes) mod banks",
               Optional},
              Cache.BankBytes, bytesUpTo(MaxLineBytes));
    V.integer({"latency_cycles",
               "from the start of a bank's service to the result of a hit, and "
               "to the departure of a miss"},
              Cache.Latency, {1, MaxLatency});
    V.integer({"miss_registers", "sectors whose miss can be under way at once"},
              Cache.MissRegisters, {1, MaxMissRegisters});
    V.integer({"merges_per_miss",
               "requests that can wait for one miss, the first included"},
              Cache.MergesPerMiss, {1, MaxMissRegisters});
    V.choice(
        {"writes",
         "stores go `through` to the next level at once, or come `back` to "
         "it when their line is evicted",
         Optional},
        Cache.Writes, {"through", "back"});
  }

  void visitOuterMemories() {
    V.section<CacheConfig>({{"l1", "data cache of each TM", Optional}}, C.L1,
                           [&](CacheConfig &Cache) { visitCache(Cache); });
    V.section<CrossbarConfig>(
        {{"crossbar", "way between the TMs and the next level", Optional}},
        C.Crossbar, [&](CrossbarConfig &Crossbar) {
          V.integer({"latency_cycles", "of one way"}, Crossbar.Latency,
                    {1, MaxLatency});
          V.integer({"request_bytes_per_cycle", "of a TM's port to memory"},
                    Crossbar.RequestBytesPerCycle, {1, MaxPortBytes});
          V.integer({"answer_bytes_per_cycle", "of a TM's port from memory"},
                    Crossbar.AnswerBytesPerCycle, {1, MaxPortBytes});
          V.integer({"header_bytes",
                     "of each request, before the data of a store or atomic",
                     Optional},
                    Crossbar.HeaderBytes, {1, MaxPortBytes});
        });
    V.section<CacheConfig>({{"l2", "cache of a group of TMs", Optional}}, C.L2,
                           [&](CacheConfig &Cache) {
                             V.integer({"tms_per_l2", "TMs that share one"},
                                       C.TmsPerL2, {1, MaxThreads});
                             visitCache(Cache);
                           });
    V.section({{"memory", "global memory"}}, [&] {
      V.integer({"bytes", "its end; the first 64 KiB of it trap"},
                C.MemoryBytes,
                {MinMemoryBytes, MaxMemoryBytes, 16, false, true});
      visitDram();
      if (!C.Dram || V.visitsAll())
        V.integer({"latency_cycles",
                   "without `dram`: from the issue of a load or atomic, or its "
                   "departure from the last level before memory, to its result",
                   Optional},
                  C.MemoryLatency, {1, MaxLatency});
      else
        V.exclude("latency_cycles", "memory.dram");
    });
  }

  void visitDram() {
    V.section<DramConfig>(
        {{"dram", "DRAM and its controllers", Optional}, "dram"}, C.Dram,
        [&](DramConfig &Dram) {
          V.text({"name", "of the device family"}, Dram.Name);
          V.text({"source", "where the figures come from"}, Dram.Source);
          V.integer({"clock_khz", "of the command clock"}, Dram.ClockKHz,
                    {1000, 100'000'000});
          V.integer({"channels", "independent (pseudo) channels"},
                    Dram.Channels, {1, MaxDramChannels});
          V.integer({"bank_groups", "of a channel"}, Dram.BankGroups,
                    {1, MaxDramBanks});
          V.integer({"banks_per_group", "banks"}, Dram.BanksPerGroup,
                    {1, MaxDramBanks});
          V.integer({"rows_per_bank", "rows"}, Dram.RowsPerBank, {1, 1 << 24});
          V.integer({"row_bytes", "bytes of a row"}, Dram.RowBytes,
                    {1, 1 << 20, 1, false, true});
          V.integer({"burst_bytes", "bytes of an access"}, Dram.BurstBytes,
                    bytesUpTo(1024));
          V.integer({"burst_ticks", "an access holds the data bus so long"},
                    Dram.BurstTicks, {1, 1024});
          V.integer({"command_buses",
                     "2: row and column commands have a bus each", Optional},
                    Dram.CommandBuses, {1, 2});
          V.text({"address_mapping",
                  "`row`, `bank`, `bankgroup`, `column`, `channel` from the "
                  "highest to the lowest digit above a burst, between colons; "
                  "`column/8` is a part of 8 columns",
                  Optional},
                 Dram.AddressMapping);
          visitTicks(Dram);
          visitController(Dram);
          visitDramEnergy(Dram.Energy);
        });
  }

  void visitTicks(DramConfig &Dram) {
    V.section({{"ticks", "times in cycles of the command clock"}}, [&] {
      auto Ticks = [&](StringRef Name, StringRef Meaning, uint32_t &Value,
                       uint32_t Min = 1) {
        V.integer({Name, Meaning}, Value, {Min, MaxDramTicks});
      };
      Ticks("rcd_read", "activate to read (tRCDRD)", Dram.RcdReadTicks);
      Ticks("rcd_write", "activate to write (tRCDWR)", Dram.RcdWriteTicks);
      Ticks("rp", "precharge to activate (tRP)", Dram.RpTicks);
      Ticks("cl", "read to its data (CL)", Dram.ClTicks);
      Ticks("cwl", "write to its data (CWL)", Dram.CwlTicks);
      Ticks("ras", "activate to precharge (tRAS)", Dram.RasTicks);
      Ticks("rrd_short", "activate to activate, other bank group (tRRDS)",
            Dram.RrdShortTicks);
      Ticks("rrd_long", "activate to activate, same bank group (tRRDL)",
            Dram.RrdLongTicks);
      Ticks("faw", "window of four activates (tFAW)", Dram.FawTicks);
      Ticks("wr", "end of write data to precharge (tWR)", Dram.WrTicks);
      Ticks("wtr_short", "end of write data to read, other bank group (tWTRS)",
            Dram.WtrShortTicks, 0);
      Ticks("wtr_long", "end of write data to read, same bank group (tWTRL)",
            Dram.WtrLongTicks, 0);
      Ticks("rtw", "read to write, any bank (tRTW)", Dram.RtwTicks, 0);
      Ticks("rtp", "read to precharge (tRTP)", Dram.RtpTicks);
      Ticks("ccd_short", "access to access, other bank group (tCCDS)",
            Dram.CcdShortTicks);
      Ticks("ccd_long", "access to access, same bank group (tCCDL)",
            Dram.CcdLongTicks);
      Ticks("rfc", "duration of a refresh (tRFC)", Dram.RfcTicks);
      Ticks("refi", "between refreshes (tREFI); 0: none", Dram.RefiTicks, 0);
    });
  }

  void visitController(DramConfig &Dram) {
    V.section({{"queue", "of a channel's controller", Optional}}, [&] {
      auto Entries = [&](StringRef Name, StringRef Meaning, uint32_t &Value,
                         uint32_t Min) {
        V.integer({Name, Meaning, Optional}, Value, {Min, MaxDramQueue});
      };
      Entries("read_entries", "reads it can choose among",
              Dram.ReadQueueEntries, 1);
      Entries("write_entries", "writes it can choose among",
              Dram.WriteQueueEntries, 1);
      Entries("write_high_mark", "so many writes start a drain",
              Dram.WriteHighMark, 1);
      Entries("write_low_mark", "a drain stops at so many", Dram.WriteLowMark,
              0);
      Entries("row_hit_limit",
              "row hits that may pass an older request to their bank",
              Dram.RowHitLimit, 1);
    });
    V.integer({"controller_cycles",
               "cycles of the chip that controller and PHY add to each read",
               Optional},
              Dram.ControllerCycles, {0, MaxLatency});
  }

  void visitSource(FigureSource &Source) {
    V.text({"source", "where the figures come from"}, Source.Text);
    V.choice({"assumption", "nobody published them for this part", Optional},
             Source.IsAssumption, {"false", "true"});
  }

  void visitDramEnergy(std::optional<DramEnergy> &Value) {
    V.section<DramEnergy>(
        {{"energy", "of a channel with its interface", Optional}}, Value,
        [&](DramEnergy &Energy) {
          auto Nj = [&](StringRef Name, StringRef Meaning, double &Number) {
            V.number({Name, Meaning}, Number, {0, 1e6});
          };
          Nj("activate_nj", "nJ of opening and closing a row",
             Energy.ActivateNj);
          Nj("read_nj", "nJ of an access", Energy.ReadNj);
          Nj("write_nj", "nJ of an access", Energy.WriteNj);
          Nj("refresh_nj", "nJ of a refresh", Energy.RefreshNj);
          Nj("background_w", "W, always", Energy.BackgroundW);
          visitSource(Energy.Source);
        });
  }

  void visitUnits() {
    V.section({{"units", "functional units of each TM"}}, [&] {
      for (unsigned I = 0; I != NumUnits; ++I) {
        UnitConfig &Config = C.Units[I];
        V.section({{unitName(Unit(I)), "a type of unit", {}, "UNIT"}, {}, true},
                  [&] {
                    V.integer({"count", "operations that can start in a cycle"},
                              Config.Count, {1, MaxUnitCount});
                    V.integer({"interval_cycles",
                               "the unit starts operations only in cycles "
                               "divisible by this",
                               Optional},
                              Config.Interval, {1, MaxUnitInterval});
                  });
      }
    });
    V.section(
        {{"latency_cycles", "where it is not the instruction set's", Optional}},
        [&] {
          for (unsigned I = 0; I != NumLatencyClasses; ++I)
            if (!isMemoryClass(LatencyClass(I)))
              V.integer({latencyClassName(LatencyClass(I)),
                         "cycles from issue to result", Optional, "CLASS"},
                        C.Latency[I], {1, MaxLatency});
        });
  }

  void visitCost(PartCost &Cost, StringRef Of) {
    V.number({"area_mm2", "mm2"}, Cost.AreaMm2, {0, 1000});
    V.number({"energy_nj", Of}, Cost.EnergyNj, {0, 1000});
    visitSource(Cost.Source);
  }

  void visitCacheLaw(CacheLaw &Law) {
    V.number({"area_mm2", "mm2 of no byte"}, Law.AreaMm2, {0, 1000});
    V.number({"area_mm2_per_kib", "and of each KiB"}, Law.AreaMm2PerKiB,
             {0, 1000});
    V.number({"energy_nj", "nJ of an access to no byte"}, Law.EnergyNj,
             {0, 1000});
    V.number({"energy_nj_per_sqrt_kib",
              "and times the square root of the size in KiB"},
             Law.EnergyNjPerSqrtKiB, {0, 1000});
    visitSource(Law.Source);
  }

  /// Sections `1`, `2`, `4`, ... by number of banks.
  void visitByBanks(function_ref<void(unsigned)> Keys) {
    static constexpr StringRef Names[NumBankCounts] = {"1",  "2",  "4", "8",
                                                       "16", "32", "64"};
    for (unsigned I = 0; I != NumBankCounts; ++I)
      V.section({{Names[I], "by number of banks", {}, "BANKS"}, {}, true},
                [&] { Keys(I); });
  }

  void visitTechnology() {
    V.section<TechnologyConfig>(
        {{"technology", "area and energy of the parts", Optional},
         "technology"},
        C.Technology, [&](TechnologyConfig &T) {
          V.text({"name", "of the table"}, T.Name);
          V.text({"description", "free text", Optional}, T.Description);
          V.section({{"units", "functional units"}}, [&] {
            for (unsigned I = 0; I != NumUnits; ++I)
              V.section({{unitName(Unit(I)), "one unit", {}, "UNIT"}, {}, true},
                        [&] { visitCost(T.Units[I], "nJ of an operation"); });
          });
          V.section({{"register_file", "registers of a TP"}, {}, true},
                    [&] { visitCost(T.RegisterFile, "nJ of an access"); });
          visitMemories(T);
          V.section({{"crossbar", "a TM's port"}, {}, true},
                    [&] { visitCost(T.Crossbar, "nJ of a byte"); });
        });
  }

  void visitMemories(TechnologyConfig &T) {
    V.section({{"local_store", "of a TP"}, {}, true}, [&] {
      V.integer({"bytes", "size for which the figures hold"},
                T.LocalStore.Bytes, {64, MaxLocalStoreBytes, 1, false, true});
      visitCost(T.LocalStore.Cost, "nJ of an access");
    });
    V.section({{"icache", "instruction cache of a TM"}}, [&] {
      V.integer({"bytes", "size for which the figures hold"}, T.IcacheBytes,
                {64, 1 << 30, 1, false, true});
      V.integer({"ports_per_bank", "ports for which the figures hold"},
                T.IcachePorts, {1, MaxIcachePorts});
      visitByBanks(
          [&](unsigned I) { visitCost(T.Icache[I], "nJ of a fetch"); });
    });
    V.section({{"cache", "an L1 or L2"}}, [&] {
      visitByBanks([&](unsigned I) { visitCacheLaw(T.Cache[I]); });
    });
  }
};

} // namespace

std::string rangeText(const IntegerRange &Range) {
  std::string Text =
      Range.IsBytes ? "a number of bytes from " : "a whole number from ";
  Text += utostr(Range.Min) + " to " + utostr(Range.Max);
  if (Range.IsBytes)
    Text += " (KiB, MiB and GiB may follow it)";
  if (Range.Multiple > 1)
    Text += ", a multiple of " + utostr(Range.Multiple);
  if (Range.PowerOfTwo)
    Text += ", a power of two";
  return Text;
}

std::string rangeText(const NumberRange &Range) {
  std::string Text;
  raw_string_ostream(Text) << "a number from " << format("%g", Range.Min)
                           << " to " << format("%g", Range.Max);
  return Text;
}

void visitChip(ChipVisitor &Visitor, ChipConfig &Chip) {
  ChipKeys(Visitor, Chip).visit();
}

ChipConfig defaultChip() {
  ChipConfig Chip;
  for (unsigned I = 0; I != NumLatencyClasses; ++I)
    Chip.Latency[I] = defaultLatency(LatencyClass(I));
  return Chip;
}

} // namespace tp
