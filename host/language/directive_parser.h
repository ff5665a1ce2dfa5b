// Obeys the directives of a shader, and passes on the code between them that isn't skipped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/language/macro_expander.h"
#include "host/language/preprocessing_token.h"
#include "host/language/source_reader.h"

namespace shadertwin {

class DirectiveParser : public TokenSource {
 public:
  DirectiveParser(SourceReader& source, PreprocessingState& state, const PreprocessOptions& options);

  PreprocessingToken next() override;
  const MacroTable& macros() const { return macros_; }

 private:
  struct Condition {
    std::string_view directive;  // that opened it
    int line = 1;
    bool within_skipped = false;
    bool skipping = false;
    bool taken = false;  // a group of it was not skipped
    bool has_else = false;
  };

  void predefine(std::string_view name, std::string_view replacement, Macro::Origin origin,
                 const std::vector<std::string>& parameters = {});
  bool skipping() const;
  void advance() { token_ = source_.next(); }
  void error(const std::string& message) { state_.error(token_.line, message); }
  // Tells of what follows a directive that is complete.
  void expect_end(std::string_view directive);

  void parse_directive();
  void parse_define();
  bool parse_parameters(Macro& macro);
  void parse_undef();
  void parse_if(std::string_view directive);
  void parse_else();
  void parse_elif();
  void parse_endif();
  void parse_error();
  void parse_pragma();
  void parse_extension();
  void parse_version();
  void parse_line();
  bool read_expression();
  bool read_whether_defined(std::string_view directive);

  SourceReader& source_;
  PreprocessingState& state_;
  const PreprocessOptions& options_;
  MacroTable macros_;
  std::vector<Condition> conditions_;
  PreprocessingToken token_;      // of the directive that is parsed
  bool anything_before_ = false;  // but comments
  bool code_before_ = false;
};

}  // namespace shadertwin
