// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   node naga_check.mjs NAGA_WASM_DIR FILE.wgsl...
//
// Reads and validates WGSL with naga. Exit code 1 names each file that it refuses, and why.

import {readFileSync} from "node:fs";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";

const [package_dir, ...paths] = process.argv.slice(2);
const {parseWgsl, validate} = await import(pathToFileURL(resolve(package_dir, "dist/node.js")).href);

for (const path of paths) {
  try {
    validate(parseWgsl(readFileSync(path, "utf8")));
  } catch (error) {
    console.error(`${path}: ${error.formatted ?? error.message ?? error}`);
    process.exitCode = 1;
  }
}
