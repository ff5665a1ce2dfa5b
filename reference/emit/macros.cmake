# Writes the names of all macros that COMPILER finds in what twins include, under ROOT, into OUTPUT.
set(stub ${OUTPUT}.includes.h)
file(WRITE ${stub} "#include \"reference/twin/alone.h\"\n#include \"reference/twin/packet_invocation.h\"\n")
execute_process(
  COMMAND ${COMPILER} -std=c++20 -march=native -I${ROOT} -dM -E -x c++ ${stub}
  OUTPUT_VARIABLE definitions COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "#define [A-Za-z0-9_]+" names "${definitions}")
list(SORT names)  # as std::string has it: by bytes
list(TRANSFORM names REPLACE "#define (.*)" "    \"\\1\",\n")
string(JOIN "" names ${names})
file(WRITE ${OUTPUT}
     "#include \"reference/emit/names.h\"\n\n#include <algorithm>\n#include <iterator>\n#include <string_view>\n\n"
     "namespace shadertwin::emit {\nnamespace {\n\nconstexpr std::string_view macros[] = {\n${names}};\n\n"
     "}  // namespace\n\nbool is_header_macro(const std::string& name) {\n"
     "  return std::binary_search(std::begin(macros), std::end(macros), name);\n}\n\n"
     "}  // namespace shadertwin::emit\n")
