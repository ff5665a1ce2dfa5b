// Names for C++: GLSL's own where C++ and the twin's library leave them free.
#pragma once

#include <set>
#include <string>

namespace shadertwin::emit {

// What a name of the shader's is in C++: itself, or with one more underscore where C++ or the emitter has
// taken it. Two names never become one: what is one of those but for underscores at its end gets one more,
// too. Names that end in two underscores are the twin's own.
std::string cpp_name(const std::string& glsl_name);
// The same for structures, functions and global variables, which would hide a built-in function.
std::string global_cpp_name(const std::string& glsl_name);

// Whether some header that twins include defines a macro of this name.
bool is_header_macro(const std::string& name);

// Hands out names, each only once until it is given back.
class NameScope {
 public:
  // `wanted` if it is free, else `wanted` with a number.
  std::string take(const std::string& wanted);
  void reserve(const std::string& name) { taken_.insert(name); }
  void give_back(const std::string& name) { taken_.erase(name); }
  bool has(const std::string& name) const { return taken_.count(name) != 0; }

 private:
  std::set<std::string> taken_;
};

}  // namespace shadertwin::emit
