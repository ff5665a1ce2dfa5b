// What the writers of one function share: its text and its names.
#pragma once

#include <map>
#include <string>

#include "reference/emit/cpp_writer.h"
#include "reference/emit/names.h"
#include "reference/emit/program.h"

namespace shadertwin::emit {

struct FunctionScope {
  CppWriter out;
  NameScope names;                         // what no further variable may be called
  std::map<SymbolId, std::string> locals;  // the names of parameters and local variables
};

}  // namespace shadertwin::emit
