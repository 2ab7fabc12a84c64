// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// From where the picture of the laboratory is seen.

const k_distance = 4.2, k_target = [-0.45, 0.22, 0.42];
/// Half of the picture's height, or of its width where that is less than 4 / 3 of it, at a distance of 1.
export const k_field = 0.4;
const k_steepest = 2, k_flattest = 84; // degrees at which the camera stays

const sub = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

/// The camera that looks at the origin's surroundings from a view angle.
export function cameraAt(thetaDegrees) {
  const theta = Math.min(Math.max(thetaDegrees, k_steepest), k_flattest) * Math.PI / 180;
  const eye = [k_distance * Math.sin(theta), 0, k_distance * Math.cos(theta)];
  const forward = unit(sub(k_target, eye)), right = unit(cross(forward, [0, 0, 1])), up = cross(right, forward);
  return {eye, forward, right, up};
}

// Pixels from the middle for a slope of 1.
const scaleOf = (width, height) => Math.min(height, width * 0.75) / (2 * k_field);

/// The ray of a place in a picture of that size: [origin, direction].
export function rayIn(x, y, thetaDegrees, width, height) {
  const {eye, forward, right, up} = cameraAt(thetaDegrees), scale = scaleOf(width, height);
  const a = (x - width / 2) / scale, b = (height / 2 - y) / scale;
  return [eye, unit(forward.map((f, i) => f + a * right[i] + b * up[i]))];
}

/// Where a point is seen in a picture of that size; null behind the camera.
export function placeIn(point, thetaDegrees, width, height) {
  const {eye, forward, right, up} = cameraAt(thetaDegrees), scale = scaleOf(width, height);
  const to = sub(point, eye), dot = (v) => to.reduce((s, x, i) => s + x * v[i], 0);
  const depth = dot(forward);
  return depth < 0.1 ? null : [width / 2 + dot(right) / depth * scale, height / 2 - dot(up) / depth * scale];
}
