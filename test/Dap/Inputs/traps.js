// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Traps, and the way back from them.

'use strict';

const {
  assert, frames, lineOf, move, runTo, session,
} = require('./session.js');

session('a trap stops with its reason', async (client) => {
  const { threadId } = await runTo(client, ['begin']);
  const stop = await move(client, 'continue', { threadId });
  assert.equal(stop.reason, 'exception');
  assert.match(stop.text, /null/i);
  const stack = await frames(client, stop.threadId);
  assert.equal(stack[0].line, lineOf('traps'));
  assert.equal(stack[1].line, lineOf('call'));
  const info = await client.exceptionInfoRequest({ threadId: stop.threadId });
  assert.match(info.body.description, /0x00000000/);
  assert.equal(info.body.breakMode, 'always');
  const back = await move(client, 'reverseContinue', { threadId });
  assert.equal(back.reason, 'breakpoint');
  assert.equal((await frames(client, threadId))[0].line, lineOf('begin'));
  await assert.rejects(client.exceptionInfoRequest({ threadId }), /trap/);
});

session('a trap ends the run with status 1', async (client) => {
  const { threadId } = await runTo(client, ['begin']);
  await move(client, 'continue', { threadId });
  const exited = client.waitForEvent('exited');
  await client.continueRequest({ threadId });
  assert.equal((await exited).body.exitCode, 1);
});
