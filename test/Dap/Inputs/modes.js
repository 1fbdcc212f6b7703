// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// What is chosen at the launch: no timing, where sources are; and the progress
// of a run that takes long.

'use strict';

const {
  assert, configuration, frames, lineOf, move, path, runTo, scope, session,
  source,
} = require('./session.js');

const moved = process.env.DAP_MOVED;

async function rounds(client, threadId) {
  const [frame] = await frames(client, threadId);
  const answer = await client.evaluateRequest(
    { expression: 'Rounds', frameId: frame.id, context: 'watch' });
  return answer.body.result;
}

session('without timing, forwards and backwards', async (client) => {
  const { threadId } = await runTo(client, ['turns'], { functional: true });
  await move(client, 'continue', { threadId });
  await move(client, 'continue', { threadId });
  assert.equal(await rounds(client, threadId), '2');
  const [frame] = await frames(client, threadId);
  const chip = await scope(client, frame.id, 'Chip');
  assert.ok(Number(chip.get('instruction of the run').value) > 0);
  assert.equal(chip.has('cycle'), false);
  await move(client, 'reverseContinue', { threadId });
  assert.equal(await rounds(client, threadId), '1');
  await move(client, 'stepBack', { threadId });
  const stack = await frames(client, threadId);
  assert.equal(stack.at(-2).line, lineOf('second'));
});

session('sources that have been moved', async (client) => {
  const initialized = client.waitForEvent('initialized');
  const launched = client.launch(configuration({
    sourceMap: { [path.dirname(source)]: path.dirname(moved) },
  }));
  await initialized;
  const set = await client.setBreakpointsRequest({
    source: { path: moved }, breakpoints: [{ line: lineOf('turns') }],
  });
  assert.equal(set.body.breakpoints[0].verified, true);
  const stopped = client.waitForEvent('stopped');
  await client.configurationDoneRequest();
  await launched;
  const { threadId } = (await stopped).body;
  const [frame] = await frames(client, threadId);
  assert.equal(frame.source.path, moved);
  assert.equal(frame.line, lineOf('turns'));
});

session('a run that takes long tells how far it is', async (client) => {
  const initialized = client.waitForEvent('initialized');
  await client.initializeRequest({
    adapterID: 'tp', linesStartAt1: true, columnsStartAt1: true,
    pathFormat: 'path', supportsProgressReporting: true,
  });
  const begun = client.waitForEvent('progressStart');
  const launched = client.launchRequest(configuration());
  await initialized;
  await client.configurationDoneRequest();
  await launched;
  const { progressId, title } = (await begun).body;
  assert.notEqual(title, '');
  const updated = (await client.waitForEvent('progressUpdate')).body;
  assert.equal(updated.progressId, progressId);
  assert.match(updated.message, /\d/);
  const ended = client.waitForEvent('progressEnd');
  const [stopped] = await Promise.all([
    client.waitForEvent('stopped'), client.pauseRequest({ threadId: 1 }),
  ]);
  assert.equal(stopped.body.reason, 'pause');
  assert.equal((await ended).body.progressId, progressId);
});
