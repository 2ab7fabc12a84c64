// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The dialect's tree as text of a shading language, with its names, comments and structure.

#pragma once

#include "openltc/shaders/language.h"
#include "openltc/shaders/layout.h"
#include "openltc/shaders/syntax.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace openltc::shaders {

/// What a parameter of a type that is only a handle in the dialect stands for: parameters of these
/// types, named after it. None: it is left out.
struct HandlePart {
  std::string type;
  std::string suffix;
};
using Handles = std::map<std::string, std::vector<HandlePart>>;

/// Writes items. Names that other items know get the prefix; variables that the language has
/// another use for get an underscore at their end.
///
/// The dialect of the files in dialect/ has three functions more, which are written in each
/// language:
///   Vec4 texture_at(texture, sampler, Vec2 uv, Real level)   trilinear look-up
///   Vec2 texture_size(texture)                               columns and rows of level 0
///   Vec4 polygon_data(Polygon, int)                          element i of what the caller provides
class Writer {
public:
  Writer(Language language, std::string prefix, Handles handles, std::set<std::string> globals);
  virtual ~Writer() = default;

  /// The text of an item, with its comments, ended by a line break.
  std::string item(const Item& item);

protected:
  /// An expression, and how tightly its outermost operator binds.
  struct Written {
    Piece piece;
    int level;
  };
  static constexpr int k_tightest = 9;

  virtual std::string constant(const Item& item);
  virtual std::string structure(const Item& item);
  virtual std::string header(const Item& item);
  virtual std::string first_statements(const Item&) { return ""; }
  virtual Piece declaration(const Node& node, bool loops);
  virtual std::string step(const std::string& name) { return "++" + name; }
  virtual Written conditional(const Node& node);
  /// An argument of a call. The flag: whether another behind it compares.
  virtual Piece argument(const Node& node, bool) { return expression(node).piece; }
  virtual bool needs_brackets(const Node& node, const Node& part, int level, int part_level,
                              bool right) const;

  Written expression(const Node& node);
  std::string type(const std::string& name) const;
  std::string variable(const std::string& name) const;
  std::string global(const std::string& name) const { return prefix_ + name; }
  /// A number, or a constant that other items know.
  std::string array_size(const std::string& size) const {
    return globals_.count(size) > 0 ? global(size) : size;
  }
  /// Type and name of each parameter, handles taken apart.
  std::vector<Variable> parameters(const Item& item) const;
  std::string elements(const Item& item, const char* open, const char* close);
  std::string head(const std::string& begin, const std::vector<std::string>& parameters,
                   const std::string& end) const;
  std::string with_notes(const std::vector<Variable>& fields,
                         const std::vector<std::string>& lines);

  const Words& words_;
  Language language_;
  std::string prefix_;
  Handles handles_;
  std::set<std::string> globals_;
  std::map<std::string, std::string> locals_; ///< of the function in work: their types
  std::set<std::string> changed_;             ///< those that are set after their declaration

private:
  std::string function(const Item& item);
  std::string statement(const Node& node, int indent, bool spaced);
  std::string block(const Node& node, int indent);
  Piece simple(const Node& node);
  Written binary(const Node& node);
  Written choice(const char* name, const Node& node);
  Written call(const Node& node);
  std::vector<Piece> arguments(const Node& node);
};

/// The writer of a language. `globals`: names of all items.
std::unique_ptr<Writer> make_writer(Language language, std::string prefix, Handles handles,
                                    std::set<std::string> globals);

/// Lines of comment at this column.
std::string comment_lines(const Comments& comments, int indent);

} // namespace openltc::shaders
