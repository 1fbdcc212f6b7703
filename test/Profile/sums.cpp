// A profile, the statistics and the files of stacks of a run say the same, on
// chips with and without caches, whatever the host and the engine.

// RUN: tpcc -O1 -g %s -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf --profile=%t.json --stats %t.stats.json --per-pc --profile-folded %t.folded --profile-speedscope %t.speedscope.json
// RUN: %python %S/Inputs/check_profile.py %t.json %t.stats.json %t.folded %t.speedscope.json
// RUN: %python %S/../Simulator/Inputs/check_schema.py %profile_schema %t.json
// RUN: tpsim --chip 4x32 --quiet %t.elf --profile=%t.3.json --host-threads 3
// RUN: cmp %t.json %t.3.json
// RUN: tpsim --chip 4x32 --quiet %t.elf --profile=%t.reference.json --engine reference
// RUN: cmp %t.json %t.reference.json

// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --profile=%t.l2.json --stats %t.stats.json --per-pc --profile-folded %t.folded --profile-speedscope %t.speedscope.json
// RUN: %python %S/Inputs/check_profile.py %t.l2.json %t.stats.json %t.folded %t.speedscope.json
// RUN: %python %S/../Simulator/Inputs/check_schema.py %profile_schema %t.l2.json
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --profile=%t.l2.reference.json --engine reference --host-threads 2
// RUN: cmp %t.l2.json %t.l2.reference.json

// DRAM alone: it has each access, whose row was open or not.
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --set l1=none --set l2=none --quiet %t.elf --profile=%t.dram.json --stats %t.stats.json --per-pc --profile-folded %t.folded --profile-speedscope %t.speedscope.json
// RUN: %python %S/Inputs/check_profile.py %t.dram.json %t.stats.json %t.folded %t.speedscope.json
// RUN: %python %S/../Simulator/Inputs/check_schema.py %profile_schema %t.dram.json
// RUN: tpsim --read-profile %t.dram.json | FileCheck %s --check-prefix=ROWS
// RUN: tpsim --read-profile %t.dram.json --profile-by instruction --profile-sort dram_queue --profile-rows 2 | FileCheck %s --check-prefix=QUEUE
// QUEUE: in
// QUEUE-NEXT: lwx
// QUEUE-NEXT: swx
// ROWS: row is the percent of those from DRAM whose row was open
// ROWS: wait access row in
// ROWS-NEXT: {{[0-9]+}} {{[0-9]+}} sums.cpp:[[#@LINE+33]] mix

// Also of a run that is cut, in which waits are under way; without debug
// information; and with a trap.
// RUN: not tpsim --chip trax-32x32 --set tm.count=2 --quiet --max-cycles 777 %t.elf --profile=%t.cut.json --stats %t.stats.json --per-pc --profile-folded %t.folded --profile-speedscope %t.speedscope.json
// RUN: %python %S/Inputs/check_profile.py %t.cut.json %t.stats.json %t.folded %t.speedscope.json
// RUN: tpcc -O2 -DTRAP %s -o %t.plain.elf
// RUN: not tpsim --chip 4x32 --quiet %t.plain.elf --profile=%t.plain.json --stats %t.stats.json --per-pc --profile-folded %t.folded --profile-speedscope %t.speedscope.json
// RUN: %python %S/Inputs/check_profile.py %t.plain.json %t.stats.json %t.folded %t.speedscope.json
// RUN: %python %S/../Simulator/Inputs/check_schema.py %profile_schema %t.cut.json %t.plain.json

// A profile changes nothing in the run.
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --stats %t.with.json --profile
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --stats %t.without.json
// RUN: cmp %t.with.json %t.without.json

// A run that goes on from a checkpoint has the whole run's profile.
// RUN: not tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --profile --checkpoint %t.checkpoint --max-cycles 777 --host-threads 2
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --profile=%t.restored.json --restore %t.checkpoint --host-threads 2
// RUN: cmp %t.l2.json %t.restored.json
// RUN: not tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --restore %t.checkpoint 2>&1 | FileCheck %s --check-prefix=RESTORE
// RESTORE: tpsim: error: {{.*}}.checkpoint: made by another run: its --profile is 'yes', this run's is 'no'; restore it with what it was made with

// What was written says the same when it is read.
// RUN: tpsim --read-profile %t.l2.json --profile-folded %t.again.folded --profile-speedscope %t.again.json > %t.table.txt
// RUN: tpsim --chip trax-32x32 --set tm.count=2 %t.elf --profile --profile-folded %t.folded --profile-speedscope %t.speedscope.json 2>&1 | sed -n '/^profile:/,$p' > %t.printed.txt
// RUN: cmp %t.table.txt %t.printed.txt
// RUN: cmp %t.folded %t.again.folded
// RUN: cmp %t.speedscope.json %t.again.json

unsigned Values[1 << 14];

static inline unsigned mix(unsigned Sum, unsigned Step) {
  return Sum * 5 + Values[(Sum ^ Step * 64) % (1 << 14)];
}

[[gnu::noinline]] unsigned walk(unsigned Start, unsigned Steps) {
  unsigned Sum = Start;
  for (unsigned I = 0; I != Steps; ++I)
    Sum = mix(Sum, I);
  return Sum;
}

[[gnu::noinline]] unsigned count(unsigned Depth) {
  return Depth == 0 ? walk(Depth, 2) : count(Depth - 1) + count(Depth / 2) + 1;
}

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  unsigned Sum = walk(Thread, 10 + Thread % 9) + count(Thread % 4);
  Values[Thread * 16] = Sum;
  __builtin_tp_barrier();
#ifdef TRAP
  if (Thread == 77)
    __builtin_tp_trap_break(7);
#endif
  Values[Thread] = walk(Thread + 1, 5);
  return 0;
}
