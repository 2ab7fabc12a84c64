// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//! A warm quad and a cool star over a dark floor, as in scenes/engines.glb. Metres, +Y up.

mod area_lights;
mod polygon;

use area_lights::{AreaLightPlugin, AreaLights, Lights, LitMaterial};
use bevy::{
    asset::RenderAssetUsages,
    camera::Exposure,
    core_pipeline::tonemapping::Tonemapping,
    light::GlobalAmbientLight,
    mesh::{Indices, PrimitiveTopology},
    prelude::*,
};

/// Centre and half axes. Both lamps shine along the product of the two.
const QUAD: [Vec3; 3] = [
    Vec3::new(-1.25, 0.85, -0.4),
    Vec3::new(0.6, 0.0, -0.4),
    Vec3::new(0.12, 0.7, 0.18),
];
const STAR: [Vec3; 3] = [
    Vec3::new(1.2, 0.95, -0.5),
    Vec3::new(0.85, -0.15, 0.3),
    Vec3::new(0.15, 0.85, 0.0),
];
const QUAD_RADIANCE: Vec3 = Vec3::new(6.0, 2.1, 0.5);
const STAR_RADIANCE: Vec3 = Vec3::new(0.7, 2.0, 6.0);

fn main() {
    App::new()
        .add_plugins((DefaultPlugins, AreaLightPlugin))
        .insert_resource(ClearColor(Color::BLACK))
        .insert_resource(GlobalAmbientLight::NONE)
        .add_systems(Startup, setup)
        .run();
}

fn setup(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut lit: ResMut<Assets<LitMaterial>>,
    mut plain: ResMut<Assets<StandardMaterial>>,
) {
    let square = [
        Vec2::new(-1.0, -1.0),
        Vec2::new(1.0, -1.0),
        Vec2::ONE,
        Vec2::new(-1.0, 1.0),
    ];
    let outline: Vec<Vec2> = (0..10)
        .map(|k| {
            Vec2::from_angle((90.0 + 36.0 * k as f32).to_radians())
                * if k % 2 == 0 { 1.0 } else { 0.45 }
        })
        .collect();
    let star = placed(&outline, STAR);

    let lights = Lights {
        quad_center: QUAD[0],
        quad_half_u: QUAD[1],
        quad_half_v: QUAD[2],
        quad_radiance: QUAD_RADIANCE,
        star_radiance: STAR_RADIANCE,
        star: polygon::pack_polygon(&star, false)
            .try_into()
            .expect("eight elements and eleven points"),
    };
    commands.spawn((
        Mesh3d(meshes.add(Plane3d::default().mesh().size(24.0, 24.0))),
        MeshMaterial3d(lit.add(LitMaterial {
            base: StandardMaterial {
                base_color: Color::linear_rgb(0.4, 0.4, 0.4),
                metallic: 0.4,
                perceptual_roughness: 0.2,
                ..default()
            },
            extension: AreaLights { lights },
        })),
    ));

    // The lamps themselves.
    for (points, radiance) in [
        (placed(&square, QUAD), QUAD_RADIANCE),
        (star, STAR_RADIANCE),
    ] {
        commands.spawn((
            Mesh3d(meshes.add(fan(&points))),
            MeshMaterial3d(plain.add(StandardMaterial {
                base_color: Color::BLACK,
                reflectance: 0.0,
                emissive: LinearRgba::rgb(radiance.x, radiance.y, radiance.z),
                emissive_exposure_weight: 1.0,
                ..default()
            })),
        ));
    }

    commands.spawn((
        Camera3d::default(),
        Projection::from(PerspectiveProjection {
            fov: 34f32.to_radians(),
            ..default()
        }),
        Transform::from_xyz(0.0, 1.8, 6.0).looking_at(Vec3::new(0.0, 0.2, 0.0), Vec3::Y),
        Exposure { ev100: 0.7 }, // multiplies by 0.5
        Tonemapping::AcesFitted,
    ));
}

/// Points of an outline in units of a lamp's half axes.
fn placed(outline: &[Vec2], [center, half_u, half_v]: [Vec3; 3]) -> Vec<Vec3> {
    outline
        .iter()
        .map(|p| center + p.x * half_u + p.y * half_v)
        .collect()
}

/// Triangles around the middle of an outline.
fn fan(points: &[Vec3]) -> Mesh {
    let count = points.len() as u32;
    let middle = points.iter().sum::<Vec3>() / count as f32;
    let normal = (points[0] - middle).cross(points[1] - middle).normalize();
    let mut positions = points.to_vec();
    positions.push(middle);
    Mesh::new(
        PrimitiveTopology::TriangleList,
        RenderAssetUsages::default(),
    )
    .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, vec![normal; positions.len()])
    .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, positions)
    .with_inserted_indices(Indices::U32(
        (0..count)
            .flat_map(|i| [count, i, (i + 1) % count])
            .collect(),
    ))
}
