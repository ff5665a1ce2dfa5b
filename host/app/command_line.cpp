#include "host/app/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>

namespace shadertwin::app {

namespace {

// The first line of a CLI11 message, which may be several.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

bool takes_all(const CLI::Option& option) {
  return option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

}  // namespace

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::default_str(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

Option Option::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

Option Option::between(double least, double most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

Option Option::not_negative() const {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

Option Option::hidden() const {
  option_->group("");
  return *this;
}

bool Option::given() const {
  return option_->count() > 0;
}

bool Option::is_flag() const {
  return option_->get_items_expected_max() == 0;
}

std::string Option::name() const {
  return option_->get_name();
}

std::string Option::shortest_name() const {
  return option_->get_snames().empty() ? name() : '-' + option_->get_snames()[0];
}

std::vector<std::string> Option::words() const {
  const std::vector<std::string>& words = option_->results();
  if (takes_all(*option_) || words.empty()) return words;
  return {words.back()};
}

CommandLine CommandLine::add_subcommand(const std::string& name, const std::string& help) const {
  return CommandLine(*app_->add_subcommand(name, help));
}

Option CommandLine::add_flag(const std::string& names, bool& value, const std::string& help) const {
  return Option(help.empty() ? *app_->add_flag(names, value) : *app_->add_flag(names, value, help));
}

template <typename T>
Option CommandLine::add_option(const std::string& names, T& value, const std::string& help) const {
  return Option(*app_->add_option(names, value, help));
}

template Option CommandLine::add_option(const std::string&, std::string&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, int&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, double&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::uint32_t&, const std::string&) const;

Option CommandLine::add_word(const std::string& names, std::function<void(const std::string&)> take,
                             const std::string& help) const {
  return Option(*app_->add_option_function<std::string>(names, take, help));
}

Option CommandLine::add_words(const std::string& names, std::function<void(const std::string&)> take,
                              const std::string& help) const {
  const auto take_all = [take = std::move(take)](const std::vector<std::string>& words) {
    for (const std::string& word : words) take(word);
  };
  return Option(*app_->add_option_function<std::vector<std::string>>(names, take_all, help)
                     ->expected(1)
                     ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

void CommandLine::callback(std::function<void()> run) const {
  app_->callback(std::move(run));
}

bool CommandLine::given(const std::string& name) const {
  return app_->count(name) > 0;
}

int run_command_line(int argc, char** argv, const ProgramText& text,
                     const std::function<void(CommandLine)>& declare) {
  CLI::App app{text.description};
  app.name(text.name);
  app.require_subcommand(1);
  app.set_version_flag("--version", text.version);
  // Later options win, so that scripts can put their own in front of the user's.
  app.option_defaults()->always_capture_default()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer(text.footer);
  declare(CommandLine(app));
  try {
    app.parse(argc, argv);
    return static_cast<int>(ExitStatus::done);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(e);
    throw Error(ExitStatus::usage, first_line(e.what()) + " (" + text.name + " --help lists what there is)");
  }
}

}  // namespace shadertwin::app
