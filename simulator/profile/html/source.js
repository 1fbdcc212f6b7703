// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The annotated source.

function sourceLink(file, line) {
  return line === undefined ? `#source/${file}` : `#source/${file}/${line}`;
}

/** The paths of calls through which a line was inlined, the largest first. */
function inlinedPaths(line) {
  const paths = new Map();
  for (const entry of line.instructions) {
    const chain = chainOf(entry.frame);
    const key = chain.slice(1).join(",");
    const path = paths.get(key) ?? { chain, cycles: 0 };
    path.cycles += entry.cycles;
    paths.set(key, path);
  }
  return [...paths.values()].sort((a, b) => b.cycles - a.cycles);
}

function pathElement({ chain, cycles }, of) {
  const steps = chain.slice(1).map((frame) => {
    const { file, line } = profile.frames[frame];
    return el("a", {
      href: file === undefined ? "#source" : sourceLink(file, line ?? 0),
      title: functionName(profile.frames[frame].function),
    }, `${shortName(functionName(profile.frames[frame].function))} `,
    el("small", {}, placeText(frame)));
  });
  return el("li", {}, el("span.share", {}, percent(cycles, of)),
    shortName(functionName(profile.frames[chain[0]].function)),
    ...steps.flatMap((step) => [" ← ", step]));
}

function servedText(entry) {
  if (!entry.served) return "";
  return levels.filter(({ name }) => entry.served[name])
    .map(({ name, label }) => {
      const { accesses, cycles } = entry.served[name];
      return `${label} ${percent(accesses, entry.global)} at `
        + `${(cycles / Math.max(1, accesses)).toFixed(0)} cycles`;
    }).join(", ");
}

function instructionTable(line) {
  const most = Math.max(...line.instructions.map((entry) => entry.cycles));
  return new SortedTable({
    rows: line.instructions, text: (entry) => entry.text,
    columns: [
      { title: "address", text: true, value: (entry) => entry.pc,
        cell: (entry) => el("td.code", {}, entry.pc) },
      { title: "instruction", text: true, value: (entry) => entry.text,
        cell: (entry) => el("td.code", {}, entry.text) },
      countColumn("executed", (entry) => entry.executed),
      cyclesColumn("cycles", (entry) => entry.cycles, most),
      barColumn(most),
      { title: "global accesses", value: (entry) => entry.global ?? 0,
        cell: (entry) => el("td", {}, servedText(entry)) },
    ],
  }).element;
}

/** All that is known of a line. */
function lineDetail(line) {
  const paths = inlinedPaths(line);
  const shown = paths.slice(0, 12);
  return el("div.detail", {},
    el("div.detail-parts", {},
      countsTable(line.counts),
      el("div", {}, el("h3", {}, paths.length === 1
        ? "Called in" : `Called in ${paths.length} paths`),
      el("ol.paths", {},
        shown.map((path) => pathElement(path, line.cycles)),
        paths.length > shown.length
          ? el("li", {}, `and ${paths.length - shown.length} more`) : null))),
    instructionTable(line));
}

class SourceView {
  constructor() {
    this.list = el("ul.files", { "aria-label": "Files" });
    this.code = el("div.source-code", { tabindex: -1 });
    this.heading = el("div.source-heading");
    this.element = el("div.source", {}, this.list,
      el("div.source-pane", {}, this.heading, this.code));
    this.sorted = files.filter((file) => file.cycles > 0)
      .sort((a, b) => b.cycles - a.cycles);
    this.file = null;
    this.rows = new Map();
    this.needle = "";
    this.showFiles();
  }

  showFiles() {
    const most = this.sorted[0]?.cycles ?? 1;
    this.list.replaceChildren(...this.sorted.map((file) => el("li", {
      style: `--heat:${(file.cycles / most).toFixed(4)}`,
      class: file === this.file ? "current" : "",
    }, el("a", { href: sourceLink(file.index), title: file.path },
      el("span", {}, this.listName(file)), el("small", {},
        percent(file.cycles, whole))))));
  }

  /** The file's name, with its folder if another file has the same name. */
  listName(file) {
    const isAlone = this.sorted.every((other) =>
      other === file || other.name !== file.name);
    return isAlone ? file.name : file.path.split("/").slice(-2).join("/");
  }

