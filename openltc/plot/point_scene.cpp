// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/point_scene.h"

#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::plot {

namespace {

struct Places {
  Vec3d camera, light;
};

double theta_rad(const PointSetup& setup) { return setup.theta_degrees * f64::k_pi / 180; }

Places place(const PointSetup& setup) {
  const double y = setup.distance_m * std::cos(theta_rad(setup));
  const double z = setup.distance_m * std::sin(theta_rad(setup));
  return {Vec3d(0, y, z), Vec3d(0, y, -z)};
}

// The camera's axes: it looks at the origin and sees the far side of the floor on top.
Vec3d forward_of(const PointSetup& setup) {
  return Vec3d(0, -std::cos(theta_rad(setup)), -std::sin(theta_rad(setup)));
}
Vec3d up_of(const PointSetup& setup) {
  return Vec3d(0, std::sin(theta_rad(setup)), -std::cos(theta_rad(setup)));
}

// The specular luminance where a ray meets the floor, up to a factor. The ray's slopes are those to
// the right of the camera's axis and above it.
double highlight(const PointSetup& setup, double roughness, double right, double above) {
  const Places at = place(setup);
  const Vec3d d = forward_of(setup) + Vec3d(1, 0, 0) * right + up_of(setup) * above;
  const Vec3d point = at.camera - d * (at.camera.y / d.y), to_light = at.light - point;
  const Vec3d wo_world = normalize(-d);
  const f64::Frame frame = f64::shading_frame(Vec3d(0, 1, 0), wo_world);
  const auto terms = f64::eval_ggx_terms(f64::to_shading(frame, wo_world),
                                         f64::to_shading(frame, normalize(to_light)),
                                         f64::alpha_from_roughness(roughness));
  return terms.scale / dot(to_light, to_light);
}

} // namespace

PointView frame_highlight(const PointSetup& setup, double roughness) {
  constexpr double k_faded = 0.03; // shares of the brightest point that end the picture
  constexpr double k_widest = 0.7; // slope
  constexpr int k_steps = 2000;
  PointView view;
  const double to_horizon = f64::k_pi / 2 - theta_rad(setup);
  const double highest = std::min(k_widest, std::tan(0.75 * to_horizon));
  const double aspect = double(view.width) / view.height;
  // Slopes are walked geometrically: highlights are as narrow as alpha.
  const auto slope = [&](int i, double last) {
    return last * std::pow(1e-5, 1 - double(i) / k_steps);
  };
  double brightest = 0;
  for (int i = 0; i <= k_steps; ++i)
    for (const double sign : {-1.0, 1.0})
      brightest = std::max(brightest, highlight(setup, roughness, 0, sign * slope(i, highest)));
  double reach = 1e-4;
  for (int i = 0; i <= k_steps; ++i) {
    const double above = slope(i, highest), right = slope(i, k_widest);
    for (const double sign : {-1.0, 1.0})
      if (highlight(setup, roughness, 0, sign * above) > k_faded * brightest)
        reach = std::max(reach, above);
    if (highlight(setup, roughness, right, 0) > k_faded * brightest)
      reach = std::max(reach, right / aspect);
  }
  view.tan_half_height = std::min(reach, highest);
  return view;
}

Vec2d floor_at(const PointSetup& setup, const PointView& view, int column, int row) {
  const double scale = 2 * view.tan_half_height / view.height; // square pixels
  const double sx = (column + 0.5 - 0.5 * view.width) * scale;
  const double sy = (0.5 * view.height - row - 0.5) * scale;
  const Vec3d d = forward_of(setup) + Vec3d(1, 0, 0) * sx + up_of(setup) * sy;
  const Vec3d origin = place(setup).camera;
  const double t = -origin.y / d.y;
  return Vec2d(origin.x + t * d.x, origin.z + t * d.z);
}

