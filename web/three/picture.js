// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A texture as a light's emission, filtered once so that shading needs few looks at it: what
// openltc/light/emission_stack.h says. Rows of it begin at the bottom.

import {ClampToEdgeWrapping, Color, DataTexture, DataUtils, HalfFloatType, LinearFilter, LinearMipmapLinearFilter,
        RGBAFormat, SRGBColorSpace} from 'three';

const leastSide = 32, mostSide = 512; // texels

// Red, green and blue of the texture's image, linear, its rows from the bottom.
function pixelsOf({image, flipY, colorSpace, name}) {
  const {width, height} = image ?? {}, pixels = new Float32Array(3 * width * height), color = new Color();
  if (!(width > 0 && height > 0)) throw new Error(`the picture "${name}" of a light is not there yet, or empty`);
  let {data} = image, bottomFirst = true;
  if (!data) { // an image of the browser, the same to flip or not
    const canvas = new OffscreenCanvas(width, height).getContext('2d');
    canvas.drawImage(image, 0, 0);
    data = canvas.getImageData(0, 0, width, height).data;
    bottomFirst = false;
  } else if (flipY) bottomFirst = false;
  const channels = data.length / (width * height), isByte = data instanceof Uint8Array || data instanceof Uint8ClampedArray;
  const linear = value => {
    const x = isByte ? value / 255 : data instanceof Uint16Array ? DataUtils.fromHalfFloat(value) : value;
    return Math.max(colorSpace === SRGBColorSpace ? color.setRGB(x, 0, 0, SRGBColorSpace).r : x, 0) || 0; // no NaN
  };
  const bytes = isByte ? Float32Array.from({length: 256}, (_, value) => linear(value)) : null;
  for (let y = 0, to = 0; y < height; ++y)
    for (let x = 0, from = channels * width * (bottomFirst ? y : height - 1 - y); x < width; ++x, from += channels)
      for (let c = 0; c < 3; ++c, ++to) {
        const value = data[from + Math.min(c, channels - 1)];
        pixels[to] = bytes ? bytes[value] : linear(value);
      }
  return {width, height, pixels};
}

// The mean of what falls together, for fewer pixels along an axis: `step` from one to the next, `lines` of them.
function reducedLines(from, count, step, lines, lineStep, fewer) {
  const to = new Float32Array(from.length / count * fewer), ratio = count / fewer;
  const toLine = step === 3 ? 3 * fewer : lineStep;
  for (let i = 0; i < fewer; ++i) {
    const low = i * ratio, high = low + ratio;
    for (let k = Math.floor(low); k < Math.min(Math.ceil(high), count); ++k) {
      const share = (Math.min(k + 1, high) - Math.max(k, low)) / ratio;
      for (let line = 0; line < lines; ++line)
        for (let c = 0; c < 3; ++c)
          to[line * toLine + i * step + c] += share * from[line * lineStep + k * step + c];
    }
  }
  return to;
}

function reduced({width, height, pixels}, columns, rows) {
  const narrow = reducedLines(pixels, width, 3, height, 3 * width, columns);
  return {width: columns, height: rows, pixels: reducedLines(narrow, height, 3 * columns, columns, 3, rows)};
}

