# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The shaders that are measured: compute shaders of GLSL that read a point and a light of their own for each lane
(shader_case.h), make the surface and shade the light. Calls are those that tests/parity compiles."""

import os

import check_files
import kernels

k_usual_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), "usual.glsl")
k_usual = {"usual, sphere": "", "usual, clipped": "#define USUAL_CLIPPED\n"}
k_quads_per_case = 32  # of a shader that is timed: reading a case is a small part of it

k_lean = "--lean"  # option of the tool: a file without the functions that the rows before it call

k_textures = "".join("layout(binding = %d) uniform sampler2D %s;\n" % (3 + i, name)
                     for i, name in enumerate(check_files.k_textures))
k_table_arguments = {"table": "coefficients, amplitudes, ", "two-lobe": "coefficients, amplitudes, second, "}
# Bytes of 64 x 64 texels of four floats.
k_texture_bytes = 64 * 64 * 16

k_usual_call = """
vec4 run_usual(vec4 at, vec4 n, vec4 eye, vec4 triangle, vec4 a, vec4 b, vec4 c) {
  vec2 uv = usual_coordinates(at.w, dot(n.xyz, eye.xyz));
  UsualSurface surface = usual_surface(at.xyz, n.xyz, eye.xyz, vec3(n.w), vec3(eye.w),
                                       textureLod(coefficients, uv, 0.0), textureLod(amplitudes, uv, 0.0).xy);
  return vec4(usual_quad(surface, a.xyz, b.xyz, c.xyz), 1.0);
}
"""

# Many quads on one surface, each a little beside the last.
k_many = """
vec4 run_many(vec4 at, vec4 n, vec4 eye, vec4 triangle, vec4 a, vec4 b, vec4 c) {
SURFACE
  vec3 light = vec3(0.0);
  for (int i = 0; i < %d; ++i) {
    vec3 center = a.xyz + vec3(3e-4 * float(i), 0.0, 0.0);
    light += TERM;
  }
  return vec4(light / %d.0, 1.0);
}
""" % (k_quads_per_case, k_quads_per_case)
k_our_surface = """
  ltc_Surface surface = ltc_surface_at(at.xyz, n.xyz, eye.xyz, vec3(n.w), vec3(eye.w), vec3(1.0), at.w);"""
k_our_term = "ltc_shade_quad(surface, ltc_make_quad(center, b.xyz, c.xyz, 0.0))"
# The lobe is that of our polynomials in both: no texture is read, which a processor does by other means.
k_usual_surface = """
  ltc_FittedLobe fitted = ltc_eval_lobe_polynomial(ltc_alpha_from_roughness(at.w), dot(n.xyz, eye.xyz));
  UsualSurface surface = usual_surface(at.xyz, n.xyz, eye.xyz, vec3(n.w), vec3(eye.w),
      vec4(fitted.lobe.m00, fitted.lobe.m20, fitted.lobe.m02, fitted.lobe.m22), vec2(fitted.n1, fitted.n5));"""
k_usual_term = "usual_quad(surface, center, b.xyz, c.xyz)"

# The surface itself, each seen a little from beside the last; all that a light reads of it counts.
k_surface = "surface"
k_surface_term = """surface_sum(ltc_surface_at(at.xyz, n.xyz, normalize(eye.xyz + vec3(1e-3 * float(i), 0.0, 0.0)),
                         vec3(n.w), vec3(eye.w), vec3(1.0), at.w))"""
k_surface_sum = """
vec3 surface_sum(ltc_Surface s) {
  ltc_Lobe lobe = s.fitted.lobe;
  return s.specular + s.diffuse + s.frame.t1 + s.frame.t2 + s.wo
      + vec3(lobe.m00 + lobe.m02 + lobe.m20 + lobe.m22 + s.inv_share + s.axis_weight);
}
"""

# A shader that may have no area light to shade; the point light stands for all that it shades else.
k_variant = """
vec4 run_variant(vec4 at, vec4 n, vec4 eye, vec4 triangle, vec4 a, vec4 b, vec4 c) {
  vec3 to_light = triangle.xyz - at.xyz;
  vec3 light = vec3(n.w * max(dot(n.xyz, normalize(to_light)), 0.0) / dot(to_light, to_light));
  if (CONDITION) { light += run_quad(at, n, eye, triangle, a, b, c).xyz; }
  return vec4(light, 1.0);
}
"""
k_variants = {
    "no quad: a specialisation constant is false": ("layout(constant_id = 0) const bool lit = false;", "lit"),
    "no quad in view: a branch on a number of a buffer": ("", "polygons[0].x > 0.0"),
    "a quad: the constant is true": ("layout(constant_id = 0) const bool lit = true;", "lit"),
}


class Row:
    """A shader beside others: what light, where its lobes come from, what it calls besides, or its file's option."""

    def __init__(self, light, lobe, more=""):
        self.light, self.lobe, self.more = light, lobe, more

    @property
    def title(self):
        return self.light + (", `%s`" % self.more if self.more else "")

    @property
    def file_name(self):
        return "".join(c if c.isalnum() else "_" for c in "_".join((self.light, self.lobe, self.more)))

    @property
    def texture_bytes(self):
        return {"table": 2, "two-lobe": 3}.get(self.lobe, 0) * k_texture_bytes


