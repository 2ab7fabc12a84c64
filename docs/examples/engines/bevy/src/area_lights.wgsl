// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Bevy's standard material, lit by a quad and a polygon beside Bevy's own lights. ltc_lights.wgsl is put behind it
// by area_lights.rs.

#import bevy_pbr::{
    forward_io::{VertexOutput, FragmentOutput},
    mesh_view_bindings::view,
    pbr_fragment::pbr_input_from_standard_material,
    pbr_functions::{apply_pbr_lighting, main_pass_post_lighting_processing},
}

struct AreaLights {
    quad_center: vec3f,
    quad_half_u: vec3f,
    quad_half_v: vec3f,
    quad_radiance: vec3f, // nits
    star_radiance: vec3f,
    star: array<vec4f, 19>, // eight elements, and its ten points with the first one again: polygon.rs
}
@group(#{MATERIAL_BIND_GROUP}) @binding(100) var<uniform> lights: AreaLights;

// The star is the only polygon, so its index is 0.
fn ltc_polygon_data(i: i32) -> vec4f {
    return lights.star[i];
}

@fragment
fn fragment(in: VertexOutput, @builtin(front_facing) is_front: bool) -> FragmentOutput {
    let pbr = pbr_input_from_standard_material(in, is_front);

    // Bevy's N, V and position are in world space, V points to the eye, and its roughness is perceptual.
    let surface = ltc_gltf_surface(pbr.world_position.xyz, pbr.N, pbr.V, pbr.material.base_color.rgb,
                                   pbr.material.metallic, pbr.material.perceptual_roughness);
    let quad = ltc_make_quad(lights.quad_center, lights.quad_half_u, lights.quad_half_v, 0.0);
    let light = lights.quad_radiance * ltc_shade_quad(surface, quad)
        + lights.star_radiance * ltc_shade_polygon(surface, 0);

    var out: FragmentOutput;
    out.color = apply_pbr_lighting(pbr);
    out.color = vec4f(out.color.rgb + view.exposure * light, out.color.a);
    out.color = main_pass_post_lighting_processing(pbr, out.color);
    return out;
}
