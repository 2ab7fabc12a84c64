// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The whole state as the part of an address behind #, which no server sees.

const k_version = 1;

/// What a link carries: JSON in base64 for addresses.
export function toLink(state) {
  const bytes = new TextEncoder().encode(JSON.stringify({version: k_version, ...state}));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return '#' + btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/// The members of a link that are as they should be, checked one by one; null if it is no link of ours.
export function fromLink(hash, choices) {
  if (hash.length < 2) return null;
  let given;
  try {
    const text = atob(hash.slice(1).replaceAll('-', '+').replaceAll('_', '/'));
    given = JSON.parse(new TextDecoder('utf-8', {fatal: true}).decode(Uint8Array.from(text, (c) => c.charCodeAt(0))));
  } catch {
    return null;
  }
  if (given?.version !== k_version) return null;
  const state = {};
  const take = (name, good) => {
    if (name in given && good(given[name])) state[name] = given[name];
  };
  const number = (least, most) => (x) => typeof x === 'number' && x >= least && x <= most;
  const among = (list) => (x) => list.includes(x);
  const numbers = (count, most) => (x) => Array.isArray(x) && x.length === count && x.every(number(-most, most));
  take('brdf', among(choices.brdfs));
  take('text', (x) => typeof x === 'string' && x.length < 1e5);
  take('width', among(['alpha', 'one']));
  take('form', among(choices.forms));
  take('size', among(choices.sizes));
  take('objective', among(choices.objectives));
  take('roughness', number(0, 1));
  take('thetaDegrees', number(0, 89));
  take('exposure', number(0.1, 20));
  take('light', (x) => x !== null && typeof x === 'object' && numbers(3, 20)(x.center) && number(-180, 180)(x.turn) &&
      number(-85, 85)(x.tilt) && Array.isArray(x.outline) && x.outline.length >= 3 && x.outline.length <= 16 &&
      x.outline.every(numbers(2, 20)));
  return state;
}
