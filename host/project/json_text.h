// JSON as the loaders read it: every mistake is one line with file and line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace shadertwin {

// Keeps the order of members, so that a document is written as it was read.
using Json = nlohmann::ordered_json;

// `name` stands in messages. Throws Error(file) for what is not JSON and for over 64 levels.
Json parse_json(const std::string& text, const std::string& name);

// `value` as a type, or Error(file) `name: error: what is not a ...`.
const Json& need_object(const Json& value, const std::string& name, const std::string& what);
const Json& need_array(const Json& value, const std::string& name, const std::string& what);
const std::string& need_string(const Json& value, const std::string& name, const std::string& what);

}  // namespace shadertwin
