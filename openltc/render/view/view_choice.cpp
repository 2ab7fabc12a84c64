// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A view is worth the sum, over points of the subject, of what their visible side is worth times
// the root of the cosine to the camera, times a preference that makes pictures of plain objects
// look alike. Every number here is one of taste; the tests state what must come of them.

#include "openltc/render/view/view_choice.h"

#include "openltc/base/parallel.h"
#include "openltc/render/view/sight_lines.h"
#include "openltc/render/view/view_samples.h"
#include "openltc/scene/view/framing.h"
#include "openltc/scene/view/subject.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace openltc::render {

namespace {

constexpr double k_degree = std::numbers::pi / 180;

/// A direction to look from and how well people like it.
struct Preference {
  double degrees, liking;
};
// glTF's front is +Z: from behind one looks only where there is much more to see.
constexpr Preference k_azimuths[] = {{30, 1},     {-30, 1},    {0, 0.97},    {60, 0.92},
                                     {-60, 0.92}, {90, 0.85},  {-90, 0.85},  {120, 0.8},
                                     {-120, 0.8}, {150, 0.77}, {-150, 0.77}, {180, 0.77}};
constexpr Preference k_elevations[] = {{20, 1}, {5, 0.95}, {45, 0.92}, {70, 0.75}};
constexpr double k_liking_of_usual_view = 1.12;
constexpr double k_liking_of_inside = 0.7;
// In front of a wall: a short lens, as in pictures of rooms, and not touching it.
constexpr double k_widest_fov_rad = 58 * k_degree;
constexpr double k_before_wall = 0.92;
constexpr double k_off_surface = 1e-4; // of the scene's diagonal

struct Candidate {
  scene::Camera camera;
  double liking = 1;
  double value = 0;
};

class Chooser {
public:
  Chooser(const scene::Scene& scene, const scene::Subject& subject, const SightLines& sight,
          float aspect)
      : subject_(subject), sight_(sight), aspect_(aspect), points_(points_of(scene, subject)),
        samples_(sample_subject(scene, subject, sight)),
        middle_((to_double(subject.bounds.lower) + to_double(subject.bounds.upper)) * 0.5),
        off_surface_(k_off_surface * scene::diagonal(scene.bounds)) {}

  scene::Camera best() {
    add(scene::three_quarter_view(subject_.bounds), k_liking_of_usual_view);
    for (const Preference& elevation : k_elevations)
      for (const Preference& azimuth : k_azimuths)
        add(scene::view_from(azimuth.degrees * k_degree, elevation.degrees * k_degree),
            azimuth.liking * elevation.liking);
    // A card is looked at straight, but one that lies on the floor from one's place before it.
    const Vec3d normal = subject_.flat_normal;
    if (length(normal) > 0 && std::abs(normal.y) < 0.9) {
      add(normal, 1);
      add(-normal, normal.z > 0 ? 0.97 : 1.03);
    }
    parallel_for(std::int64_t(candidates_.size()), 0, [&](std::int64_t i) {
      Candidate& candidate = candidates_[std::size_t(i)];
      candidate.value = candidate.liking * seen_by(candidate.camera);
    });
    const auto best =
        std::max_element(candidates_.begin(), candidates_.end(),
                         [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
    return best->camera;
  }

private:
  void add(Vec3d back, double liking) {
    const scene::Camera framed = scene::frame_subject(points_, subject_, back, aspect_);
    candidates_.push_back({framed, liking});
    // Where a wall stands before that camera, one in front of the wall.
    const double distance = length(to_double(framed.position) - middle_);
    const double free = sight_.free_distance(middle_, back, distance);
    if (!(free < distance)) return;
    const double to_camera = k_before_wall * free;
    const double widening = distance / to_camera;
    const double fov = std::min(2 * std::atan(std::tan(0.5 * scene::k_framed_fov_rad) * widening),
                                k_widest_fov_rad);
    scene::Camera inside = scene::camera_along(back, fov, aspect_);
    inside.position = to_float(middle_ + back * to_camera);
    inside.near = float(1e-3 * to_camera);
    candidates_.push_back({inside, liking * (subject_.has_backdrop ? 0.95 : k_liking_of_inside)});
  }

  double seen_by(const scene::Camera& camera) const {
    const Vec3d eye = to_double(camera.position), forward = to_double(camera.forward);
    const Vec3d right = to_double(camera.right), up = to_double(camera.up);
    const double tan_y = std::tan(0.5 * double(camera.fov_y_rad));
    const double tan_x = tan_y * (aspect_ > 0 ? double(aspect_) : 1);
    std::vector<SightLine> lines;
    std::vector<double> values;
    for (const ViewSample& sample : samples_) {
      const Vec3d offset = sample.position - eye;
      const double depth = dot(offset, forward);
      if (depth <= double(camera.near) || std::abs(dot(offset, right)) > tan_x * depth ||
          std::abs(dot(offset, up)) > tan_y * depth)
        continue;
      const double cosine = -dot(sample.normal, offset) / length(offset);
      if (cosine <= 0 && !sample.two_sided) continue;
      const Vec3d from = sample.position + sample.normal * std::copysign(off_surface_, cosine);
      lines.push_back({from, eye});
      values.push_back(sample.worth[cosine > 0 ? 0 : 1] * std::sqrt(std::abs(cosine)));
    }
    sight_.trace(lines, SightLines::Blocks::what_is_seen);
    double sum = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].is_free) sum += values[i];
    return sum;
  }

  const scene::Subject& subject_;
  const SightLines& sight_;
  float aspect_;
  std::vector<Vec3f> points_;
  std::vector<ViewSample> samples_;
  Vec3d middle_;
  double off_surface_;
  std::vector<Candidate> candidates_;
};

} // namespace

Result<scene::Camera> choose_view(const scene::Scene& scene, float aspect) {
  const scene::Subject subject = scene::find_subject(scene);
  if (!(scene::diagonal(subject.bounds) > 0)) return scene::frame_scene(scene.bounds, aspect);
  const Result<SightLines> sight = SightLines::create(scene);
  if (!sight) return sight.error();
  return Chooser(scene, subject, *sight, aspect).best();
}

} // namespace openltc::render
