#include "reference/emit/names.h"

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
      // of GNU's dialect and of clang's
      "_Alignas", "_Alignof", "_Atomic", "_Bool", "_Complex", "_Float16", "_Generic", "_Imaginary",
      "_Noreturn", "_Static_assert", "_Thread_local"};
  return words;
}

// What the headers that a twin includes define as macros, and the names that the emitter itself writes.
const std::set<std::string>& library_words() {
  static const std::set<std::string> words = {
      // macros
      "BUFSIZ", "CHAR_BIT", "DBL_EPSILON", "DBL_MAX", "DBL_MIN", "DOMAIN", "EDOM", "EOF", "ERANGE",
      "EXIT_FAILURE", "EXIT_SUCCESS", "FLT_EPSILON", "FLT_MAX", "FLT_MIN", "FP_INFINITE", "FP_NAN",
      "FP_NORMAL", "FP_SUBNORMAL", "FP_ZERO", "HUGE", "HUGE_VAL", "HUGE_VALF", "INFINITY", "INT_MAX",
      "INT_MIN", "LONG_MAX", "LONG_MIN", "M_1_PI", "M_2_PI", "M_2_SQRTPI", "M_E", "M_LN10", "M_LN2",
      "M_LOG10E", "M_LOG2E", "M_PI", "M_PI_2", "M_PI_4", "M_SQRT1_2", "M_SQRT2", "NAN", "NULL", "OVERFLOW",
      "PLOSS", "RAND_MAX", "SING", "SNAN", "TLOSS", "UINT_MAX", "UNDERFLOW", "assert", "errno", "i386",
      "linux", "major", "makedev", "math_errhandling", "minor", "offsetof", "setjmp", "sigsetjmp", "stderr",
      "stdin", "stdout", "unix",
      // the twin's library
      "Bool", "Float", "Int", "Lane", "Lods", "Packet", "Uint", "Varying", "packet", "mix_strict",
      "Invocation", "Lod", "Quad", "Shader", "Bind", "array", "at", "bind", "bind_uniforms", "construct",
      "divide", "emit", "f32", "f64", "glm", "glsl", "implicit_lod", "initialise", "int32_t", "loop_guard",
      "make", "modulo", "needs_lod", "not_", "report", "shadertwin", "shift_left", "shift_right", "size_t",
      "std", "stop_invocation", "swizzle", "uint", "uint32_t", "unwritten"};
  return words;
}

}  // namespace

bool is_taken_in_cpp(const std::string& name) {
  return cpp_words().count(name) != 0 || library_words().count(name) != 0;
}

std::string NameScope::take(const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; has(name); ++i) name = wanted + '_' + std::to_string(i);
  reserve(name);
  return name;
}

}  // namespace shadertwin::emit
