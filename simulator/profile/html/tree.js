// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The tree of calls: functions by their chain of calls, and in each what was
// inlined into it.

function makeNode(name, place, kind) {
  return {
    name, place, kind, calls: 0, self: noCounts(), children: new Map(),
    total: 0, own: 0, estimated: false,
  };
}

function childOf(node, key, make) {
  if (!node.children.has(key)) node.children.set(key, make());
  return node.children.get(key);
}

/** By outermost function what was inlined into it, and its own instructions. */
function inlinedTrees() {
  const roots = new Map();
  for (const entry of instructions) {
    const chain = chainOf(entry.frame).reverse();
    const outermost = profile.frames[chain[0]].function;
    if (!roots.has(outermost))
      roots.set(outermost, makeNode(functionName(outermost), "", "call"));
    let node = roots.get(outermost);
    for (let depth = 1; depth < chain.length; depth += 1) {
      const name = functionName(profile.frames[chain[depth]].function);
      const place = placeText(chain[depth - 1]);
      node = childOf(node, `${name}@${place}`,
        () => makeNode(name, place, "inlined"));
    }
    addTo(node.self, entry.counts);
  }
  return roots;
}

/** All counts of a tree. */
function treeCounts(node) {
  const counts = [...node.self];
  for (const child of node.children.values()) addTo(counts, treeCounts(child));
  return counts;
}

/** Puts a part of an inlined tree into a node of the tree of calls. */
function graft(node, inlined, shares, estimated) {
  node.estimated = estimated;
  node.self = inlined.self.map((cycles, use) => cycles * shares[use]);
  for (const [key, child] of inlined.children) {
    const copy = makeNode(child.name, child.place, child.kind);
    graft(copy, child, shares, estimated);
    node.children.set(key, copy);
  }
}

/** The whole tree. A function that was called through several chains has
 * counts for each of them, but not what was inlined into it: that is estimated
 * to be distributed as all of the function is. */
function callTree() {
  const inlined = inlinedTrees();
  const root = makeNode("(all threads)", "", "root");
  const nodes = [];
  const nodesOf = new Map();
  for (const entry of profile.call_tree)
    nodesOf.set(entry.function, (nodesOf.get(entry.function) ?? 0) + 1);
  profile.call_tree.forEach((entry, index) => {
    const site = entry.call_site === undefined ? ""
      : placeText(instructions[entry.call_site].frame);
    const node = makeNode(functionName(entry.function), site, "call");
    const counts = countsOf(entry.instructions, entry.lost);
    const source = inlined.get(entry.function);
    node.calls = entry.calls;
    if (source) {
      const all = treeCounts(source);
      const shares = all.map((cycles, use) =>
        cycles === 0 ? 0 : counts[use] / cycles);
      graft(node, source, shares, nodesOf.get(entry.function) > 1);
      addTo(node.self, counts.map((cycles, use) =>
        (all[use] === 0 ? cycles : 0)));
    } else node.self = counts;
    nodes.push(node);
    const parent = entry.caller === undefined ? root : nodes[entry.caller];
    parent.children.set(`call ${index}`, node);
  });
  if (profile.run.finished > 0) {
    const halted = makeNode("(halted threads)", "", "halted");
    halted.self[finishedUse] = profile.run.finished;
    root.children.set("halted", halted);
  }
  finishNode(root);
  return root;
}

/** Sums up and sorts the children, the largest first. */
function finishNode(node) {
  node.counts = [...node.self];
  node.own = sum(node.self);
  for (const child of node.children.values()) {
    finishNode(child);
    addTo(node.counts, child.counts);
  }
  node.total = sum(node.counts);
  node.children = [...node.children.values()]
    .sort((a, b) => b.total - a.total);
}
