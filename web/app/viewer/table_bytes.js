// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Smooth tables of 16-bit numbers in the order in which gzip makes least of them: each channel by itself, what a number
// has beyond the plane through its three neighbours, low bytes, then high bytes. A third of the plain bytes' size.

const k_channels = 4;

// Calls visit(i, left, above, between) with each number's place and its neighbours', -1 outside, row by row.
function forEach(count, side, visit) {
  const texels = side * side;
  for (let begin = 0; begin < count; begin += texels * k_channels)
    for (let channel = 0; channel < k_channels; ++channel)
      for (let t = 0; t < texels; ++t) {
        const i = begin + k_channels * t + channel, x = t % side > 0, y = t >= side;
        visit(i, x ? i - k_channels : -1, y ? i - k_channels * side : -1, x && y ? i - k_channels * (side + 1) : -1);
      }
}

const plane = (values, left, above, between) => (values[left] ?? 0) + (values[above] ?? 0) - (values[between] ?? 0);

/// The bytes of tables of `side` times `side` texels of four numbers, one after the other.
export function pack(values, side) {
  const bytes = new Uint8Array(2 * values.length);
  let k = 0;
  forEach(values.length, side, (i, ...near) => {
    const more = (values[i] - plane(values, ...near)) << 16 >> 16;
    const even = more << 1 ^ more >> 15; // small numbers of either sign have a high byte of 0
    bytes[k] = even;
    bytes[values.length + k++] = even >> 8;
  });
  return bytes;
}

/// The numbers of `pack`.
export function unpack(bytes, side) {
  const count = bytes.length / 2, values = new Uint16Array(count);
  let k = 0;
  forEach(count, side, (i, ...near) => {
    const even = bytes[k] | bytes[count + k++] << 8;
    values[i] = (even >> 1 ^ -(even & 1)) + plane(values, ...near);
  });
  return values;
}