// At a place in [0, 1], between the middles of pixels.
function bilinear({width, height, pixels}, u, v, channel) {
  const x = Math.min(Math.max(u * width - 0.5, 0), width - 1), y = Math.min(Math.max(v * height - 0.5, 0), height - 1);
  const x0 = Math.floor(x), y0 = Math.floor(y), x1 = Math.min(x0 + 1, width - 1), y1 = Math.min(y0 + 1, height - 1);
  const at = (column, row) => pixels[3 * (row * width + column) + channel], fx = x - x0, fy = y - y0;
  return (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) + (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

// Which share of each texel lies in the ellipse that fills the rectangle, by lines through it.
function coverOfEllipse(columns, rows) {
  const lines = 16, cover = new Float32Array(columns * rows);
  for (let y = 0; y < rows * lines; ++y) {
    const half = Math.sqrt(Math.max(1 - (2 * (y + 0.5) / (rows * lines) - 1) ** 2, 0)) / 2;
    const low = (0.5 - half) * columns, high = (0.5 + half) * columns, row = Math.floor(y / lines) * columns;
    for (let x = 0; x < columns; ++x)
      cover[row + x] += Math.max(Math.min(x + 1, high) - Math.max(x, low), 0) / lines;
  }
  return cover;
}

// Half of the texels along an axis, by 1 3 3 1: texels 2i - 1 to 2i + 2, those that there are.
function decimated({width, height, texels}, along) {
  const [count, step] = along === 'x' ? [width, 4] : [height, 4 * width];
  if (count === 1) return {width, height, texels};
  const size = along === 'x' ? {width: width / 2, height} : {width, height: height / 2};
  const result = new Float32Array(4 * size.width * size.height);
  for (let y = 0, to = 0; y < size.height; ++y)
    for (let x = 0; x < size.width; ++x) {
      const i = along === 'x' ? x : y, start = along === 'x' ? 4 * y * width : 4 * x;
      const before = 2 * i > 0 ? 1 : 0, after = 2 * i + 2 < count ? 1 : 0, scale = 1 / (6 + before + after);
      for (let c = 0, at = start + 2 * i * step; c < 4; ++c, ++at, ++to)
        result[to] = scale * (3 * (texels[at] + texels[at + step]) + (before ? texels[at - step] : 0) +
                              (after ? texels[at + 2 * step] : 0));
    }
  return {...size, texels: result};
}

function meanOf({texels}) {
  const sum = [0, 0, 0, 0];
  for (let i = 0; i < texels.length; ++i) sum[i % 4] += texels[i];
  return sum.map(x => 4 * x / texels.length);
}

function halves(texels) {
  const result = new Uint16Array(texels.length);
  for (let i = 0; i < texels.length; ++i) result[i] = DataUtils.toHalfFloat(Math.min(texels[i], 65504));
  return result;
}

const powerOfTwo = x => Math.min(Math.max(2 ** Math.ceil(Math.log2(x)), leastSide), mostSide);

function makePicture(texture, isRound) {
  let source = pixelsOf(texture);
  const width = powerOfTwo(source.width), height = powerOfTwo(source.height);
  if (source.width > width || source.height > height)
    source = reduced(source, Math.min(source.width, width), Math.min(source.height, height));
  const cover = isRound ? coverOfEllipse(width, height) : new Float32Array(width * height).fill(1);
  let level = {width, height, texels: new Float32Array(4 * width * height)};
  const isSame = source.width === width && source.height === height;
  for (let i = 0; i < cover.length; ++i) {
    const u = (i % width + 0.5) / width, v = (Math.floor(i / width) + 0.5) / height;
    for (let c = 0; c < 3; ++c)
      level.texels[4 * i + c] = cover[i] * (isSame ? source.pixels[3 * i + c] : bilinear(source, u, v, c));
    level.texels[4 * i + 3] = cover[i];
  }
  const mean = meanOf(level), mipmaps = [];
  for (;;) {
    const isLast = level.width === 1 && level.height === 1;
    if (isLast) level.texels = new Float32Array(mean);
    mipmaps.push({width: level.width, height: level.height,
                  data: halves(level.texels)});
    if (isLast) break;
    level = decimated(decimated(level, 'x'), 'y');
  }
  const result = new DataTexture(mipmaps[0].data, width, height, RGBAFormat, HalfFloatType);
  Object.assign(result, {mipmaps, magFilter: LinearFilter, minFilter: LinearMipmapLinearFilter, needsUpdate: true,
                         wrapS: ClampToEdgeWrapping, wrapT: ClampToEdgeWrapping});
  return {picture: result, mean: mean.slice(0, 3).map(x => x / mean[3])};
}

const made = new WeakMap(); // by texture, for a rectangle and for an ellipse, and of which version of it

/// The picture of a light, for its shader, and its mean over the light, white being 1. Made anew when the texture's
/// version changes. Throws an Error where the texture has no image.
export function pictureOf(texture, isRound) {
  if (!made.has(texture)) {
    made.set(texture, {});
    texture.addEventListener('dispose', () => {
      for (const one of Object.values(made.get(texture) ?? {})) one.picture.dispose();
      made.delete(texture);
    });
  }
  const kept = made.get(texture), key = isRound ? 'round' : 'whole';
  if (kept[key]?.version !== texture.version) {
    kept[key]?.picture.dispose();
    kept[key] = {...makePicture(texture, isRound), version: texture.version};
  }
  return kept[key];
}
