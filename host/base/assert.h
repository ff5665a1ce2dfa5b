// Checks of what the code takes for granted, which print the values that break it. They are on in builds
// without NDEBUG; in others their arguments are not evaluated. What a user can cause is an Error instead.
#pragma once

#include <sstream>
#include <string>

namespace shadertwin {

// Prints `file:line: text` on stderr and aborts.
[[noreturn]] void assertion_failed(const char* file, int line, const std::string& text);

template <class A, class B>
[[noreturn]] void comparison_failed(const char* file, int line, const char* text, const A& a, const B& b) {
  std::ostringstream values;
  values << text << " (" << a << " and " << b << ')';
  assertion_failed(file, line, values.str());
}

}  // namespace shadertwin

#ifdef NDEBUG
#define SHADERTWIN_ASSERT(condition) static_cast<void>(decltype(!(condition))())
#define SHADERTWIN_ASSERT_COMPARED(a, operation, b) static_cast<void>(decltype((a)operation(b))())
#else
#define SHADERTWIN_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : shadertwin::assertion_failed(__FILE__, __LINE__, #condition))
#define SHADERTWIN_ASSERT_COMPARED(a, operation, b)                                             \
  do {                                                                                          \
    const auto& shadertwin_a = (a);                                                             \
    const auto& shadertwin_b = (b);                                                             \
    if (!(shadertwin_a operation shadertwin_b))                                                 \
      shadertwin::comparison_failed(__FILE__, __LINE__, #a " " #operation " " #b, shadertwin_a, \
                                    shadertwin_b);                                              \
  } while (false)
#endif

// Statements: SHADERTWIN_ASSERT_EQ(picture.width, frame.width);
#define SHADERTWIN_ASSERT_EQ(a, b) SHADERTWIN_ASSERT_COMPARED(a, ==, b)
#define SHADERTWIN_ASSERT_LT(a, b) SHADERTWIN_ASSERT_COMPARED(a, <, b)
#define SHADERTWIN_ASSERT_LE(a, b) SHADERTWIN_ASSERT_COMPARED(a, <=, b)
