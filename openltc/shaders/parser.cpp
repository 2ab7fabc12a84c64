// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/parser.h"

#include "openltc/shaders/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace openltc::shaders {

namespace {

// From the loosest to the tightest.
const std::vector<std::vector<std::string>> k_operators = {
    {"||"}, {"&&"}, {"==", "!="}, {"<", ">", "<=", ">="}, {"+", "-"}, {"*", "/"}};

// Comments before the first blank line, from which the licence is taken; what follows stays.
Comments take_opening(Comments& comments) {
  const auto end = std::find(comments.begin(), comments.end(), std::string());
  Comments opening(comments.begin(), end);
  comments.erase(comments.begin(), end == comments.end() ? end : end + 1);
  while (!opening.empty() && (opening[0].rfind("Copyright", 0) == 0 ||
                              opening[0].rfind("SPDX", 0) == 0 || opening[0] == " "))
    opening.erase(opening.begin());
  return opening;
}

// Recursive descent. After an error nothing more is taken, and the first error counts.
class Parser {
public:
  Parser(std::vector<Token> tokens, std::string file)
      : tokens_(std::move(tokens)), file_(std::move(file)) {}

  Result<SourceFile> read() {
    SourceFile source{file_};
    source.opening = take_opening(tokens_[0].comments);
    while (ok() && !peek().empty())
      source.items.push_back(item());
    if (!ok()) return Error{error_};
    return source;
  }

private:
  bool ok() const { return error_.empty(); }
  const std::string& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)].text;
  }
  void expected(const std::string& what) {
    if (ok())
      error_ = fmt::format("{}:{}: expected {}, not '{}'", file_, tokens_[at_].line, what, peek());
    at_ = tokens_.size() - 1;
  }
  std::string take() {
    const std::string text = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return text;
  }
  void take(const char* text) {
    if (peek() == text)
      take();
    else
      expected(fmt::format("'{}'", text));
  }
  bool take_if(const char* text) {
    if (peek() != text) return false;
    take();
    return true;
  }
  std::string word() {
    const std::string text = peek();
    if (text.empty() || !(std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_'))
      expected("a name");
    return take();
  }
  // Comments before the next token, without blank lines at their beginning.
  Comments comments() {
    Comments found = std::move(tokens_[at_].comments);
    while (!found.empty() && found[0].empty())
      found.erase(found.begin());
    return found;
  }

  Item item() {
    Item result;
    result.comments = comments();
    const std::string first = word();
    if (first == "struct") {
      result.kind = ItemKind::structure;
      result.name = word();
      take("{");
      while (ok() && peek() != "}") {
        Variable field;
        field.comments = comments();
        field.type = word();
        field.name = word();
        field.size = array_size();
        take(";");
        field.note = tokens_[at_].note;
        result.variables.push_back(std::move(field));
      }
      take("}");
      take(";");
    } else if (first == "CONSTANT" || first == "const") {
      result.kind = ItemKind::constant;
      result.type = first == "const" ? word() : std::string("Real");
      result.name = word();
      take("=");
      result.body = expression();
      take(";");
    } else if (first == "FN" || first == "FN_INLINE" || first == "FN_CALL") {
      result.type = word();
      result.name = word();
      take("(");
      while (ok() && peek() != ")") {
        Variable parameter;
        const bool given = take_if("GIVEN");
        if (given) take("(");
        parameter.type = word();
        if (given) take(")");
        parameter.name = word();
        result.variables.push_back(std::move(parameter));
        if (peek() != ")") take(",");
      }
      take(")");
      result.body = statement();
    } else {
      expected("struct, CONSTANT, const, FN, FN_INLINE or FN_CALL");
    }
    return result;
  }

  Node statement() {
    Comments before = std::move(tokens_[at_].comments);
    Node result = bare_statement();
    result.comments = std::move(before);
    result.note = tokens_[at_].note;
    return result;
  }

  Node bare_statement() {
    if (take_if("{")) {
      Node block{Kind::block, ""};
      while (ok() && peek() != "}")
        block.parts.push_back(statement());
      take("}");
      return block;
    }
    if (take_if("if")) {
      Node branch{Kind::branch, ""};
      take("(");
      branch.parts.push_back(expression());
      take(")");
      branch.parts.push_back(statement());
      if (take_if("else")) branch.parts.push_back(statement());
      return branch;
    }
    if (take_if("for")) {
      Node loop{Kind::loop, ""};
      take("(");
      loop.parts.push_back(simple());
      take(";");
      loop.parts.push_back(expression());
      take(";");
      loop.parts.push_back(simple());
      take(")");
      loop.parts.push_back(statement());
      return loop;
    }
    Node result;
    if (take_if("return"))
      result = {Kind::give, "", {expression()}};
    else
      result = simple();
    take(";");
    return result;
  }

  bool is_type_ahead() const {
    const auto is_word = [](const std::string& text) {
      return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_');
    };
    return is_word(peek()) && is_word(peek(1));
  }

  Node simple() {
    if (take_if("++")) return {Kind::step, "", {expression()}};
    if (is_type_ahead()) {
      Node declared{Kind::declare, word()};
      declared.name = word();
      declared.size = array_size();
      if (take_if("=")) declared.parts.push_back(expression());
      return declared;
    }
    Node left = expression();
    if (take_if("=")) return {Kind::assign, "", {std::move(left), expression()}};
    return {Kind::evaluate, "", {std::move(left)}};
  }

  // [ size ] behind a name; empty where there is none.
  std::string array_size() {
    if (!take_if("[")) return {};
    std::string size = take();
    take("]");
    return size;
  }

  Node expression() {
    Node condition = binary(0);
    if (!take_if("?")) return condition;
    Node a = expression();
    take(":");
    return {Kind::conditional, "", {std::move(condition), std::move(a), expression()}};
  }

  Node binary(std::size_t level) {
    if (level == k_operators.size()) return unary();
    Node left = binary(level + 1);
    const std::vector<std::string>& signs = k_operators[level];
    while (ok() && std::find(signs.begin(), signs.end(), peek()) != signs.end()) {
      const std::string sign = take();
      left = {Kind::binary, sign, {std::move(left), binary(level + 1)}};
    }
    return left;
  }

  Node unary() {
    if (peek() == "-" || peek() == "!") {
      const std::string sign = take();
      return {Kind::unary, sign, {unary()}};
    }
    return postfix();
  }

  Node postfix() {
    Node node;
    if (take_if("(")) {
      node = expression();
      take(")");
    } else if (!peek().empty() && std::isdigit(static_cast<unsigned char>(peek()[0]))) {
      node = {Kind::number, take()};
    } else {
      node = name_of(word());
    }
    while (ok()) {
      if (node.kind == Kind::name && take_if("(")) {
        node.kind = Kind::call;
        while (ok() && peek() != ")") {
          node.parts.push_back(expression());
          if (peek() != ")") take(",");
        }
        take(")");
      } else if (take_if(".")) {
        node = {Kind::member, word(), {std::move(node)}};
      } else if (take_if("[")) {
        node = {Kind::index, "", {std::move(node), expression()}};
        take("]");
      } else {
        break;
      }
    }
    return node;
  }

  std::vector<Token> tokens_;
  std::string file_;
  std::size_t at_ = 0;
  std::string error_;
};

} // namespace

Result<SourceFile> parse_file(const std::string& source, const std::string& name) {
  Result<std::vector<Token>> tokens = read_tokens(source, name);
  if (!tokens) return tokens.error();
  return Parser(std::move(*tokens), name).read();
}

} // namespace openltc::shaders
