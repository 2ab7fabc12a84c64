// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//! Area lights as an extension of Bevy's standard material.

use bevy::{
    asset::uuid_handle,
    pbr::{ExtendedMaterial, MaterialExtension},
    prelude::*,
    render::render_resource::{AsBindGroup, ShaderType},
    shader::ShaderRef,
};

/// Add it beside DefaultPlugins, and give surfaces a LitMaterial.
pub struct AreaLightPlugin;

pub type LitMaterial = ExtendedMaterial<StandardMaterial, AreaLights>;

/// What lights a surface. Slots below 100 are those of the standard material.
#[derive(Asset, AsBindGroup, Reflect, Debug, Clone)]
pub struct AreaLights {
    #[uniform(100)]
    pub lights: Lights,
}

/// AreaLights of the shader: world space, metres, nits. A lamp shines along half_u x half_v.
#[derive(ShaderType, Reflect, Debug, Clone)]
pub struct Lights {
    pub quad_center: Vec3,
    pub quad_half_u: Vec3,
    pub quad_half_v: Vec3,
    pub quad_radiance: Vec3,
    pub star_radiance: Vec3,
    pub star: [Vec4; 19],
}

const SHADER: Handle<Shader> = uuid_handle!("5a4e0c9e-6a0f-4d43-9d5c-0b1f3b8c2f11");

/// WGSL has no include, and Bevy's imports want files that are whole by themselves: both in one.
const SOURCE: &str = concat!(
    include_str!("area_lights.wgsl"),
    include_str!("../../../../../shaders/ltc_lights.wgsl")
);

impl Plugin for AreaLightPlugin {
    fn build(&self, app: &mut App) {
        let shader = Shader::from_wgsl(SOURCE, "area_lights.wgsl");
        let mut shaders = app.world_mut().resource_mut::<Assets<Shader>>();
        shaders
            .insert(&SHADER, shader)
            .expect("a handle of our own");
        app.add_plugins(MaterialPlugin::<LitMaterial>::default());
    }
}

impl MaterialExtension for AreaLights {
    fn fragment_shader() -> ShaderRef {
        SHADER.into()
    }
}
