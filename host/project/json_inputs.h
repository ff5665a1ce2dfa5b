// What a Shadertoy JSON binds to the channels of a pass.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "host/project/json_text.h"
#include "host/project/kinds.h"

namespace shadertwin {

// How a JSON names a pass.
struct JsonPass {
  PassKind kind = PassKind::image;
  std::string output;  // the id of its output: a number's digits become the string that the site uses
  int number = -1;     // of a buffer, from 0; -1 if the document does not say
};

// Throws Error(file) if outputs have another shape.
JsonPass identify(const Json& pass, const PassTraits& kind, const std::string& document);

class JsonInputs {
 public:
  // `passes` in the order of Project::passes. `muted`: nobody hears the music, so none is missing. Warnings
  // are added to `warnings`, one for each thing that is missing.
  JsonInputs(std::filesystem::path media, std::string document, std::vector<JsonPass> passes, bool muted,
             std::vector<std::string>& warnings);

  // Fills pass.inputs. Throws Error(file) for what has the wrong type.
  void bind(const Json& json, Pass& pass);

 private:
  [[noreturn]] void fail(const std::string& message) const;
  void warn(const std::string& subject, const std::string& message);
  Input read(const Json& json);
  Input read_pass(const std::string& id, const std::string& source, const PassTraits& kind);
  void find_media(const std::string& source, InputKind kind, Input& input);
  std::filesystem::path find_one(const std::string& source, std::string& problem) const;

  std::filesystem::path media_;
  std::string document_;
  std::vector<JsonPass> passes_;
  bool muted_;
  std::vector<std::string>& warnings_;
  std::set<std::string> warned_;
};

}  // namespace shadertwin