  /** Follows a link: #source/<file>/<line>. */
  open(place) {
    const [fileText, lineText] = place;
    const file = fileText === undefined
      ? this.file ?? this.sorted[0] : files[Number(fileText)];
    if (!file) {
      this.code.replaceChildren(el("p", {},
        "No instruction has a line: compile with -g."));
      return;
    }
    if (file !== this.file) this.showFile(file);
    const wanted = lineText === undefined ? null : Number(lineText);
    if (wanted !== null) this.select(wanted);
  }

  showFile(file) {
    this.file = file;
    this.selected = null;
    this.showFiles();
    const text = file.text === undefined ? null : file.text.split("\n");
    const hottest = [...file.lines.values()].find((line) =>
      line.cycles === file.hottest);
    this.heading.replaceChildren(el("b", {}, file.path.replace(/^\.\//, "")),
      ` ${percent(file.cycles, whole)} of all thread-cycles · `,
      el("a", { href: sourceLink(file.index, hottest.line) }, "hottest line"),
      " (j: next, k: back)",
      text ? "" : el("em", {}, " The file could not be read; lines only."),
      el("div.line.columns", {}, el("span.share", {}, "cycles"),
        el("span", {}, "issued, lost"), el("span.executed", {}, "executed"),
        el("span.line-number", {}, "line"), el("span")));
    const numbers = text ? text.map((_, index) => index + 1)
      : [...file.lines.keys()].filter(Boolean).sort((a, b) => a - b);
    if (file.lines.has(0)) numbers.unshift(0);
    const comments = commentLines(text ?? []);
    this.rows.clear();
    this.code.replaceChildren(...numbers.map((number) => {
      const code = number === 0 ? "code of no line" : text?.[number - 1] ?? "";
      const row = this.lineRow(file, number, code,
        number === 0 || comments[number - 1]);
      this.rows.set(number, row);
      return row;
    }));
    this.code.scrollTop = 0;
  }

  lineRow(file, number, text, isComment) {
    const line = file.lines.get(number);
    const code = el("code", {},
      ...(isComment ? [el("span.comment", {}, text)] : highlighted(text)));
    if (!line)
      return el("div.line", {}, el("span"), el("span"), el("span"),
        el("span.line-number", {}, String(number)), code);
    return el("div.line.counted", {
      style: `--heat:${(line.cycles / file.hottest).toFixed(4)}`,
      onclick: () => { location.hash = sourceLink(file.index, number); },
    },
    el("span.share", {}, percent(line.cycles, whole)),
    usesBar(line.counts, file.hottest),
    el("span.executed", { title: `${count(line.counts[0])} instructions` },
      short(line.counts[0])),
    el("span.line-number", {}, number === 0 ? "?" : String(number)), code);
  }

  select(number) {
    this.code.querySelectorAll(".detail").forEach((detail) => detail.remove());
    this.code.querySelector(".selected")?.classList.remove("selected");
    const row = this.rows.get(number);
    if (!row) return;
    this.selected = number;
    row.classList.add("selected");
    const line = this.file.lines.get(number);
    if (line) row.after(lineDetail(line));
    row.scrollIntoView({ block: "center" });
  }

  /** To the next line by cycles of the file: one step hotter or colder. */
  step(colder) {
    if (!this.file) return;
    const byHeat = [...this.file.lines.values()]
      .sort((a, b) => b.cycles - a.cycles);
    const at = byHeat.findIndex((line) => line.line === this.selected);
    const next = at < 0 ? 0 : at + (colder ? 1 : -1);
    const line = byHeat[Math.max(0, Math.min(byHeat.length - 1, next))];
    location.hash = sourceLink(this.file.index, line.line);
  }

  search(needle) {
    this.needle = needle.toLowerCase();
    for (const row of this.rows.values())
      row.classList.toggle("found", this.needle !== ""
        && row.lastChild.textContent.toLowerCase().includes(this.needle));
  }

  /** To the next line with the searched text, also of the next files. */
  searchNext() {
    if (this.needle === "") return;
    const start = Math.max(0, this.sorted.indexOf(this.file));
    for (let step = 0; step <= this.sorted.length; step += 1) {
      const file = this.sorted[(start + step) % this.sorted.length];
      const after = step === 0 ? this.selected ?? 0 : 0;
      const found = (file.text ?? "").split("\n").findIndex((text, index) =>
        index + 1 > after && text.toLowerCase().includes(this.needle));
      if (found < 0) continue;
      location.hash = sourceLink(file.index, found + 1);
      return;
    }
  }
}
