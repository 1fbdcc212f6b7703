// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Takes pictures of a report, of its overview, its hottest line in the source
// and, in dark, of the map of the chip: node profile_picture.js REPORT.html
// PREFIX writes PREFIX.png, PREFIX-source.png and PREFIX-chip.png.

const path = require("path");
const { withReport } = require("../test/Profile/Inputs/browser.js");

const [report, prefix] = process.argv.slice(2);
const pictures = [
  ["", "light", "overview"],
  ["-source", "light", "source"],
  ["-chip", "dark", "chip"],
];

async function takePicture(page, view, file) {
  await page.evaluate((hash) => { location.hash = hash; }, view);
  if (view === "source") await page.getByText("hottest line").click();
  await page.waitForTimeout(300);
  await page.screenshot({ path: file });
}

async function takeAll() {
  for (const [name, colorScheme, view] of pictures)
    await withReport(path.resolve(report),
      { colorScheme, viewport: { width: 1280, height: 860 } },
      (page) => takePicture(page, view, `${prefix}${name}.png`));
}

takeAll();
