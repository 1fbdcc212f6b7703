// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Optimized code.

'use strict';

const {
  assert, frames, lineOf, move, runTo, scope, session,
} = require('./session.js');

session('inlined functions are frames', async (client) => {
  const { threadId } = await runTo(client, ['in inner']);
  const stack = await frames(client, threadId);
  assert.deepEqual(
    stack.slice(0, 4).map((frame) => [frame.name.replace(/\(.*?\)/, ''),
      frame.line]),
    [['inner [inlined]', lineOf('in inner')],
      ['middle [inlined]', lineOf('calls inner')],
      ['outer', lineOf('calls middle')],
      ['main', lineOf('calls outer')]]);
  assert.equal(new Set(
    stack.slice(0, 3).map((frame) => frame.instructionPointerReference)).size, 1);
  const inner = await scope(client, stack[0].id, 'Arguments');
  assert.equal(inner.get('A').value, '6');
  const middle = await scope(client, stack[1].id, 'Arguments');
  assert.equal(middle.get('B').value, '5');
});

session('one steps out of inlined functions', async (client) => {
  const { threadId } = await runTo(client, ['in inner']);
  await move(client, 'stepOut', { threadId });
  const [frame] = await frames(client, threadId);
  assert.match(frame.name, /^(middle|outer)/);
});
