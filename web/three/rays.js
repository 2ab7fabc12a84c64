// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GLSL of shadows: for each pixel the ratio of a light's sampled light with and without what stands in its way.
//
// Source: Heitz, Hill, McGuire 2018, "Combining Analytic Direct Illumination and Stochastic Shadows". Both sums are
// made by three.js's own RE_Direct of a point of each light, so that they weigh as the material reflects.

import {ShaderChunk} from 'three';
import {glsl} from './glsl.js';
import {heads, originIndex} from './rows.js';
import {diffuseShareFunction} from './shader_text.js';

// From `from` to a point of the light at head i: its direction and distance, and 1 over the density of that direction.
// u: three numbers from 0 to 1. Positions as the rows have them.
const element = k => `openltc_element(i + ${k})`;
const flat = (sample, area) => `
  vec3 to = ${element(1)}.xyz + ${sample} - from, normal = cross(${element(2)}.xyz, ${element(3)}.xyz);
  return openltc_sample(to, normal, ${element(1)}.w > 0.0, ${area} * length(normal));
`;
const polygonAxes = `
  vec4 middle = ${element(6)};
  vec3 normal = ${element(5)}.xyz, x = normalize(${element(7)}.xyz), y = cross(normal, x);
`;
const samplers = {
  quad: flat(`(2.0 * u.x - 1.0) * ${element(2)}.xyz + (2.0 * u.y - 1.0) * ${element(3)}.xyz`, '4.0'),
  ellipse: flat(`sqrt(u.x) * (cos(6.2831853 * u.y) * ${element(2)}.xyz + sin(6.2831853 * u.y) * ${element(3)}.xyz)`,
                '3.14159265'),
  // In the circle around it: outside of the outline it is dark.
  polygon: `${polygonAxes}
  float r = middle.w * sqrt(u.x);
  vec3 point = middle.xyz + r * (cos(6.2831853 * u.y) * x + sin(6.2831853 * u.y) * y);
  return openltc_sample(point - from, normal, ${element(1)}.y > 0.0,
                        openltc_is_inside(i, point, x, y) ? 3.14159265 * middle.w * middle.w : 0.0);
`,
  // In the cone around it.
  sphere: `
  vec3 to = ${element(1)}.xyz - from;
  float d2 = dot(to, to), r2 = ${element(1)}.w * ${element(1)}.w, sin2 = min(r2 / d2, 1.0);
  float one_less_cos = sin2 / (1.0 + sqrt(1.0 - sin2)), c = 1.0 - u.x * one_less_cos, s = sqrt(max(1.0 - c * c, 0.0));
  vec3 z = to * inversesqrt(d2), x = openltc_across(z), y = cross(z, x);
  vec3 direction = s * (cos(6.2831853 * u.y) * x + sin(6.2831853 * u.y) * y) + c * z;
  float far = sqrt(d2) * c - sqrt(max(r2 - d2 * s * s, 0.0));
  return openltc_Sample(direction, far, d2 > r2 ? 6.2831853 * one_less_cos : 0.0);
`,
  // Side and ends by their areas.
  tube: `
  vec3 a = ${element(1)}.xyz, b = ${element(2)}.xyz, z = normalize(b - a), x = openltc_across(z), y = cross(z, x);
  float r = ${element(1)}.w, caps = ${element(2)}.w, side = 2.0 * length(b - a), whole = side + 2.0 * r * caps;
  float angle = 6.2831853 * u.y;
  vec3 around = cos(angle) * x + sin(angle) * y;
  if (u.x * whole < side)
    return openltc_sample(mix(a, b, u.x * whole / side) + r * around - from, around, false, 3.14159265 * r * whole);
  float end = 2.0 * u.z - 1.0, left = (u.x * whole - side) / (whole - side);
  vec3 normal = caps > 1.0 ? left * sign(end) * z + sqrt(max(1.0 - left * left, 0.0)) * around : sign(end) * z;
  vec3 point = (end > 0.0 ? b : a) + r * (caps > 1.0 ? normal : sqrt(left) * around);
  return openltc_sample(point - from, normal, false, 3.14159265 * r * whole);
`,
  line: `
  vec3 a = ${element(1)}.xyz, b = ${element(2)}.xyz, to = mix(a, b, u.x) - from, along = cross(b - a, to);
  float d2 = dot(to, to);
  return openltc_Sample(to * inversesqrt(d2), sqrt(d2), length(along) * inversesqrt(d2) / d2);
`,
};

