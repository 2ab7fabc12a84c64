# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# A polygon light as the shader files want it: "polygon data" in ltc_lights.gdshaderinc.

class_name LtcPolygon


## The numbers of one polygon, four for each element. `points` are its corners in one plane, world space,
## counter-clockwise as seen from the side to which it shines; convex or not, without holes.
static func pack(points: PackedVector3Array, two_sided := false) -> PackedFloat32Array:
	var count := points.size()
	var origin := points[0]
	var sum := Vector3.ZERO
	for i in count:
		sum += (points[i] - origin).cross(points[(i + 1) % count] - origin)
	var area := sum.length() / 2.0
	var normal := sum.normalized()

	# Moments of the area in two axes of its plane: triangles (origin, a, b) with signed areas.
	var axis_u := (points[1] - origin).normalized()
	var axis_v := normal.cross(axis_u)
	var flat := PackedVector2Array()
	for p in points:
		flat.append(Vector2((p - origin).dot(axis_u), (p - origin).dot(axis_v)))
	var middle := Vector2.ZERO
	var xx := 0.0
	var yy := 0.0
	var xy := 0.0
	for i in count:
		var a := flat[i]
		var b := flat[(i + 1) % count]
		var share := a.cross(b) / 2.0 / area
		middle += share * (a + b) / 3.0
		xx += share * (a.x * a.x + a.x * b.x + b.x * b.x) / 6.0
		yy += share * (a.y * a.y + a.y * b.y + b.y * b.y) / 6.0
		xy += share * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y) / 12.0
	xx -= middle.x * middle.x
	yy -= middle.y * middle.y
	xy -= middle.x * middle.y

	# The principal axes of its spread.
	var angle := atan2(2.0 * xy, xx - yy) / 2.0
	var mean := (xx + yy) / 2.0
	var half := Vector2((xx - yy) / 2.0, xy).length()
	var along := Vector2.from_angle(angle) * sqrt(2.0 * (mean + half))
	var across := Vector2.from_angle(angle + PI / 2.0) * sqrt(2.0 * maxf(mean - half, 0.0))
	var radius := 0.0
	for p in flat:
		radius = maxf(radius, p.distance_to(middle))

	var numbers := PackedFloat32Array([count + 1, 1.0 if two_sided else 0.0, area, 0.0])
	numbers.append_array(element(origin, 0.0))
	numbers.append_array(element(Vector3.ZERO, 0.0))
	numbers.append_array(element(Vector3.ZERO, 0.0))
	numbers.append_array(element(normal, 0.0))
	numbers.append_array(element(origin + middle.x * axis_u + middle.y * axis_v, radius))
	numbers.append_array(element(along.x * axis_u + along.y * axis_v, 0.0))
	numbers.append_array(element(across.x * axis_u + across.y * axis_v, 0.0))
	for i in count + 1:
		numbers.append_array(element(points[i % count], 1.0 if i == 0 else 0.0))
	return numbers


static func element(v: Vector3, w: float) -> PackedFloat32Array:
	return PackedFloat32Array([v.x, v.y, v.z, w])
