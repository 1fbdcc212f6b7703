// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A session of Microsoft's test client with `tpdbg --dap`.
//
// `node --test FILE.js` gets the program and its source from the environment.

'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const { test } = require('node:test');
const { DebugClient } = require('@vscode/debugadapter-testsupport');

const program = process.env.DAP_PROGRAM;
const source = process.env.DAP_SOURCE;

/** The number of the line of the source that ends with the comment `mark`. */
function lineOf(mark) {
  const lines = fs.readFileSync(source, 'utf8').split('\n');
  const index = lines.findIndex((line) => line.endsWith(`// ${mark}`));
  assert.notEqual(index, -1, `no line of ${source} is marked '${mark}'`);
  return index + 1;
}

/** What a launch needs besides the defaults. */
function configuration(attributes = {}) {
  return { program, chip: '1x1', ...attributes };
}

/** Runs `body` with a client that is connected to a new adapter. */
function session(name, body) {
  test(name, { timeout: 20000 }, async () => {
    const client = new DebugClient('tpdbg', '--dap', 'tp', undefined, true);
    client.defaultTimeout = 15000;
    client.outputs = [];
    client.on('output', (event) => client.outputs.push(event.body));
    await client.start();
    try {
      await body(client);
    } finally {
      await client.stop();
    }
  });
}

/** Launches, sets breakpoints at marked lines, and runs to the first stop. */
async function runTo(client, marks, attributes = {}) {
  const stopped = client.waitForEvent('stopped');
  await Promise.all([
    client.waitForEvent('initialized').then(async () => {
      await client.setBreakpointsRequest({
        source: { path: source },
        breakpoints: marks.map((mark) => ({ line: lineOf(mark) })),
      });
      await client.configurationDoneRequest();
    }),
    client.launch(configuration(attributes)),
  ]);
  return (await stopped).body;
}

/** Sends a request that moves the program, and waits until it stands. */
async function move(client, request, args) {
  const [event] = await Promise.all([
    client.waitForEvent('stopped'),
    client.send(request, args),
  ]);
  return event.body;
}

/** The frames of a thread, innermost first. */
async function frames(client, threadId) {
  const answer = await client.stackTraceRequest({ threadId });
  return answer.body.stackFrames;
}

/** The variables of a scope of a frame, by their names. */
async function scope(client, frameId, name) {
  const answer = await client.scopesRequest({ frameId });
  const found = answer.body.scopes.find((each) => each.name === name);
  assert.ok(found, `no scope ${name}`);
  return variables(client, found.variablesReference);
}

/** The parts of a variable, by their names. */
async function variables(client, variablesReference, rest = {}) {
  const answer = await client.variablesRequest({ variablesReference, ...rest });
  return new Map(answer.body.variables.map((each) => [each.name, each]));
}

/** Everything that the program or the adapter printed. */
function output(client, category) {
  return client.outputs
    .filter((each) => each.category === category)
    .map((each) => each.output)
    .join('');
}

module.exports = {
  assert, configuration, frames, lineOf, move, output, path, program, runTo,
  scope, session, source, test, variables,
};
