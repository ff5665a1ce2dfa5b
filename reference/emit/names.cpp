#include "reference/emit/names.h"

#include <cctype>

#include "reference/emit/operators.h"

namespace shadertwin::emit {
namespace {

const std::set<std::string>& cpp_words() {
  static const std::set<std::string> words = {
      "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case",
      "catch", "char", "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield",
      "compl", "concept", "const", "const_cast", "consteval", "constexpr", "constinit", "continue",
      "decltype", "default", "delete", "do", "double", "dynamic_cast", "else", "enum", "explicit", "export",
      "extern", "false", "float", "for", "friend", "goto", "if", "inline", "int", "long", "mutable",
      "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or", "or_eq", "private",
      "protected", "public", "register", "reinterpret_cast", "requires", "return", "short", "signed",
      "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template", "this",
      "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "typeof", "union", "unsigned",
      "using", "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq",
      // with a meaning in places, and to the preprocessor
      "defined", "final", "import", "module", "override",
      // of GNU's dialect and of clang's
      "_Alignas", "_Alignof", "_Atomic", "_Bool", "_Complex", "_Float16", "_Generic", "_Imaginary",
      "_Noreturn", "_Static_assert", "_Thread_local"};
  return words;
}

// What the emitter writes. Everything else that the twin's headers declare may be hidden by the shader's
// names, and macros are undefined.
const std::set<std::string>& emitted_words() {
  static const std::set<std::string> words = {
      "Anonymous",   "Bind",   "Bool",           "Float",  "Int",         "Invocation",
      "PixelLoop",   "Shader", "Uint",           "array",  "atan_strict", "as_pixel",
      "at",          "bind",   "checked_divide", "divide", "glsl",        "make",
      "mix_strict",  "modulo", "output",         "packet", "shadertwin",  "shift_left",
      "shift_right", "std",    "swizzle",        "uint",   "unwritten"};
  return words;
}

const std::set<std::string>& builtin_functions() {
  static const std::set<std::string> names = [] {
    std::set<std::string> found;
    for (int op = 0; op < static_cast<int>(glslang::EOpTextureGuardEnd); ++op) {
      if (const char* name = builtin_name(static_cast<glslang::TOperator>(op))) found.insert(name);
    }
    return found;
  }();
  return names;
}

// What C++ keeps for compilers, and the macros that the twin's code is exported by.
bool is_reserved(const std::string& name) {
  const bool by_underscore = name.size() > 1 && name[0] == '_' &&
                             (name[1] == '_' || std::isupper(static_cast<unsigned char>(name[1])) != 0);
  return by_underscore || name.starts_with("SHADERTWIN");
}

std::string cpp_name(const std::string& name, bool is_global) {
  const std::string stem = name.substr(0, name.find_last_not_of('_') + 1);
  const bool is_taken = cpp_words().count(stem) != 0 || emitted_words().count(stem) != 0 ||
                        is_reserved(stem) || (is_global && builtin_functions().count(stem) != 0);
  return is_taken || name.size() - stem.size() >= 2 ? name + '_' : name;
}

}  // namespace

std::string cpp_name(const std::string& glsl_name) {
  return cpp_name(glsl_name, false);
}

std::string global_cpp_name(const std::string& glsl_name) {
  return cpp_name(glsl_name, true);
}

std::string NameScope::take(const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; has(name); ++i) name = wanted + '_' + std::to_string(i);
  reserve(name);
  return name;
}

}  // namespace shadertwin::emit
