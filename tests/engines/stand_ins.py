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


def godot_page(examples, work):
    """webgl2.html with Godot's file and shader; its name below /data/."""
    shader = read(examples, "godot", "floor.gdshader")
    for line in (r"^shader_type spatial;$", r"^render_mode unshaded;$", r"^uniform .*$",
                 r'^#include "res://ltc_lights.gdshaderinc"$'):
        shader = replaced(shader, line, "")
    shader = replaced(shader, r"^vec4 ltc_polygon_data.*?^}\n", "", re.M | re.S)
    write(os.path.join(work, "floor_godot.glsl"), k_godot_head
          + floor_without_light(examples, "floor.glsl", "") + k_godot.replace("SHADER", shader))
    page = read(examples, "webgl2.html")
    for before, after in (("'floor.glsl'", "'/data/floor_godot.glsl'"),
                          ("'../../../shaders/ltc_lights_es.glsl'", "'/shaders/ltc_lights.gdshaderinc'"),
                          ("'scene.glsl'", "'/docs/examples/engines/scene.glsl'"),
                          ("'./scene.js'", "'/docs/examples/engines/scene.js'")):
        page = replaced(page, re.escape(before), after)
    write(os.path.join(work, "godot.html"), page)
    return "/data/godot.html"
