// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//! A polygon light as the shader files want it: "polygon data" in ltc_lights.wgsl.

use bevy::math::{Vec2, Vec3, Vec4};

/// The elements of one polygon. `points` are its corners in one plane, world space, counter-clockwise as seen from
/// the side to which it shines; convex or not, without holes.
pub fn pack_polygon(points: &[Vec3], two_sided: bool) -> Vec<Vec4> {
    let origin = points[0];
    let next = |i: usize| (i + 1) % points.len();
    let sum: Vec3 = (0..points.len())
        .map(|i| (points[i] - origin).cross(points[next(i)] - origin))
        .sum();
    let (area, normal) = (sum.length() / 2.0, sum.normalize());

    // Moments of the area in two axes of its plane: triangles (origin, a, b) with signed areas.
    let axis_u = (points[1] - origin).normalize();
    let axis_v = normal.cross(axis_u);
    let flat: Vec<Vec2> = points
        .iter()
        .map(|&p| Vec2::new((p - origin).dot(axis_u), (p - origin).dot(axis_v)))
        .collect();
    let (mut middle, mut xx, mut yy, mut xy) = (Vec2::ZERO, 0.0, 0.0, 0.0);
    for (i, &a) in flat.iter().enumerate() {
        let b = flat[next(i)];
        let share = a.perp_dot(b) / 2.0 / area;
        middle += share * (a + b) / 3.0;
        xx += share * (a.x * a.x + a.x * b.x + b.x * b.x) / 6.0;
        yy += share * (a.y * a.y + a.y * b.y + b.y * b.y) / 6.0;
        xy += share * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y) / 12.0;
    }
    let (xx, yy, xy) = (
        xx - middle.x * middle.x,
        yy - middle.y * middle.y,
        xy - middle.x * middle.y,
    );

    // The principal axes of its spread.
    let along = Vec2::from_angle((2.0 * xy).atan2(xx - yy) / 2.0);
    let (mean, half) = ((xx + yy) / 2.0, Vec2::new((xx - yy) / 2.0, xy).length());
    let spread_u = along * (2.0 * (mean + half)).sqrt();
    let spread_v = along.perp() * (2.0 * (mean - half).max(0.0)).sqrt();
    let radius = flat.iter().map(|p| p.distance(middle)).fold(0.0, f32::max);

    let world = |p: Vec2| axis_u * p.x + axis_v * p.y;
    let mut elements = vec![
        Vec4::new(
            (points.len() + 1) as f32,
            if two_sided { 1.0 } else { 0.0 },
            area,
            0.0,
        ),
        origin.extend(0.0),
        Vec4::ZERO,
        Vec4::ZERO,
        normal.extend(0.0),
        (origin + world(middle)).extend(radius),
        world(spread_u).extend(0.0),
        world(spread_v).extend(0.0),
    ];
    elements.extend(
        points
            .iter()
            .enumerate()
            .map(|(i, p)| p.extend(if i == 0 { 1.0 } else { 0.0 })),
    );
    elements.push(origin.extend(0.0));
    elements
}
