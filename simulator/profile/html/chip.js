// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The map of the chip: TMs from top to bottom, time from left to right.

/** Colours from little to much, as red, green, blue. */
const heatStops = [
  [68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37],
];

function heatColor(share) {
  const scaled = Math.max(0, Math.min(1, share)) * (heatStops.length - 1);
  const index = Math.min(heatStops.length - 2, Math.floor(scaled));
  const part = scaled - index;
  return heatStops[index].map((from, channel) =>
    Math.round(from + (heatStops[index + 1][channel] - from) * part));
}

/** What the map can show: thread-cycles of a TM and an interval. */
const chipMeasures = [
  { name: "issued", label: "issued instructions",
    of: (tm, i) => profile.utilisation.issued[tm][i] },
  { name: "memory", label: "waited for memory",
    of: (tm, i) => profile.utilisation.memory[tm][i] },
  { name: "finished", label: "had finished",
    of: (tm, i) => profile.utilisation.finished[tm][i] },
  { name: "other", label: "lost otherwise",
    of: (tm, i) => capacity(i) - chipMeasures.slice(0, 3)
      .reduce((all, measure) => all + measure.of(tm, i), 0) },
];

/** Thread-cycles that a TM has in an interval. */
function capacity(interval) {
  return (profile.utilisation.ends[interval] - intervalBegin(interval))
    * profile.run.tps_per_tm;
}

class ChipMap {
  constructor() {
    this.measure = chipMeasures[0];
    this.canvas = el("canvas", { role: "img",
      "aria-label": "Utilisation by TM and time" });
    const rows = profile.run.tm_count;
    this.canvas.width = chartWidth;
    this.canvas.height = rows;
    const height = Math.max(120, Math.min(420, rows * 12));
    this.canvas.style.height = `${height}px`;
    withTooltip(this.canvas, (event) => this.describe(event));
    this.buttons = chipMeasures.map((measure) => el("button", {
      onclick: () => this.show(measure), "data-measure": measure.name,
    }, measure.label));
    this.element = el("div.chip-map", {},
      el("div.choices", { role: "group", "aria-label": "Shown" }, this.buttons,
        el("span.scale", {}, "0 %", el("i", { style:
          `background:linear-gradient(90deg,${heatStops.map((stop) =>
            `rgb(${stop})`)})` }), "100 %")),
      el("div.map", {}, el("span.axis-name", {}, `TM 0 to ${rows - 1}`),
        this.canvas), timeAxis());
    this.show(this.measure);
  }

  show(measure) {
    this.measure = measure;
    this.buttons.forEach((button) => button.setAttribute("aria-pressed",
      String(button.dataset.measure === measure.name)));
    const context = this.canvas.getContext("2d");
    const { width, height } = this.canvas;
    const image = context.createImageData(width, height);
    const intervals = Array.from({ length: width }, (_, x) =>
      intervalAt(((x + 0.5) / width) * profile.run.cycles));
    for (let tm = 0; tm < height; tm += 1)
      for (let x = 0; x < width; x += 1) {
        const interval = intervals[x];
        const share = measure.of(tm, interval) / capacity(interval);
        image.data.set([...heatColor(share), 255], (tm * width + x) * 4);
      }
    context.putImageData(image, 0, 0);
  }

  describe(event) {
    const box = this.canvas.getBoundingClientRect();
    const row = Math.floor(((event.clientY - box.top) / box.height)
      * profile.run.tm_count);
    const tm = Math.max(0, Math.min(profile.run.tm_count - 1, row));
    const interval = intervalAt(cycleAt(event, this.canvas));
    return [el("b", {}, `TM ${tm}`),
      el("div", {}, `from ${timeText(intervalBegin(interval))}`),
      ...chipMeasures.map((measure) => el("div", {}, `${measure.label}: `
        + percent(measure.of(tm, interval), capacity(interval))))];
  }
}

/** Sums of each TM over the run. */
function tmRows() {
  const total = profile.run.cycles * profile.run.tps_per_tm;
  return Array.from({ length: profile.run.tm_count }, (_, tm) => {
    const row = { tm, total };
    for (const measure of chipMeasures)
      row[measure.name] = profile.utilisation.ends.reduce((all, _end, i) =>
        all + measure.of(tm, i), 0);
    return row;
  });
}

function chipView() {
  const rows = tmRows();
  const table = new SortedTable({
    rows, sortBy: 1, limit: 32, text: (row) => `TM ${row.tm}`,
    columns: [
      { title: "TM", value: (row) => row.tm,
        cell: (row) => el("td.number", {}, String(row.tm)) },
      ...chipMeasures.map((measure) => ({
        title: measure.label, value: (row) => row[measure.name],
        cell: (row) => heatCell(row[measure.name], row.total,
          percent(row[measure.name], row.total)),
      })),
    ],
  });
  return {
    element: el("div", {},
      section("The chip over time", new ChipMap().element),
      section("All TMs", usesOverTime(120), timeAxis(), legend(totals)),
      section("Each TM", table.element)),
    search: (text) => table.search(text),
  };
}
