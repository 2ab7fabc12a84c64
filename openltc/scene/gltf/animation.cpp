// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// tinygltf does not see animations (document.cpp), so that they are checked here, each for
// itself: a damaged one that nobody asks for costs no picture.

#include "openltc/scene/gltf/animation.h"

#include "openltc/scene/gltf/file/accessor.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/keyframes.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::size_t k_most_named = 8;

struct Sampler {
  std::vector<double> times;
  Interpolation interpolation = Interpolation::linear;
  int output = -1;
  std::size_t values_per_key = 1; ///< 3 for a cubic spline
};

class AnimationReader {
public:
  AnimationReader(Document& document, const PoseOptions& options)
      : document_(document), model_(*document.model), options_(options) {}

  std::vector<NodePose> read(std::vector<Animation>& animations) {
    for (const FileAnimation& from : document_.animations) {
      try {
        animations.push_back({from.json.value("name", std::string()), duration_of(from.json)});
        readable_.push_back(&from);
      } catch (const Failure& failure) {
        document_.warnings.add(
            fmt::format("{}; animations[{}] cannot be played", failure.message, from.index));
      }
    }
    if (options_.is_rest()) {
      if (!animations.empty())
        document_.warnings.add(fmt::format("animations are not played; the rest pose is shown; "
                                           "openltc render --time SECONDS shows "
                                           "another: {}",
                                           listed(animations)));
      return {};
    }
    if (animations.empty() && options_.animation.empty()) {
      document_.warnings.add(
          "no time or animation can be chosen: the file has no animations; the rest pose is shown");
      return {};
    }
    return pose(*readable_[choose(animations)]);
  }

private:
  static std::string listed(const std::vector<Animation>& animations) {
    std::string text;
    for (std::size_t i = 0; i < std::min(animations.size(), k_most_named); ++i)
      text += fmt::format("{}{} \"{}\" of {:.4g} s", i == 0 ? "" : ", ", i,
                          animations[i].name.substr(0, 60), animations[i].duration_seconds);
    if (animations.size() > k_most_named)
      text += fmt::format(", and {} more", animations.size() - k_most_named);
    return text;
  }

  std::size_t choose(const std::vector<Animation>& animations) const {
    const std::string& choice = options_.animation;
    if (choice.empty()) return 0;
    for (std::size_t i = 0; i < animations.size(); ++i)
      if (animations[i].name == choice) return i;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
    if (error == std::errc() && end == choice.data() + choice.size() && index < animations.size())
      return index;
    fail("animations",
         fmt::format("there is no animation \"{}\"; there {}", choice.substr(0, 60),
                     animations.empty() ? std::string("are none") : "are " + listed(animations)));
  }

  // Key times are shared by most channels.
  const std::vector<double>& times_of(int accessor) {
    const auto [place, is_new] = times_.try_emplace(accessor);
    std::vector<double>& times = place->second;
    if (is_new) {
      const Floats floats = read_floats(document_, accessor);
      if (floats.components == 1) times.assign(floats.values.begin(), floats.values.end());
    }
    if (times.empty()) fail(accessor_field(accessor) + ".type", "key times must be SCALAR");
    for (std::size_t i = 0; i < times.size(); ++i)
      if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
        fail(accessor_field(accessor),
             fmt::format("key {} is at {} s, not behind the one before it; export the file again",
                         i, times[i]));
    return times;
  }

  double duration_of(const json& animation) {
    double duration = 0;
    for (const json& sampler : animation["samplers"])
      duration = std::max(duration, times_of(sampler["input"].get<int>()).back());
    return duration;
  }

  Sampler sampler_of(const json& from) {
    Sampler sampler;
    sampler.times = times_of(from["input"].get<int>());
    const std::string mode = from.value("interpolation", std::string("LINEAR"));
    if (mode == "STEP") sampler.interpolation = Interpolation::step;
    if (mode == "CUBICSPLINE") sampler.interpolation = Interpolation::cubic_spline;
    sampler.values_per_key = sampler.interpolation == Interpolation::cubic_spline ? 3 : 1;
    sampler.output = from["output"].get<int>();
    return sampler;
  }

