// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

/** What could not be done, in one line: an unknown name, a BRDF that throws or is not finite, an option. */
export class OpenltcError extends Error {}

/**
 * A BRDF's value, 1/steradian, without the cosine, for one direction to the viewer and many to the light.
 *
 * Directions are unit vectors in shading space, away from the surface: z is the normal, and wo = (sin theta, 0,
 * cos theta). `wi` holds x y z of each, `out` has one place for each. All are above the surface. The function
 * fills `out`, or returns an array of as many numbers, all finite and none negative. It is isotropic and pure.
 */
export type BatchFunction = (
    wo: [number, number, number], wi: Float64Array, roughness: number, out: Float64Array) => void | ArrayLike<number>;

/** A name of `brdfs`; a function; or the bytes of a file of the MERL database. */
export type BrdfSource = string | BatchFunction | {
  evaluate: BatchFunction;
  name?: string;
  /** 'alpha' (default): a mirror at roughness 0, as microfacet lobes are; 'one': stays wide, as cloth does. */
  width?: 'alpha' | 'one';
  /** false: the BRDF does not look at `roughness`, and the table has one column. Default true. */
  parameter?: boolean;
} | {merl: Uint8Array | ArrayBuffer; name?: string};

export interface FitOptions {
  /** Default 'ggx'. */
  brdf?: BrdfSource;
  /** Default 'table'. */
  form?: 'table' | 'two-lobe' | 'polynomial' | 'two-lobe-polynomial';
  /** Nodes per axis, 2 to 512. Default 64, of two lobes 32. */
  size?: number;
  /** Of polynomials, 3 to 6. Default 4. */
  degree?: number;
  /** balanced (default), tv, l2, l3, or weights "TV,L2,L3". */
  objective?: string;
  /** Whose look-up reads the table, a name of `layouts`. Default native. */
  layout?: string;
  precision?: 'float32' | 'float16';
  refine?: 'auto' | 'on' | 'off';
  /** For layouts other than native: for a renderer that clips lights at the surface's horizon. */
  clipAware?: boolean;
  /** Files for an engine of `engines`, which chooses layout, size and precision. */
  engine?: string;
  /** Called with the share that is done, 0 to 1; false stops the fit. */
  progress?: (share: number) => boolean | void;
}

/** How far lobes are from their BRDF: the members that `openltc fit --report` explains. 0 is best. */
export interface LobeError {
  tv: number;
  bound: number;
  l1: number;
  l2: number;
  l3: number;
  peak: number;
  leak: number;
  n1: number;
  n5: number;
}

export interface Texture {
  width: number;
  height: number;
  channels: number;
  /** Row by row, the channels of a texel side by side. */
  values: Float32Array;
}

/** A file of a fit: hand its bytes to a download, or write them. */
export interface FitFile {
  name: string;
  bytes: Uint8Array;
}

/** One view angle and roughness, seen from above: squares of `side` x `side` pixels, top row first. */
export interface Cell {
  roughness: number;
  thetaDegrees: number;
  error: LobeError;
  albedo: number;
  /** The part of the unit disc (Lambert's equal-area projection) that is shown: x from centerX - half. */
  window: {centerX: number; half: number};
  /** Where the mirror direction lies on the disc's x axis. */
  mirrorX: number;
  /** Of `brdf`: what colours are relative to. */
  brightest: number;
  side: number;
  /** Densities, 1/steradian; -1 below the horizon. */
  brdf: Float32Array;
  lobe: Float32Array;
}

type Point = [number, number, number];

export interface PolygonSpace {
  corners: Point[];
  /** What lies above both horizons. */
  kept: Point[];
  samples: Point[];
  inside: boolean[];
  /** Of the lobe, or of the cosine; the same number by two ways. */
  integral: number;
}

export interface PolygonFigure {
  shading: PolygonSpace;
  cosine: PolygonSpace;
  /** M^-1, by rows. */
  matrix: number[];
  horizonInCosine: Point;
  horizonOfLobe: Point;
  albedo: number;
  /** Light of radiance 1 that is reflected, by the lobes and by quadrature of the BRDF. */
  lightByLobe: number;
  lightByBrdf: number;
}

