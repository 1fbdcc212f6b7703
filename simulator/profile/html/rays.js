// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the rays did.

/** Rays per second of each thread that had rays, over its own time. */
function raysPerSecond() {
  const { rays, own_cycles: cycles } = statistics?.threads ?? {};
  if (!rays || !cycles) return [];
  const clock = profile.run.clock_ghz * 1e9;
  return rays.map((all, thread) =>
    (all > 0 && cycles[thread] > 0 ? (all / cycles[thread]) * clock : 0))
    .filter((rate) => rate > 0);
}

/** The round numbers from one below to one above a range. */
function roundRates(low, high) {
  const rates = [];
  for (let power = Math.floor(Math.log10(low)); ; power += 1)
    for (const step of [1, 2, 5]) {
      const rate = step * 10 ** power;
      if (rate <= low) rates.length = 0;
      rates.push(rate);
      if (rate > high) return rates;
    }
}

/** Slowest and fastest thread and the whole chip on one logarithmic axis. */
function rateChart() {
  const rates = statistics?.rays;
  const threads = profile.run.tm_count * profile.run.tps_per_tm;
  if (!rates?.per_thread) return null;
  const points = [
    ["slowest thread × threads", rates.slowest_thread_per_second * threads],
    ["chip", rates.per_second],
    ["fastest thread × threads", rates.fastest_thread_per_second * threads],
  ].filter(([, rate]) => rate > 0);
  if (points.length === 0) return null;
  const ticks = roundRates(points[0][1], points.at(-1)[1]);
  const low = Math.log10(ticks[0]);
  const high = Math.log10(ticks.at(-1));
  const x = (rate) => ((Math.log10(rate) - low) / (high - low)) * 100;
  return el("div.rate-chart", {},
    ticks.map((rate) => el("span.tick", { style: `left:${x(rate)}%` },
      short(rate).replace(/\.0+(?= |$)/, ""))),
    el("div.range", { style: `left:${x(points[0][1])}%;`
      + `width:${x(points.at(-1)[1]) - x(points[0][1])}%` }),
    points.map(([name, rate]) => withTooltip(
      el("i.point", { class: name === "chip" ? "chip" : "",
        style: `left:${x(rate)}%` }),
      () => [el("b", {}, name), el("div", {}, `${count(rate)} rays/s`)])),
    el("p.axis", {}, `rays per second: ${points.map(([name, rate]) =>
      `${name} ${short(rate)}`).join(", ")}`));
}

/** How many threads trace how many rays per second. */
function rateHistogram() {
  const rates = raysPerSecond();
  if (rates.length < 2) return null;
  const low = Math.min(...rates);
  const high = Math.max(...rates);
  const bins = 30;
  const width = (high - low) / bins || 1;
  const counts = new Array(bins).fill(0);
  for (const rate of rates)
    counts[Math.min(bins - 1, Math.floor((rate - low) / width))] += 1;
  return columnChart({
    labels: counts.map((_, bin) => short(low + (bin + 0.5) * width)),
    series: [{ name: "threads", color: "var(--accent)", values: counts }],
    axis: "rays per second of a thread over its own time", height: 140,
  });
}

/** Nodes and triangles of a ray, and what of them came from memory. */
function perRayTable(rays) {
  const rows = [
    ["nodes visited", "nodes_visited"],
    ["of them from memory", "nodes_from_memory"],
    ["triangles visited", "triangles_visited"],
    ["of them from memory", "triangles_from_memory"],
  ];
  const most = Math.max(...rows.map(([, key]) => rays.per_ray[key].mean));
  return el("div.table", {}, el("table", {},
    el("thead", {}, el("tr", {}, el("th", {}, "of a ray"),
      el("th.number", {}, "mean"), el("th.number", {}, "most"),
      el("th.number", {}, "all rays"))),
    el("tbody", {}, rows.map(([label, key]) => el("tr", {},
      el("td", {}, label),
      heatCell(rays.per_ray[key].mean, most, rays.per_ray[key].mean.toFixed(2)),
      el("td.number", {}, count(rays.per_ray[key].maximum)),
      el("td.number", {}, count(rays[key])))))));
}

function cacheSections(cache) {
  const depths = Math.max(cache.hits_by_depth.length,
    cache.loads_by_depth.length);
  return [
    section("Cache in the local store",
      el("p", {}, `${count(cache.slots)} slots of ${cache.slot_bytes} bytes, `
        + `at most ${count(cache.peak_slots_used)} in use. `
        + `${percent(cache.hits, cache.visits)} of ${count(cache.visits)} `
        + `visits found what they needed; ${count(cache.loads)} loads, `
        + `${count(cache.bypasses)} bypasses, ${count(cache.deletions)} `
        + "deletions."),
      columnChart({
        labels: Array.from({ length: depths }, (_, depth) => String(depth)),
        series: [
          { name: "hits", color: "var(--use-issued)",
            values: cache.hits_by_depth },
          { name: "loads", color: "var(--use-memory)",
            values: cache.loads_by_depth },
        ],
        axis: "depth in the tree",
      })),
    cache.deletions === 0 ? null : section("Slots freed by a deletion",
      columnChart({
        labels: cache.slots_freed.histogram.map((_, i) =>
          (i === 0 ? "1" : `${2 ** i}–${2 ** (i + 1) - 1}`)),
        series: [{ name: "deletions", color: "var(--accent)",
          values: cache.slots_freed.histogram }],
        axis: "slots", height: 120,
      })),
  ];
}

function raysView() {
  const rays = statistics?.ray_profile;
  const chart = rateChart();
  const histogram = rateHistogram();
  const empty = !rays && !chart && !histogram;
  return {
    element: el("div", {},
      empty ? el("p", {}, "The program reports no rays.") : null,
      chart ? section("Rays per second", chart) : null,
      histogram ? section("Threads by their speed", histogram) : null,
      rays ? section("What a ray does",
        el("p", {}, `${count(rays.rays.closest)} rays looked for the closest `
          + `hit, ${count(rays.rays.any)} for any.`), perRayTable(rays)) : null,
      ...(rays?.cache ? cacheSections(rays.cache) : [])),
  };
}
