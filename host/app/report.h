// The files of --json.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace shadertwin::app {

// Writes the report whole or not at all. Throws Error(file).
void write_report(const std::string& file, const nlohmann::json& report);

}  // namespace shadertwin::app
