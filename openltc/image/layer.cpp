// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace openltc::image {

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return out;
}

// "red" and "R" are "r"; everything else in small letters.
std::string component_of(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> words = {
      {{"red", "r"}, {"green", "g"}, {"blue", "b"}, {"alpha", "a"}}};
  const std::string small = lower(name);
  for (const auto& [word, letter] : words)
    if (small == word) return std::string(letter);
  return small;
}

// X Y Z are CIE XYZ in a picture without a name. Below a name they are nearly always coordinates
// (Blender's Normal, Arnold's N and P, Mitsuba's nn), unless the name speaks of light.
bool speaks_of_color(const std::string& layer) {
  const std::string last = lower(layer.substr(layer.rfind('.') + 1)); // npos + 1 is 0
  if (layer.empty() || last == "light") return true;
  for (const char* word : {"normal", "position", "vector", "direction", "velocity"})
    if (last.find(word) != std::string::npos) return false;
  for (const char* word :
       {"xyz", "cie", "color", "colour", "combined", "beauty", "radiance", "luminance", "rgb",
        "image", "picture", "diffuse", "specular", "glossy", "emission"})
    if (last.find(word) != std::string::npos) return true;
  return false;
}

// The channels of one part below one prefix, by what stands behind the last dot.
class Group {
public:
  void add(const std::string& component, const std::string& channel) {
    const std::string key = component_of(component);
    // The spelling of the standard goes before others of the same channel.
    const bool standard =
        component.size() <= 2 && std::all_of(component.begin(), component.end(),
                                             [](unsigned char c) { return std::isupper(c) != 0; });
    const auto [at, is_new] = channels_.emplace(key, channel);
    if (is_new) return;
    if (standard) std::swap(at->second, others_.emplace_back(channel));
    if (!standard) others_.push_back(channel);
  }

  bool has(const char* component) const { return channels_.count(component) != 0; }

  /// Takes these channels out, and alpha where there is one.
  std::vector<std::string> take(std::initializer_list<const char*> components, bool with_alpha) {
    std::vector<std::string> names;
    for (const char* component : components)
      take_one(component, names);
    if (with_alpha && has("a")) take_one("a", names);
    return names;
  }

  /// What is left.
  std::vector<std::string> rest() const {
    std::vector<std::string> names = others_;
    for (const auto& [component, channel] : channels_)
      names.push_back(channel);
    return names;
  }

private:
  void take_one(const char* component, std::vector<std::string>& names) {
    const auto at = channels_.find(component);
    names.push_back(at->second);
    channels_.erase(at);
  }

  std::map<std::string, std::string> channels_;
  std::vector<std::string> others_;
};

// The name of a layer of a part of many: PART, PART.LAYER, or LAYER where that has PART in it.
std::string name_in_part(const std::string& part, const std::string& layer) {
  if (part.empty() || layer == part || layer.rfind(part + ".", 0) == 0) return layer;
  return layer.empty() ? part : part + "." + layer;
}

void add_group(Group& group, const std::string& prefix, const LayerInfo& base,
               std::vector<LayerInfo>& layers) {
  const std::string name = name_in_part(base.part_name, prefix);
  const std::size_t before = layers.size();
  const auto add = [&](const std::string& layer_name, LayerKind kind,
                       std::vector<std::string> channels) {
    LayerInfo& layer = layers.emplace_back(base);
    layer.name = layer_name;
    layer.kind = kind;
    layer.channels = std::move(channels);
  };
  if (group.has("r") && group.has("g") && group.has("b"))
    add(name, LayerKind::color, group.take({"r", "g", "b"}, true));
  else if (group.has("y") && group.has("ry") && group.has("by"))
    add(name, LayerKind::luminance_chroma, group.take({"y", "ry", "by"}, true));
  else if (group.has("x") && group.has("y") && group.has("z"))
    speaks_of_color(name) ? add(name, LayerKind::xyz, group.take({"x", "y", "z"}, true))
                          : add(name, LayerKind::vector, group.take({"x", "y", "z"}, false));
  else if (group.has("y") && !group.has("x") && !group.has("ry") && !group.has("by"))
    add(name, LayerKind::grey, group.take({"y"}, true));
  const std::vector<std::string> rest = group.rest();
  // A channel alone below its prefix goes by that: "Depth" for Depth.Z.
  if (layers.size() == before && rest.size() == 1 && !name.empty()) {
    add(name, LayerKind::channel, rest);
    return;
  }
  for (const std::string& channel : rest)
    add(name_in_part(base.part_name, channel), LayerKind::channel, {channel});
}

std::string list_of(const std::vector<LayerInfo>& layers) {
  constexpr std::size_t most = 24;
  std::string text;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i == most) return text + fmt::format(" and {} more", layers.size() - most);
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", layers[i].name);
  }
  return text;
}

