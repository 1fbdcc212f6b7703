// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Many threads.

'use strict';

const {
  assert, frames, lineOf, move, runTo, session, source,
} = require('./session.js');

async function threads(client) {
  return (await client.threadsRequest()).body.threads;
}

session('each thread has a name, a stack and a local store', async (client) => {
  const stop = await runTo(client, ['end'],
    { chip: '4x32', set: { 'tm.count': 1 } });
  assert.equal(stop.allThreadsStopped, true);
  const list = await threads(client);
  assert.equal(list.length, 32);
  assert.match(list[5].name, /0\.5/);
  assert.equal(new Set(list.map((each) => each.id)).size, 32);
  for (const { id } of [list[0], list[5], list[31]]) {
    const stack = await frames(client, id);
    assert.match(stack.at(-1).name, /main|start/);
    const own = await client.evaluateRequest(
      { expression: 'Own', frameId: stack[0].id, context: 'watch' });
    assert.equal(Number(own.body.result), 2 * (id - 1));
  }
});

session('a condition chooses the thread', async (client) => {
  const line = lineOf('begin');
  const stopped = client.waitForEvent('stopped');
  await Promise.all([
    client.waitForEvent('initialized').then(async () => {
      await client.setBreakpointsRequest({
        source: { path: source },
        breakpoints: [{ line, condition: 'Number == 77' }],
      });
      await client.configurationDoneRequest();
    }),
    client.launch({ program: process.env.DAP_PROGRAM, chip: '4x32' }),
  ]);
  const { threadId } = (await stopped).body;
  assert.equal(threadId, 78);
});

session('thousands of threads are listed by their places', async (client) => {
  const stop = await runTo(client, ['started'],
    { chip: '128x32' });
  const begin = Date.now();
  const grouped = await threads(client);
  assert.ok(grouped.length < 100, `${grouped.length}`);
  assert.ok(grouped.some((each) => each.id === stop.threadId));
  assert.ok(grouped.some((each) => /more/.test(each.name)));
  for (const { id } of grouped)
    assert.ok((await frames(client, id)).length > 0);
  assert.ok(Date.now() - begin < 2000);
});

session('all of thousands if they are wanted', async (client) => {
  await runTo(client, ['started'],
    { chip: '128x32', threadList: 'all' });
  const begin = Date.now();
  const list = await threads(client);
  assert.equal(list.length, 4096);
  const stack = await frames(client, list[4000].id);
  assert.ok(stack.length > 0);
  assert.ok(Date.now() - begin < 2000);
});

session('the chip shows what a thread waits for', async (client) => {
  const { threadId } = await runTo(client, ['end'], { chip: '4x32' });
  const [frame] = await frames(client, threadId);
  const scopes = (await client.scopesRequest({ frameId: frame.id })).body.scopes;
  const chip = scopes.find((each) => each.name === 'Chip');
  const rows = (await client.variablesRequest(
    { variablesReference: chip.variablesReference })).body.variables;
  const names = rows.map((each) => each.name);
  assert.ok(names.includes('cycle') && names.includes('state'), `${names}`);
  assert.ok(Number(rows[names.indexOf('cycle')].value) > 0);
});

session('a command that goes on is cancelled', async (client) => {
  const { threadId } = await runTo(client, ['begin'], { chip: '1x1' });
  await client.setBreakpointsRequest(
    { source: { path: source }, breakpoints: [] });
  const [frame] = await frames(client, threadId);
  const type = (expression) =>
    client.evaluateRequest({ expression, frameId: frame.id, context: 'repl' });
  await type('print Missing = 1');
  const running = type('continue');
  // One that has not begun would only be taken out of the queue.
  await new Promise((resolve) => setTimeout(resolve, 500));
  const stop = move(client, 'cancel', { requestId: client.sequence - 1 });
  await assert.rejects(running, /cancelled/);
  assert.equal((await stop).reason, 'pause');
  assert.ok((await frames(client, threadId)).length > 0);
});

session('a run is paused, and breakpoints change while it goes on',
  async (client) => {
    const { threadId } = await runTo(
      client, ['begin'], { chip: '1x1', set: { 'tm.count': 2 } });
    await client.setBreakpointsRequest(
      { source: { path: source }, breakpoints: [] });
    await client.setFunctionBreakpointsRequest({ breakpoints: [] });
    const [frame] = await frames(client, threadId);
    await client.evaluateRequest(
      {
      expression: 'print Missing = 1', frameId: frame.id, context: 'repl',
    });
    await client.continueRequest({ threadId });
    await assert.rejects(client.stackTraceRequest({ threadId }), /notStopped/);
    const stop = await move(client, 'pause', { threadId });
    assert.equal(stop.reason, 'pause');
    await client.continueRequest({ threadId });
    const hit = client.waitForEvent('stopped');
    await client.setBreakpointsRequest(
      { source: { path: source }, breakpoints: [{ line: lineOf('waits') }] });
    assert.equal((await hit).body.reason, 'breakpoint');
  });
