// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Stacks, scopes, variables and expressions.

'use strict';

const {
  assert, frames, lineOf, move, path, runTo, scope, session, source, variables,
} = require('./session.js');

session('a stack has its frames with names and lines', async (client) => {
  const stop = await runTo(client, ['in the loop']);
  assert.equal(stop.reason, 'breakpoint');
  const stack = await frames(client, stop.threadId);
  assert.match(stack[0].name, /sum/);
  assert.equal(stack[0].line, lineOf('in the loop'));
  assert.equal(stack[0].source.path, source);
  assert.equal(stack[0].source.name, path.basename(source));
  assert.match(stack[1].name, /main/);
  assert.equal(stack[1].line, lineOf('call'));
  assert.match(stack[0].instructionPointerReference, /^0x[0-9a-f]{8}$/);

  const part = await client.stackTraceRequest(
    { threadId: stop.threadId, startFrame: 1, levels: 1 });
  assert.deepEqual(part.body.stackFrames, [stack[1]]);
  assert.equal(part.body.totalFrames, stack.length);
});

session('scopes have arguments, locals, globals and registers',
  async (client) => {
    const stop = await runTo(client, ['in the loop']);
    const [sum, main] = await frames(client, stop.threadId);
    const args = await scope(client, sum.id, 'Arguments');
    assert.deepEqual([...args.keys()], ['Values', 'Count']);
    assert.equal(args.get('Count').value, '4');
    assert.equal(args.get('Count').type, 'int');
    const locals = await scope(client, sum.id, 'Locals');
    assert.equal(locals.get('Total').value, '0');
    const callers = await scope(client, main.id, 'Locals');
    assert.ok(callers.has('Numbers') && callers.has('Alias'));
    const globals = await scope(client, sum.id, 'Globals');
    assert.equal(globals.get('Scratch').value, '11');
    const registers = await scope(client, sum.id, 'Registers');
    assert.equal(registers.get('pc').value, sum.instructionPointerReference);
    assert.match(registers.get('r0').value, /^0x00000000/);
    const floats = await variables(
      client, registers.get('floats').variablesReference);
    assert.equal(floats.size, 32);
  });

session('structures, pointers, references and arrays unfold',
  async (client) => {
    const stop = await runTo(client, ['call']);
    const [main] = await frames(client, stop.threadId);
    const locals = await scope(client, main.id, 'Locals');
    const local = await variables(
      client, locals.get('Local').variablesReference);
    assert.equal(local.get('Tint').value, 'Color::Green');
    assert.equal(local.get('Flags').value, '5');
    assert.match(local.get('Name').value, /"root"/);
    const next = await variables(client, local.get('Next').variablesReference);
    const base = await variables(client, next.get('Base').variablesReference);
    assert.equal(base.get('Id').value, '42');
    const alias = await variables(
      client, locals.get('Alias').variablesReference);
    assert.deepEqual([...alias.keys()], [...local.keys()]);

    const numbers = locals.get('Numbers');
    assert.equal(numbers.indexedVariables, 4);
    const middle = await variables(client, numbers.variablesReference,
      { filter: 'indexed', start: 1, count: 2 });
    assert.deepEqual([...middle].map(([name, each]) => [name, each.value]),
      [['[1]', '2'], ['[2]', '3']]);
    const none = await variables(
      client, numbers.variablesReference, { filter: 'named' });
    assert.equal(none.size, 0);
  });

session('expressions of rows give the rows again', async (client) => {
  const stop = await runTo(client, ['call']);
  const [main] = await frames(client, stop.threadId);
  let compared = 0;
  async function compare(rows, depth) {
    for (const row of rows.values()) {
      if (!row.evaluateName)
        continue;
      const answer = await client.evaluateRequest(
        { expression: row.evaluateName, frameId: main.id, context: 'watch' });
      assert.equal(answer.body.result, row.value, row.evaluateName);
      ++compared;
      if (depth > 0 && row.variablesReference)
        await compare(
          await variables(client, row.variablesReference,
            row.indexedVariables > 3 ? { start: 0, count: 3 } : {}),
          depth - 1);
    }
  }
  await compare(await scope(client, main.id, 'Locals'), 3);
  assert.ok(compared > 20, `${compared}`);
  const registers = await scope(client, main.id, 'Registers');
  for (const name of ['r29', 'r31']) {
    const answer = await client.evaluateRequest(
      { expression: `(unsigned) $${name}`, frameId: main.id, context: 'watch' });
    assert.equal(
      Number(answer.body.result), Number(registers.get(name).value.split(' ')[0]));
  }
});

session('values can be changed', async (client) => {
  const stop = await runTo(client, ['call']);
  const [main] = await frames(client, stop.threadId);
  const scopes = await client.scopesRequest({ frameId: main.id });
  const locals = scopes.body.scopes.find((each) => each.name === 'Locals');
  const rows = await variables(client, locals.variablesReference);
  const numbers = rows.get('Numbers').variablesReference;
  const answer = await client.setVariableRequest(
    { variablesReference: numbers, name: '[3]', value: 'Numbers[2] * 100' });
  assert.equal(answer.body.value, '300');
  const set = await client.send('setExpression',
    { expression: 'Numbers[0]', value: '1000', frameId: main.id });
  assert.equal(set.body.value, '1000');
  const after = await move(client, 'next', { threadId: stop.threadId });
  assert.equal(after.reason, 'step');
  const [frame] = await frames(client, stop.threadId);
  const result = await client.evaluateRequest(
    { expression: 'Result', frameId: frame.id, context: 'hover' });
  assert.equal(result.body.result, '1305');
});

session('wrong requests say what is wrong', async (client) => {
  const stop = await runTo(client, ['call']);
  const [main] = await frames(client, stop.threadId);
  const evaluate = (expression) =>
    client.evaluateRequest({ expression, frameId: main.id, context: 'watch' });
  await assert.rejects(evaluate('Nothing'), /Nothing/);
  await assert.rejects(evaluate('1 +'), /syntax error/);
  await assert.rejects(
    client.variablesRequest({ variablesReference: 9999 }), /no variables 9999/);
  await assert.rejects(client.scopesRequest({ frameId: 9999 }),
    /no frame 9999/);
  await assert.rejects(client.stackTraceRequest({ threadId: 99 }), /thread/);
  await assert.rejects(client.send('stackTrace', { threadId: 'one' }),
    /expected integer at arguments.threadId/);
  await assert.rejects(client.send('unheard', {}), /notSupported/);
});
