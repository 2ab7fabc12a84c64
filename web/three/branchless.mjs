// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Conditional expressions of shader text as calls of functions, which drivers make no branches of. In a loop
// SwiftShader walks over all ways through the branches that follow one another, so that 30 of them take for ever.

// Where a part of an expression begins: behind these, at its own depth.
const begins = /^(?:return|else|[=,;{}]|[-+*\/]=)$/;

// Names, numbers, operators and brackets, with the spaces before each.
function tokensOf(text) {
  return [...text.matchAll(/\s*(?:[\w.]+|&&|\|\||[<>=!+*\/-]=|->|<<|>>|.)/gs)].map(([token]) => token);
}

const plain = token => token.trim();

// Cuts tokens at those that `isCut` holds of, at depth 0.
function split(tokens, isCut) {
  const parts = [[]], cuts = [];
  let depth = 0;
  for (const token of tokens) {
    const t = plain(token);
    if ('([{'.includes(t) && t) ++depth;
    if (')]}'.includes(t) && t) --depth;
    if (depth === 0 && isCut(t) && !')]}'.includes(t)) {
      parts.push([]);
      cuts.push(token);
    } else {
      parts.at(-1).push(token);
    }
  }
  return {parts, cuts};
}

// `tokens` is one expression.
function expression(tokens) {
  const question = split(tokens, t => t === '?');
  if (question.cuts.length) {
    // c ? a : b, where a may hold others
    const [condition] = question.parts, rest = tokens.slice(condition.length + 1);
    let open = 1, depth = 0, at = 0;
    for (; at < rest.length; ++at) {
      const t = plain(rest[at]);
      if (t === '(' || t === '[') ++depth;
      if (t === ')' || t === ']') --depth;
      if (depth === 0 && t === '?') ++open;
      if (depth === 0 && t === ':' && --open === 0) break;
    }
    return call('openltc_choose', [condition, rest.slice(0, at), rest.slice(at + 1)]);
  }
  for (const [operator, name] of [['||', 'openltc_either'], ['&&', 'openltc_both']]) {
    const {parts} = split(tokens, t => t === operator);
    if (parts.length > 1)
      return parts.slice(1).reduce((left, part) => ` ${name}(${left}, ${argument(part)})`, argument(parts[0]));
  }
  // Brackets within.
  let out = '';
  for (let i = 0; i < tokens.length; ++i) {
    if (plain(tokens[i]) !== '(' && plain(tokens[i]) !== '[' || !tokens.slice(i).some(t => /^[)\]]$/.test(plain(t)))) {
      out += tokens[i];
      continue;
    }
    let depth = 0, end = i;
    do {
      const t = plain(tokens[end++]);
      if (t === '(' || t === '[') ++depth;
      if (t === ')' || t === ']') --depth;
    } while (depth > 0);
    out += tokens[i] + statement(tokens.slice(i + 1, end - 1)) + tokens[end - 1];
    i = end - 1;
  }
  return out;
}

// WGSL would take `f(a < b, c > d)` for a template.
function argument(tokens) {
  const text = expression(tokens).trim();
  return /[<>]/.test(text) ? `(${text})` : text;
}

function call(name, parts) { return ` ${name}(${parts.map(argument).join(', ')})`; }

// What may hold several expressions: arguments, statements, a body.
function statement(tokens) {
  const {parts, cuts} = split(tokens, t => begins.test(t));
  return parts.map((part, i) => expression(part) + (cuts[i] ?? '')).join('');
}

/// What they are in a language: [name, text] of definitions.
export const helpers = {
  'glsl-es': [
    ...['float', 'vec2', 'vec3', 'vec4'].map((type, i) => ['openltc_choose',
        `${type} openltc_choose(bool c, ${type} a, ${type} b) { return mix(b, a, ${i ? `bvec${i + 1}(c)` : 'c'}); }`]),
    ['openltc_choose', 'int openltc_choose(bool c, int a, int b) { return int(c) * a + int(!c) * b; }'],
    ['openltc_both', 'bool openltc_both(bool a, bool b) { return all(bvec2(a, b)); }'],
    ['openltc_either', 'bool openltc_either(bool a, bool b) { return any(bvec2(a, b)); }'],
  ],
  wgsl: [ // which has select
    ['openltc_both', 'fn openltc_both(a: bool, b: bool) -> bool { return a & b; }'],
    ['openltc_either', 'fn openltc_either(a: bool, b: bool) -> bool { return a | b; }'],
  ],
};

/// The text of a function, its `c ? a : b`, `a && b` and `a || b` as openltc_choose, openltc_both, openltc_either.
export function withoutBranches(text) {
  if (!/^(?!const|struct)[^{]*\{.*(\?|&&|\|\|)/s.test(text)) return text;
  const brace = text.indexOf('{');
  // Statements are no deeper than their braces: taken one level after the other.
  const body = part => part.replace(/[^{};]*[{};]/g, piece => statement(tokensOf(piece)));
  return text.slice(0, brace + 1) + body(text.slice(brace + 1));
}
