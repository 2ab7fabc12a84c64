// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   node check_wgsl.mjs NAGA_WASM_DIR FILE.wgsl
//
// Parses and validates WGSL with naga.

import {readFileSync} from "node:fs";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";

const [package_dir, path] = process.argv.slice(2);
const {parseWgsl, validate} =
    await import(pathToFileURL(resolve(package_dir, "dist/node.js")).href);
try {
  validate(parseWgsl(readFileSync(path, "utf8")));
} catch (error) {
  console.error(`${path}: ${error.formatted ?? error.message ?? error}`);
  process.exit(1);
}
