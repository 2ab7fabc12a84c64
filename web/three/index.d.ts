// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

import type {BufferGeometry, Camera, ColorRepresentation, Light, LineBasicMaterial, LineSegments, Scene, Texture, Vector2} from 'three';

/** A corner of an outline: metres, in the light's xy plane. */
export type Corner = Vector2 | readonly [number, number];

/** What all lights have. Emission is the same in all directions; `color` is a factor. */
export abstract class AreaLight extends Light {
  readonly isAreaLight: true;
  /** Whether it has shadows, by enableAreaShadows of openltc-three/shadows; false by default. */
  castShadow: boolean;
  /** Lumens of the whole light. Setting it sets the luminance or intensity. */
  power: number;
}

/** A light with a surface. */
export abstract class SurfaceLight extends AreaLight {
  /** Nits: candela per square metre along the normal of the emitting surface. It is three.js's `intensity`. */
  luminance: number;
  /**
   * Lumens of the whole light, of both sides where it has two, at its size now and without its node's scale.
   * Setting it sets the luminance.
   */
  power: number;
}

/** A light in its xy plane, which shines along its -z. */
export abstract class PlanarLight extends SurfaceLight {
  /** Whether it shines along +z too. */
  twoSided: boolean;
}

/** A light in its plane that can show a picture. */
export abstract class FramedLight extends PlanarLight {
  /**
   * Fills the rectangle around the light, upright for who looks at the emitting side, and multiplies the luminance,
   * which is that of white. Its alpha and its uv transform do not count. A light whose texture has no image yet
   * shines white. After a change set the texture's needsUpdate. Of a scene four lights have pictures, others the
   * mean of theirs.
   */
  texture: Texture | null;
}

/** A rectangle, as three's RectAreaLight. */
export class RectLight extends FramedLight {
  /** Nits; metres, 1 by default. */
  constructor(color?: ColorRepresentation, luminance?: number, width?: number, height?: number, twoSided?: boolean);
  width: number;
  height: number;
}

/** A polygon of any outline, convex or not, with holes. */
export class PolygonLight extends PlanarLight {
  /**
   * Outlines run either way round and must not cross themselves or each other; holes lie in the outline.
   * @throws Error where one has no three corners, no area, or a corner that is no number.
   */
  constructor(color?: ColorRepresentation, luminance?: number, points?: readonly Corner[],
              holes?: readonly (readonly Corner[])[], twoSided?: boolean);
  readonly points: readonly Corner[];
  readonly holes: readonly (readonly Corner[])[];
  /** Another outline; throws as the constructor does, and the light then stays as it was. */
  setOutline(points: readonly Corner[], holes?: readonly (readonly Corner[])[]): this;
}

/** An ellipse, exact. */
export class EllipseLight extends FramedLight {
  /** Nits; metres, 0.5 by default. */
  constructor(color?: ColorRepresentation, luminance?: number, radiusX?: number, radiusY?: number, twoSided?: boolean);
  radiusX: number;
  radiusY: number;
}

/** A disk, exact. */
export class DiskLight extends FramedLight {
  /** Nits; metres, 0.5 by default. */
  constructor(color?: ColorRepresentation, luminance?: number, radius?: number, twoSided?: boolean);
  radius: number;
}

/** A sphere. */
export class SphereLight extends SurfaceLight {
  /** Nits; metres, 0.1 by default. */
  constructor(color?: ColorRepresentation, luminance?: number, radius?: number);
  radius: number;
}

/** Ends of a tube: half spheres, disks, or open, where its side shines outwards alone. */
export type Caps = 'round' | 'flat' | 'none';

/** A cylinder or capsule along x. */
export class TubeLight extends SurfaceLight {
  /**
   * Nits; metres, 1 and 0.02 by default.
   * @throws Error where caps are none of the three.
   */
  constructor(color?: ColorRepresentation, luminance?: number, length?: number, radius?: number, caps?: Caps);
  /** Without round ends. */
  length: number;
  radius: number;
  caps: Caps;
}

/** A tube along x without thickness; `intensity` is in candela, of the whole line across it. */
export class LineLight extends AreaLight {
  /** Candela; metres, 1 by default. */
  constructor(color?: ColorRepresentation, intensity?: number, length?: number);
  length: number;
}

/** The lights of a scene. */
export interface SceneLights {
  /**
   * Prepares materials for the lights that `camera` sees now, before compile or compileAsync of WebGLRenderer. World
   * matrices must be right. Before a picture, and by WebGPURenderer always, it is called by itself.
   */
  update(camera: Camera): void;
  /** Ends it: the scene's onBeforeRender and onAfterRender are what they were. */
  dispose(): void;
}

/**
 * Lets the area lights of a scene shine, from the next picture on: of WebGLRenderer, or, where it comes from
 * openltc-three/webgpu, of WebGPURenderer. Call it once a scene; if you set its onBeforeRender or onAfterRender, do so before.
 */
export function enableAreaLights(scene: Scene): SceneLights;

/** Lines along the outline of a light; add it to the scene or to the light. */
export class AreaLightHelper extends LineSegments<BufferGeometry, LineBasicMaterial> {
  /** In the light's colour, where none is given. */
  constructor(light: AreaLight, color?: ColorRepresentation);
  readonly light: AreaLight;
  color?: ColorRepresentation;
  /** After a change of the light's size. */
  update(): void;
  dispose(): void;
}

/**
 * A plugin of GLTFLoader, which reads EXT_lights_area and openltc_light of a node's extras as `openltc render` does:
 * `loader.register(parser => new GLTFAreaLights(parser))`. What it cannot read is left out with a warning on the
 * console.
 */
export class GLTFAreaLights {
  constructor(parser: object);
  readonly name: string;
}

/**
 * A plugin of GLTFExporter, which writes lights as GLTFAreaLights and `openltc render` read them:
 * `exporter.register(writer => new GLTFAreaLightsExport(writer))`. Rectangles and disks of one side become
 * EXT_lights_area, others openltc_light in the node's extras. A light's picture is not part of the file, which names it
 * as the texture is named.
 */
export class GLTFAreaLightsExport {
  constructor(writer: object);
  readonly name: string;
}
