// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Opens a report in Chromium and holds what it shows against the profile that
// it was made from: node check_report.js REPORT.html PROFILE.json

const fs = require("fs");
const path = require("path");
const { check, fail, withReport } = require("./browser.js");

const [report, profilePath] = process.argv.slice(2).map((p) => path.resolve(p));
const profile = JSON.parse(fs.readFileSync(profilePath, "utf8"));
const whole = profile.run.thread_cycles;
const mostBytes = 5e6;

function cyclesOf(entry) {
  return Object.values(entry.lost).reduce((a, b) => a + b, entry.executed);
}

/** The text of all elements that match. */
function texts(page, selector) {
  return page.locator(selector).allInnerTexts();
}

function numberOf(text) {
  return Number(text.replaceAll(",", ""));
}

function percentOf(text) {
  return text.startsWith("<") ? 0.05 : Number.parseFloat(text);
}

async function show(page, view) {
  await page.evaluate((hash) => { location.hash = hash; }, view);
  await page.waitForSelector(`nav a[data-view="${view.split("/")[0]}"]`
    + "[aria-selected=true]");
}

/** By reason, the overview has what the profile has. */
async function checkOverview(page) {
  const expected = new Map();
  const add = (reason, cycles) =>
    expected.set(reason, (expected.get(reason) ?? 0) + cycles);
  for (const { executed, lost } of profile.instructions) {
    add("issued", executed);
    for (const [reason, cycles] of Object.entries(lost)) add(reason, cycles);
  }
  if (profile.run.finished > 0) add("finished", profile.run.finished);
  const rows = await page.locator(".beside > .counts tr").all();
  check(rows.length === [...expected.values()].filter(Boolean).length,
    `${rows.length} reasons instead of ${expected.size}`);
  let sum = 0;
  for (const row of rows) {
    const [label, cycles] = await row.locator("td").allInnerTexts();
    const reason = label.toLowerCase().replaceAll(" ", "_");
    check(numberOf(cycles) === expected.get(reason),
      `${reason}: ${cycles} instead of ${expected.get(reason)}`);
    sum += numberOf(cycles);
  }
  check(sum === whole, `${sum} thread-cycles instead of ${whole}`);
}

/** The hottest line is the hottest, and its source is what the file says. */
async function checkSource(page) {
  const cycles = new Map();
  for (const entry of profile.instructions) {
    const { file, line } = profile.frames[entry.frame];
    if (file === undefined || line === undefined) continue;
    const key = `${file}/${line}`;
    cycles.set(key, (cycles.get(key) ?? 0) + cyclesOf(entry));
  }
  const [[key, most]] = [...cycles].sort((a, b) => b[1] - a[1]);
  const [file, line] = key.split("/").map(Number);
  await show(page, `source/${key}`);
  const selected = page.locator(".line.selected");
  const share = percentOf(await selected.locator(".share").innerText());
  check(Math.abs(share - (most / whole) * 100) < 0.051,
    `the line ${key} has ${share} %`);
  const text = profile.files[file].text.split("\n")[line - 1];
  check(await selected.locator("code").textContent() === text,
    `line ${line} is not '${text}'`);
  const executed = profile.instructions.filter((entry) =>
    profile.frames[entry.frame].file === file
    && profile.frames[entry.frame].line === line);
  const shown = await texts(page, ".detail tbody td.code:nth-child(2)");
  check(shown.length === executed.length,
    `${shown.length} instructions instead of ${executed.length}`);
  await page.keyboard.press("j");
  await page.waitForFunction((hash) => location.hash !== hash,
    `#source/${key}`);
}

/** Clicks sort a table both ways; search leaves what contains the text. */
async function checkFunctions(page) {
  await show(page, "functions");
  const shares = async () =>
    (await texts(page, "main tbody td:nth-child(2)")).map(percentOf);
  const isSorted = (list, sign) => list.every((value, i) =>
    i === 0 || sign * (value - list[i - 1]) >= 0);
  check(isSorted(await shares(), -1), "functions are not sorted by cycles");
  await page.getByRole("button", { name: "own" }).click();
  check(isSorted(await shares(), 1), "a click does not turn the order");
  const all = (await shares()).length;
  await page.keyboard.press("/");
  await page.keyboard.type("main");
  const found = await texts(page, "main tbody td:nth-child(1)");
  check(found.length > 0 && found.length < all
    && found.every((name) => name.includes("main")), "search finds otherwise");
  await page.keyboard.press("Escape");
  check((await shares()).length === all, "Escape does not end the search");
}

/** The tree of calls is the whole run, and unfolds. */
async function checkCalls(page) {
  await show(page, "calls");
  const row = page.locator(".call-list tbody tr");
  const total = Number(await row.first().getAttribute("data-cycles"));
  check(total === whole, `the tree of calls has ${total} thread-cycles`);
  const before = await row.count();
  await page.locator(".call-list tr[aria-level='1'] .fold").click();
  check(await row.count() === 1, "the tree does not fold");
  await page.locator(".call-list tr[aria-level='1'] .fold").click();
  check(await row.count() > 1 && await row.count() <= before,
    "the tree does not unfold");
  const boxes = page.locator(".graph .box");
  const width = async () => (await boxes.last().boundingBox()).width;
  const narrow = await width();
  await boxes.last().click();
  check(await width() > narrow, "a click does not enlarge a box");
}