PointLuminance shade_floor(const PointSetup& setup, double roughness,
                           const fit::LobeFunction& lobes, Vec2d floor) {
  const Places at = place(setup);
  const Vec3d normal(0, 1, 0), point(floor.x, 0, floor.y);
  const Vec3d wo = normalize(at.camera - point), to_light = at.light - point;
  const double f0 = setup.f0 * (1 - setup.metallic) + setup.base_color * setup.metallic;
  const fit::MeasuredLobe fitted = lobes(roughness, dot(normal, wo));
  f64::Surface surface =
      f64::make_surface(fitted, point, normal, wo, Vec3d(setup.base_color * (1 - setup.metallic)),
                        Vec3d(f0), Vec3d(1.0), roughness);
  if (fitted.two()) surface = f64::add_second_lobe(surface, fitted.second);
  const Vec3d wi = f64::to_shading(surface.frame, normalize(to_light));
  const double illuminance = setup.intensity_cd / dot(to_light, to_light);
  return {f64::eval_surface(surface, wi).x * illuminance,
          f64::eval_surface_ltc(surface, wi).x * illuminance};
}

std::vector<ScanPoint> scan_highlight(const PointSetup& setup, const PointView& view, Scan scan,
                                      double roughness, const fit::LobeFunction& lobes) {
  std::vector<ScanPoint> points;
  const int count = scan == Scan::along ? view.height : view.width;
  for (int i = 0; i < count; ++i) {
    ScanPoint p;
    p.column = scan == Scan::along ? view.middle_column() : i;
    p.row = scan == Scan::along ? count - 1 - i : view.middle_row(); // from the near end
    const Vec2d floor = floor_at(setup, view, p.column, p.row);
    p.position_m = scan == Scan::along ? -floor.y : floor.x;
    p.luminance = shade_floor(setup, roughness, lobes, floor);
    points.push_back(p);
  }
  return points;
}

scene::Scene make_point_scene(const PointSetup& setup, const PointView& view, double roughness) {
  scene::Scene scene;
  scene::Material material;
  const auto base = float(setup.base_color);
  material.base_color = {base, base, base, 1};
  material.metallic = float(setup.metallic);
  material.roughness = float(roughness);
  material.ior = 0; // reflects all, so that the specular colour is F0
  material.specular_color = Vec3f(float(setup.f0));
  scene.materials.push_back(material);

  // As large as the view needs: positions are interpolated between corners, to within their size
  // times single precision.
  const Vec2d near = floor_at(setup, view, -1, view.height), far = floor_at(setup, view, -1, -1);
  const auto half = float(1.1 * std::max(std::abs(far.x), std::abs(near.x)));
  const auto front = float(near.y + 0.1 * (near.y - far.y));
  const auto back = float(far.y - 0.1 * (near.y - far.y));
  scene::Mesh mesh;
  mesh.name = "floor";
  mesh.positions = {{-half, 0, front}, {half, 0, front}, {half, 0, back}, {-half, 0, back}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.bounds = {{-half, 0, back}, {half, 0, front}};
  scene.meshes.push_back(std::move(mesh));

  light::PunctualLight light;
  light.name = "point";
  const Vec3d at = place(setup).light;
  light.position = {float(at.x), float(at.y), float(at.z)};
  light.intensity = Vec3f(float(setup.intensity_cd));
  scene.lights.punctual.push_back(light);
  return scene;
}

scene::Camera make_point_camera(const PointSetup& setup, const PointView& view) {
  scene::Camera camera;
  camera.position = to_float(place(setup).camera);
  camera.forward = to_float(forward_of(setup));
  camera.right = {1, 0, 0};
  camera.up = to_float(up_of(setup));
  camera.fov_y_rad = float(2 * std::atan(view.tan_half_height));
  return camera;
}

Result<PointPictures> render_point(const PointSetup& setup, const PointView& view, double roughness,
                                   const render::LobeSource& lobes) {
  const scene::Scene scene = make_point_scene(setup, view, roughness);
  const scene::Camera camera = make_point_camera(setup, view);
  render::RenderOptions options;
  options.width = view.width;
  options.height = view.height;
  options.samples = 1;
  options.shadow_samples = 0;
  options.filter = render::PixelFilter::none;
  PointPictures pictures;
  for (const render::PunctualForm form : {render::PunctualForm::exact, render::PunctualForm::ltc}) {
    options.punctual_form = form;
    const Result<render::Picture> picture = render::render(scene, camera, lobes, options);
    if (!picture) return picture.error();
    image::Image grey(view.width, view.height, 1);
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        *grey.pixel(x, y) = picture->radiance.rgb(x, y).x;
    (form == render::PunctualForm::exact ? pictures.exact : pictures.ltc) = std::move(grey);
  }
  return pictures;
}

} // namespace openltc::plot
