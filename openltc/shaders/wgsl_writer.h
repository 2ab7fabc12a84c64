// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What WGSL has of its own: types behind names, parameters that stay as they are, select for a
// conditional, and brackets that it asks for.

#pragma once

#include "openltc/shaders/writer.h"

namespace openltc::shaders {

/// Writes WGSL.
class WgslWriter : public Writer {
public:
  using Writer::Writer;

private:
  std::string constant(const Item& item) override;
  std::string structure(const Item& item) override;
  std::string header(const Item& item) override;
  std::string first_statements(const Item& item) override;
  Piece declaration(const Node& node, bool loops) override;
  std::string step(const std::string& name) override { return name + "++"; }
  Written conditional(const Node& node) override;
  Piece argument(const Node& node, bool comparison_follows) override;
  bool needs_brackets(const Node& node, const Node& part, int level, int part_level,
                      bool right) const override;
  /// Of a variable, or of an array of that size.
  std::string type_of(const std::string& name, const std::string& size) const;
};

} // namespace openltc::shaders