// The same for a direction, where it meets the light; with weight 0 where it does not.
const flatHit = (inside, area) => `
  vec3 u = ${element(2)}.xyz, v = ${element(3)}.xyz, normal = cross(u, v), to_middle = ${element(1)}.xyz - from;
  vec3 to = direction * openltc_far(dot(to_middle, normal), dot(direction, normal));
  float x = dot(to - to_middle, u) / dot(u, u), y = dot(to - to_middle, v) / dot(v, v);
  return openltc_sample(to, normal, ${element(1)}.w > 0.0, ${inside} ? ${area} * length(normal) : 0.0);
`;
const hits = {
  quad: flatHit('max(abs(x), abs(y)) <= 1.0', '4.0'),
  ellipse: flatHit('x * x + y * y <= 1.0', '3.14159265'),
  polygon: `${polygonAxes}
  vec3 to = direction * openltc_far(dot(middle.xyz - from, normal), dot(direction, normal));
  return openltc_sample(to, normal, ${element(1)}.y > 0.0,
                        openltc_is_inside(i, from + to, x, y) ? 3.14159265 * middle.w * middle.w : 0.0);
`,
  sphere: `
  vec3 to = ${element(1)}.xyz - from;
  float d2 = dot(to, to), r2 = ${element(1)}.w * ${element(1)}.w, along = dot(to, direction);
  float inside = r2 - d2 + along * along, sin2 = min(r2 / d2, 1.0);
  bool meets = inside >= 0.0 && along > 0.0 && d2 > r2;
  return openltc_Sample(direction, meets ? along - sqrt(inside) : 0.0,
                        meets ? 6.2831853 * sin2 / (1.0 + sqrt(1.0 - sin2)) : 0.0);
`,
};
// Those that no direction is asked of: in smooth surfaces they have the shadows of rougher ones.
const canHit = shape => shape in hits;

