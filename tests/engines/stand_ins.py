# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Shaders of engines that do not run here, run by the examples that do: names of the engine get a stand-in, and the
engine's function becomes light_of_floor of floor.glsl or floor.wgsl, the rest of which is left as it is. So their use
of the shader files, their frames and their order of arguments are checked; that the engine takes them is not."""

import os
import re


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as stream:
        return stream.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def replaced(text, pattern, by, flags=re.M):
    """Where the pattern is not found an example has changed, and so must this."""
    text, count = re.subn(pattern, lambda _: by, text, flags=flags)
    assert count, pattern
    return text


def floor_without_light(examples, name, declaration):
    """floor.glsl or floor.wgsl without what an engine's shader takes over."""
    return replaced(read(examples, name), r"^// What the floor at a point reflects.*?^}\n", declaration, re.M | re.S)


k_godot_head = """
vec3 light_of_floor(vec3 position, vec3 view);
"""

# A camera's space, as Godot has it: x to the right, y up, looking along -z.
k_godot = """
#define floor_color (floor_color_metallic.rgb)
#define floor_metallic (floor_color_metallic.a)
#define floor_roughness (floor_roughness.x)
#define quad_center (quad_center.xyz)
#define quad_half_u (quad_half_u.xyz)
#define quad_half_v (quad_half_v.xyz)
#define quad_radiance (quad_radiance.rgb)
#define star_radiance (star_radiance.rgb)
mat4 VIEW_MATRIX, INV_VIEW_MATRIX;
vec3 VERTEX, NORMAL, VIEW, ALBEDO;
SHADER
vec3 light_of_floor(vec3 position, vec3 view) {
  INV_VIEW_MATRIX = mat4(vec4(normalize(right.xyz), 0.0), vec4(normalize(up.xyz), 0.0), back, vec4(eye.xyz, 1.0));
  VIEW_MATRIX = inverse(INV_VIEW_MATRIX);
  VERTEX = (VIEW_MATRIX * vec4(position, 1.0)).xyz;
  NORMAL = mat3(VIEW_MATRIX) * vec3(0.0, 1.0, 0.0);
  VIEW = mat3(VIEW_MATRIX) * view;
  fragment();
  return ALBEDO;
}
"""


def write_page(work, name, page, changes):
    """A page with another shader, of half the size, which draws when it is asked to; its name below /data/."""
    for pattern, by in [('width="960" height="540"', 'width="480" height="270"'), ("'./scene.js'", "'/data/scene.js'"),
                        ("  draw();\n", "")] + changes:
        page = replaced(page, re.escape(pattern), by)
    write(os.path.join(work, name), page)
    return "/data/" + name


def write_scene(examples, work):
    """scene.js for such pages."""
    scene = read(examples, "scene.js")
    for pattern, by in (("[960, 540]", "[480, 270]"), ("'./polygon.js'", "'/docs/examples/engines/polygon.js'")):
        scene = replaced(scene, re.escape(pattern), by)
    write(os.path.join(work, "scene.js"), scene)


def godot_page(examples, work):
    """webgl2.html with Godot's file and shader; its name below /data/."""
    shader = read(examples, "godot", "floor.gdshader")
    for line in (r"^shader_type spatial;$", r"^render_mode unshaded;$", r"^uniform .*$",
                 r'^#include "res://ltc_lights.gdshaderinc"$'):
        shader = replaced(shader, line, "")
    shader = replaced(shader, r"^vec4 ltc_polygon_data.*?^}\n", "", re.M | re.S)
    write(os.path.join(work, "floor_godot.glsl"), k_godot_head
          + floor_without_light(examples, "floor.glsl", "") + k_godot.replace("SHADER", shader))
    return write_page(work, "godot.html", read(examples, "webgl2.html"), [
        ("'floor.glsl'", "'/data/floor_godot.glsl'"), ("'scene.glsl'", "'/docs/examples/engines/scene.glsl'"),
        ("'../../../shaders/ltc_lights_es.glsl'", "'/shaders/ltc_lights.gdshaderinc'")])


