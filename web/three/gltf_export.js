// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights into glTF files, as `openltc render` and gltf.js read them.

const extension = 'EXT_lights_area', prefix = 'openltc_', own = 'openltc_light';
const keptExtras = ['openltc_emits_light', 'openltc_surface_deviation']; // of nodes, which are no light's

const corners = ring => Array.from(ring, p => Array.isArray(p) ? [...p] : [p.x, p.y]);
const properties = {
  RectLight: ({width, height}) => ({type: 'rect', width, height}),
  DiskLight: ({radius}) => ({type: 'disk', radius}),
  EllipseLight: ({radiusX, radiusY}) => ({type: 'ellipse', radius_x: radiusX, radius_y: radiusY}),
  PolygonLight: ({points, holes}) => ({type: 'polygon', points: corners(points),
                                       ...(holes.length ? {holes: holes.map(corners)} : {})}),
  SphereLight: ({radius}) => ({type: 'sphere', radius}),
  TubeLight: ({length, radius, caps}) => ({type: 'tube', length, radius, caps}),
  LineLight: ({length}) => ({type: 'line', length}),
};

/// A plugin of GLTFExporter: exporter.register(writer => new GLTFAreaLightsExport(writer)). Rectangles and disks of one
/// side are written as EXT_lights_area, the rest as openltc_light in the node's extras. A picture is named as its
/// texture is, and not part of the file.
export class GLTFAreaLightsExport {
  constructor(writer) {
    this.writer = writer;
    this.name = extension;
  }

  /// Called by GLTFExporter for each node.
  writeNode(light, node) {
    if (!light.isAreaLight) return;
    this.removeOld(node);
    if (this.fitsExtension(light)) this.writeExtension(light, node);
    else node.extras = {...node.extras, [own]: this.describe(light)};
  }

  // What the node's light was when it was loaded.
  removeOld(node) {
    for (const name of Object.keys(node.extras ?? {}))
      if (name.startsWith(prefix) && !keptExtras.includes(name)) delete node.extras[name];
    if (node.extras && Object.keys(node.extras).length === 0) delete node.extras;
  }

  fitsExtension(light) {
    return ['RectLight', 'DiskLight'].includes(light.type) && !light.twoSided && !light.texture &&
        Math.max(...light.color.toArray()) <= 1;
  }

  writeExtension(light, node) {
    const {json, extensionsUsed} = this.writer;
    const shape = light.type === 'DiskLight' ? {type: 'disk', size: 2 * light.radius}
                                             : {type: 'rect', size: light.height, rect: {aspect: light.width / light.height}};
    json.extensions ??= {};
    const {lights} = json.extensions[extension] ??= {lights: []};
    lights.push({...(light.name ? {name: light.name} : {}), ...shape, color: light.color.toArray(), intensity: light.luminance});
    node.extensions = {...node.extensions, [extension]: {light: lights.length - 1}};
    extensionsUsed[extension] = true;
  }

  describe(light) {
    const brightness = light.type === 'LineLight' ? 'intensity_candela' : 'luminance_nits';
    const result = {...properties[light.type](light), color: light.color.toArray(), [brightness]: light.intensity};
    if (light.twoSided) result.two_sided = true;
    if (light.texture && /\.(png|jpe?g|webp)$/i.test(light.texture.name)) result.texture = light.texture.name;
    else if (light.texture)
      console.warn(`openltc-three: the picture of light "${light.name}" is not exported: its texture's name is no file's`);
    return result;
  }
}
