// Runs the program as a user types it.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/scratch_folder.h"
#include "tests/skip.h"

namespace shadertwin {

struct Outcome {
  int status = -1;  // exit status; 128 + n after signal n
  std::string out;
  std::string err;

  // Lines of stderr.
  int error_lines() const { return static_cast<int>(std::count(err.begin(), err.end(), '\n')); }
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// `arguments` as in a shell, in `folder`. `before` goes in front of the program (environment, ulimit ...).
inline Outcome run(const ScratchFolder& folder, const std::string& arguments,
                   const std::string& before = "") {
  // The output goes beside the folder, so that a test can see that nothing was left in it.
  const ScratchFolder captured;
  const std::string command = "cd '" + folder.path().string() + "' && " + before +
                              " '" SHADERTWIN_BINARY "' " + arguments + " >'" + (captured / "out").string() +
                              "' 2>'" + (captured / "err").string() + "' </dev/null";
  const int raw = std::system(command.c_str());
  Outcome outcome;
  outcome.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  outcome.out = contents(captured / "out");
  outcome.err = contents(captured / "err");
  return outcome;
}

}  // namespace shadertwin
