#include "host/project/browser_text.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

#include "host/project/tokens.h"

namespace shadertwin {

namespace {

constexpr std::string_view later_words[] = {"packed",
                                            "shared",
                                            "buffer",
                                            "precise",
                                            "dmat2",
                                            "dmat3",
                                            "dmat4",
                                            "dmat2x2",
                                            "dmat2x3",
                                            "dmat2x4",
                                            "dmat3x2",
                                            "dmat3x3",
                                            "dmat3x4",
                                            "dmat4x2",
                                            "dmat4x3",
                                            "dmat4x4",
                                            "samplerCubeArray",
                                            "samplerCubeArrayShadow",
                                            "isamplerCubeArray",
                                            "usamplerCubeArray"};

// Built-in functions of GLSL ES 3.10 and 3.20, and of 1.00 with its extensions.
constexpr std::string_view other_builtins[] = {"bitfieldExtract",
                                               "bitfieldInsert",
                                               "bitfieldReverse",
                                               "bitCount",
                                               "findLSB",
                                               "findMSB",
                                               "frexp",
                                               "ldexp",
                                               "uaddCarry",
                                               "usubBorrow",
                                               "umulExtended",
                                               "imulExtended",
                                               "packUnorm4x8",
                                               "packSnorm4x8",
                                               "unpackUnorm4x8",
                                               "unpackSnorm4x8",
                                               "textureGather",
                                               "textureGatherOffset",
                                               "textureGatherOffsets",
                                               "imageLoad",
                                               "imageStore",
                                               "imageSize",
                                               "imageAtomicAdd",
                                               "imageAtomicMin",
                                               "imageAtomicMax",
                                               "imageAtomicAnd",
                                               "imageAtomicOr",
                                               "imageAtomicXor",
                                               "imageAtomicExchange",
                                               "imageAtomicCompSwap",
                                               "atomicAdd",
                                               "atomicMin",
                                               "atomicMax",
                                               "atomicAnd",
                                               "atomicOr",
                                               "atomicXor",
                                               "atomicExchange",
                                               "atomicCompSwap",
                                               "atomicCounter",
                                               "atomicCounterIncrement",
                                               "atomicCounterDecrement",
                                               "barrier",
                                               "memoryBarrier",
                                               "memoryBarrierAtomicCounter",
                                               "memoryBarrierBuffer",
                                               "memoryBarrierImage",
                                               "memoryBarrierShared",
                                               "groupMemoryBarrier",
                                               "fma",
                                               "interpolateAtCentroid",
                                               "interpolateAtSample",
                                               "interpolateAtOffset",
                                               "texture1D",
                                               "texture1DProj",
                                               "texture1DLod",
                                               "texture1DProjLod",
                                               "texture2D",
                                               "texture2DProj",
                                               "texture2DLod",
                                               "texture2DProjLod",
                                               "texture3D",
                                               "texture3DProj",
                                               "texture3DLod",
                                               "texture3DProjLod",
                                               "textureCube",
                                               "textureCubeLod",
                                               "shadow1D",
                                               "shadow2D",
                                               "shadow1DProj",
                                               "shadow2DProj",
                                               "shadow1DLod",
                                               "shadow2DLod",
                                               "texture2DRect",
                                               "texture2DRectProj"};

constexpr std::string_view qualifiers[] = {"const", "in", "out", "inout", "lowp", "mediump", "highp"};

constexpr std::string_view value_types[] = {
    "float",  "vec2",   "vec3",   "vec4",   "int",    "ivec2",  "ivec3",  "ivec4", "uint", "uvec2",
    "uvec3",  "uvec4",  "bool",   "bvec2",  "bvec3",  "bvec4",  "mat2",   "mat3",  "mat4", "mat2x2",
    "mat2x3", "mat2x4", "mat3x2", "mat3x3", "mat3x4", "mat4x2", "mat4x3", "mat4x4"};

bool among(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct Edit {
  std::size_t begin = 0;
  std::size_t length = 0;
  std::string text;
};

class Rewriter {
 public:
  Rewriter(std::string_view text, bool zero_outputs)
      : text_(text), zero_outputs_(zero_outputs), tokens_(tokenize(text)) {}

  std::string run() {
    find_declared();
    const bool by_macro = zero_outputs_ && macro_makes_image();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (by_macro && opens_image(i)) edits_.push_back({tokens_[i + 2].begin, 0, "in"});
      if (token.preprocessor && token.first && token.is("#")) fix_directive(i);
      if (token.kind == Token::Kind::identifier &&
          (among(later_words, token.text) || renamed_.contains(token.text)))
        edits_.push_back({token.begin, 0, "shadertwin_"});
      if (token.kind == Token::Kind::identifier && token.text.starts_with("iCh")) fix_channel_struct(i);
      if (token.is("(") && opens_function(i)) fix_function(i);
    }
    return apply();
  }

 private:
  bool is_word(std::size_t i) const { return tokens_[i].kind == Token::Kind::identifier; }

  // `mainImage(out`
  bool opens_image(std::size_t i) const {
    return i + 2 < tokens_.size() && tokens_[i].is("mainImage") && tokens_[i + 1].is("(") &&
           tokens_[i + 2].is("out");
  }
  bool macro_makes_image() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (tokens_[i].preprocessor && opens_image(i)) return true;
    return false;
  }

