// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Options that take one of a few words.

#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace openltc::cli {

/// The words of an option and the enumerator that each stands for, in the order of the help.
template <class Enum> using Choices = std::vector<std::pair<std::string, Enum>>;

/// The words of choices, as the help shows them: "ltc|reference".
template <class Enum> std::string words_of(const Choices<Enum>& choices) {
  std::string words;
  for (const auto& [word, value] : choices)
    words += (words.empty() ? "" : "|") + word;
  return words;
}

/// For Option::transform: turns a word into the number that CLI11 reads an enumeration from. Only
/// the words are taken, not the numbers, which CLI::CheckedTransformer would take as well.
template <class Enum> CLI::Validator one_of(const Choices<Enum>& choices) {
  std::string listed;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    listed += (i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ") + choices[i].first;
  }
  return CLI::Validator(
      [choices, listed](std::string& text) -> std::string {
        for (const auto& [word, value] : choices)
          if (text == word) {
            text = std::to_string(int(value));
            return "";
          }
        return "must be " + listed + ", not '" + text + "'";
      },
      "");
}

/// Adds an option that takes one of the words of `choices`, which the help shows.
template <class Value, class Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& value,
                        const std::string& help, const Choices<Enum>& choices) {
  return command.add_option(name, value, help)
      ->transform(one_of(choices))
      ->type_name(words_of(choices));
}

} // namespace openltc::cli
