// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Chromium without a window, for a report that is opened from its file.

const { execFileSync } = require("child_process");
const { chromium } = require("playwright-core");

const flags = [
  "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update",
  "--disable-sync",
];

function fail(message) {
  console.error(`error: ${message}`);
  process.exit(1);
}

/** Fails unless a condition holds. */
function check(condition, message) {
  if (!condition) fail(message);
}

/** Opens a report and lets test(page) look at it. Errors of the page, and
 * requests for anything but its file, fail. */
async function withReport(path, options, test) {
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
    if (["error", "warning"].includes(message.type()))
      fail(`from the page: ${message.text()}`);
  });
  const url = `file://${path}`;
  page.on("request", (request) =>
    check(request.url().split("#")[0] === url,
      `the page asks for ${request.url()}`));
  await page.goto(url);
  await test(page);
  await browser.close();
}

module.exports = { check, fail, withReport };