  // A name, a type before it, and it is no statement's keyword.
  bool opens_function(std::size_t paren) const {
    if (paren < 2 || tokens_[paren].preprocessor || !is_word(paren - 1)) return false;
    const Token& name = tokens_[paren - 1];
    const Token& before = tokens_[paren - 2];
    if (name.is("if") || name.is("for") || name.is("while") || name.is("switch")) return false;
    if (before.preprocessor || before.is("return") || before.is("else")) return false;
    return before.kind == Token::Kind::identifier || before.is("]");
  }

  void find_declared() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].is("(") && opens_function(i) && among(other_builtins, tokens_[i - 1].text))
        renamed_.insert(tokens_[i - 1].text);
      if (i >= 2 && tokens_[i - 1].is("define") && tokens_[i - 2].is("#")) macros_.insert(tokens_[i].text);
    }
  }

  void fix_channel_struct(std::size_t i) {
    const std::string_view name = tokens_[i].text;
    if (name.size() != 4 || name[3] < '0' || name[3] > '3' || i + 2 >= tokens_.size() ||
        !tokens_[i + 1].is("."))
      return;
    const Token& member = tokens_[i + 2];
    const std::string channel(1, name[3]);
    std::string by;
    if (member.is("sampler")) by = "iChannel" + channel;
    if (member.is("size")) by = "iChannelResolution[" + channel + "]";
    if (member.is("time")) by = "iChannelTime[" + channel + "]";
    if (member.is("loaded")) by = "shadertwin_loaded_" + channel;
    if (!by.empty() && member.line == tokens_[i].line)
      edits_.push_back({tokens_[i].begin, member.end() - tokens_[i].begin, by});
  }

  void fix_directive(std::size_t hash) {
    std::size_t end = hash + 1;
    while (end < tokens_.size() && tokens_[end].preprocessor && !(tokens_[end].first && tokens_[end].is("#")))
      ++end;
    if (hash + 1 >= end) return;
    const Token& word = tokens_[hash + 1];
    std::size_t extra = end;
    if (word.is("else") || word.is("endif")) extra = hash + 2;
    if (word.is("ifdef") || word.is("ifndef")) extra = hash + 3;
    for (std::size_t i = extra; i < end; ++i)
      edits_.push_back({tokens_[i].begin, tokens_[i].text.size(), ""});
    if (!word.is("define")) return;
    for (std::size_t i = hash + 3; i < end; ++i) {
      const bool pasted = tokens_[i - 1].is("#") || (i + 1 < end && tokens_[i + 1].is("#"));
      if (tokens_[i].is("#") && !pasted) edits_.push_back({tokens_[i].begin, 1, ""});
    }
  }

  // The parameters of a definition; a prototype may stay as it is.
  void fix_function(std::size_t open) {
    std::size_t close = open;
    int depth = 0;
    for (; close < tokens_.size(); ++close) {
      if (tokens_[close].preprocessor) return;  // what is chosen there can't be known here
      if (tokens_[close].is("(")) ++depth;
      if (tokens_[close].is(")") && --depth == 0) break;
      if (tokens_[close].is("{") || tokens_[close].is(";")) return;
    }
    if (close + 1 >= tokens_.size() || !tokens_[close + 1].is("{")) return;
    std::string zeros;
    std::size_t start = open + 1;
    depth = 0;
    for (std::size_t i = start; i <= close; ++i) {
      if (tokens_[i].is("[") || tokens_[i].is("(")) ++depth;
      if (tokens_[i].is("]") || (tokens_[i].is(")") && i < close)) --depth;
      if (i < close && (depth > 0 || !tokens_[i].is(","))) continue;
      fix_parameter(start, i, zeros);
      start = i + 1;
    }
    if (zero_outputs_ && !zeros.empty()) edits_.push_back({tokens_[close + 1].end(), 0, zeros});
  }

  void fix_parameter(std::size_t begin, std::size_t end, std::string& zeros) {
    bool out = false;
    for (; begin < end && among(qualifiers, tokens_[begin].text); ++begin)
      out = out || tokens_[begin].is("out");
    if (begin >= end || !is_word(begin)) return;
    const std::string_view type = tokens_[begin].text;
    const bool array = std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                                   tokens_.begin() + static_cast<std::ptrdiff_t>(end),
                                   [](const Token& token) { return token.is("["); });
    const bool unnamed = begin + 1 == end || (tokens_[begin + 1].is("[") && tokens_[end - 1].is("]"));
    if (unnamed && type != "void" && !macros_.contains(type)) {
      edits_.push_back({tokens_[end - 1].end(), 0, " shadertwin_unnamed_" + std::to_string(unnamed_++)});
    } else if (out && !array && begin + 2 == end && among(value_types, type) && !macros_.contains(type)) {
      const std::string name(tokens_[begin + 1].text);
      const bool word = among(later_words, name);
      zeros += " " + std::string(word ? "shadertwin_" : "") + name + " = " + std::string(type) + "(0);";
    }
  }

  std::string apply() {
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string result;
    std::size_t copied = 0;
    for (const Edit& edit : edits_) {
      if (edit.begin < copied) continue;  // what is dropped needs no other change
      result.append(text_.substr(copied, edit.begin - copied)).append(edit.text);
      copied = edit.begin + edit.length;
    }
    return result.append(text_.substr(copied));
  }

  std::string_view text_;
  bool zero_outputs_;
  std::vector<Token> tokens_;
  std::vector<Edit> edits_;
  std::set<std::string_view> renamed_;
  std::set<std::string_view> macros_;
  int unnamed_ = 0;
};

}  // namespace

std::string as_in_a_browser(std::string_view text, bool zero_outputs) {
  return Rewriter(text, zero_outputs).run();
}

}  // namespace shadertwin
