// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The profile's sums by line, function and path of calls.

const profile =
  JSON.parse(document.getElementById("profile-data").textContent);
const { statistics } = profile;

/** What a thread-cycle was used or lost for, in the order of all counts. */
const uses = [
  ["issued", "issued", "an instruction was issued"],
  ["data", "data", "waited for a unit or the local store"],
  ["memory", "memory", "waited for memory of fixed latency, or for an answer "
    + "that was still on its way"],
  ["l1", "L1", "waited for a load or atomic that the L1 served"],
  ["l2", "L2", "waited for a load or atomic that the L2 served"],
  ["dram", "DRAM", "waited for a load or atomic that DRAM served"],
  ["store_buffer", "store buffer", "found the store buffer full"],
  ["unit_conflict", "unit conflict", "found no free functional unit"],
  ["icache_conflict", "icache conflict",
    "found no free port of the instruction cache"],
  ["icache_miss", "icache miss", "waited for a line of the instruction cache"],
  ["branch", "branch", "waited for the target of a branch"],
  ["barrier", "barrier", "waited at a barrier"],
  ["sync", "sync", "waited for its stores to be visible"],
  ["sleep", "sleep", "slept"],
  ["finished", "finished", "had halted while others still ran"],
].map(([name, label, meaning]) => ({ name, label, meaning }));

const useIndex = new Map(uses.map((use, index) => [use.name, index]));
const finishedUse = useIndex.get("finished");

/** Who can have what an access asks for. */
const levels = [
  ["l1", "L1", "served by the L1"],
  ["l2", "L2", "served by the L2"],
  ["dram_row_hit", "row hits", "from DRAM, whose row was open"],
  ["dram_row_miss", "row misses", "from DRAM, where no row was open"],
  ["dram_row_conflict", "row conflicts",
    "from DRAM, where another row was open"],
  ["dram_queue", "queue",
    "by queues of DRAM: stores that a channel took, and reads of what it had yet to write"],
  ["memory", "memory", "served by memory of fixed latency"],
].map(([name, label, meaning]) => ({ name, label, meaning }));

function noCounts() {
  return new Array(uses.length).fill(0);
}

function countsOf(issued, lost) {
  const counts = noCounts();
  counts[0] = issued;
  for (const [reason, cycles] of Object.entries(lost))
    counts[useIndex.get(reason)] = cycles;
  return counts;
}

function addTo(counts, more) {
  for (let use = 0; use < uses.length; use += 1) counts[use] += more[use];
}

/** Adds accesses and their cycles by level. */
function addServed(served, more) {
  for (const [level, { accesses, cycles }] of Object.entries(more)) {
    served[level] ??= { accesses: 0, cycles: 0 };
    served[level].accesses += accesses;
    served[level].cycles += cycles;
  }
}

function sum(counts) {
  return counts.reduce((total, cycles) => total + cycles, 0);
}

/** Instructions with their counts. */
const instructions = profile.instructions.map((entry, index) => {
  const counts = countsOf(entry.executed, entry.lost);
  return { ...entry, index, counts, cycles: sum(counts) };
});

const whole = profile.run.thread_cycles;
const totals = noCounts();
for (const entry of instructions) addTo(totals, entry.counts);
totals[finishedUse] += profile.run.finished;

function functionName(index) {
  return profile.functions[index].name || "(unknown)";
}

/** A frame and those it was inlined into, innermost first. */
function chainOf(frame) {
  const chain = [];
  for (let at = frame; at !== undefined; at = profile.frames[at].inlined_into)
    chain.push(at);
  return chain;
}

/** "file:line" of a frame; nothing if it has no file. */
function placeText(frame) {
  const { file, line } = profile.frames[frame];
  return file === undefined ? "" : lineText(file, line ?? 0);
}

/** Values of a map, made when they are first asked for. */
class Table extends Map {
  constructor(make) {
    super();
    this.make = make;
  }
  entry(key, ...parts) {
    if (!this.has(key)) this.set(key, this.make(...parts));
    return this.get(key);
  }
}

/** "file:line"; line 0 is that of code that is at no line. */
function lineText(file, line) {
  return `${files[file].name}:${line === 0 ? "?" : line}`;
}

/** Source lines by "file:line", with the instructions of each. */
const lines = new Table((file, line) => ({
  file, line, counts: noCounts(), cycles: 0, functions: new Set(),
  instructions: [], served: {},
}));

/** Functions by number. */
const functions = new Table((index) => ({
  index, name: functionName(index), file: profile.functions[index].file,
  line: profile.functions[index].line, counts: noCounts(), cycles: 0,
  inclusive: 0, hottest: null,
}));

for (const entry of instructions) {
  const frame = profile.frames[entry.frame];
  const own = functions.entry(frame.function, frame.function);
  addTo(own.counts, entry.counts);
  own.cycles += entry.cycles;
  const callers = chainOf(entry.frame).map((f) => profile.frames[f].function);
  for (const caller of new Set(callers))
    functions.entry(caller, caller).inclusive += entry.cycles;
  if (frame.file === undefined) continue;
  const number = frame.line ?? 0;
  const line = lines.entry(`${frame.file}:${number}`, frame.file, number);
  addTo(line.counts, entry.counts);
  line.cycles += entry.cycles;
  line.functions.add(frame.function);
  line.instructions.push(entry);
  addServed(line.served, entry.served ?? {});
  if (!own.hottest || line.cycles > own.hottest.cycles) own.hottest = line;
}

/** Files with the lines that have counts. */
const files = profile.files.map((file, index) => ({
  ...file, index, name: fileName(file.path), lines: new Map(), cycles: 0,
  hottest: 0,
}));
for (const line of lines.values()) {
  const file = files[line.file];
  file.lines.set(line.line, line);
  file.cycles += line.cycles;
  file.hottest = Math.max(file.hottest, line.cycles);
}

/** The source of a line; empty if there is none. */
const sourceLines = new Table((file) =>
  files[file].text === undefined ? [] : files[file].text.split("\n"));
function sourceOf(file, line) {
  return (sourceLines.entry(file, file)[line - 1] ?? "").trim();
}
