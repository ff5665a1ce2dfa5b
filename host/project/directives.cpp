#include "host/project/directives.h"

#include <charconv>
#include <initializer_list>

#include "host/project/directive_reader.h"

namespace shadertwin {

std::string DirectiveReader::string(const std::string& what) {
  if (peek().kind == Token::Kind::open_string) {
    ++at_;
    fail("the quote is not closed");
  }
  if (peek().kind != Token::Kind::string) fail("expected " + what + " in quotes" + found());
  const std::string_view quoted = take().text;
  std::string text;
  // Paths with Windows' backslashes must survive: only a quote and a backslash can be escaped.
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    const char next = quoted[i + 1];
    if (quoted[i] == '\\' && i + 2 < quoted.size() && (next == '\\' || next == '"' || next == '\'')) ++i;
    text += quoted[i];
  }
  return text;
}

namespace {

template <typename T>
struct Choice {
  std::string_view name;
  T value;
};

template <typename T>
T choose(DirectiveReader& reader, const std::string& setting, std::initializer_list<Choice<T>> choices) {
  const std::string value = reader.string("a value");
  std::string names;
  for (const Choice<T>& choice : choices) {
    if (choice.name == value) return choice.value;
    names += (names.empty() ? "" : ", ") + std::string(choice.name);
  }
  reader.fail(setting + " can't be \"" + value + "\": it is one of " + names);
}

int channel_number(const DirectiveReader& reader, std::string_view word) {
  const std::string_view digits = word.substr(std::string_view("iChannel").size());
  int channel = -1;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), channel);
  if (problem != std::errc() || end != digits.data() + digits.size() || channel < 0 ||
      channel >= max_channels)
    reader.fail("#" + std::string(word) + ": the channels are iChannel0 to iChannel" +
                std::to_string(max_channels - 1));
  return channel;
}

void read_channel(DirectiveReader& reader, std::string_view word, Directive& directive) {
  using Kind = Directive::Kind;
  directive.channel = channel_number(reader, word);
  if (!reader.take_if("::")) {
    directive.kind = Kind::channel;
    directive.text = reader.string("a path");
    if (directive.text.empty()) reader.fail("#" + std::string(word) + ": the path is empty");
    return;
  }
  const std::string setting(reader.peek().text);
  if (!reader.done()) reader.take();
  if (setting == "MinFilter") {
    directive.kind = Kind::channel_min;
    directive.min = choose<MinFilter>(reader, setting,
                                      {{"Nearest", MinFilter::nearest},
                                       {"NearestMipMapNearest", MinFilter::nearest_mipmap_nearest},
                                       {"NearestMipMapLinear", MinFilter::nearest_mipmap_linear},
                                       {"Linear", MinFilter::linear},
                                       {"LinearMipMapNearest", MinFilter::linear_mipmap_nearest},
                                       {"LinearMipMapLinear", MinFilter::linear_mipmap_linear}});
  } else if (setting == "MagFilter") {
    directive.kind = Kind::channel_mag;
    directive.mag =
        choose<MagFilter>(reader, setting, {{"Nearest", MagFilter::nearest}, {"Linear", MagFilter::linear}});
  } else if (setting == "WrapMode") {
    directive.kind = Kind::channel_wrap;
    directive.wrap = choose<Wrap>(
        reader, setting, {{"Repeat", Wrap::repeat}, {"Clamp", Wrap::clamp}, {"Mirror", Wrap::mirror}});
  } else if (setting == "Type") {
    directive.kind = Kind::channel_cubemap;
    directive.cubemap = choose<bool>(reader, setting, {{"Texture2D", false}, {"CubeMap", true}});
  } else {
    reader.fail("unknown setting '" + setting +
                "' of a channel: there are MinFilter, MagFilter, WrapMode, Type");
  }
}

// True if the word opens a directive; reads the rest of it then.
bool read_directive(DirectiveReader& reader, Directive& directive) {
  using Kind = Directive::Kind;
  const std::string_view word = reader.take().text;
  if (word == "include" || word == "iVertex") {
    directive.kind = word == "include" ? Kind::include : Kind::vertex;
    directive.text = reader.string("a path");
    if (directive.text.empty()) reader.fail("#" + std::string(word) + ": the path is empty");
  } else if (word == "iKeyboard") {
    directive.kind = Kind::keyboard;
  } else if (word == "iFirstPersonControls") {
    directive.kind = Kind::first_person_controls;
  } else if (word == "StrictCompatibility") {
    directive.kind = Kind::strict_compatibility;
  } else if (word == "iUniform") {
    directive.kind = Kind::uniform;
    directive.uniform = read_uniform(reader);
  } else if (word == "version") {
    directive.kind = Kind::version;
    while (!reader.done() && reader.peek().preprocessor && !reader.peek().first) reader.take();
  } else if (word.starts_with("iChannel")) {
    read_channel(reader, word, directive);
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::vector<Directive> parse_directives(std::string_view text, const std::string& file) {
  const std::vector<Token> tokens = tokenize(text);
  DirectiveReader reader(tokens, file);
  std::vector<Directive> directives;
  for (std::size_t i = 0; i + 1 < tokens.size();) {
    // The extension takes its own anywhere.
    const bool opens = tokens[i].is("#") && tokens[i + 1].kind == Token::Kind::identifier &&
                       tokens[i + 1].begin == tokens[i].end() &&
                       (tokens[i].first || !tokens[i + 1].is("version"));
    reader.start(i + 1);
    Directive directive;
    if (opens && read_directive(reader, directive)) {
      directive.begin = tokens[i].begin;
      directive.end = reader.last().end();
      directive.line = tokens[i].line;
      directives.push_back(directive);
      i = reader.place();
    } else {
      ++i;
    }
  }
  return directives;
}

}  // namespace shadertwin
