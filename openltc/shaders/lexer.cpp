// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/lexer.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

namespace openltc::shaders {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Lexer {
public:
  Lexer(const std::string& source, const std::string& file) : source_(source), file_(file) {}

  Result<std::vector<Token>> read() {
    std::vector<Token> tokens;
    for (;;) {
      Token token;
      read_space(token, tokens.empty());
      token.line = line_;
      if (at_ < source_.size() && !read_text(token))
        return Error{fmt::format("{}:{}: no word of the dialect begins with '{}'", file_, line_,
                                 source_[at_])};
      const bool end = token.text.empty();
      tokens.push_back(std::move(token));
      if (end) return tokens;
    }
  }

private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  // White space and comments.
  void read_space(Token& token, bool first) {
    int breaks = first ? 1 : 0; // since the last token or comment
    bool any_break = first;
    for (;;) {
      if (peek() == '\n') {
        ++line_;
        any_break = true;
        if (++breaks == 2 && !(first && token.comments.empty())) token.comments.emplace_back();
        ++at_;
      } else if (peek() == ' ') {
        ++at_;
      } else if (peek() == '/' && peek(1) == '/') {
        std::string text = read_comment();
        if (any_break)
          token.comments.push_back(std::move(text));
        else
          token.note = std::move(text);
        breaks = 0;
      } else {
        return;
      }
    }
  }

  // Without the slashes, and the mark of a comment behind what it is about.
  std::string read_comment() {
    const std::size_t end = std::min(source_.find('\n', at_), source_.size());
    std::size_t begin = at_;
    while (begin < end && source_[begin] == '/')
      ++begin;
    if (begin < end && source_[begin] == '<') ++begin;
    if (begin < end && source_[begin] == ' ') ++begin;
    at_ = end;
    return begin == end ? std::string(" ") : source_.substr(begin, end - begin);
  }

  bool read_text(Token& token) {
    const std::size_t begin = at_;
    const char c = peek();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      while (is_word(peek()) || peek() == '.' ||
             ((peek() == '-' || peek() == '+') && std::strchr("eE", source_[at_ - 1]) != nullptr))
        ++at_;
    } else if (is_word(c)) {
      while (is_word(peek()))
        ++at_;
    } else {
      for (const char* sign : {"++", "<=", ">=", "==", "!=", "&&", "||"})
        if (c == sign[0] && peek(1) == sign[1]) at_ += 2;
      if (at_ == begin && std::strchr("+-*/<>=!?:;,.(){}[]", c) != nullptr) ++at_;
    }
    token.text = source_.substr(begin, at_ - begin);
    return at_ > begin;
  }

  const std::string& source_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

} // namespace

Result<std::vector<Token>> read_tokens(const std::string& source, const std::string& file) {
  return Lexer(source, file).read();
}

} // namespace openltc::shaders
