// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// From initialize to disconnect, and what can go wrong on the way.

'use strict';

const { spawn } = require('node:child_process');
const fs = require('node:fs');
const { DebugClient } = require('@vscode/debugadapter-testsupport');
const {
  assert, configuration, frames, lineOf, move, output, program, runTo, session,
  source, test,
} = require('./session.js');

session('a run without breakpoints ends', async (client) => {
  const exited = client.waitForEvent('exited');
  await Promise.all([
    client.configurationSequence(),
    client.launch(configuration()),
    client.waitForEvent('terminated'),
    client.assertOutput('stdout', 'sum 10\n'),
  ]);
  assert.equal((await exited).body.exitCode, 0);
});

session('stopOnEntry stops before the first instruction', async (client) => {
  const stop = await runTo(client, ['call'], { stopOnEntry: true });
  assert.equal(stop.reason, 'entry');
  assert.equal(stop.allThreadsStopped, true);
  const hit = await move(client, 'continue', { threadId: stop.threadId });
  assert.equal(hit.reason, 'breakpoint');
});

session('noDebug runs past breakpoints', async (client) => {
  const stopped = [];
  client.on('stopped', (event) => stopped.push(event));
  await Promise.all([
    client.waitForEvent('terminated'),
    client.waitForEvent('initialized').then(async () => {
      await client.setBreakpointsRequest(
        { source: { path: source }, breakpoints: [{ line: lineOf('call') }] });
      await client.configurationDoneRequest();
    }),
    client.launch(configuration({ noDebug: true })),
  ]);
  assert.equal(stopped.length, 0);
});

session('after the end time can run back', async (client) => {
  const { threadId } = await runTo(client, ['call'], { stopAtEnd: true });
  const end = await move(client, 'continue', { threadId });
  assert.equal(end.reason, 'exit');
  const back = await move(client, 'reverseContinue', { threadId });
  assert.equal(back.reason, 'breakpoint');
});

session('restart begins again', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  const first = (await frames(client, threadId))[0];
  const again = await move(client, 'restart', {});
  assert.equal(again.reason, 'breakpoint');
  const second = (await frames(client, again.threadId))[0];
  assert.equal(second.instructionPointerReference,
    first.instructionPointerReference);
});

session('terminate ends the session', async (client) => {
  await runTo(client, ['call']);
  await Promise.all([
    client.waitForEvent('terminated'),
    client.terminateRequest(),
  ]);
});

session('a launch that cannot be done says why', async (client) => {
  await client.initializeRequest();
  await assert.rejects(client.launchRequest({}), /'program' is missing/);
  await assert.rejects(client.launchRequest(configuration({ chip: 'none' })),
    /none/);
  await assert.rejects(
    client.launchRequest(configuration({ program: '/nowhere/a.elf' })),
    /nowhere/);
  await assert.rejects(client.launchRequest(configuration({ hostThreds: 3 })),
    /host-threds/);
  await assert.rejects(client.attachRequest({}), /launch/);
  await assert.rejects(client.threadsRequest(), /notLaunched/);
});

session('console commands are those of tpdbg', async (client) => {
  const { threadId } = await runTo(client, ['call']);
  const [frame] = await frames(client, threadId);
  const type = (expression) =>
    client.evaluateRequest({ expression, frameId: frame.id, context: 'repl' });
  assert.match((await type('bt')).body.result, /main/);
  assert.match((await type('print Numbers[1] + 40')).body.result, /42/);
  await assert.rejects(type('frobnicate'), /frobnicate/);
  const offered = await client.completionsRequest({ text: 'brea', column: 5 });
  assert.ok(offered.body.targets.some((each) => each.label === 'break'));
  const stop = client.waitForEvent('stopped');
  await type('next');
  await stop;
  const [after] = await frames(client, threadId);
  assert.equal(after.line, lineOf('after the call'));
});

test('clients can come by a port, one after the other', async () => {
  const server = spawn('tpdbg', ['--dap', '--port', '0']);
  try {
    const port = await new Promise((resolve) => {
      let text = '';
      server.stderr.on('data', (data) => {
        text += data;
        const found = /127\.0\.0\.1:(\d+)\n/.exec(text);
        if (found)
          resolve(Number(found[1]));
      });
    });
    for (let i = 0; i < 2; ++i) {
      const client = new DebugClient('', '', 'tp');
      await client.start(port);
      await client.hitBreakpoint(
        configuration(), { path: source, line: lineOf('call') });
      await client.stop();
    }
  } finally {
    server.kill();
  }
});

test('what is no message ends the session with a word', async () => {
  const adapter = spawn('tpdbg', ['--dap']);
  let text = '';
  adapter.stdout.on('data', (data) => { text += data; });
  adapter.stdin.end('GET / HTTP/1.1\r\n\r\n');
  const status = await new Promise((resolve) => adapter.on('exit', resolve));
  assert.equal(status, 0);
  assert.match(text, /header lacks 'Content-Length'/);
});

test('the capabilities are those that the protocol knows', async () => {
  const client = new DebugClient('tpdbg', '--dap', 'tp');
  await client.start();
  const { body } = await client.initializeRequest();
  await client.stop();
  const protocol = fs.readFileSync(
    require.resolve('@vscode/debugprotocol/lib/debugProtocol.d.ts'), 'utf8');
  const capabilities = /interface Capabilities \{([^]*?)\n\t\}/
    .exec(protocol)[1];
  for (const name of Object.keys(body))
    assert.match(capabilities, new RegExp(`\\b${name}\\?:`));
  assert.ok(Object.keys(body).length > 20);
});
