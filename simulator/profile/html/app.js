// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Views, keys, search and theme.

const source = new SourceView();
const views = [
  { name: "overview", label: "Overview", make: overviewView },
  { name: "source", label: "Source", make: () => source },
  { name: "functions", label: "Functions", make: functionsView },
  { name: "lines", label: "Lines", make: linesView },
  { name: "calls", label: "Calls", make: callsView },
  { name: "memory", label: "Memory", make: memoryView },
  { name: "chip", label: "Chip", make: chipView },
  { name: "rays", label: "Rays", make: raysView },
];
const keyTexts = [
  ["1 to 8", "views"], ["/", "search"],
  ["Enter", "in the search of the source: next line with the text"],
  ["j, k", "in the source: next colder, next hotter line"],
  ["t", "light or dark"], ["?", "these keys"], ["Esc", "close, clear search"],
];

const search = document.getElementById("search");
const keysDialog = document.getElementById("keys");
let current = null;

/** Makes a view when it is first shown. */
function viewOf(entry) {
  entry.view ??= entry.make();
  return entry.view;
}

function showView(name, place) {
  const entry = views.find((view) => view.name === name) ?? views[0];
  const view = viewOf(entry);
  hideTooltip();
  if (current !== entry) {
    document.querySelector("main").replaceChildren(view.element);
    window.scrollTo(0, 0);
  }
  current = entry;
  for (const tab of document.querySelectorAll("nav a")) {
    const selected = tab.dataset.view === entry.name;
    tab.setAttribute("aria-selected", String(selected));
  }
  search.disabled = !view.search;
  view.open?.(place);
  view.search?.(search.value);
}

function follow() {
  const [name, ...place] = location.hash.slice(1).split("/");
  showView(name, place);
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
}

function isDark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === "dark"
    : window.matchMedia("(prefers-color-scheme: dark)").matches;
}

function press(event) {
  if (event.key === "Escape") {
    search.value = "";
    current.view.search?.("");
    search.blur();
    return;
  }
  if (event.target === search) {
    if (event.key === "Enter") current.view.searchNext?.();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const number = Number(event.key);
  if (number >= 1 && number <= views.length)
    location.hash = `#${views[number - 1].name}`;
  else if (event.key === "/") search.focus();
  else if (event.key === "t") setTheme(isDark() ? "light" : "dark");
  else if (event.key === "?") keysDialog.showModal();
  else if (current.name === "source" && "jk".includes(event.key))
    source.step(event.key === "j");
  else return;
  event.preventDefault();
}

function keyFigures() {
  const { run } = profile;
  const rate = run.instructions / Math.max(1, whole);
  const figures = [
    ["cycles", short(run.cycles), count(run.cycles)],
    ["time", timeText(run.cycles).replace(/.*\((.*)\)/, "$1"),
      `at ${run.clock_ghz} GHz`],
    ["instructions", short(run.instructions), count(run.instructions)],
    ["issued", percent(rate, 1), "thread-cycles with an instruction"],
  ];
  const rays = statistics?.rays?.per_second;
  if (rays) figures.push(["rays/s", short(rays), count(rays)]);
  return figures.map(([name, text, title]) => el("div", { title },
    el("dt", {}, name), el("dd", {}, text)));
}

function start() {
  const { run } = profile;
  const name = fileName(run.program);
  document.title = `${name} on ${run.chip}`;
  document.querySelector("h1").textContent = name;
  document.querySelector(".chip-line").textContent =
    `${run.chip}: ${count(run.tm_count)} TMs × ${count(run.tps_per_tm)} TPs`
    + (run.outcome === "finished" ? "" : ` · ended early: ${run.outcome}`);
  document.querySelector(".key-figures").append(...keyFigures());
  document.querySelector("nav").append(...views.map((view, index) =>
    el("a", { href: `#${view.name}`, role: "tab", "data-view": view.name,
      title: `${index + 1}` }, view.label)));
  keysDialog.append(el("h2", {}, "Keys"),
    el("table", {}, keyTexts.map(([key, text]) =>
      el("tr", {}, el("td", {}, el("kbd", {}, key)), el("td", {}, text)))),
    el("form", { method: "dialog" }, el("button", {}, "Close")));
  search.addEventListener("input", () => current.view.search?.(search.value));
  document.getElementById("theme").addEventListener("click", () =>
    setTheme(isDark() ? "light" : "dark"));
  document.getElementById("help").addEventListener("click", () =>
    keysDialog.showModal());
  document.addEventListener("keydown", press);
  window.addEventListener("hashchange", follow);
  follow();
}

start();
