// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   node read_textures.mjs NODE_MODULES FILE...
//
// Reads .dds and .ktx2 files with the packages parse-dds and ktx-parse, which share no code with
// OpenLTC, and .js modules with Node itself. Prints a JSON array with what each file holds: width,
// height, channels, precision, values (of single precision), metadata.

import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {extname, join, resolve} from "node:path";
import {pathToFileURL} from "node:url";

const [modules, ...files] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "here.js"));

function floats(bytes, offset, count) {
  const view = new DataView(bytes.buffer, bytes.byteOffset + offset, 4 * count);
  return Array.from({length: count}, (_, i) => view.getFloat32(4 * i, true));
}

function readDds(bytes) {
  const parsed = require("parse-dds")(new Uint8Array(bytes).buffer);
  const [width, height] = parsed.shape;
  if (parsed.format !== "rgba32f" || parsed.images.length !== 1 || parsed.cubemap)
    throw new Error(`unexpected ${parsed.format}, ${parsed.images.length} images`);
  const {offset} = parsed.images[0];
  if (bytes.length !== offset + 16 * width * height)
    throw new Error(`${bytes.length} bytes, but the texels begin at ${offset}`);
  return {width, height, channels: 4, precision: "float32",
          values: floats(bytes, offset, 4 * width * height)};
}

// VkFormat: channels, bytes of a number.
const k_formats = {109: [4, 4], 97: [4, 2], 103: [2, 4], 83: [2, 2]};

async function readKtx2(bytes) {
  const {read} = await import(pathToFileURL(require.resolve("ktx-parse")).href);
  const file = read(new Uint8Array(bytes));
  const format = k_formats[file.vkFormat];
  if (!format) throw new Error(`VkFormat ${file.vkFormat}`);
  const [channels, size] = format;
  const {pixelWidth: width, pixelHeight: height} = file;
  const samples = file.dataFormatDescriptor[0].samples;
  const level = file.levels[0].levelData;
  const expect = (name, is, wanted) => {
    if (is !== wanted) throw new Error(`${name} is ${is}, not ${wanted}`);
  };
  expect("typeSize", file.typeSize, size);
  expect("levels", file.levels.length, 1);
  expect("faceCount", file.faceCount, 1);
  expect("pixelDepth", file.pixelDepth, 0);
  expect("samples", samples.length, channels);
  expect("bytesPlane0", file.dataFormatDescriptor[0].bytesPlane[0], channels * size);
  samples.forEach((sample, i) => {
    expect("bitOffset", sample.bitOffset, 8 * size * i);
    expect("bitLength", sample.bitLength, 8 * size - 1);
    expect("channelType", sample.channelType, (i === 3 ? 15 : i) | 0xc0);
  });
  expect("bytes of the level", level.byteLength, width * height * channels * size);
  expect("orientation", String(file.keyValue.KTXorientation).replace(/\0/g, ""), "rd");
  const metadata = {};
  for (const [key, value] of Object.entries(file.keyValue))
    metadata[key] = (typeof value === "string" ? value : new TextDecoder().decode(value))
        .replace(/\0+$/, "");
  return {width, height, channels, precision: size === 4 ? "float32" : "float16", metadata,
          values: size === 4 ? floats(level, 0, width * height * channels) : []};
}

async function readModule(path) {
  const module = await import(pathToFileURL(resolve(path)).href);
  const find = (ending) => Object.entries(module).find(([name]) => name.endsWith(ending))?.[1];
  const info = find("_info"), values = find("_1");
  if (!(values instanceof Float32Array)) throw new Error("no Float32Array");
  return {width: info.columns, height: info.rows,
          channels: values.length / info.columns / info.rows, precision: info.precision,
          values: Array.from(values), metadata: info};
}

const k_readers = {".dds": (path) => readDds(readFileSync(path)),
                   ".ktx2": (path) => readKtx2(readFileSync(path)), ".mjs": readModule};
const results = [];
for (const path of files) {
  try {
    results.push(await k_readers[extname(path)](path));
  } catch (error) {
    console.error(`${path}: ${error.message}`);
    process.exit(1);
  }
}
console.log(JSON.stringify(results));
