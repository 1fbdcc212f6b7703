// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The tree of calls as a graph of boxes and as a list that unfolds.

const narrowest = 0.0008;

function nodeTitle(node) {
  const calls = node.kind === "inlined" ? "inlined"
    : node.calls > 0 ? `${count(node.calls)} calls` : "";
  return [el("b", {}, node.name),
    el("div", {}, [percent(node.total, whole), calls,
      node.place && `at ${node.place}`,
      node.estimated && "shares of inlined functions are estimated"]
      .filter(Boolean).join(" · ")),
    countsTable(node.counts)];
}

/** Boxes, each as wide as its thread-cycles, callers above what they call. */
class CallGraph {
  constructor(root) {
    this.root = root;
    this.path = [root];
    this.needle = "";
    this.element = el("div.graph", { role: "img",
      "aria-label": "Graph of calls; the list below has the same" });
    this.show();
  }

  zoom(path) {
    this.path = path;
    this.show();
  }

  search(needle) {
    this.needle = needle.toLowerCase();
    this.show();
  }

  show() {
    const top = this.path.at(-1);
    const boxes = [];
    let depths = this.path.length;
    this.path.slice(0, -1).forEach((node, depth) =>
      boxes.push(this.box(node, depth, 0, 1, this.path.slice(0, depth + 1))));
    const place = (node, depth, left, path) => {
      const width = node.total / Math.max(1, top.total);
      if (width < narrowest) return;
      boxes.push(this.box(node, depth, left, width, path));
      depths = Math.max(depths, depth + 1);
      let at = left;
      for (const child of node.children) {
        place(child, depth + 1, at, [...path, child]);
        at += child.total / Math.max(1, top.total);
      }
    };
    place(top, this.path.length - 1, 0, this.path);
    this.element.style.height = `${depths * 22}px`;
    this.element.replaceChildren(...boxes);
  }

  box(node, depth, left, width, path) {
    const found = this.needle !== ""
      && node.name.toLowerCase().includes(this.needle);
    const box = el(`button.box.${node.kind}`, {
      class: found ? "found" : "",
      style: `left:${(left * 100).toFixed(3)}%;top:${depth * 22}px;`
        + `width:${(width * 100).toFixed(3)}%;`
        + `--lost:${(1 - node.counts[0] / Math.max(1, node.total)).toFixed(3)}`,
      onclick: () => this.zoom(path),
    }, width > 0.02 ? shortName(node.name) : "");
    return withTooltip(box, () => nodeTitle(node));
  }
}

/** The same tree, unfolded along what takes most. */
class CallList {
  constructor(root) {
    this.body = el("tbody");
    this.element = el("table.call-list", {},
      el("thead", {}, el("tr", {}, el("th", {}, "function"),
        el("th.number", { title: "with all that it called" }, "total"),
        el("th.number", {}, "own"), el("th.number", {}, "calls"),
        el("th", {}, "issued and lost"))), this.body);
    this.add(root, 0, null);
  }

  add(node, depth, after) {
    const row = this.row(node, depth);
    if (after) after.after(row);
    else this.body.append(row);
    if (depth < 9 && node.total > whole * 0.2) row.unfold();
    return row;
  }

  row(node, depth) {
    const mark = el("button.fold", {
      disabled: node.children.length === 0, "aria-label": "Unfold",
    }, node.children.length === 0 ? "·" : "▸");
    const row = el("tr", { "aria-level": depth + 1,
      "data-cycles": Math.round(node.total) },
      el("td.name", { style: `padding-left:${depth * 1.1 + 0.4}rem`,
        title: node.name }, mark,
      node.kind === "inlined" ? el("em", {}, shortName(node.name))
        : shortName(node.name), " ",
      el("small", {}, node.place ? `at ${node.place}` : "",
        node.estimated ? " ≈" : "")),
      heatCell(node.total, whole, percent(node.total, whole)),
      el("td.number", {}, percent(node.own, whole)),
      el("td.number", {}, node.calls === 0 ? "" : count(node.calls)),
      el("td.bar", {}, usesBar(node.counts, whole)));
    let children = null;
    const fold = () => {
      children.forEach((child) => {
        child.fold?.();
        child.remove();
      });
      children = null;
      mark.textContent = "▸";
      row.setAttribute("aria-expanded", "false");
    };
    row.fold = () => { if (children) fold(); };
    row.unfold = () => {
      if (children || node.children.length === 0) return;
      mark.textContent = "▾";
      row.setAttribute("aria-expanded", "true");
      children = [];
      for (const child of [...node.children].reverse())
        children.push(this.add(child, depth + 1, row));
    };
    mark.addEventListener("click", () => (children ? fold() : row.unfold()));
    return row;
  }
}

function callsView() {
  const root = callTree();
  const graph = new CallGraph(root);
  return {
    element: el("div.calls", {},
      el("p.note", {}, "Each box is as wide as its thread-cycles; the redder, "
        + "the more of them were lost. Italics were inlined. Click to enlarge, "
        + "and above to go back."),
      graph.element, el("div.table", {}, new CallList(root).element)),
    search: (text) => graph.search(text),
  };
}
