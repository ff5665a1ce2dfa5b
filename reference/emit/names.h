// Names for C++: GLSL's own where C++ and the twin's library leave them free.
#pragma once

#include <set>
#include <string>

namespace shadertwin::emit {

// Whether C++, a macro of its standard library, or the library that twins include uses this name.
bool is_taken_in_cpp(const std::string& name);

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
