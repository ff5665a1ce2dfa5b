// Options of CLI11 whose words become typed values while the command line is read.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/error.h"

namespace shadertwin::app {

// read(word), with the option and the word in front of what it throws: "--size 12: expected WIDTHxHEIGHT".
template <typename Read>
auto read_word(const std::string& names, const std::string& word, const Read& read) {
  try {
    return read(word);
  } catch (const Error& error) {
    throw Error(error.status(), names.substr(0, names.find(',')) + ' ' + word + ": " + error.what());
  }
}

// An option with one word, the last that was given; take(word) reads it. `names` as CLI11 has them:
// "-o,--output".
template <typename Take>
CLI::Option* add_word(CLI::App& command, const std::string& names, const Take& take,
                      const std::string& help) {
  return command.add_option_function<std::string>(
      names, [names, take](const std::string& word) { read_word(names, word, take); }, help);
}

// `value` has to live as long as the command; its first value is the default, which `default_text` says in
// the help.
template <typename T, typename Read>
CLI::Option* add_value(CLI::App& command, const std::string& names, T& value, const Read& read,
                       const std::string& help, const std::string& default_text = "") {
  const auto take = [&value, read](const std::string& word) { value = read(word); };
  return add_word(command, names, take, help)->default_str(default_text);
}

// An option that may be given again: `add(word)` for each.
template <typename Add>
CLI::Option* add_repeated(CLI::App& command, const std::string& names, const Add& add,
                          const std::string& help) {
  return command
      .add_option_function<std::vector<std::string>>(
          names,
          [names, add](const std::vector<std::string>& words) {
            for (const std::string& word : words) read_word(names, word, add);
          },
          help)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// One of a few words.
template <typename T, typename Value>
CLI::Option* add_choice(CLI::App& command, const std::string& names, T& value,
                        const std::vector<std::pair<std::string, Value>>& choices, const std::string& help,
                        const std::string& default_text = "") {
  std::string list;
  for (const auto& [word, meaning] : choices) list += (list.empty() ? "" : ",") + word;
  const auto read = [choices, list](const std::string& word) {
    for (const auto& [known, meaning] : choices)
      if (word == known) return meaning;
    throw Error(ExitStatus::usage, "expected one of " + list);
  };
  return add_value(command, names, value, read, help, default_text)->type_name("TEXT:{" + list + "}");
}

}  // namespace shadertwin::app