def all_rows():
    found = [Row("quad", "polynomial"), Row("quad", "table"), Row("quad", "two-lobe-polynomial"),
             Row("quad", "polynomial", "ltc_correct_at_mean"),
             Row("quad", "polynomial", "ltc_set_geometric_normal"), Row("quad", "polynomial", k_lean)]
    found += [Row(name, "table") for name in k_usual]
    return found + [Row(shape, lobe) for shape in check_files.k_shapes[1:] for lobe in ("polynomial", "table")]


def timed_rows():
    return ([Row("quad", "polynomial"), Row("quad", "two-lobe-polynomial")]
            + [Row(name, "polynomial") for name in k_usual] + [Row(k_surface, "polynomial")])


def usual_source(light):
    with open(k_usual_file, encoding="utf-8") as stream:
        return k_usual[light] + stream.read()


def our_source(folder, row):
    return folder.source("glsl", row.light, "--lobe", row.lobe, *([k_lean] if row.more == k_lean else []))


def compute_shader(body, run, declared=k_textures):
    return kernels.k_compute_head + declared + body + kernels.k_compute_main.replace("RUN", run)


def our_call(row):
    """As tests/parity calls it, with textures and with what the row calls besides."""
    call = kernels.fill(kernels.k_glsl_call, row.light)
    call = call.replace("ltc_surface_at(", "ltc_surface_at(" + k_table_arguments.get(row.lobe, ""))
    more = {"": "", k_lean: "", "ltc_correct_at_mean": "  surface = ltc_correct_at_mean(surface);\n",
            "ltc_set_geometric_normal": "  surface = ltc_set_geometric_normal(surface, triangle.xyz);\n"}[row.more]
    call = call.replace("  return", more + "  return")
    return call.replace("(surface, light)", "(surface, light, picture)") if row.light == "textured" else call


def shader(row, folder):
    """The whole shader of a row."""
    if row.light in k_usual:
        return compute_shader(usual_source(row.light) + k_usual_call, "run_usual")
    return compute_shader(our_source(folder, row) + our_call(row), "run_" + row.light)


def variant_shader(title, folder):
    """A shader of k_variants."""
    declared, condition = k_variants[title]
    quad = Row("quad", "polynomial")
    return compute_shader(our_source(folder, quad) + our_call(quad) + k_variant.replace("CONDITION", condition),
                          "run_variant", declared)


def timed_shader(row, folder):
    """Many quads, or surfaces, for each case, without textures."""
    if row.light in k_usual:
        file, surface, term = Row("quad", "polynomial"), k_usual_surface, k_usual_term
    else:
        file, surface, term = Row("quad", row.lobe), k_our_surface, k_our_term
    body = k_many.replace("SURFACE", surface).replace("TERM", term)
    if row.light == k_surface:
        body = k_surface_sum + k_many.replace("SURFACE", "").replace("TERM", k_surface_term)
    usual = usual_source(row.light) if row.light in k_usual else ""
    return compute_shader(our_source(folder, file) + usual + body, "run_many", "")


def usual_fragment_shader(light):
    """For WebGL 2, as kernels.call_kernel makes ours."""
    return (kernels.k_fragment_head + "uniform sampler2D coefficients;\nuniform sampler2D amplitudes;\n"
            + usual_source(light) + k_usual_call + kernels.k_fragment_main.replace("RUN", "run_usual"))
