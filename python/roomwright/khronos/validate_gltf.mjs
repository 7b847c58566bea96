#!/usr/bin/env node
// Runs the Khronos glTF validator over files and prints one JSON line per file:
//   {"file": ..., "errors": n, "warnings": n, "infos": n, "hints": n, "messages": [...]}
// in the order of the arguments. Files named on standard input, one a line, follow those of the command line
// if the last argument is "-". Exit 0 if no file has an error or a warning, 1 if one has, 2 on a bad call.
import { readFile } from 'node:fs/promises';
import { dirname, extname, resolve } from 'node:path';
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

const SEVERITIES = ['error', 'warning', 'info', 'hint'];
// Enough to see what is wrong; the counts are complete.
const MESSAGES_PER_FILE = 20;

function filesToValidate() {
  const files = process.argv.slice(2);
  if (files.at(-1) !== '-') return files;
  const listed = readFileSync(0, 'utf8').split('\n').filter((line) => line !== '');
  return [...files.slice(0, -1), ...listed];
}

async function validate(file) {
  const folder = dirname(resolve(file));
  const bytes = new Uint8Array(await readFile(file));
  return validator.validateBytes(bytes, {
    uri: file,
    format: extname(file).toLowerCase() === '.glb' ? 'glb' : 'gltf',
    maxIssues: 0,
    writeTimestamp: false,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(resolve(folder, decodeURIComponent(uri)))),
  });
}

async function report(file) {
  try {
    const { issues } = await validate(file);
    const messages = issues.messages.toSorted((a, b) => a.severity - b.severity).slice(0, MESSAGES_PER_FILE);
    return {
      file,
      errors: issues.numErrors,
      warnings: issues.numWarnings,
      infos: issues.numInfos,
      hints: issues.numHints,
      messages: messages.map(({ code, message, severity, pointer = '' }) => (
        { severity: SEVERITIES[severity], code, pointer, message }
      )),
    };
  } catch (error) {
    // Unreadable, or no glTF at all: the validator rejects instead of reporting.
    const messages = [{ severity: 'error', code: 'NOT_GLTF', pointer: '', message: String(error) }];
    return { file, errors: 1, warnings: 0, infos: 0, hints: 0, messages };
  }
}

const files = filesToValidate();
if (files.length === 0) {
  process.stderr.write('usage: validate_gltf.mjs FILE... [-]\n');
  process.exit(2);
}
for (const file of files) {
  const result = await report(file);
  process.stdout.write(`${JSON.stringify(result)}\n`);
  if (result.errors + result.warnings > 0) process.exitCode = 1;
}
