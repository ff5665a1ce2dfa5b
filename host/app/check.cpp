#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/report.h"
#include "host/base/error.h"
#include "reference/check/finding.h"
#include "reference/check/rules.h"
#include "reference/check/run.h"

namespace shadertwin::app {

namespace {

using check::Finding;

void append(std::vector<Finding>& findings, std::vector<Finding> more) {
  findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

bool has_vertex_shader(const Project& project) {
  return std::any_of(project.passes.begin(), project.passes.end(),
                     [](const Pass& pass) { return pass.vertex.has_value(); });
}

std::vector<Finding> find(const Project& project, const PlayOptions& options) {
  check::Reading reading = check::read_rules(project);
  if (!reading.can_run) return reading.findings;
  if (has_vertex_shader(project)) {
    if (!options.quiet)
      std::fprintf(stderr, "%s: warning: only read, not run: the twin has no vertex shaders (#iVertex)\n",
                   options.shader.c_str());
    return reading.findings;
  }
  append(reading.findings, check::run_checks(project, {options.schedule, options.frames, options.timeout}));
  return check::sorted(std::move(reading.findings));
}

nlohmann::json to_json(const std::vector<Finding>& findings) {
  nlohmann::json list = nlohmann::json::array();
  for (const Finding& finding : findings)
    list.push_back(
        {{"file", finding.file}, {"line", finding.line}, {"kind", finding.kind}, {"text", finding.text}});
  return list;
}

void run_check(const PlayOptions& options) {
  const Project project = load(options, Warnings::of_loading);
  const std::vector<Finding> findings = find(project, options);
  for (const Finding& finding : findings) std::printf("%s\n", check::to_line(finding).c_str());
  if (!options.json.empty())
    write_report(options.json, {{"frames", options.frames},
                                {"size", {options.schedule.width, options.schedule.height}},
                                {"findings", to_json(findings)}});
  if (findings.empty()) return;
  std::fflush(stdout);
  const std::string count = std::to_string(findings.size());
  throw Error(ExitStatus::failed, options.shader + ": " + count + (count == "1" ? " finding" : " findings"));
}

}  // namespace

void add_check(CommandLine app) {
  const CommandLine command = app.add_subcommand(
      "check", "find what will not paste, not run everywhere, or is undefined: one line a finding");
  const auto options = std::make_shared<PlayOptions>();
  options->schedule.width = 64;
  options->schedule.height = 36;
  options->frames = 2;
  add_options(command, Command::check, *options);
  command.callback([options] { run_check(*options); });
}

}  // namespace shadertwin::app
