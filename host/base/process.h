// Runs another program and waits for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace shadertwin {

// The first of `names` that is an executable file, searched on the PATH unless it has a slash. Empty: none.
std::filesystem::path find_program(const std::vector<std::string>& names);

struct ProcessResult {
  int status = 0;      // exit status; -1 if the program could not be started or died of a signal
  std::string output;  // standard output and standard error
};

ProcessResult run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments);

}  // namespace shadertwin
