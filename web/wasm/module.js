// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What both modules share: how one is loaded, an instance with what it wants of a system, which is a clock and a
// place for its last words, and how a caller's mistakes are told.

const k_badf = 8;

/// What could not be done, in one line.
export class OpenltcError extends Error {
  constructor(message, options) {
    super(message, options);
    this.name = 'OpenltcError';
  }
}

// The member of an object, or an error that names it.
export function checked(object, name, type, otherwise) {
  const value = object[name];
  if (value === undefined) return otherwise;
  if (typeof value !== type || (type === 'number' && !Number.isFinite(value)))
    throw new OpenltcError(`${name} is ${describe(value)}; it is to be a ${type === 'number' ? 'finite number' : type}`);
  return value;
}

export function describe(value) {
  if (typeof value === 'string') return `the string ${JSON.stringify(value.slice(0, 40))}`;
  if (Array.isArray(value)) return `an array of ${value.length}`;
  if (ArrayBuffer.isView(value)) return `a ${value.constructor.name} of ${value.length}`;
  if (value === null || typeof value !== 'object') return String(value);
  return `an object (${value.constructor?.name ?? 'of no class'})`;
}

// A file, or an error that says what was given instead.
export function bytesOf(file, name) {
  const bytes = file instanceof ArrayBuffer ? new Uint8Array(file) : file;
  if (!(bytes instanceof Uint8Array))
    throw new OpenltcError(`${name} is ${describe(file)}; it is a Uint8Array or ArrayBuffer of a file`);
  return bytes;
}

/// A module from beside this file, or from `source`: its bytes, or what WebAssembly.compile made of them.
export async function compileModule(name, source) {
  const url = new URL(`./${name}`, import.meta.url);
  if (source instanceof WebAssembly.Module) return source;
  if (source !== undefined) return WebAssembly.compile(source);
  if (url.protocol === 'file:') {
    const {readFile} = await import('node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new OpenltcError(`${url}: ${response.status} ${response.statusText}`);
  // Not compileStreaming, which wants a media type that plain servers of files do not send.
  return WebAssembly.compile(await response.arrayBuffer());
}

/// An instance's exports and memory. For the fitter: callbacks.brdf(x, y, z, wi, count, roughness, values, memory),
/// callbacks.progress(share).
export function instantiate(compiled, callbacks = {}) {
  let memory, words = '';
  const view = () => new DataView(memory.buffer);
  const wasi = {
    fd_write(file, parts, count, written) {
      let size = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(parts + 8 * i, true), length = view().getUint32(parts + 8 * i + 4, true);
        words += new TextDecoder().decode(new Uint8Array(memory.buffer, at, length));
        size += length;
      }
      view().setUint32(written, size, true);
      return 0;
    },
    clock_time_get(clock, precision, at) {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    proc_exit(code) {
      throw new Error(words.trim() || `exit code ${code}`);
    },
  };
  const imports = {openltc: {
    brdf: (...numbers) => callbacks.brdf(...numbers, memory),
    progress: callbacks.progress,
  }};
  // Files, which nothing of it opens.
  for (const {module, name} of WebAssembly.Module.imports(compiled))
    if (module !== 'openltc') (imports[module] ??= {})[name] = wasi[name] ?? (() => k_badf);
  const {exports} = new WebAssembly.Instance(compiled, imports);
  memory = exports.memory;
  exports._initialize();
  return {exports, memory};
}
