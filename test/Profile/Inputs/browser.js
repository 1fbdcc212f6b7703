// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Chromium without a window, for a report that is opened from its file.

const { execFileSync } = require("child_process");
const { chromium } = require("playwright-core");

const flags = [
  "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update",
  "--disable-sync", "--enable-unsafe-swiftshader",
];

function fail(message) {
  console.error(`error: ${message}`);
  process.exit(1);
}

/** Fails unless a condition holds. */
function check(condition, message) {
  if (!condition) fail(message);
}

/** Opens a page and lets test(page) look at it. What the page complains of,
 * and requests for files that are not below a folder, fail. */
async function withPage(path, folder, options, test) {
  const binary = execFileSync("sh", ["-c", "command -v chromium"])
    .toString().trim();
  const browser = await chromium.launch(
    { executablePath: binary, args: flags });
  const context = await browser.newContext({
    viewport: { width: 1366, height: 820 }, ...options,
  });
  const page = await context.newPage();
  page.on("pageerror", (error) => fail(`in the page: ${error.stack}`));
  page.on("console", (message) => {
    // What is drawn by the processor is slow, which its driver says.
    if (["error", "warning"].includes(message.type())
      && !message.text().includes("GL Driver Message"))
      fail(`from the page: ${message.text()}`);
  });
  page.on("request", (request) =>
    check(request.url().startsWith(`file://${folder}`),
      `the page asks for ${request.url()}`));
  await page.goto(`file://${path}`);
  await test(page);
  await browser.close();
}

/** Opens a report, which is all in one file. */
function withReport(path, options, test) {
  return withPage(path, path, options, test);
}

module.exports = { check, fail, withPage, withReport };
