// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   node naga_wgsl.mjs NAGA_WASM_DIR IN.spv OUT.wgsl
//
// Translates SPIR-V to WGSL with naga, then reads the WGSL back and validates it again, so that
// what is written is known to be a shader and not only text.

import {readFileSync, writeFileSync} from "node:fs";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";

const [package_dir, spirv_path, wgsl_path] = process.argv.slice(2);
const {parseSpirv, parseWgsl, validate, writeWgsl} =
    await import(pathToFileURL(resolve(package_dir, "dist/node.js")).href);

function stop(step, error) {
  console.error(`naga: ${step}: ${error.formatted ?? error.message ?? error}`);
  process.exit(1);
}

function attempt(step, action) {
  try {
    return action();
  } catch (error) {
    return stop(step, error);
  }
}

const module = attempt("reading SPIR-V", () => parseSpirv(new Uint8Array(readFileSync(spirv_path))));
const info = attempt("validating SPIR-V", () => validate(module));
const wgsl = attempt("writing WGSL", () => writeWgsl(module, info));
const again = attempt("reading its WGSL back", () => parseWgsl(wgsl));
attempt("validating its WGSL", () => validate(again));
writeFileSync(wgsl_path, wgsl);
