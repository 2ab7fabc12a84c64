// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

import type {Scene, Texture} from 'three';
import type {SceneLights} from './index.js';

/** The shadows of a scene. */
export interface AreaShadows {
  /** What enableAreaLights gives; its dispose() ends shadows too. */
  readonly lights: SceneLights;
  /** How many rays each pixel has sent to each light since the last change; the picture is worth drawing anew below `frames`. */
  readonly frame: number;
  /** After so many pictures no more rays are sent. */
  frames: number;
  /** Whether the sums are a reference: the light of the material itself, without what makes a ratio less noisy. May be changed. */
  exact: boolean;
  /** Of each pixel the light of its rays, of `frame` pictures together, without and with what stands between; there after the first picture. */
  readonly sums: {unshadowed: Texture, shadowed: Texture};
  /** Begins anew, for changes that are not seen by themselves: of materials, of what skins and morphs do to vertices. */
  reset(): void;
  /** Ends shadows; the lights shine on without. */
  dispose(): void;
}

/**
 * Lets lights of a scene whose castShadow is true have shadows, from the next picture on; its area
 * lights are enabled too. Each picture adds a ray to each pixel and light, until a camera, light or mesh moves. All
 * visible meshes cast shadows but children of lights. Needs three-mesh-bvh.
 */
export function enableAreaShadows(scene: Scene, options?: {frames?: number, exact?: boolean}): AreaShadows;
