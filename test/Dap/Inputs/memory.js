// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Memory and instructions.

'use strict';

const { execFileSync } = require('node:child_process');
const {
  assert, frames, lineOf, program, runTo, scope, session,
} = require('./session.js');

session('memory is read and written', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  const [main] = await frames(client, threadId);
  const locals = await scope(client, main.id, 'Locals');
  const { memoryReference } = locals.get('Numbers');
  assert.match(memoryReference, /^0x[0-9a-f]{8}@0$/);
  const read = (offset, count) =>
    client.send('readMemory', { memoryReference, offset, count });
  const words = Buffer.from((await read(4, 8)).body.data, 'base64');
  assert.deepEqual([words.readInt32LE(0), words.readInt32LE(4)], [2, 3]);

  const data = Buffer.alloc(4);
  data.writeInt32LE(-5);
  await client.send('writeMemory',
    { memoryReference, offset: 8, data: data.toString('base64') });
  const value = await client.evaluateRequest(
    { expression: 'Numbers[2]', frameId: main.id, context: 'watch' });
  assert.equal(value.body.result, '-5');
});

session('what is no memory is said to be none', async (client) => {
  await runTo(client, ['call']);
  const low = await client.send('readMemory',
    { memoryReference: '0x00000010', count: 16 });
  assert.equal(low.body.data ?? '', '');
  assert.equal(low.body.unreadableBytes, 16);
  await assert.rejects(client.send('readMemory',
    { memoryReference: 'here', count: 1 }), /'here' is no address/);
  await assert.rejects(client.send('writeMemory',
    { memoryReference: '0x00000010', data: 'AAAA' }), /0x00000010/);
});

session('disassembly is that of tp-objdump', async (client) => {
  const { threadId } = await runTo(client, ['in the loop']);
  const [frame] = await frames(client, threadId);
  const answer = await client.disassembleRequest({
    memoryReference: frame.instructionPointerReference,
    instructionOffset: -20,
    instructionCount: 40,
  });
  const { instructions } = answer.body;
  assert.equal(instructions.length, 40);
  assert.equal(instructions[20].address, frame.instructionPointerReference);
  assert.ok(instructions[0].location);
  assert.equal(instructions[20].line, lineOf('in the loop'));

  const listing = execFileSync('tp-objdump', ['-d', program],
    { encoding: 'utf8', maxBuffer: 1 << 26 });
  const words = new Map();
  for (const line of listing.split('\n')) {
    const found = /^\s*([0-9a-f]+):\s+((?:[0-9a-f]{2} ){3}[0-9a-f]{2}|[0-9a-f]{8})\s+(\S+)/
      .exec(line);
    if (found)
      words.set(Number.parseInt(found[1], 16), found[3]);
  }
  let compared = 0;
  for (const each of instructions) {
    const mnemonic = words.get(Number(each.address));
    if (!mnemonic)
      continue;
    assert.equal(each.instruction.split(/\s/)[0], mnemonic);
    ++compared;
  }
  assert.equal(compared, 40);
});

session('before and behind the text there are no instructions',
  async (client) => {
    await runTo(client, ['call']);
    const answer = await client.disassembleRequest(
      { memoryReference: '0x00000000', instructionCount: 3 });
    assert.deepEqual(
      answer.body.instructions.map((each) => each.presentationHint),
      ['invalid', 'invalid', 'invalid']);
  });