/** Each TM has its sums, and the map several colours. */
async function checkChip(page) {
  await show(page, "chip");
  const total = profile.run.cycles * profile.run.tps_per_tm;
  const issued = profile.utilisation.issued[0].reduce((a, b) => a + b, 0);
  const rows = await page.locator("main tbody tr").all();
  for (const row of rows) {
    const cells = await row.locator("td").allInnerTexts();
    const sum = cells.slice(1).reduce((all, text) => all + percentOf(text), 0);
    check(Math.abs(sum - 100) < 0.3, `TM ${cells[0]} has ${sum} %`);
    if (cells[0] === "0")
      check(Math.abs(percentOf(cells[1]) - (issued / total) * 100) < 0.051,
        `TM 0 has issued ${cells[1]}`);
  }
  const colors = await page.evaluate(() => {
    const canvas = document.querySelector(".map canvas");
    const { data } = canvas.getContext("2d")
      .getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
  check(colors > 1, "the map has one colour");
}

async function checkMemory(page) {
  await show(page, "memory");
  const expected = profile.instructions.filter((entry) => entry.global).length;
  const rows = await page.locator("main .table tbody tr").count();
  check(rows === Math.min(300, expected),
    `${rows} accesses to memory instead of ${expected}`);
  const titles = await texts(page, "main .table thead th");
  const column = titles.findIndex((title) =>
    title.toLowerCase().startsWith("row hits"));
  const most = Math.max(...profile.instructions.map((entry) =>
    entry.served?.dram_row_hit?.accesses ?? 0));
  const cell = page.locator("main .table tbody td").and(
    page.locator(`td:nth-child(${column + 1})[title="${
      most.toLocaleString("en-US")}"]`));
  check(column > 0 && await cell.count() > 0,
    `no instruction has ${most} hits in rows of DRAM`);
}

/** Lines have the rates of hits of their instructions. */
async function checkLines(page) {
  await show(page, "lines");
  const hits = { hit: 0, all: 0 };
  for (const { served = {} } of profile.instructions)
    for (const [level, { accesses }] of Object.entries(served)) {
      if (level === "dram_row_hit") hits.hit += accesses;
      if (level.startsWith("dram_row_")) hits.all += accesses;
    }
  const titles = await texts(page, "main .table thead th");
  const column = titles.findIndex((title) =>
    title.toLowerCase().startsWith("row hits"));
  const rates = (await texts(page,
    `main .table tbody td:nth-child(${column + 1})`)).filter(Boolean)
    .map(percentOf);
  const mean = (hits.hit / hits.all) * 100;
  check(column > 0 && Math.min(...rates) <= mean
    && mean <= Math.max(...rates), `rows: ${rates}, in all ${mean} %`);
}

/** What the rays did is that of the statistics. */
async function checkRays(page) {
  await show(page, "rays");
  const rays = profile.statistics.ray_profile;
  const cells = await texts(page, "main .table tbody tr:first-child td");
  check(numberOf(cells[3]) === rays.nodes_visited,
    `${cells[3]} nodes instead of ${rays.nodes_visited}`);
  check(await page.locator(".rate-chart .point").count() === 3,
    "the chart of the rates has not three points");
  const sticks = page.locator(".column-chart").nth(1).locator(".column");
  const depths = Math.max(rays.cache.hits_by_depth.length,
    rays.cache.loads_by_depth.length);
  check(await sticks.count() === depths,
    `the cache has not ${depths} depths`);
}

/** Light and dark are different, by the system's choice and by the key. */
async function checkThemes(page) {
  const luminance = () => page.evaluate(() => {
    const color = getComputedStyle(document.body).backgroundColor;
    return color.match(/[\d.]+/g).slice(0, 3)
      .reduce((sum, channel) => sum + Number(channel), 0);
  });
  await page.emulateMedia({ colorScheme: "light" });
  const light = await luminance();
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await luminance();
  check(light > 600 && dark < 150, `backgrounds: ${light} and ${dark}`);
  await page.keyboard.press("t");
  check(await luminance() === light, "the key t does not change the theme");
}

/** Every view opens by its number. */
async function checkKeys(page) {
  const names = await page.locator("nav a").evaluateAll((tabs) =>
    tabs.map((tab) => tab.dataset.view));
  for (const [index, name] of names.entries()) {
    await page.keyboard.press(String(index + 1));
    await page.waitForSelector(`nav a[data-view=${name}][aria-selected=true]`);
    check((await page.locator("main").innerText()).length > 10,
      `the view ${name} is empty`);
  }
}

/** Nothing is wider than the page of a laptop. */
async function checkWidth(page) {
  for (const width of [1366, 800]) {
    await page.setViewportSize({ width, height: 820 });
    const overflow = await page.evaluate(() =>
      document.documentElement.scrollWidth - window.innerWidth);
    check(overflow <= 0, `at ${width} pixels ${overflow} are cut off`);
  }
}

async function checkAll(page) {
  await checkOverview(page);
  await checkSource(page);
  await checkFunctions(page);
  await checkCalls(page);
  await checkChip(page);
  await checkLines(page);
  await checkMemory(page);
  await checkRays(page);
  await checkThemes(page);
  await checkKeys(page);
  await checkWidth(page);
}

const bytes = fs.statSync(report).size;
check(bytes < mostBytes, `the report has ${bytes} bytes`);
withReport(report, {}, checkAll).catch((error) => fail(error.stack));
