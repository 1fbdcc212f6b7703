// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A report without debug information, with a function whose name looks like
// markup: node check_plain.js REPORT.html

const path = require("path");
const { check, fail, withReport } = require("./browser.js");

async function checkPlain(page) {
  await page.keyboard.press("3");
  const names = await page.locator("main tbody td:nth-child(1)")
    .allInnerTexts();
  check(names.some((name) => name.startsWith("</script><b>"))
    && names.some((name) => name.startsWith("main")), `functions: ${names}`);
  await page.keyboard.press("2");
  const text = await page.locator("main").innerText();
  check(text.includes("code of no line"), `the source shows: ${text}`);
}

withReport(path.resolve(process.argv[2]), {}, checkPlain)
  .catch((error) => fail(error.stack));
