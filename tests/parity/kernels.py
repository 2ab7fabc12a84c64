# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Kernels around a shader file: what a case is made into, and what is kept of its light.

Cases and results: shader_case.h. `ltc_` is the prefix of the shader file."""

k_forms = 3
k_shapes = ("quad", "polygon", "disk", "sphere", "tube", "line")

# Shape -> the function's name, the light's type, and how a case's a, b, c make one.
k_lights = {
    "quad": ("quad", "ltc_Quad", "ltc_make_quad(a.xyz, b.xyz, c.xyz, b.w)"),
    "polygon": ("polygon", "int", "int(b.w)"),
    "disk": ("ellipse", "ltc_Ellipse", "ltc_make_ellipse(a.xyz, b.xyz, c.xyz, b.w)"),
    "sphere": ("sphere", "ltc_Sphere", "ltc_make_sphere(a.xyz, a.w)"),
    "tube": ("tube", "ltc_Tube", "ltc_make_tube(a.xyz, b.xyz, a.w, b.w)"),
    "line": ("line", "ltc_Line", "ltc_make_line(a.xyz, b.xyz)"),
    "textured": ("textured_quad", "ltc_Quad", "ltc_make_quad(a.xyz, b.xyz, c.xyz, b.w)"), # whose picture is no case
}

# One call for all forms: compilers put a copy of all that a call reaches in its place.
k_glsl_case = """
vec4 run_SHAPE(vec4 at, vec4 n, vec4 eye, vec4 triangle, vec4 a, vec4 b, vec4 c) {
  ltc_Surface surface = ltc_surface_at(at.xyz, n.xyz, eye.xyz, vec3(n.w), vec3(eye.w), vec3(1.0), at.w);
  if (triangle.w == 1.0) { surface = ltc_correct_at_mean(surface); }
HIDE  TYPE light = MAKE;
  ltc_ShadedLight parts = ltc_shade_NAME_parts(surface, light);
  return vec4(parts.diffuse.x, parts.specular.x, 0.0, 0.0);
}
"""

k_wgsl_case = """
fn run_SHAPE(at: vec4f, n: vec4f, eye: vec4f, triangle: vec4f, a: vec4f, b: vec4f, c: vec4f) -> vec4f {
  var surface = ltc_surface_at(at.xyz, n.xyz, eye.xyz, vec3f(n.w), vec3f(eye.w), vec3f(1.0), at.w);
  if (triangle.w == 1.0) { surface = ltc_correct_at_mean(surface); }
HIDE  let light = MAKE;
  let parts = ltc_shade_NAME_parts(surface, light);
  return vec4f(parts.diffuse.x, parts.specular.x, 0.0, 0.0);
}
"""

# What a caller writes, for the time that it takes to compile: one call of one function.
k_glsl_call = """
vec4 run_SHAPE(vec4 at, vec4 n, vec4 eye, vec4 triangle, vec4 a, vec4 b, vec4 c) {
  ltc_Surface surface = ltc_surface_at(at.xyz, n.xyz, eye.xyz, vec3(n.w), vec3(eye.w), vec3(1.0), at.w);
  TYPE light = MAKE;
  return vec4(ltc_shade_NAME(surface, light), 1.0);
}
"""

k_wgsl_call = """
fn run_SHAPE(at: vec4f, n: vec4f, eye: vec4f, triangle: vec4f, a: vec4f, b: vec4f, c: vec4f) -> vec4f {
  let surface = ltc_surface_at(at.xyz, n.xyz, eye.xyz, vec3f(n.w), vec3f(eye.w), vec3f(1.0), at.w);
  let light = MAKE;
  return vec4f(ltc_shade_NAME(surface, light), 1.0);
}
"""

k_compute_head = """#version 450
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Cases { vec4 cases[]; };
layout(set = 0, binding = 1, std430) readonly buffer Polygons { vec4 polygons[]; };
layout(set = 0, binding = 2, std430) buffer Results { vec4 results[]; };
vec4 ltc_polygon_data(int i) { return polygons[i]; }
"""

k_compute_main = """
void main() {
  int i = int(gl_GlobalInvocationID.x), k = 7 * i;
  results[i] = RUN(cases[k], cases[k + 1], cases[k + 2], cases[k + 3], cases[k + 4], cases[k + 5], cases[k + 6]);
}
"""

# A row of the cases' texture is one row of results.
k_fragment_head = """#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D cases;
uniform sampler2D polygons;
out vec4 color;
vec4 ltc_polygon_data(int i) { return texelFetch(polygons, ivec2(i % 1024, i / 1024), 0); }
vec4 case_data(int k) {
  ivec2 at = ivec2(gl_FragCoord.xy);
  return texelFetch(cases, ivec2(7 * at.x + k, at.y), 0);
}
"""

k_fragment_main = """
void main() {
  color = RUN(case_data(0), case_data(1), case_data(2), case_data(3), case_data(4), case_data(5), case_data(6));
}
"""

k_wgsl_head = """@group(0) @binding(0) var<storage, read> cases: array<vec4f>;
@group(0) @binding(1) var<storage, read> polygons: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> results: array<vec4f>;
fn ltc_polygon_data(i: i32) -> vec4f { return polygons[i]; }
"""

k_wgsl_main = """
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
  let k = 7 * id.x;
  results[id.x] = RUN(cases[k], cases[k + 1], cases[k + 2], cases[k + 3], cases[k + 4], cases[k + 5], cases[k + 6]);
}
"""


def fill(text, shape):
    name, kind, make = k_lights[shape]
    if "vec4f" in text:  # WGSL has its own name for int
        make = make.replace("int(", "i32(")
    return (text.replace("SHAPE", shape).replace("NAME", name).replace("TYPE", kind)
            .replace("MAKE", make))


def all_shapes(call, vector):
    """Every shape's call in one: a sum, so that none is left out."""
    names = ("at", "n", "eye", "triangle", "a", "b", "c")
    total = " + ".join("run_%s(%s)" % (shape, ", ".join(names)) for shape in k_shapes)
    if vector == "vec4":
        head = "vec4 run_all(%s)" % ", ".join("vec4 " + name for name in names)
    else:
        head = "fn run_all(%s) -> vec4f" % ", ".join(name + ": vec4f" for name in names)
    return "".join(fill(call, shape) for shape in k_shapes) + head + " { return " + total + "; }\n"


k_languages = {
    "glsl": (k_compute_head, k_glsl_case, k_glsl_call, k_compute_main, "vec4"),
    "glsl-es": (k_fragment_head, k_glsl_case, k_glsl_call, k_fragment_main, "vec4"),
    "wgsl": (k_wgsl_head, k_wgsl_case, k_wgsl_call, k_wgsl_main, "vec4f"),
}


k_hide = """  if (triangle.w == 2.0) { surface = ltc_set_geometric_normal(surface, triangle.xyz); }
"""


def case_kernel(language, source, shape, forms=k_forms):
    """A whole shader that evaluates cases of `shape` by the shader file `source`. With two forms it has none for
    the third, whose results are then those of the first."""
    head, case, _, main, _ = k_languages[language]
    case = case.replace("HIDE", k_hide if forms == k_forms else "")
    return head + source + fill(case, shape) + main.replace("RUN", "run_" + shape)


def call_kernel(language, source, shape):
    """A whole shader that calls the function of `shape`, or those of "all" shapes, once."""
    head, _, call, main, vector = k_languages[language]
    body = all_shapes(call, vector) if shape == "all" else fill(call, shape)
    return head + source + body + main.replace("RUN", "run_" + shape)
