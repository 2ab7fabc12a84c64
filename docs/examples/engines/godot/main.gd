# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# A warm quad and a cool star over a dark floor, as in scenes/engines.glb. Metres, +Y up.

extends Node3D

# Both shine along half_u x half_v.
const QUAD := {center = Vector3(-1.25, 0.85, -0.4), half_u = Vector3(0.6, 0, -0.4), half_v = Vector3(0.12, 0.7, 0.18)}
const STAR := {center = Vector3(1.2, 0.95, -0.5), half_u = Vector3(0.85, -0.15, 0.3), half_v = Vector3(0.15, 0.85, 0)}
const QUAD_RADIANCE := Vector3(6, 2.1, 0.5)
const STAR_RADIANCE := Vector3(0.7, 2, 6)


func _ready() -> void:
	var square := PackedVector2Array([Vector2(-1, -1), Vector2(1, -1), Vector2(1, 1), Vector2(-1, 1)])
	var outline := PackedVector2Array()
	for k in 10:
		outline.append(Vector2.from_angle(deg_to_rad(90 + 36 * k)) * (1.0 if k % 2 == 0 else 0.45))
	add_lamp(placed(square, QUAD), QUAD_RADIANCE)
	add_lamp(placed(outline, STAR), STAR_RADIANCE)

	var material := ShaderMaterial.new()
	material.shader = load("res://floor.gdshader")
	material.set_shader_parameter("floor_color", Vector3(0.4, 0.4, 0.4))
	material.set_shader_parameter("floor_metallic", 0.4)
	material.set_shader_parameter("floor_roughness", 0.2)
	material.set_shader_parameter("quad_center", QUAD.center)
	material.set_shader_parameter("quad_half_u", QUAD.half_u)
	material.set_shader_parameter("quad_half_v", QUAD.half_v)
	material.set_shader_parameter("quad_radiance", QUAD_RADIANCE)
	material.set_shader_parameter("star_radiance", STAR_RADIANCE)
	material.set_shader_parameter("star", LtcPolygon.pack(placed(outline, STAR)))
	var plane := PlaneMesh.new()
	plane.size = Vector2(24, 24)
	add_mesh(plane, material)

	var camera := Camera3D.new()
	camera.fov = 34
	add_child(camera)
	camera.look_at_from_position(Vector3(0, 1.8, 6), Vector3(0, 0.2, 0))


## Points of an outline in units of a lamp's half axes.
func placed(outline: PackedVector2Array, lamp: Dictionary) -> PackedVector3Array:
	var points := PackedVector3Array()
	for p in outline:
		points.append(lamp.center + p.x * lamp.half_u + p.y * lamp.half_v)
	return points


## Shows a lamp: a fan of triangles around its middle. Godot's front is clockwise.
func add_lamp(points: PackedVector3Array, radiance: Vector3) -> void:
	var middle := Vector3.ZERO
	for p in points:
		middle += p / points.size()
	var triangles := SurfaceTool.new()
	triangles.begin(Mesh.PRIMITIVE_TRIANGLES)
	for i in points.size():
		for p in [middle, points[(i + 1) % points.size()], points[i]]:
			triangles.add_vertex(p)
	var material := ShaderMaterial.new()
	material.shader = load("res://lamp.gdshader")
	material.set_shader_parameter("radiance", radiance)
	add_mesh(triangles.commit(), material)


func add_mesh(mesh: Mesh, material: Material) -> void:
	var instance := MeshInstance3D.new()
	instance.mesh = mesh
	instance.material_override = material
	add_child(instance)
