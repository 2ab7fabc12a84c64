// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Pictures of numbers on canvases: the map of errors, and lobes seen from above.

const k_decades = 3; // of a lobe's density, as in `openltc plot fit`

const clamp01 = (t) => Math.min(Math.max(t, 0), 1);

// The colour at t, 0 to 1, of a map of 256 colours, into bytes at `at`.
function put(bytes, at, map, t) {
  const i = 3 * Math.round(255 * clamp01(t));
  for (let c = 0; c < 3; ++c) bytes[at + c] = Math.round(255 * map[i + c]);
  bytes[at + 3] = 255;
}

function draw(canvas, width, height, colour) {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', {willReadFrequently: true}), image = context.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) colour(i, image.data, 4 * i);
  context.putImageData(image, 0, 0);
}

/// Total variation over roughness, to the right, and view angle, upwards; `most` is the brightest.
export function drawErrorMap(canvas, map, most, colours) {
  const columns = map.roughness.length, rows = map.thetaDegrees.length;
  draw(canvas, columns, rows, (i, bytes, at) => {
    const row = rows - 1 - Math.floor(i / columns);
    put(bytes, at, colours.magma, map.tv[row * columns + i % columns] / most);
  });
}

/// A density over the disc of directions, logarithmic; what lies below the horizon stays clear.
export function drawLobe(canvas, cell, values, colours) {
  draw(canvas, cell.side, cell.side, (i, bytes, at) => {
    if (values[i] < 0) return;
    put(bytes, at, colours.viridis, 1 + Math.log10(Math.max(values[i], 1e-30) / cell.brightest) / k_decades);
  });
}

/// Lobe less BRDF, in shares of the BRDF's greatest density.
export function drawDifference(canvas, cell, colours) {
  draw(canvas, cell.side, cell.side, (i, bytes, at) => {
    if (cell.brdf[i] < 0) return;
    const d = (cell.lobe[i] - cell.brdf[i]) / cell.brightest;
    put(bytes, at, colours.blueRed, 0.5 + 0.5 * Math.sign(d) * Math.sqrt(Math.min(Math.abs(d), 1)));
  });
}

/// A strip of a map's colours, from left to right.
export function drawStrip(canvas, map) {
  draw(canvas, 256, 1, (i, bytes, at) => put(bytes, at, map, i / 255));
}

/// The worst cells of a map, each the worst of its surroundings: [{roughness, thetaDegrees, tv}].
export function worstCells(map, count) {
  const columns = map.roughness.length, rows = map.thetaDegrees.length, k_near = 5;
  const order = [...map.tv.keys()].sort((a, b) => map.tv[b] - map.tv[a]);
  const found = [];
  for (const i of order) {
    const column = i % columns, row = Math.floor(i / columns);
    if (found.some((f) => Math.abs(f.column - column) < k_near && Math.abs(f.row - row) < k_near)) continue;
    found.push({column, row, roughness: map.roughness[column], thetaDegrees: map.thetaDegrees[row], tv: map.tv[i]});
    if (found.length === Math.min(count, columns * rows)) break;
  }
  return found;
}

/// The cell of a map that is next to a place.
export function cellNear(map, roughness, thetaDegrees) {
  const nearest = (axis, value) => axis.reduce((best, x, i) => Math.abs(x - value) < Math.abs(axis[best] - value) ? i : best, 0);
  return {column: nearest(map.roughness, roughness), row: nearest(map.thetaDegrees, thetaDegrees)};
}
