// The C++ of small shaders, as text to look into.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "reference/emit/emit_cpp.h"

namespace shadertwin {

// The C++ of functions that stand in front of an empty main.
std::string emitted(const std::string& functions, const CppOptions& options = {});

// Whether `text` holds `part`, #line directives and indentation aside.
testing::AssertionResult contains(const std::string& text, const std::string& part);

}  // namespace shadertwin
