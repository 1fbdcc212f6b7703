// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions, lines and accesses to memory as tables.

function functionsView() {
  const rows = [...functions.values()];
  const most = Math.max(1, ...rows.map((row) => row.cycles));
  const mostInclusive = Math.max(1, ...rows.map((row) => row.inclusive));
  const table = new SortedTable({
    rows, text: (row) => row.name, sortBy: 1,
    onSelect: (row) => {
      if (row.hottest)
        location.hash = sourceLink(row.hottest.file, row.hottest.line);
    },
    columns: [
      { title: "function", text: true, value: (row) => shortName(row.name),
        cell: (row) => el("td.name", { title: row.name },
          shortName(row.name), " ",
          el("small", {}, row.file === undefined ? ""
            : files[row.file].name + (row.line ? `:${row.line}` : ""))) },
      cyclesColumn("own", (row) => row.cycles, most,
        "thread-cycles at the function's own lines"),
      cyclesColumn("with inlined", (row) => row.inclusive, mostInclusive,
        "with what was inlined into it, but without what it called"),
      countColumn("instructions", (row) => row.counts[0]),
      countColumn("cycles per instruction",
        (row) => (row.counts[0] === 0 ? 0 : row.cycles / row.counts[0]),
        "thread-cycles over instructions", (value) => value.toFixed(2)),
      barColumn(most),
    ],
  });
  return { element: table.element, search: (text) => table.search(text) };
}

function linesView() {
  const rows = [...lines.values()];
  const most = Math.max(1, ...rows.map((row) => row.cycles));
  const names = (row) => [...row.functions].map(functionName).join(" ");
  const table = new SortedTable({
    rows, sortBy: 1,
    text: (row) => `${files[row.file].name}:${row.line} ${names(row)} `
      + sourceOf(row.file, row.line),
    onSelect: (row) => { location.hash = sourceLink(row.file, row.line); },
    columns: [
      { title: "line", text: true,
        value: (row) => `${files[row.file].name}:`
          + String(row.line).padStart(6),
        cell: (row) => el("td.code", {},
          el("span.place", {}, lineText(row.file, row.line)), " ",
          ...highlighted(sourceOf(row.file, row.line))) },
      cyclesColumn("cycles", (row) => row.cycles, most),
      countColumn("instructions", (row) => row.counts[0]),
      latencyColumn(),
      ...rateColumns(),
      barColumn(most),
    ],
  });
  return { element: table.element, search: (text) => table.search(text) };
}

function accessesTo(row, level) {
  return row.served?.[level]?.accesses ?? 0;
}

/** Which of the levels served anything. */
function usedLevels() {
  return levels.filter(({ name }) =>
    instructions.some((row) => accessesTo(row, name) > 0));
}

/** How many of the accesses that came to a cache, or to DRAM, were hits. */
function rateColumns() {
  const used = usedLevels().map(({ name }) => name);
  const rows = used.filter((name) => name.startsWith("dram_row"));
  const rateColumn = (title, meaning, hit, of) => {
    const rate = (row) => {
      const all = of.reduce((n, level) => n + accessesTo(row, level), 0);
      return all === 0 ? null : accessesTo(row, hit) / all;
    };
    return { title, meaning, value: (row) => rate(row) ?? -1,
      cell: (row) => el("td.number", {},
        rate(row) === null ? "" : percent(rate(row), 1)) };
  };
  const columns = ["l1", "l2"].filter((name) => used.includes(name))
    .map((name) => rateColumn(`${name.toUpperCase()} hits`,
      "of the accesses that came there", name,
      used.slice(used.indexOf(name))));
  return rows.length === 0 ? columns
    : [...columns, rateColumn("row hits",
      "of the accesses served by DRAM, those whose row was open",
      "dram_row_hit", rows)];
}

function latencyColumn() {
  return countColumn("latency", latencyOf, "cycles from issue to answer",
    (value) => value.toFixed(0));
}

function latencyOf(row) {
  let accesses = 0;
  let cycles = 0;
  for (const served of Object.values(row.served ?? {})) {
    accesses += served.accesses;
    cycles += served.cycles;
  }
  return accesses === 0 ? 0 : cycles / accesses;
}

/** What the levels of memory did as a whole. */
function levelFigures() {
  const memory = statistics?.memory ?? {};
  const rates = { l1: "hit_rate", l2: "hit_rate", dram: "row_hit_rate" };
  const cards = Object.entries(rates).filter(([level]) => memory[level])
    .map(([level, rate]) => {
      const figures = memory[level];
      const label = uses[useIndex.get(level)].label;
      const requests = level === "dram" ? figures.reads + figures.writes
        : figures.hits + figures.misses + figures.merged;
      return el("div.card", {}, el("h3", {}, label),
        el("b", {}, percent(figures[rate], 1)),
        el("p", {}, level === "dram" ? "of the bursts found their row open"
          : "of the requests were hits"),
        el("p", {}, `${short(requests)} ${level === "dram" ? "bursts"
          : "requests"}`),
        level === "dram" ? el("p", {}, `mean latency of a read `
          + `${figures.mean_read_latency_cycles.toFixed(0)} cycles`) : null);
    });
  return cards.length === 0 ? null : el("div.cards", {}, cards);
}

function memoryView() {
  const rows = instructions.filter((entry) => entry.global);
  const cycles = (row) =>
    Object.values(row.served ?? {}).reduce((all, s) => all + s.cycles, 0);
  const placed = (row) => {
    const { file, line } = profile.frames[row.frame];
    return file === undefined ? ""
      : el("a", { href: sourceLink(file, line ?? 0) }, placeText(row.frame));
  };
  const table = new SortedTable({
    rows, sortBy: 3, empty: "No instruction accessed global memory.",
    text: (row) => `${row.pc} ${row.text} ${placeText(row.frame)} `
      + functionName(profile.frames[row.frame].function),
    columns: [
      { title: "instruction", text: true, value: (row) => row.pc,
        cell: (row) => el("td.code", { title: row.pc }, row.text) },
      { title: "line", text: true, value: (row) => placeText(row.frame),
        cell: (row) => el("td.name", {}, placed(row), " ", el("small", {},
          shortName(functionName(profile.frames[row.frame].function)))) },
      countColumn("accesses", (row) => row.global,
        "the rest of those executed went to the local store"),
      countColumn("cycles", cycles,
        "from issue to answer; threads need not have waited for all of them"),
      latencyColumn(),
      ...usedLevels().map(({ name, label, meaning }) =>
        countColumn(label, (row) => accessesTo(row, name), meaning)),
    ],
  });
  return {
    element: el("div", {}, levelFigures(), table.element),
    search: (text) => table.search(text),
  };
}
