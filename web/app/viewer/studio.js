// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Three soft boxes for a scene without lights: those of openltc/scene/view/studio.cpp, where the formula stands.

import {Vector3} from 'three';
import {RectLight} from 'openltc-three';

// Azimuth from the camera's side, to the right, and elevation, in degrees; distance and half sides in radii of the
// scene; share of the key's illuminance.
const softBoxes = [['studio key', -45, 40, 2.6, 1.1, 1.1, 1.0], ['studio fill', 60, 15, 3.0, 1.4, 1.4, 0.3],
                   ['studio rim', 160, 50, 2.6, 1.2, 0.5, 0.8]];

// Irradiance of a rectangle with these half sides that faces a point at this distance, of radiance 1.
function irradiance(a, b, d) {
  const da = Math.hypot(d, a), db = Math.hypot(d, b);
  return 2 * (a / da * Math.atan(b / da) + b / db * Math.atan(a / db));
}

/// Their lights around `bounds`, a Box3, as seen along `forward`; a white card in the middle has 1 nit by the key.
export function studioLights(bounds, forward) {
  const center = bounds.getCenter(new Vector3()), radius = bounds.getSize(new Vector3()).length() / 2 || 0.5;
  const up = new Vector3(0, 1, 0), front = forward.clone().negate().setY(0);
  if (front.length() < 1e-3) front.set(0, 0, 1);
  front.normalize();
  const side = new Vector3().crossVectors(up, front), radians = degrees => degrees * Math.PI / 180;
  return softBoxes.map(([name, azimuth, elevation, distance, a, b, share]) => {
    const light = new RectLight(0xffffff, share * Math.PI / irradiance(a, b, distance), 2 * a * radius, 2 * b * radius);
    const [turn, rise] = [radians(azimuth), radians(elevation)];
    const towards = front.clone().multiplyScalar(Math.cos(turn) * Math.cos(rise))
        .addScaledVector(side, Math.sin(turn) * Math.cos(rise)).addScaledVector(up, Math.sin(rise));
    light.name = name;
    light.position.copy(center).addScaledVector(towards, distance * radius);
    light.lookAt(center);
    return light;
  });
}
