// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/skin.h"

#include "openltc/scene/gltf/file/accessor.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <cmath>

namespace openltc::scene::gltf {

std::vector<Transform> joint_transforms(const Document& document, std::size_t skin,
                                        std::span<const Transform> to_world) {
  const nlohmann::json& from = document.skins[skin];
  const std::string field = fmt::format("skins[{}]", skin);
  if (from.is_null()) fail(field, "cannot be read");
  const auto joints = from["joints"].get<std::vector<std::size_t>>();
  if (joints.empty()) fail(field + ".joints", "there are none");
  std::vector<Transform> transforms;
  for (const std::size_t joint : joints)
    transforms.push_back(to_world[joint]);
  if (!from.contains("inverseBindMatrices")) return transforms;

  const auto matrices = read_matrices(document, from["inverseBindMatrices"].get<int>());
  if (matrices.size() < joints.size())
    fail(field + ".inverseBindMatrices",
         fmt::format("has {} matrices for {} joints; export the file again", matrices.size(),
                     joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    Transform inverse_bind;
    for (std::size_t c = 0; c < 4; ++c) {
      const float* column = matrices[i].data() + 4 * c;
      for (std::size_t row = 0; row < 3; ++row)
        if (!std::isfinite(column[row]))
          fail(field + ".inverseBindMatrices", fmt::format("matrix {} holds no numbers", i));
      inverse_bind.column[c] = Vec3d(double(column[0]), double(column[1]), double(column[2]));
    }
    transforms[i] = compose(transforms[i], inverse_bind);
  }
  return transforms;
}

} // namespace openltc::scene::gltf
