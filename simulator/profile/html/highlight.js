// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Colours of C++ source.

const tokenPattern = new RegExp([
  "(?<comment>//.*|/\\*.*?(?:\\*/|$))",
  "(?<string>\"(?:[^\"\\\\]|\\\\.)*\"|'(?:[^'\\\\]|\\\\.)+')",
  "(?<directive>^\\s*#\\s*\\w+)",
  "(?<number>\\b(?:0[xXbB][\\w']+|\\d[\\w.']*(?:(?<=[eEpP])[+-]\\d+)?f?))",
  "(?<keyword>\\b(?:alignas|auto|bool|break|case|char|class|const|consteval|"
    + "constexpr|continue|default|delete|do|double|else|enum|explicit|extern|"
    + "false|float|for|friend|if|inline|int|long|namespace|new|noexcept|"
    + "nullptr|operator|private|protected|public|requires|return|short|signed|"
    + "sizeof|static|static_assert|static_cast|reinterpret_cast|struct|switch|"
    + "template|this|thread_local|true|typedef|typename|union|unsigned|using|"
    + "virtual|void|volatile|while|u?int(?:8|16|32|64)_t|size_t)\\b)",
].join("|"), "g");

/** The pieces of a line, as text and elements. */
function highlighted(line) {
  const pieces = [];
  let end = 0;
  for (const match of line.matchAll(tokenPattern)) {
    const [kind] = Object.entries(match.groups).find(([, text]) =>
      text !== undefined);
    pieces.push(line.slice(end, match.index), el(`span.${kind}`, {}, match[0]));
    end = match.index + match[0].length;
  }
  pieces.push(line.slice(end));
  return pieces;
}

/** Which lines of a file lie within a comment of several lines. */
function commentLines(text) {
  let inside = false;
  return text.map((line) => {
    const was = inside;
    const code = line.replace(/"(?:[^"\\]|\\.)*"/g, "").replace(/\/\/.*/, "");
    const opens = code.lastIndexOf("/*");
    const closes = code.lastIndexOf("*/");
    if (opens > closes) inside = true;
    else if (closes > opens || (closes >= 0 && was)) inside = false;
    return was && closes < 0;
  });
}
