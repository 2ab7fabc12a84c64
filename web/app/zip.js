// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Several files as one: a ZIP archive without compression (PKWARE, APPNOTE.TXT 6.3.10, sections 4.3.7 and 4.3.12).

const k_table = Uint32Array.from({length: 256}, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

const crc32 = (bytes) => ~bytes.reduce((crc, byte) => k_table[(crc ^ byte) & 255] ^ (crc >>> 8), ~0) >>> 0;

const k_day = 0x21; // 1980-01-01: the archive does not say when it was made

/// The bytes of an archive of [{name, bytes}].
export function zip(files) {
  const parts = [], directory = [];
  let at = 0;
  for (const {name, bytes} of files) {
    const title = new TextEncoder().encode(name);
    const facts = [20, 0x800, 0, 0, k_day]; // version, names in UTF-8, stored, time, day
    const head = new DataView(new ArrayBuffer(30));
    head.setUint32(0, 0x04034b50, true);
    facts.forEach((x, i) => head.setUint16(4 + 2 * i, x, true));
    [crc32(bytes), bytes.length, bytes.length].forEach((x, i) => head.setUint32(14 + 4 * i, x, true));
    head.setUint16(26, title.length, true);
    const entry = new DataView(new ArrayBuffer(46));
    entry.setUint32(0, 0x02014b50, true);
    entry.setUint16(4, 20, true);
    new Uint8Array(entry.buffer).set(new Uint8Array(head.buffer, 4, 26), 6);
    entry.setUint32(42, at, true);
    parts.push(new Uint8Array(head.buffer), title, bytes);
    directory.push(new Uint8Array(entry.buffer), title);
    at += 30 + title.length + bytes.length;
  }
  const end = new DataView(new ArrayBuffer(22));
  end.setUint32(0, 0x06054b50, true);
  end.setUint16(8, files.length, true);
  end.setUint16(10, files.length, true);
  end.setUint32(12, directory.reduce((sum, part) => sum + part.length, 0), true);
  end.setUint32(16, at, true);
  return new Blob([...parts, ...directory, new Uint8Array(end.buffer)], {type: 'application/zip'});
}
