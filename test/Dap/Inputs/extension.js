// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The extension for Visual Studio Code, without the editor.

'use strict';

const { execFileSync } = require('node:child_process');
const assert = require('node:assert/strict');
const fs = require('node:fs');
const Module = require('node:module');
const path = require('node:path');
const { test } = require('node:test');

const examples = path.resolve(process.argv[2]);
const extension = path.join(examples, 'vscode', 'tp-debug');
const manifest = JSON.parse(
  fs.readFileSync(path.join(extension, 'package.json'), 'utf8'));
const [debuggerEntry] = manifest.contributes.debuggers;
const attributes = debuggerEntry.configurationAttributes.launch.properties;

/** What is no option of the command line. */
const own = ['program', 'args', 'cwd', 'stopOnEntry', 'stopAtEnd', 'threadList',
  'sourceMap'];

test('the attributes are the options that concern what is run', () => {
  const help = execFileSync('tpdbg', ['--help'], { encoding: 'utf8' });
  const named = Object.keys(attributes)
    .filter((name) => !own.includes(name))
    .map((name) => name.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`));
  for (const name of named)
    assert.match(help, new RegExp(`--${name}\\b`));
  const foreign = ['help', 'version', 'batch', 'dap', 'port', 'eval-command',
    'command'];
  for (const [, name] of help.matchAll(/^\s*--([a-z-]+)/gm))
    assert.ok(foreign.includes(name) || named.includes(name), name);
});

test('the sample configurations use attributes of the extension', () => {
  const { configurations } = JSON.parse(fs.readFileSync(path.join(
    examples, 'sample-project', '.vscode', 'launch.json'), 'utf8'));
  assert.ok(configurations.length > 0);
  for (const configuration of configurations)
    for (const name of Object.keys(configuration))
      assert.ok(name in attributes ||
        ['name', 'type', 'request', 'preLaunchTask'].includes(name), name);
});

test('the extension starts tpdbg --dap', () => {
  let factory;
  const vscode = {
    DebugAdapterExecutable: class {
      constructor(command, args, options) {
        Object.assign(this, { command, args, options });
      }
    },
    debug: {
      registerDebugAdapterDescriptorFactory(type, given) {
        assert.equal(type, debuggerEntry.type);
        factory = given;
      },
    },
    workspace: {
      getConfiguration: () => ({ get: (name, otherwise) => otherwise }),
    },
  };
  const load = Module._load;
  Module._load = (name, ...rest) =>
    name === 'vscode' ? vscode : load(name, ...rest);
  const context = { subscriptions: [] };
  require(path.join(extension, manifest.main)).activate(context);
  Module._load = load;
  assert.equal(context.subscriptions.length, 1);
  const descriptor = factory.createDebugAdapterDescriptor(
    { workspaceFolder: { uri: { fsPath: '/folder' } } });
  assert.deepEqual([descriptor.command, descriptor.args, descriptor.options],
    ['tpdbg', ['--dap'], { cwd: '/folder' }]);
});