/** Lobes that were fitted. It keeps memory of the module until it is freed. */
export interface Fit {
  readonly brdf: string;
  readonly width: 'alpha' | 'one';
  readonly layout: string;
  readonly precision: string;
  readonly objective: string;
  /** The command line that makes the same; empty for a function. */
  readonly command: string;
  readonly note: string;
  readonly warning: string;
  /** Of the fit alone, without its error. */
  readonly seconds: number;
  /** Over roughness 0.06 to 1, through the look-up of the layout. */
  readonly mean: LobeError;
  readonly max: LobeError;
  /** 0 of polynomials. */
  readonly columns: number;
  readonly rows: number;
  readonly textures: Texture[];
  /** Where `mean` comes from; roughness fast, angle slow. */
  readonly map: {roughness: number[]; thetaDegrees: number[]; tv: Float32Array; albedo: Float32Array};
  /**
   * The files that `openltc fit -o path` writes: .json .dds .ktx2 .exr .npy .h .glsl .hlsl .wgsl .js, of
   * polynomials .json and sources. Of a fit for an engine those of the engine; then there is no path.
   */
  files(path?: string): FitFile[];
  /** What `openltc fit --report FILE.json` writes. `lights` 0 leaves out the rectangles, the slowest part. */
  report(options?: {lights?: number; limit?: boolean}): any;
  /** Lobes beside their BRDF, as `openltc plot fit` shows them; roughness fast. */
  cells(options: {roughness: Iterable<number>; thetaDegrees: Iterable<number>; side?: number}): Cell[];
  /** A polygon in both spaces, as `openltc plot polygon` shows it. Its corners lie in one plane. */
  polygon(options: {roughness: number; thetaDegrees: number; corners: Point[]; samples?: number}): PolygonFigure;
  free(): void;
}

export interface Openltc {
  readonly version: string;
  readonly brdfs: {name: string; variant: string; source: string; parameter: string; width: 'alpha' | 'one'}[];
  readonly layouts: {
    name: string;
    readers: string;
    normalisation: string;
    usualSize: number;
    angleAxis: string;
    channels: string[][];
  }[];
  readonly engines: {
    name: string;
    title: string;
    layout: string;
    size: number;
    precision: string;
    files: string[];
    place: string;
    slip: string;
  }[];
  /** The colours of the figures: 256 times r g b, sRGB 0 to 1. */
  readonly colormaps: {magma: Float32Array; viridis: Float32Array; blueRed: Float32Array};
  /** What the module has taken. It grows with the largest fit and never shrinks. */
  readonly memoryBytes: number;
  /** Fits at once, in the calling thread: in a page, call it in a worker. */
  fit(options?: FitOptions): Fit;
}

/** Loads the module from beside this file, or from `wasm`: its bytes, or what WebAssembly.compile made of them. */
export function loadOpenltc(options?: {wasm?: BufferSource | WebAssembly.Module}): Promise<Openltc>;

/** What all lights but lines have. Lengths are metres, positions those of the file, +Y up. */
interface Emitter {
  name: string;
  /** cd/m2, linear Rec.709, along the normal of what emits. */
  radiance: Point;
  twoSided: boolean;
  /** At the angle t from the normal the radiance is `radiance` times cos(t) to this power; 0: the same everywhere. */
  cosinePower: number;
}

/** A light of a glTF file, as `openltc render` has it. */
export type AreaLight =
    | Emitter & {type: 'polygon'; /** Towards the emitting side. */ normal: Point;
        /** Seen from there outlines run counter-clockwise, holes clockwise. */ rings: Point[][]}
    | Emitter & {type: 'ellipse'; center: Point; /** Semi-axes; it emits along halfU x halfV. */ halfU: Point; halfV: Point}
    | Emitter & {type: 'sphere'; center: Point; radius: number}
    | Emitter & {type: 'tube'; from: Point; to: Point; radius: number; caps: 'none' | 'flat' | 'round'}
    | {type: 'line'; name: string; from: Point; to: Point; /** cd/m, seen at a right angle. */ intensityPerMetre: Point};

export interface FileLights {
  /** Of EXT_lights_area, of openltc_light, and of emissive surfaces. */
  lights: AreaLight[];
  /** Whether the file says expressly that there is light. */
  describesLights: boolean;
  /** One line each, as `openltc render` says them. */
  warnings: string[];
}

export interface LightReader {
  /**
   * The area lights of a .glb or .gltf, of one file: what lies beside it is not read, nor are pictures, Draco or
   * meshopt data, and what of it needs them is in the warnings, or an error. `name` stands for the file in messages;
   * `recogniseShapes` is --recognise-shapes of `openltc render`.
   */
  readLights(file: Uint8Array | ArrayBuffer, options?: {name?: string; recogniseShapes?: boolean}): FileLights;
  /** What the module has taken. */
  readonly memoryBytes: number;
}

/** Loads the reader of glTF files, a module of its own, from beside this file or from `wasm`. */
export function loadLightReader(options?: {wasm?: BufferSource | WebAssembly.Module}): Promise<LightReader>;
