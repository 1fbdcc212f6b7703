// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Drawings that grow with the page.

const chartWidth = 1000;

/** A cycle as text, with its time at the chip's clock. */
function timeText(cycle) {
  const seconds = cycle / (profile.run.clock_ghz * 1e9);
  const [scale, unit] = seconds >= 1 ? [1, "s"]
    : seconds >= 1e-3 ? [1e3, "ms"] : [1e6, "µs"];
  return `${count(cycle)} cycles (${(seconds * scale).toPrecision(3)} ${unit})`;
}

/** The number of the interval that a cycle lies in. */
function intervalAt(cycle) {
  const { ends } = profile.utilisation;
  let low = 0;
  let high = ends.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ends[middle] > cycle) high = middle;
    else low = middle + 1;
  }
  return low;
}

function intervalBegin(interval) {
  return interval === 0 ? 0 : profile.utilisation.ends[interval - 1];
}

/** The cycle under the pointer of something that is the run wide. */
function cycleAt(event, element) {
  const box = element.getBoundingClientRect();
  const share = (event.clientX - box.left) / box.width;
  return Math.max(0, Math.min(0.999999, share)) * profile.run.cycles;
}

/** Uses of all thread-cycles over time, one above the other. */
function usesOverTime(height) {
  const { ends, chip } = profile.utilisation;
  const all = chip.map(({ instructions: issued, lost }) =>
    countsOf(issued, lost).map((cycles) => Math.max(0, cycles)));
  const x = (cycle) => (cycle / profile.run.cycles) * chartWidth;
  const drawing = svg("svg.chart", {
    viewBox: `0 0 ${chartWidth} ${height}`, preserveAspectRatio: "none",
    style: `height:${height}px`, role: "img",
    "aria-label": "Thread-cycles by use over time",
  });
  const base = all.map(() => 0);
  const present = uses.map((_, use) =>
    all.reduce((most, counts) => Math.max(most, counts[use]), 0));
  for (const use of usesIn(present)) {
    const top = [];
    const bottom = [];
    all.forEach((counts, interval) => {
      const scale = height / Math.max(1, sum(counts));
      const [left, right] = [x(intervalBegin(interval)), x(ends[interval])];
      const low = height - base[interval];
      base[interval] += counts[use] * scale;
      const high = height - base[interval];
      top.push(`${left.toFixed(2)},${high.toFixed(2)}`,
        `${right.toFixed(2)},${high.toFixed(2)}`);
      bottom.unshift(`${right.toFixed(2)},${low.toFixed(2)}`,
        `${left.toFixed(2)},${low.toFixed(2)}`);
    });
    drawing.append(svg("polygon", {
      points: [...top, ...bottom].join(" "), style: `fill:${useColor(use)}`,
    }));
  }
  return withTooltip(drawing, (event) => {
    const interval = intervalAt(cycleAt(event, drawing));
    return [el("b", {}, `from ${timeText(intervalBegin(interval))}`),
      countsTable(all[interval])];
  });
}

/** The run's time below something that is the run wide. */
function timeAxis() {
  const ticks = 5;
  return el("div.time-axis", {}, Array.from({ length: ticks }, (_, i) =>
    el("span", {}, i === 0 ? "0"
      : `${short(Math.round((profile.run.cycles * i) / (ticks - 1)))}`)));
}

/** Bars of groups side by side, each with values of several series. */
function columnChart({ labels, series, height = 180, axis }) {
  const most = Math.max(1, ...series.flatMap(({ values }) => values));
  const columns = labels.map((label, index) => withTooltip(
    el("div.column", {},
      el("div.sticks", { style: `height:${height}px` },
        series.map(({ color, values }) => el("i", {
          style: `height:${(((values[index] ?? 0) / most) * 100).toFixed(2)}%;`
            + `background:${color}`,
        }))),
      el("span", {}, label)),
    () => [el("b", {}, `${axis} ${label}`), ...series.map(({ name, values }) =>
      el("div", {}, `${name}: ${count(values[index] ?? 0)}`))]));
  return el("div.column-chart", {},
    el("ul.legend", {}, series.map(({ name, color }) => el("li", {},
      el("i.swatch", { style: `background:${color}` }), name))),
    el("div.columns", {}, columns), el("p.axis", {}, axis));
}
