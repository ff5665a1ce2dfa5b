// The program's command line: subcommands, and options whose words become typed values while it is read.
// CLI11 reads it, behind command_line.cpp alone: its headers take ten seconds to compile.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/error.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace shadertwin::app {

// An option or a flag of a command: a reference to it, as a pointer is.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required() const;
  // What the help says of its default and of its words.
  Option default_str(const std::string& text) const;
  Option type_name(const std::string& name) const;
  Option between(double least, double most) const;
  Option not_negative() const;
  // Not in the help.
  Option hidden() const;

  // Once the command line is read:
  bool given() const;
  bool is_flag() const;
  std::string name() const;           // "--define"
  std::string shortest_name() const;  // "-D"
  // Those that hold: all if it may be given again, else the last one.
  std::vector<std::string> words() const;

 private:
  CLI::Option* option_;
};

// The program or one of its subcommands, likewise. `names` are as CLI11 has them: "-o,--output", or "SHADER"
// by its place alone. Values have to live as long as the command.
class CommandLine {
 public:
  explicit CommandLine(CLI::App& app) : app_(&app) {}

  CommandLine add_subcommand(const std::string& name, const std::string& help) const;
  Option add_flag(const std::string& names, bool& value, const std::string& help) const;
  // The value's own text is the default in the help.
  template <typename T>  // std::string, int, double, std::uint32_t
  Option add_option(const std::string& names, T& value, const std::string& help) const;
  // The word that was given last.
  Option add_word(const std::string& names, std::function<void(const std::string&)> take,
                  const std::string& help) const;
  // Every word of an option that may be given again.
  Option add_words(const std::string& names, std::function<void(const std::string&)> take,
                   const std::string& help) const;
  // What it does, if it was chosen. Throws Error.
  void callback(std::function<void()> run) const;

  bool given(const std::string& name) const;

 private:
  CLI::App* app_;
};

struct ProgramText {
  std::string name, description, version, footer;
};

// Reads the command line by what `declare` adds to it, and does what it says. Throws Error(usage) for words
// that nothing takes, and what the callbacks throw. Returns the exit status.
int run_command_line(int argc, char** argv, const ProgramText& text,
                     const std::function<void(CommandLine)>& declare);

// read(word), with the option and the word in front of what it throws: "--size 12: expected WIDTHxHEIGHT".
template <typename Read>
auto read_word(const std::string& names, const std::string& word, const Read& read) {
  try {
    return read(word);
  } catch (const Error& error) {
    throw Error(error.status(), names.substr(0, names.find(',')) + ' ' + word + ": " + error.what());
  }
}

// An option with one word, the last that was given; take(word) reads it.
template <typename Take>
Option add_word(CommandLine command, const std::string& names, const Take& take, const std::string& help) {
  return command.add_word(
      names, [names, take](const std::string& word) { read_word(names, word, take); }, help);
}

// `value`'s first value is the default, which `default_text` says in the help.
template <typename T, typename Read>
Option add_value(CommandLine command, const std::string& names, T& value, const Read& read,
                 const std::string& help, const std::string& default_text = "") {
  const auto take = [&value, read](const std::string& word) { value = read(word); };
  return add_word(command, names, take, help).default_str(default_text);
}

// An option that may be given again: `add(word)` for each.
template <typename Add>
Option add_repeated(CommandLine command, const std::string& names, const Add& add, const std::string& help) {
  return command.add_words(
      names, [names, add](const std::string& word) { read_word(names, word, add); }, help);
}

// One of a few words.
template <typename T, typename Value>
Option add_choice(CommandLine command, const std::string& names, T& value,
                  const std::vector<std::pair<std::string, Value>>& choices, const std::string& help,
                  const std::string& default_text = "") {
  std::string list;
  for (const auto& [word, meaning] : choices) list += (list.empty() ? "" : ",") + word;
  const auto read = [choices, list](const std::string& word) {
    for (const auto& [known, meaning] : choices)
      if (word == known) return meaning;
    throw Error(ExitStatus::usage, "expected one of " + list);
  };
  return add_value(command, names, value, read, help, default_text).type_name("TEXT:{" + list + "}");
}

}  // namespace shadertwin::app
