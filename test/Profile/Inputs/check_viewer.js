// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Opens a file in speedscope, which reads its own format and that of traces
// for Perfetto. It must show all profiles or tracks and have no complaint:
// node check_viewer.js FILE TITLE

const fs = require("fs");
const path = require("path");
const { check, fail, withPage } = require("./browser.js");

const [file, title] = process.argv.slice(2);
const viewer = require.resolve("speedscope/dist/release/index.html");

/** The profiles of a file for speedscope, the tracks of a trace. */
function profilesOf({ profiles, traceEvents }) {
  return profiles?.length
    ?? new Set(traceEvents.map(({ pid, tid }) => `${pid}/${tid}`)).size;
}

async function checkViewer(page) {
  await page.setInputFiles("input[type=file]", file);
  await page.waitForFunction((text) => document.title.includes(text), title)
    .catch(() => fail(`speedscope does not show ${title}`));
  const text = await page.locator("body").innerText();
  const number = profilesOf(JSON.parse(fs.readFileSync(file, "utf8")));
  check(text.includes(`(1/${number})`), `not ${number} profiles: ${text}`);
}

withPage(viewer, path.dirname(viewer), {}, checkViewer)
  .catch((error) => fail(error.stack));
