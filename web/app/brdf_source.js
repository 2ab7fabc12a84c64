// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A BRDF that is written in the page: from text to a function, with the line of what goes wrong.

/// What the editor begins with.
export const example = `// GGX over a little Lambert, 1/steradian,
// without the cosine; z is the normal.
// wo: to the viewer, [x, y, z]
// wi: to the light, x y z of many
// f:  to be filled, one for each wi
function brdf(wo, wi, roughness, f) {
  const a2 = Math.max(roughness ** 4, 1e-8);
  const s = (c) =>
    Math.sqrt(c * c * (1 - a2) + a2);
  const so = s(wo[2]);
  for (let i = 0; i < f.length; ++i) {
    const y = wi[3 * i + 1];
    const z = wi[3 * i + 2];
    const hx = wo[0] + wi[3 * i];
    const hz = wo[2] + z;
    const t = hx * hx + y * y + hz * hz * a2;
    const h2 = hx * hx + y * y + hz * hz;
    const d = a2 * (h2 / t) ** 2 / Math.PI;
    const v = 0.5 / (z * so + wo[2] * s(z));
    f[i] = 0.85 * d * v + 0.15 / Math.PI;
  }
}
`;

/// An error with its place in the text, as far as that is known.
export class SourceError extends Error {
  constructor(message, line = 0, column = 0) {
    super(message);
    this.line = line;
    this.column = column;
  }
}

/// Where in the module at `url` an error was thrown: [line, column], or [0, 0].
export function placeOf(error, url) {
  const at = String(error?.stack ?? '').split(url + ':')[1]?.match(/^(\d+)(?::(\d+))?/);
  return at ? [Number(at[1]), Number(at[2] ?? 0)] : [0, 0];
}

/// The function `brdf` of the text; {evaluate, url}. Fails with a SourceError.
export async function compile(text) {
  // Behind the text, so that its lines are those of the editor.
  const url = URL.createObjectURL(new Blob([text, '\n;export default typeof brdf === "undefined" ? undefined : brdf;\n'],
                                           {type: 'text/javascript'}));
  let found;
  try {
    found = (await import(url)).default;
  } catch (error) {
    if (error instanceof SyntaxError) throw Object.assign(new SourceError(error.message), {syntax: true});
    throw new SourceError(`${error?.name ?? 'Error'}: ${error?.message ?? error}`, ...placeOf(error, url));
  }
  if (typeof found !== 'function') throw new SourceError('there is no function brdf(wo, wi, roughness, f)');
  return {evaluate: found, url};
}

/// The place of a syntax error, which only a script of its own tells: [line, column], or [0, 0]. In a page.
export function findSyntaxError(text) {
  return new Promise((done) => {
    const url = URL.createObjectURL(new Blob(['"use strict";', text, '\npostMessage(0);'], {type: 'text/javascript'}));
    const worker = new Worker(url);
    const finish = (line, column) => {
      clearTimeout(timer);
      worker.terminate();
      URL.revokeObjectURL(url);
      done([line, line === 1 ? Math.max(1, column - 13) : column]);
    };
    const timer = setTimeout(() => finish(0, 0), 5000);
    worker.onmessage = () => finish(0, 0);
    worker.onerror = (event) => {
      event.preventDefault();
      finish(event.lineno ?? 0, event.colno ?? 0);
    };
  });
}
