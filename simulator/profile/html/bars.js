// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Thread-cycles by use as a bar of colours.

function useColor(use) {
  return `var(--use-${uses[use].name.replaceAll("_", "-")})`;
}

/** The uses that occur in counts, in their order. */
function usesIn(counts) {
  return uses.map((_, use) => use).filter((use) => counts[use] > 0);
}

/** A table of what counts consist of, for a tooltip or a detail. */
function countsTable(counts, of = sum(counts)) {
  const rows = usesIn(counts).sort((a, b) => counts[b] - counts[a]);
  return el("table.counts", {}, el("tbody", {}, rows.map((use) =>
    el("tr", {},
      el("td", {}, swatch(use), uses[use].label),
      el("td.number", {}, count(counts[use])),
      el("td.number", {}, percent(counts[use], of))))));
}

function swatch(use) {
  return el("i.swatch", { style: `background:${useColor(use)}` });
}

/** A bar whose full width is the scale. */
function usesBar(counts, scale = sum(counts)) {
  const bar = el("div.uses-bar");
  for (const use of usesIn(counts)) {
    const width = scale === 0 ? 0 : (counts[use] / scale) * 100;
    bar.append(el("span", {
      style: `width:${width.toFixed(3)}%;background:${useColor(use)}`,
    }));
  }
  return withTooltip(bar, () => countsTable(counts));
}

/** Colours with their names, for counts that have them. */
function legend(counts) {
  return el("ul.legend", {}, usesIn(counts).map((use) =>
    el("li", { title: uses[use].meaning }, swatch(use), uses[use].label)));
}

/** A number with a background that shows its share. */
function heatCell(value, most, text) {
  const share = most === 0 ? 0 : Math.min(1, value / most);
  return el("td.number.heat", { style: `--heat:${share.toFixed(4)}` }, text);
}
