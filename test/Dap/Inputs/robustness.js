// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Whatever a client sends, it gets an answer and the session goes on.

'use strict';

const { assert, frames, runTo, session } = require('./session.js');

const commands = [
  'attach', 'breakpointLocations', 'cancel', 'completions', 'dataBreakpointInfo',
  'disassemble', 'evaluate', 'exceptionInfo', 'goto', 'gotoTargets', 'launch',
  'loadedSources', 'modules', 'pause', 'readMemory', 'scopes',
  'setBreakpoints', 'setDataBreakpoints', 'setExceptionBreakpoints',
  'setExpression', 'setFunctionBreakpoints', 'setInstructionBreakpoints',
  'setVariable', 'source', 'stackTrace', 'threads', 'variables', 'writeMemory',
];

const numbers = [0, 1, -1, 2 ** 31, 2 ** 32, -(2 ** 33), 2 ** 53, 1.5];
const texts = ['', '0', '0xffffffff', '0x00010000@0', '0x10@99999', '(((((', '{',
  'Tree', '*(int *)0', 'Tree[-1]', 'main', ':::', '$', '\u{1f600}', '\0'];
const wrong = [null, true, [], {}, [null], 'x'];

/** Arguments with one value for all numbers and one for all texts. */
function filled(number, text) {
  const breakpoint = {
    line: number, name: text, instructionReference: text, offset: number,
    dataId: text, accessType: text, condition: text, hitCondition: text,
    logMessage: text,
  };
  return {
    threadId: number, frameId: number, variablesReference: number,
    startFrame: number, levels: number, start: number, count: number,
    line: number, endLine: number, column: number, targetId: number,
    offset: number, instructionOffset: number,
    instructionCount: Math.min(number, 100), sourceReference: number,
    bytes: number, name: text, value: text, text, expression: text,
    context: 'watch', filter: text, memoryReference: text, data: text,
    granularity: text, filters: [text], breakpoints: [breakpoint],
    source: { path: text },
  };
}

session('requests that make no sense', async (client) => {
  const { threadId } = await runTo(client, ['in the loop']);
  const ask = (command, args) => client.send(command, args).catch((error) => {
    assert.notEqual(error.message, '');
  });
  for (const command of commands) {
    const waiting = [ask(command, undefined)];
    for (const number of numbers)
      waiting.push(ask(command, filled(number, texts[0])));
    for (const text of texts)
      waiting.push(ask(command, filled(1, text)));
    for (const value of wrong)
      waiting.push(ask(command, filled(value, value)));
    await Promise.all(waiting);
  }
  assert.ok((await frames(client, threadId)).length >= 2);
});
