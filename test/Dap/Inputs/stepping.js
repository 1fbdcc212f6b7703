// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Forwards and backwards, by statement and by instruction.

'use strict';

const {
  assert, frames, lineOf, move, output, runTo, session, source,
} = require('./session.js');

/** The innermost function's name and line. */
async function place(client, threadId) {
  const [frame] = await frames(client, threadId);
  return [frame.name.replace(/\(.*/, ''), frame.line];
}

async function clear(client) {
  await client.setBreakpointsRequest(
    { source: { path: source }, breakpoints: [] });
}

session('into, over and out of a function', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  await clear(client);
  const into = await move(client, 'stepIn', { threadId });
  assert.equal(into.reason, 'step');
  assert.equal((await place(client, threadId))[0], 'sum');
  await move(client, 'next', { threadId });
  assert.equal((await place(client, threadId))[0], 'sum');
  const out = await move(client, 'stepOut', { threadId });
  assert.equal(out.reason, 'step');
  assert.deepEqual(await place(client, threadId), ['main', lineOf('call')]);
  await move(client, 'next', { threadId });
  assert.deepEqual(
    await place(client, threadId), ['main', lineOf('after the call')]);
  await move(client, 'next', { threadId });
  assert.deepEqual(await place(client, threadId), ['main', lineOf('prints')]);
});

session('back over the lines that were passed', async (client) => {
  const { threadId } = await runTo(client, ['prints']);
  await clear(client);
  for (const mark of ['after the call', 'call']) {
    const stop = await move(client, 'stepBack', { threadId });
    assert.equal(stop.reason, 'step');
    assert.deepEqual(await place(client, threadId), ['main', lineOf(mark)]);
  }
});

session('one instruction and back', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  const pc = async () =>
    Number((await frames(client, threadId))[0].instructionPointerReference);
  const begin = await pc();
  await move(client, 'next', { threadId, granularity: 'instruction' });
  assert.equal(await pc(), begin + 4);
  await move(client, 'stepIn', { threadId, granularity: 'instruction' });
  await move(client, 'stepBack', { threadId, granularity: 'instruction' });
  assert.equal(await pc(), begin + 4);
  await move(client, 'stepBack', { threadId, granularity: 'instruction' });
  assert.equal(await pc(), begin);
});

session('back to a breakpoint, then to the beginning', async (client) => {
  const { threadId } = await runTo(client, ['end']);
  await client.setBreakpointsRequest(
    { source: { path: source }, breakpoints: [{ line: lineOf('counts') }] });
  const hit = await move(client, 'reverseContinue', { threadId });
  assert.equal(hit.reason, 'breakpoint');
  const [frame] = await frames(client, threadId);
  const last = await client.evaluateRequest(
    { expression: 'Counter', frameId: frame.id, context: 'watch' });
  assert.equal(last.body.result, '19');
  await clear(client);
  const begin = await move(client, 'reverseContinue', { threadId });
  assert.equal(begin.reason, 'entry');
});

session('output comes once, also if time has run back', async (client) => {
  const { threadId } = await runTo(client, ['end']);
  await client.setBreakpointsRequest(
    { source: { path: source }, breakpoints: [{ line: lineOf('call') }] });
  await move(client, 'reverseContinue', { threadId });
  await clear(client);
  await Promise.all([
    client.waitForEvent('terminated'),
    client.continueRequest({ threadId }),
  ]);
  assert.equal(output(client, 'stdout'), 'sum 10\n');
});

session('the pc can be set to another line', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  await clear(client);
  const targets = await client.gotoTargetsRequest(
    { source: { path: source }, line: lineOf('prints') });
  assert.equal(targets.body.targets[0].line, lineOf('prints'));
  const stop = await move(client, 'goto',
    { threadId, targetId: targets.body.targets[0].id });
  assert.equal(stop.reason, 'goto');
  assert.deepEqual(await place(client, threadId), ['main', lineOf('prints')]);
});
