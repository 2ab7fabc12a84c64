// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   node validate.mjs NODE_MODULES FILE...
//
// Runs the Khronos glTF validator over files. Prints its errors and warnings, one line each, and how
// many it found; exit code 1 when there are errors.

import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {dirname, join, resolve} from "node:path";

const [modules, ...files] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "here.js"));
const validator = require("gltf-validator");

let errors = 0;
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    maxIssues: 0,
    externalResourceFunction: async (uri) =>
      new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  for (const message of report.issues.messages)
    if (message.severity <= 1)
      console.log(`${file}: ${message.pointer}: ${message.code}: ${message.message}`);
  console.log(`${file}: ${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
  errors += report.issues.numErrors;
}
process.exit(errors > 0 ? 1 : 0);