bool is_color(LayerKind kind) { return is_picture(kind) && kind != LayerKind::grey; }

} // namespace

const char* name_of(LayerKind kind) {
  switch (kind) {
  case LayerKind::color:
    return "colour";
  case LayerKind::luminance_chroma:
    return "luminance and chroma";
  case LayerKind::xyz:
    return "CIE XYZ";
  case LayerKind::grey:
    return "grey";
  case LayerKind::vector:
    return "vector";
  case LayerKind::channel:
    return "one channel";
  case LayerKind::not_flat:
    break;
  }
  return "deep data";
}

bool is_picture(LayerKind kind) {
  return kind == LayerKind::color || kind == LayerKind::luminance_chroma ||
         kind == LayerKind::xyz || kind == LayerKind::grey;
}

std::string describe(const Window& window) {
  if (window.width == 0 || window.height == 0) return "none";
  return fmt::format("{}x{} from ({}, {})", window.width, window.height, window.x, window.y);
}

std::vector<LayerInfo> sort_into_layers(const std::vector<PartChannels>& parts) {
  std::vector<LayerInfo> layers;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    LayerInfo base;
    base.part = int(p);
    base.part_name = parts.size() > 1 ? parts[p].name : "";
    std::vector<LayerInfo> found;
    if (!parts[p].flat) {
      base.name = base.part_name;
      base.kind = LayerKind::not_flat;
      base.channels = parts[p].channels;
      found.push_back(base);
    } else {
      std::map<std::string, Group> groups;
      for (const std::string& channel : parts[p].channels) {
        const std::size_t dot = channel.rfind('.');
        const bool has_prefix = dot != std::string::npos;
        groups[has_prefix ? channel.substr(0, dot) : ""].add(
            has_prefix ? channel.substr(dot + 1) : channel, channel);
      }
      for (auto& [prefix, group] : groups)
        add_group(group, prefix, base, found);
    }
    std::sort(found.begin(), found.end(),
              [](const LayerInfo& a, const LayerInfo& b) { return a.name < b.name; });
    layers.insert(layers.end(), found.begin(), found.end());
  }
  // Names that meet, such as a part "a.b" and a layer "b" of a part "a", are told apart by number.
  std::set<std::string> names;
  for (LayerInfo& layer : layers) {
    const std::string name = layer.name;
    for (int k = 2; !names.insert(layer.name).second; ++k)
      layer.name = fmt::format("{}#{}", name, k);
  }
  return layers;
}

Result<LayerInfo> choose_layer(const std::vector<LayerInfo>& layers, const std::string& wanted,
                               const std::string& file) {
  const auto only = [&](auto&& fits) -> std::vector<LayerInfo> {
    std::vector<LayerInfo> found;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(found), fits);
    return found;
  };
  const auto refuse = [&](const std::string& what, const std::vector<LayerInfo>& which) {
    return Error{fmt::format("{}: {} {}", file, what, list_of(which))};
  };
  std::vector<LayerInfo> found;
  if (wanted.empty()) {
    found = only([](const LayerInfo& l) { return l.name.empty() && is_picture(l.kind); });
    if (found.empty()) found = only([](const LayerInfo& l) { return is_color(l.kind); });
    if (found.empty()) found = only([](const LayerInfo& l) { return is_picture(l.kind); });
    if (found.size() > 1)
      return refuse(
          "holds several pictures; name one as FILE:NAME, or by openltc compare --layer NAME:",
          found);
    if (found.empty() && layers.size() == 1 && layers[0].kind == LayerKind::not_flat)
      return Error{fmt::format("{}: holds deep data (several values a pixel), which is not read; "
                               "save it flattened",
                               file)};
    if (found.empty())
      return refuse("no picture (channels R, G, B or Y) in the file; its layers are", layers);
  } else {
    found = only([&](const LayerInfo& l) { return l.name == wanted; });
    if (found.empty())
      found = only([&](const LayerInfo& l) {
        return l.kind == LayerKind::channel && l.channels[0] == wanted;
      });
    if (found.empty())
      found = only([&](const LayerInfo& l) {
        return l.name.rfind(wanted + ".", 0) == 0 ||
               (l.name.size() > wanted.size() && l.name.ends_with("." + wanted));
      });
    if (found.empty())
      return refuse(fmt::format("no layer '{}' in the file; its layers are", wanted), layers);
    if (found.size() > 1) return refuse(fmt::format("the layer '{}' may be one of", wanted), found);
  }
  if (found[0].kind == LayerKind::not_flat)
    return Error{fmt::format("{}: the part '{}' holds deep data (several values a pixel), which is "
                             "not read; save it flattened",
                             file, found[0].name)};
  return found[0];
}

} // namespace openltc::image
