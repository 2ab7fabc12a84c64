// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Channels by their names, as programs write them, and which layer a name means.

#include "openltc/image/file.h"
#include "openltc/image/layer.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

using namespace openltc;
using namespace openltc::image;

namespace {

std::vector<LayerInfo> one_part(const std::vector<std::string>& channels) {
  return sort_into_layers({{"", true, channels}});
}

// "name: kind (channels)", one a line.
std::string shown(const std::vector<LayerInfo>& layers) {
  std::string text;
  for (const LayerInfo& layer : layers) {
    text += layer.name + ": " + name_of(layer.kind) + " (";
    for (const std::string& channel : layer.channels)
      text += (text.back() == '(' ? "" : " ") + channel;
    text += ")\n";
  }
  return text;
}

std::string chosen(const std::vector<LayerInfo>& layers, const std::string& wanted) {
  const Result<LayerInfo> layer = choose_layer(layers, wanted, "f.exr");
  if (layer) return layer->name;
  CHECK(layer.error().message.rfind("f.exr: ", 0) == 0);
  return "refused: " + layer.error().message;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a plain picture and its layers") {
  CHECK(shown(one_part({"A", "B", "G", "R", "Z", "stderr.B", "stderr.G", "stderr.R"})) ==
        ": colour (R G B A)\nZ: one channel (Z)\nstderr: colour (stderr.R stderr.G stderr.B)\n");
  CHECK(shown(one_part({"Y"})) == ": grey (Y)\n");
  CHECK(shown(one_part({"A", "Y"})) == ": grey (Y A)\n");
  CHECK(shown(one_part({"BY", "RY", "Y"})) == ": luminance and chroma (Y RY BY)\n");
  CHECK(shown(one_part({"A", "BY", "RY", "Y"})) == ": luminance and chroma (Y RY BY A)\n");
  CHECK(shown(one_part({"X", "Y", "Z"})) == ": CIE XYZ (X Y Z)\n");
}

TEST_CASE("the layers of a Blender file") {
  const auto layers =
      one_part({"ViewLayer.Combined.A", "ViewLayer.Combined.B", "ViewLayer.Combined.G",
                "ViewLayer.Combined.R", "ViewLayer.Depth.Z", "ViewLayer.IndexOB.X",
                "ViewLayer.Normal.X", "ViewLayer.Normal.Y", "ViewLayer.Normal.Z", "ViewLayer.UV.A",
                "ViewLayer.UV.U", "ViewLayer.UV.V", "ViewLayer.Vector.W", "ViewLayer.Vector.X",
                "ViewLayer.Vector.Y", "ViewLayer.Vector.Z"});
  CHECK(
      shown(layers) ==
      R"(ViewLayer.Combined: colour (ViewLayer.Combined.R ViewLayer.Combined.G ViewLayer.Combined.B ViewLayer.Combined.A)
ViewLayer.Depth: one channel (ViewLayer.Depth.Z)
ViewLayer.IndexOB: one channel (ViewLayer.IndexOB.X)
ViewLayer.Normal: vector (ViewLayer.Normal.X ViewLayer.Normal.Y ViewLayer.Normal.Z)
ViewLayer.UV.A: one channel (ViewLayer.UV.A)
ViewLayer.UV.U: one channel (ViewLayer.UV.U)
ViewLayer.UV.V: one channel (ViewLayer.UV.V)
ViewLayer.Vector: vector (ViewLayer.Vector.X ViewLayer.Vector.Y ViewLayer.Vector.Z)
ViewLayer.Vector.W: one channel (ViewLayer.Vector.W)
)");
  CHECK(chosen(layers, "") == "ViewLayer.Combined"); // the only one of colour
  CHECK(chosen(layers, "ViewLayer.Combined") == "ViewLayer.Combined");
  CHECK(chosen(layers, "Combined") == "ViewLayer.Combined");
  CHECK(chosen(layers, "Depth") == "ViewLayer.Depth");
  CHECK(chosen(layers, "ViewLayer.Depth.Z") == "ViewLayer.Depth");
  CHECK(has(chosen(layers, "ViewLayer"), "refused: f.exr: the layer 'ViewLayer' may be one of"));
  CHECK(has(chosen(layers, "Mist"), "no layer 'Mist' in the file; its layers are "
                                    "'ViewLayer.Combined', 'ViewLayer.Depth'"));
}

TEST_CASE("several pictures are never chosen between") {
  const auto layers = one_part({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B", "c.Y", "depth"});
  CHECK(has(chosen(layers, ""),
            "holds several pictures; name one as FILE:NAME, or by openltc compare --layer NAME: "
            "'a', 'b'"));
  CHECK(chosen(layers, "b") == "b");
  CHECK(chosen(one_part({"a.Y", "depth"}), "") == "a");
  CHECK(has(chosen(one_part({"R", "G"}), ""), "no picture"));
  CHECK(has(chosen(one_part({"N.X", "N.Y", "N.Z"}), ""), "no picture"));
  CHECK(chosen(one_part({"R", "G"}), "G") == "G");
}

TEST_CASE("small letters, words, and X Y Z that are light") {
  CHECK(shown(one_part({"d.red", "d.green", "d.blue", "d.alpha"})) ==
        "d: colour (d.red d.green d.blue d.alpha)\n");
  CHECK(shown(one_part({"n.x", "n.y", "n.z"})) == "n: vector (n.x n.y n.z)\n");
  CHECK(shown(one_part({"R", "G", "B", "r"})) == ": colour (R G B)\nr: one channel (r)\n");
  CHECK(one_part({"color.X", "color.Y", "color.Z"})[0].kind == LayerKind::xyz);
  CHECK(one_part({"L.Beauty.X", "L.Beauty.Y", "L.Beauty.Z"})[0].kind == LayerKind::xyz);
  CHECK(one_part({"ColorNormal.X", "ColorNormal.Y", "ColorNormal.Z"})[0].kind == LayerKind::vector);
}

TEST_CASE("the layers of many parts") {
  const auto layers = sort_into_layers({{"left", true, {"R", "G", "B", "Z"}},
                                        {"depth", true, {"Z"}},
                                        {"deep", false, {"Z"}},
                                        {"crypto", true, {"crypto.id.R", "crypto.id.G"}},
                                        {"aov", true, {"spec.R", "spec.G", "spec.B"}}});
  CHECK(shown(layers) == R"(left: colour (R G B)
left.Z: one channel (Z)
depth: one channel (Z)
deep: deep data (Z)
crypto.id.G: one channel (crypto.id.G)
crypto.id.R: one channel (crypto.id.R)
aov.spec: colour (spec.R spec.G spec.B)
)");
  CHECK(layers[1].part == 0);
  CHECK(layers[6].part == 4);
  CHECK(has(chosen(layers, ""), "'left', 'aov.spec'"));
  CHECK(chosen(layers, "spec") == "aov.spec");
  CHECK(chosen(layers, "left") == "left");
  CHECK(has(chosen(layers, "deep"), "deep data"));
  // Two names that meet stay apart.
  const auto meeting =
      sort_into_layers({{"a", true, {"b.R", "b.G", "b.B"}}, {"a.b", true, {"R", "G", "B"}}});
  CHECK(chosen(meeting, "a.b") == "a.b");
  CHECK(chosen(meeting, "a.b#2") == "a.b#2");
}

TEST_CASE("FILE:LAYER is cut behind .exr, unless there is a file of that name") {
  const auto cut = [](const std::string& name) {
    const PictureName cut_name = split_picture_name(name);
    return cut_name.path + " | " + cut_name.layer;
  };
  CHECK(cut("a.exr") == "a.exr | ");
  CHECK(cut("a.exr:L") == "a.exr | L");
  CHECK(cut("dir:1/a.EXR:L.x:y") == "dir:1/a.EXR | L.x:y");
  CHECK(cut("a.png:L") == "a.png:L | ");
  CHECK(cut("a.exr:") == "a.exr | ");
  const test::TemporaryFolder folder;
  test::write_bytes(folder.file("a.exr:L"), {1});
  CHECK(cut(folder.file("a.exr:L")) == folder.file("a.exr:L") + " | ");
}