/// Declarations and functions for the pass that sums, to stand before main(), after those of the closed form's
/// elements; BVH functions of three-mesh-bvh stand before them. `names`: those of pictures. `exact`: the sums are those
/// of the material itself, without what quiets a ratio, its diffuse part less what the specular one reflects, which
/// three.js leaves to it.
export function rayFunctions(forms, names, exact) {
  const left = [...names], shapes = forms.map(form => form.split(':'));
  const body = (shape, factor) => `    head = openltc_element(i);
    if (head.w < 0.0) {
      u = openltc_numbers(i);
${canHit(shape) ? `      if (u.z < by_lobe) to = openltc_hit_${shape}(i, from, openltc_lobe_direction(place, u.xy));
      else to = openltc_sample_${shape}(i, from, u);
      openltc_add_ray(to, head.rgb${factor}, place, by_lobe);` : `      to = openltc_sample_${shape}(i, from, u);
      openltc_add_ray(to, head.rgb${factor}, ${exact ? 'place' : 'openltc_rougher(place)'}, 0.0);`}
    }
    i += int(abs(head.w));
`;
  const loops = shapes.map(([shape, copies]) => {
    const plain = shape.replace('_picture', ''), pictures = plain === shape ? [] : left.splice(0, copies);
    const lights = plain === shape ? `  while (i < end) {\n${body(plain, '')}  }\n` : pictures.map(name =>
        `  if (i < end) {\n${body(plain, ` * openltc_texel(i, ${name}, from + to.far * to.direction)`)}  }\n`).join('');
    return `  head = openltc_element(${heads[shape]});\n  i = int(head.x);\n  end = int(head.y);\n${lights}`;
  });
  const used = new Set(shapes.map(([shape]) => shape.replace('_picture', '')));
  return `${exact ? diffuseShareFunction(glsl) : ''}
uniform BVH openltc_bvh;
uniform uint openltc_frame;
uniform highp sampler2D openltc_unshadowed, openltc_shadowed;
layout(location = 1) out highp vec4 openltc_shadowed_sum;

struct openltc_Sample { vec3 direction; float far; float weight; };
struct openltc_Place { vec3 origin; vec3 position, normal, view, coat_normal; PhysicalMaterial material; };
vec3 openltc_sums[2];
${exact ? 'float openltc_share;' : ''}

vec3 openltc_across(vec3 n) { return normalize(abs(n.z) < 0.7 ? vec3(-n.y, n.x, 0.0) : vec3(0.0, -n.z, n.y)); }

openltc_Sample openltc_sample(vec3 to, vec3 normal, bool two_sided, float area) {
  float d2 = dot(to, to), cosine = -dot(to, normal) * inversesqrt(max(d2 * dot(normal, normal), 1.0e-30));
  return openltc_Sample(to * inversesqrt(max(d2, 1.0e-30)), sqrt(d2),
                        (two_sided ? abs(cosine) : max(cosine, 0.0)) * area / max(d2, 1.0e-30));
}

// Of this pixel, light and picture: a hash, moved from picture to picture so that the numbers fill the cube evenly.
vec3 openltc_numbers(int light) {
  uvec3 v = uvec3(uint(gl_FragCoord.x), uint(gl_FragCoord.y), uint(light)) * 1664525u + 1013904223u;
  for (int k = 0; k < 2; ++k) {
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
  }
  // (0.819, 0.671, 0.549) of 2^32
  return vec3((v + openltc_frame * uvec3(3518319155u, 2882110345u, 2360945575u)) >> 8u) / 16777216.0;
}
// Of a plane at that height, along a direction that falls so much towards it; behind, nothing is met.
float openltc_far(float height, float slope) { return max(height / (slope == 0.0 ? 1.0e-30 : slope), 0.0); }

${used.has('polygon') ? `// Whether a point of its plane lies in a polygon, by the edges that a ray along x crosses.
bool openltc_is_inside(int i, vec3 point, vec3 x, vec3 y) {
  bool inside = false;
  vec2 a = vec2(0.0);
  for (int k = 0, count = int(${element(1)}.x); k < count; ++k) {
    vec4 corner = openltc_element(i + 9 + k);
    vec2 b = vec2(dot(corner.xyz - point, x), dot(corner.xyz - point, y));
    if (corner.w == 0.0 && (a.y > 0.0) != (b.y > 0.0) && a.x * (b.y - a.y) > a.y * (b.x - a.x) == (b.y > a.y))
      inside = !inside;
    a = b;
  }
  return inside;
}
` : ''}
${names.length ? `// What a picture shows at a point of its light.
vec3 openltc_texel(int i, sampler2D picture, vec3 point) {
  vec3 to = point - ${element(1)}.xyz, u = ${element(2)}.xyz, v = ${element(3)}.xyz;
  return textureLod(picture, 0.5 + 0.5 * vec2(dot(to, u) / dot(u, u), dot(to, v) / dot(v, v)), 0.0).rgb;
}
` : ''}
${[...used].map(shape => `
openltc_Sample openltc_sample_${shape}(int i, vec3 from, vec3 u) {${samplers[shape]}}
${canHit(shape) ? `openltc_Sample openltc_hit_${shape}(int i, vec3 from, vec3 direction) {${hits[shape]}}` : ''}
`).join('')}
// Below this roughness half of the rays go where the material's lobe points.
const float openltc_smooth = 0.4;

openltc_Place openltc_rougher(openltc_Place place) {
  place.material.roughness = max(place.material.roughness, 0.25);
  return place;
}

// A direction of the lobe, by the distribution of its half vector (Walter et al. 2007), in the world.
vec3 openltc_lobe_direction(openltc_Place place, vec2 u) {
  float a2 = pow(place.material.roughness, 4.0), c = sqrt((1.0 - u.x) / (1.0 + (a2 - 1.0) * u.x));
  vec3 x = openltc_across(place.normal), y = cross(place.normal, x);
  vec3 h = sqrt(max(1.0 - c * c, 0.0)) * (cos(6.2831853 * u.y) * x + sin(6.2831853 * u.y) * y) + c * place.normal;
  return transpose(mat3(viewMatrix)) * reflect(-place.view, h);
}

// And its density, of a direction in the view's axes.
float openltc_lobe_density(openltc_Place place, vec3 direction) {
  vec3 h = normalize(direction + place.view);
  float a2 = pow(place.material.roughness, 4.0), c = max(dot(h, place.normal), 0.0), d = (a2 - 1.0) * c * c + 1.0;
  return a2 * c / (3.14159265 * d * d) / max(4.0 * abs(dot(h, place.view)), 1.0e-6);
}

// by_lobe: the share of directions that are the lobe's.
void openltc_add_ray(openltc_Sample to, vec3 radiance, openltc_Place place, float by_lobe) {
  if (!(to.weight > 0.0)) return;
  IncidentLight light;
  light.direction = mat3(viewMatrix) * to.direction;
  light.color = radiance / ((1.0 - by_lobe) / to.weight + by_lobe * openltc_lobe_density(place, light.direction));
  light.visible = true;
  ReflectedLight lit = ReflectedLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
#ifdef USE_CLEARCOAT
  vec3 before = clearcoatSpecularDirect;
  clearcoatSpecularDirect = vec3(0.0);
#endif
  RE_Direct(light, place.position, place.normal, place.view, place.coat_normal, place.material, lit);
  vec3 sum = ${exact ? 'openltc_share * ' : ''}lit.directDiffuse + lit.directSpecular;
#ifdef USE_CLEARCOAT
  sum += place.material.clearcoat * clearcoatSpecularDirect;
  clearcoatSpecularDirect = before;
#endif
${exact ? '' : `  // Where the material reflects nothing of the points that were found, all of them count alike.
  sum += 1.0e-4 * light.color;
`}  openltc_sums[0] += sum;
  uvec4 face;
  vec3 normal, place_in_face;
  float side, hit = 0.0;
  if (!bvhIntersectFirstHit(openltc_bvh, place.origin, to.direction, face, normal, place_in_face, side, hit) ||
      hit > 0.9998 * to.far - 0.0002)
    openltc_sums[1] += sum;
}

void openltc_trace(openltc_Place place) {
  vec3 from = place.origin - openltc_element(${originIndex}).xyz;
  int i, end;
  vec4 head;
  vec3 u;
  openltc_Sample to;
  float by_lobe = place.material.roughness < openltc_smooth ? 0.5 : 0.0;
  openltc_sums[0] = openltc_sums[1] = vec3(0.0);
${exact ? `  openltc_share = openltc_diffuse_share(place.normal, place.view, place.material.specularColorBlended,
      place.material.specularF90, place.material.roughness);
` : ''}${loops.join('')}}
`;
}