  std::vector<NodePose> pose(const FileAnimation& chosen) {
    const json& animation = chosen.json;
    std::vector<NodePose> poses(model_.nodes.size());
    for (std::size_t c = 0; c < animation["channels"].size(); ++c) {
      const json& channel = animation["channels"][c];
      const std::string field = fmt::format("animations[{}].channels[{}]", chosen.index, c);
      const json& target = channel["target"];
      if (!target.contains("node")) continue; // what extensions animate; the specification: ignored
      const std::size_t node = target["node"].get<std::size_t>();
      try {
        const std::size_t sampler = channel["sampler"].get<std::size_t>();
        if (sampler >= animation["samplers"].size())
          fail(field + ".sampler", fmt::format("points at sampler {}, but there are only {}",
                                               sampler, animation["samplers"].size()));
        apply(sampler_of(animation["samplers"][sampler]), target["path"].get<std::string>(), node,
              field, poses[node]);
      } catch (const Failure& failure) {
        document_.warnings.add(failure.message + "; this channel is left out");
      }
    }
    return poses;
  }

  void apply(const Sampler& sampler, const std::string& path, std::size_t node,
             const std::string& field, NodePose& pose) {
    const bool is_weights = path == "weights", is_rotation = path == "rotation";
    const bool is_known = is_weights || is_rotation || path == "translation" || path == "scale";
    if (!is_known)
      fail(field + ".target.path", fmt::format("\"{}\" is not known", path.substr(0, 60)));
    if (!is_weights && model_.nodes[node].matrix.size() == 16)
      fail(field + ".target.node",
           fmt::format("nodes[{}] has a matrix, which cannot be animated; export the file with "
                       "translation, rotation and scale",
                       node));
    const std::vector<double> value = value_of(sampler, is_rotation, is_weights, node, field);
    if (is_weights)
      pose.weights = value;
    else if (is_rotation)
      pose.rotation = {value[0], value[1], value[2], value[3]};
    else
      (path == "scale" ? pose.scale : pose.translation) = Vec3d(value[0], value[1], value[2]);
  }

  std::vector<double> value_of(const Sampler& sampler, bool is_rotation, bool is_weights,
                               std::size_t node, const std::string& field) {
    const tinygltf::Accessor& accessor = model_.accessors[std::size_t(sampler.output)];
    const std::size_t components = is_weights ? 1 : is_rotation ? 4 : 3;
    std::size_t per_value = 1; // elements of the accessor
    if (is_weights) per_value = target_count(node);
    const std::size_t per_key = sampler.values_per_key * per_value;
    if (per_key == 0 || accessor.count != sampler.times.size() * per_key)
      fail(accessor_field(sampler.output) + ".count",
           fmt::format("has {} values for {} keys of {} each, in {}", accessor.count,
                       sampler.times.size(), per_key, field));
    const KeySpan span =
        find_span(sampler.times, options_.time_seconds.value_or(0), sampler.interpolation);
    const std::size_t keys = span.at_key ? 1 : 2;
    const Floats floats =
        read_floats(document_, sampler.output, span.first * per_key, keys * per_key);
    if (floats.components != components)
      fail(accessor_field(sampler.output) + ".type",
           fmt::format("has {} components, but {} needs {}", floats.components, field, components));
    const std::vector<double> values(floats.values.begin(), floats.values.end());
    for (const double v : values)
      if (!std::isfinite(v)) fail(accessor_field(sampler.output), "a value is not a number");
    const std::size_t key_size = per_key * components;
    const std::span<const double> from(values.data(), key_size);
    const auto to = std::span<const double>(values).subspan(keys == 2 ? key_size : 0);
    return value_at(span, from, to, per_value * components, sampler.interpolation, is_rotation);
  }

  std::size_t target_count(std::size_t node) const {
    const int mesh = model_.nodes[node].mesh;
    if (mesh < 0) return 0;
    const auto& primitives = model_.meshes[std::size_t(mesh)].primitives;
    return primitives.empty() ? 0 : primitives[0].targets.size();
  }

  Document& document_;
  const tinygltf::Model& model_;
  const PoseOptions& options_;
  std::vector<const FileAnimation*> readable_;
  std::map<int, std::vector<double>> times_;
};

} // namespace

std::vector<NodePose> read_pose(Document& document, const PoseOptions& options,
                                std::vector<Animation>& animations) {
  return AnimationReader(document, options).read(animations);
}

} // namespace openltc::scene::gltf
