// The preprocessor of GLSL ES 3.00: resolves directives and macros exactly as Chromium does, so that whatever
// reads a shader behind it sees plain code. Where Chromium (ANGLE) departs from the C standard, Chromium is
// followed; the cases in tests/language/preprocessor_cases.txt say where, and are put to the browser itself.
//
// Why no ready-made preprocessor: Boost.Wave is one of C++. It pastes tokens, takes names that are undefined
// in #if for zero, calculates in 64 bits, wants string literals closed and forgives junk behind #endif; none
// of it can be turned off.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shadertwin {

struct PlainToken {
  std::string text;
  // Physical line, from 1, whatever #line says; never decreases. Of what a macro made: the line of its name
  // or, if it has parameters, of its closing parenthesis, as in a browser's messages. \n, \r\n and a single
  // \r each end a line.
  int line = 1;
  bool space_before = false;
};

struct Diagnostic {
  int line = 1;         // physical
  std::string message;  // one line, without place
};

struct PlainText {
  std::vector<PlainToken> tokens;      // no directives, no comments, no continuations
  std::vector<PlainToken> directives;  // for the compiler: each #extension and #pragma as one token
  std::vector<Diagnostic> errors;      // what a browser refuses, in its order, at most 100
};

// A macro of the host's: object-like, or function-like with at least one parameter.
struct HostMacro {
  std::string name;
  std::string replacement;
  std::vector<std::string> parameters = {};
};

struct PreprocessOptions {
  // The text may define these anew or undefine them without complaint.
  std::vector<HostMacro> predefined = {};
  // Whether the text stands behind a host's head with code in it, as on shadertoy.com: #version and
  // #extension are then refused wherever they are. Else #version 300 es may be on the first line, and
  // #extension before the first code.
  bool behind_head = true;
  // The text is one of GLSL ES 1.00: #extension may stand anywhere and goes, as ES 3.00 has what it asks for.
  bool es100 = false;
};

// A text is refused, besides what browsers refuse, where its macros make more than 1,000,000 tokens of the
// result or more than 4,000,000 on the way: a browser would not end. Time is linear in the text and in those.
PlainText preprocess(std::string_view text, const PreprocessOptions& options = {});

// Every token on its line and each directive on its own: line numbers stay. Exactly line_count lines, each
// ended by \n. line_count: at least as many as the text has; tokens beyond would stand in the last.
std::string to_text(const PlainText& text, int line_count);

// How many lines a text has, as PlainToken counts them; a line end at the very end begins no other.
int count_lines(std::string_view text);

}  // namespace shadertwin