// Since r186 three.js brightens rough metals, and sets by what only where it has lights itself; the closed form does not.
const noCompensation = ShaderChunk.lights_physical_pars_fragment.includes('multiScatteringCompensation')
    ? 'material.multiScatteringCompensation = vec3(1.0);' : '';

// No ray is sent for the coat: its shadows are those of a rougher one.
const roughCoat = `
#ifdef USE_CLEARCOAT
  float coat = material.clearcoatRoughness;
  material.clearcoatRoughness = max(coat, 0.25);
#endif
`;
const coatAgain = `
#ifdef USE_CLEARCOAT
  material.clearcoatRoughness = coat;
#endif
`;
// The material's own, as the closed form has it, but for three.js's least one.
const ownRoughness = `
  material.roughness = max(roughnessFactor, 0.0525);
`;

/// What follows three.js's own lights in main(), in the pass that sums.
export const rayStatements = exact => `
{
  vec3 up = normalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
  mat3 to_world = transpose(mat3(viewMatrix));
  vec3 here = to_world * geometryPosition + cameraPosition;
  ${exact ? ownRoughness : roughCoat}
  ${noCompensation}
  openltc_trace(openltc_Place(here + (1.0e-4 + 1.0e-6 * length(here)) * (to_world * up), geometryPosition,
      geometryNormal, geometryViewDir, geometryClearcoatNormal, material));
  ${exact ? '' : coatAgain}
}
`;

/// And at its end, in place of the colour.
export const sumStatements = `
gl_FragColor = vec4(texelFetch(openltc_unshadowed, ivec2(gl_FragCoord.xy), 0).rgb + openltc_sums[0], 1.0);
openltc_shadowed_sum = vec4(texelFetch(openltc_shadowed, ivec2(gl_FragCoord.xy), 0).rgb + openltc_sums[1], 1.0);
`;

/// The ratio, for the picture itself. Where a channel was found of no ray, that of all channels.
export const ratioFunctions = `
uniform highp sampler2D openltc_unshadowed, openltc_shadowed;
vec3 openltc_ratio;
vec3 openltc_ratio_here() {
  vec3 all = texelFetch(openltc_unshadowed, ivec2(gl_FragCoord.xy), 0).rgb;
  vec3 open = texelFetch(openltc_shadowed, ivec2(gl_FragCoord.xy), 0).rgb;
  float mean = (open.r + open.g + open.b) / max(all.r + all.g + all.b, 1.0e-30);
  return mix(vec3(mean), open / max(all, vec3(1.0e-30)), greaterThan(all, vec3(0.0)));
}
vec3 openltc_radiance(vec4 head) { return head.w < 0.0 ? head.rgb * openltc_ratio : head.rgb; }
`;
