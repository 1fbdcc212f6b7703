// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Breakpoints of every kind.

'use strict';

const {
  assert, configuration, frames, lineOf, move, output, runTo, scope, session,
  source, variables,
} = require('./session.js');

/** Replaces the breakpoints of the source by those at marked lines. */
async function setLines(client, ...marks) {
  const answer = await client.setBreakpointsRequest({
    source: { path: source },
    breakpoints: marks.map(
      ({ mark, ...rest }) => ({ line: lineOf(mark), ...rest })),
  });
  return answer.body.breakpoints;
}

/** The value of an expression in the innermost frame of a thread. */
async function evaluate(client, threadId, expression) {
  const [frame] = await frames(client, threadId);
  const answer = await client.evaluateRequest(
    { expression, frameId: frame.id, context: 'watch' });
  return answer.body.result;
}

session('a line is hit', async (client) => {
  await client.hitBreakpoint(
    configuration(), { path: source, line: lineOf('in the loop') });
});

session('a line without code moves to the next that has', async (client) => {
  const line = lineOf('in the loop') - 3;
  const blank = lineOf('call') + 6;
  await runTo(client, ['call']);
  const answer = await client.setBreakpointsRequest({
    source: { path: source },
    breakpoints: [{ line }, { line: blank }],
  });
  const [moved, none] = answer.body.breakpoints;
  assert.equal(moved.verified, true);
  assert.ok(moved.line >= line);
  assert.equal(none.verified, false);
  assert.ok(none.message);
});

session('another file has no code', async (client) => {
  await runTo(client, ['call']);
  const answer = await client.setBreakpointsRequest(
    { source: { path: '/nowhere/other.cpp' }, breakpoints: [{ line: 3 }] });
  assert.equal(answer.body.breakpoints[0].verified, false);
  assert.match(answer.body.breakpoints[0].message, /other\.cpp/);
});

session('conditions and counts choose hits', async (client) => {
  const { threadId } = await runTo(client, ['after numbers']);
  await setLines(client, { mark: 'in the loop', condition: 'I == 2' });
  await move(client, 'continue', { threadId });
  assert.equal(await evaluate(client, threadId, 'I'), '2');
  await setLines(client, { mark: 'counts', hitCondition: '% 7' });
  await move(client, 'continue', { threadId });
  assert.equal(await evaluate(client, threadId, 'Counter'), '6');
  await move(client, 'continue', { threadId });
  assert.equal(await evaluate(client, threadId, 'Counter'), '13');
});

session('a wrong condition is not verified', async (client) => {
  await runTo(client, ['after numbers']);
  const [condition, count] = await setLines(client,
    { mark: 'counts', condition: 'I ==' },
    { mark: 'in the loop', hitCondition: 'often' });
  assert.equal(condition.verified, false);
  assert.ok(condition.message);
  assert.equal(count.verified, false);
  assert.match(count.message, /often/);
});

session('a log point prints and goes on', async (client) => {
  const { threadId } = await runTo(client, ['after numbers']);
  await setLines(client,
    { mark: 'in the loop', logMessage: 'I is {I}, \\{value} {Values[I]}' },
    { mark: 'after the call' });
  const stop = await move(client, 'continue', { threadId });
  assert.equal(stop.reason, 'breakpoint');
  const text = output(client, 'console');
  for (const [i, value] of [1, 2, 3, 4].entries())
    assert.ok(text.includes(`I is ${i}, {value} ${value}\n`), text);
});

session('functions and instructions are hit', async (client) => {
  const { threadId } = await runTo(client, ['after numbers']);
  const functions = await client.setFunctionBreakpointsRequest(
    { breakpoints: [{ name: 'sum' }, { name: 'nothing' }] });
  assert.equal(functions.body.breakpoints[0].verified, true);
  assert.equal(functions.body.breakpoints[1].verified, false);
  const stop = await move(client, 'continue', { threadId });
  assert.equal(stop.reason, 'function breakpoint');
  const [frame, caller] = await frames(client, threadId);
  assert.match(frame.name, /sum/);
  const instructions = await client.send('setInstructionBreakpoints', {
    breakpoints: [
      { instructionReference: caller.instructionPointerReference },
      { instructionReference: '0x00000004' },
    ],
  });
  assert.equal(instructions.body.breakpoints[0].verified, true);
  assert.equal(instructions.body.breakpoints[1].verified, false);
  const back = await move(client, 'continue', { threadId });
  assert.equal(back.reason, 'instruction breakpoint');
  const [main] = await frames(client, threadId);
  assert.equal(main.instructionPointerReference,
    caller.instructionPointerReference);
});

session('writes and reads of data are hit', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  const [frame] = await frames(client, threadId);
  const info = await client.dataBreakpointInfoRequest(
    { name: 'Counter', frameId: frame.id });
  assert.ok(info.body.dataId);
  assert.deepEqual(info.body.accessTypes, ['read', 'write', 'readWrite']);
  const answer = await client.setDataBreakpointsRequest({
    breakpoints: [{ dataId: info.body.dataId, accessType: 'write' }],
  });
  assert.equal(answer.body.breakpoints[0].verified, true);
  await setLines(client);
  const stop = await move(client, 'continue', { threadId });
  assert.equal(stop.reason, 'data breakpoint');
  assert.equal(await evaluate(client, threadId, 'Counter'), '1');
  const back = await move(client, 'reverseContinue', { threadId });
  assert.equal(back.reason, 'data breakpoint');
  assert.equal(await evaluate(client, threadId, 'Counter'), '0');
});

session('data without an address cannot be watched', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  const [frame] = await frames(client, threadId);
  const info = await client.dataBreakpointInfoRequest(
    { name: '1 + 2', frameId: frame.id });
  assert.equal(info.body.dataId, null);
  assert.ok(info.body.description);
});

session('a member is watched through its list', async (client) => {
  const { threadId } = await runTo(client, ['after numbers']);
  const [frame] = await frames(client, threadId);
  const locals = await scope(client, frame.id, 'Locals');
  const reference = locals.get('Numbers').variablesReference;
  await variables(client, reference);
  const info = await client.dataBreakpointInfoRequest(
    { variablesReference: reference, name: '[2]' });
  await client.setDataBreakpointsRequest(
    { breakpoints: [{ dataId: info.body.dataId, accessType: 'read' }] });
  await setLines(client);
  const stop = await move(client, 'continue', { threadId });
  assert.equal(stop.reason, 'data breakpoint');
  assert.equal(await evaluate(client, threadId, 'I'), '2');
});

session('lines with code are offered', async (client) => {
  await runTo(client, ['call']);
  const answer = await client.send('breakpointLocations', {
    source: { path: source },
    line: lineOf('in the loop'),
    endLine: lineOf('end of sum') + 3,
  });
  const lines = answer.body.breakpoints.map((each) => each.line);
  assert.ok(lines.includes(lineOf('in the loop')));
  assert.ok(lines.includes(lineOf('end of sum')));
  assert.ok(!lines.includes(lineOf('end of sum') + 2));
});
