// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The first view: where the thread-cycles went.

function section(title, ...content) {
  return el("section", {}, el("h2", {}, title), ...content);
}

function hottestList(entries, most, link) {
  return el("ol.hottest", {}, entries.map((entry) => el("li", {},
    el("a", { href: link(entry) },
      el("span.share", {}, percent(entry.cycles, whole)),
      entry.code ?? el("span.name", { title: entry.name },
        shortName(entry.name))),
    usesBar(entry.counts, most))));
}

function largest(entries, shown) {
  return [...entries].sort((a, b) => b.cycles - a.cycles).slice(0, shown);
}

function hottestFunctions() {
  const list = largest(functions.values(), 10);
  return hottestList(list, list[0]?.cycles ?? 1, (entry) =>
    entry.hottest ? sourceLink(entry.hottest.file, entry.hottest.line)
      : "#functions");
}

function hottestLines() {
  const list = largest(lines.values(), 10).map((line) => ({
    ...line, name: "",
    code: el("span.code", {},
      el("span.place", {}, lineText(line.file, line.line)), " ",
      ...highlighted(sourceOf(line.file, line.line))),
  }));
  return hottestList(list, list[0]?.cycles ?? 1, (entry) =>
    sourceLink(entry.file, entry.line));
}

function overviewView() {
  const element = el("div.overview", {},
    section("Where the thread-cycles went",
      el("div.big", {}, usesBar(totals, whole)),
      el("div.beside", {}, countsTable(totals, whole),
        el("div", {}, el("h3", {}, "Over time"), usesOverTime(170),
          timeAxis()))),
    el("div.pair", {},
      section("Hottest functions", hottestFunctions()),
      section("Hottest lines", hottestLines())));
  return { element };
}
