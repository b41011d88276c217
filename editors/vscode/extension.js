// Starts `plm lsp` for declarations, and for Rust files that may hold some.
'use strict';

const { workspace } = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');

let client;

/** Languages that are served, by the settings. */
function selector(settings) {
  const languages = settings.get('rust') ? ['plm', 'rust'] : ['plm'];
  return languages.flatMap((language) => ['file', 'untitled'].map((scheme) => ({ scheme, language })));
}

/** Called by the editor when the first such file is opened. */
async function activate() {
  const settings = workspace.getConfiguration('plm');
  const server = { command: settings.get('command'), args: ['lsp'] };
  client = new LanguageClient('plm', 'plm', server, { documentSelector: selector(settings) });
  // Without the program there are colours alone; the client says what is missing.
  await client.start();
}

/** Called by the editor when it ends. */
function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
