// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Starts `tpdbg --dap` for launch configurations of the type "tp".

'use strict';

const vscode = require('vscode');

const factory = {
  createDebugAdapterDescriptor(session) {
    const settings = vscode.workspace.getConfiguration('tp');
    const command = settings.get('debuggerPath', 'tpdbg');
    const folder = session.workspaceFolder?.uri.fsPath;
    const options = folder ? { cwd: folder } : {};
    return new vscode.DebugAdapterExecutable(command, ['--dap'], options);
  },
};

function activate(context) {
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory('tp', factory));
}

module.exports = { activate };
