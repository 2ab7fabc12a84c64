// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// An instance of openltc.wasm with what it wants of a system, which is a clock and a place for its
// last words.

const k_badf = 8;

/// callbacks.brdf(x, y, z, wi, count, roughness, values, memory), callbacks.progress(share).
export function instantiate(compiled, callbacks) {
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
