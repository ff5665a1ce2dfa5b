// The one kind of exception that crosses module borders, and the exit status it turns into.
#pragma once

#include <stdexcept>
#include <string>

namespace shadertwin {

// What `shadertwin` returns to the shell.
enum class ExitStatus {
  done = 0,
  failed = 1,  // a comparison or a check failed
  usage = 2,   // wrong command line
  shader = 3,  // the shader does not compile
  file = 4,    // a file can't be read or written
  device = 5,  // there is no way to run here
};

// A failure that the user can act on. what() is what they read: one line, or one line a finding,
// without a trailing newline. Text about a shader has the form `file:line: error: text`.
class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, const std::string& text) : std::runtime_error(text), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

}  // namespace shadertwin