# What Bevy imports, and its lights out.
k_bevy = """
struct VertexOutput { world_position: vec4f, world_normal: vec3f }
struct FragmentOutput { color: vec4f }
struct Material { base_color: vec4f, metallic: f32, perceptual_roughness: f32 }
struct PbrInput { material: Material, world_position: vec4f, N: vec3f, V: vec3f }
struct View { exposure: f32 }
const view = View(1.0);
var<private> to_eye: vec3f;
fn pbr_input_from_standard_material(in: VertexOutput, is_front: bool) -> PbrInput {
  let material = Material(vec4f(scene.floor_color_metallic.rgb, 1.0), scene.floor_color_metallic.a,
                          scene.floor_roughness.x);
  return PbrInput(material, in.world_position, in.world_normal, to_eye);
}
fn apply_pbr_lighting(in: PbrInput) -> vec4f { return vec4f(0.0, 0.0, 0.0, 1.0); }
fn main_pass_post_lighting_processing(in: PbrInput, color: vec4f) -> vec4f { return color; }
SHADER
fn light_of_floor(position: vec3f, v: vec3f) -> vec3f {
  lights = AreaLights(scene.quad_center.xyz, scene.quad_half_u.xyz, scene.quad_half_v.xyz, scene.quad_radiance.rgb,
                      scene.star_radiance.rgb, scene.star);
  to_eye = v;
  return fragment(VertexOutput(vec4f(position, 1.0), vec3f(0.0, 1.0, 0.0)), true).color.rgb;
}
"""


def bevy_page(examples, work):
    """webgpu.html with Bevy's shader; its name below /data/."""
    shader = read(examples, "bevy", "src", "area_lights.wgsl")
    for pattern in (r"^#import .*?^}$", r"^fn ltc_polygon_data.*?^}$", r"^@fragment$"):
        shader = replaced(shader, pattern, "", re.M | re.S)
    shader = replaced(shader, re.escape("@builtin(front_facing) "), "")
    shader = replaced(shader, r"^@group.*var<uniform>", "var<private>")
    write(os.path.join(work, "floor_bevy.wgsl"),
          floor_without_light(examples, "floor.wgsl", "") + k_bevy.replace("SHADER", shader))
    return write_page(work, "bevy.html", read(examples, "webgpu.html"), [
        ("'floor.wgsl'", "'/data/floor_bevy.wgsl'"), ("'../../../shaders/ltc_lights.wgsl'", "'/shaders/ltc_lights.wgsl'"),
        ("await make_pipeline(format, false)", "null")])


# floor.glsl as HLSL, in the order of scene.h.
k_hlsl = """
#define vec2 float2
#define vec3 float3
#define vec4 float4
[[vk::binding(0, 0)]] cbuffer Scene {
  float4 size, eye, right, up, back, floor_color_metallic, floor_roughness, quad_center, quad_half_u, quad_half_v,
      quad_radiance, star_radiance;
};
[[vk::binding(1, 0)]] RWStructuredBuffer<float4> picture;
INCLUDES
float3 light_of_floor(float3 position, float3 view) {
  float3 light;
  AreaLights_float(position, float3(0, 1, 0), view, floor_color_metallic.rgb, floor_color_metallic.a,
                   floor_roughness.x, quad_center.xyz, quad_half_u.xyz, quad_half_v.xyz, quad_radiance.rgb,
                   star_radiance.rgb, light);
  return light;
}
FLOOR
[numthreads(8, 8, 1)] void main(uint3 at : SV_DispatchThreadID) {
  if (at.x < uint(size.x) && at.y < uint(size.y))
    picture[at.y * uint(size.x) + at.x] = float4(radiance_at(float2(at.xy) + 0.5), 1.0);
}
"""


def hlsl_shader(examples, work):
    """A compute shader for the program of Vulkan around unity.hlsl and what it includes; its path."""
    includes = read(examples, "hlsl", "unity.hlsl")
    shaders = os.path.join(examples, "..", "..", "..", "shaders")
    for name, folder in (("star", os.path.join(examples, "hlsl")), ("ltc_lights", shaders),
                         ("area_lights", os.path.join(examples, "hlsl"))):
        includes = replaced(includes, r'^#include "%s.hlsl"$' % name, read(folder, name + ".hlsl"))
    floor = floor_without_light(examples, "floor.glsl", "")
    floor = replaced(floor, r"^// For a screen.*", "", re.M | re.S).replace("vec3(0.0)", "float3(0.0, 0.0, 0.0)")
    path = os.path.join(work, "hlsl.comp")
    write(path, k_hlsl.replace("INCLUDES", includes).replace("FLOOR", floor))
    return path
