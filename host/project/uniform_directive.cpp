// #iUniform TYPE NAME [= VALUE] [in {MIN, MAX}] [step VALUE]
#include <charconv>
#include <cmath>
#include <optional>

#include "host/project/directive_reader.h"
#include "host/project/kinds.h"

namespace shadertwin {

namespace {

constexpr std::string_view color = "color3";

const UniformTypeInfo* find_type(std::string_view name) {
  if (name == color) name = "vec3";
  for (const UniformTypeInfo& type : uniform_types)
    if (type.name == name && type.kind != UniformType::mat4) return &type;
  return nullptr;
}

struct Number {
  float value = 0.0F;
  bool integer = true;
};

std::optional<Number> parse_number(std::string_view text) {
  if (!text.empty() && (text.back() == 'f' || text.back() == 'F')) text.remove_suffix(1);
  Number number;
  number.integer = text.find_first_of(".eE") == std::string_view::npos;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

class UniformReader {
 public:
  UniformReader(DirectiveReader& reader) : reader_(reader) {}

  CustomUniform read() {
    type_ = find_type(reader_.peek().text);
    if (type_ == nullptr)
      reader_.fail("#iUniform: expected a type (float, vec2, vec3, vec4, int, ivec2, ivec3, ivec4, color3)" +
                   reader_.found());
    CustomUniform uniform;
    uniform.type = type_->kind;
    type_name_ = reader_.take().text;
    uniform.is_color = type_name_ == color;
    if (reader_.peek().kind != Token::Kind::identifier)
      reader_.fail("#iUniform: expected a name" + reader_.found());
    uniform.name = reader_.take().text;

    bool has_value = false;
    if (reader_.take_if("=")) {
      uniform.value = value();
      has_value = true;
    }
    if (reader_.peek().is("in") && (reader_.peek(1).is("{") || reader_.peek(1).is("["))) read_range(uniform);
    if (type_->is_integer) uniform.step.fill(1.0F);
    if (reader_.take_if("step")) {
      uniform.step = value();
      for (int i = 0; i < type_->components; ++i)
        if (!(uniform.step[i] > 0.0F)) reader_.fail("#iUniform: a step is above 0");
    }
    if (!has_value) {
      if (!uniform.has_range)
        reader_.fail("#iUniform " + uniform.name + ": needs a default value or a range");
      uniform.value = uniform.min;
    }
    return uniform;
  }

 private:
  void read_range(CustomUniform& uniform) {
    reader_.take();
    const bool braces = reader_.take().is("{");
    uniform.min = value();
    reader_.expect(",");
    uniform.max = value();
    reader_.expect(braces ? "}" : "]");
    uniform.has_range = true;
    for (int i = 0; i < type_->components; ++i)
      if (uniform.min[i] > uniform.max[i]) reader_.fail("#iUniform: the range ends below its start");
  }

  // A number or a constructor. A scalar stands for all components.
  std::array<float, 4> value() {
    std::array<float, 4> result{};
    if (reader_.peek().kind != Token::Kind::identifier) {
      const float scalar = number();
      for (int i = 0; i < type_->components; ++i) result[i] = scalar;
      return result;
    }
    const std::string name(reader_.take().text);
    const UniformTypeInfo* made = find_type(name);
    const bool same =
        made != nullptr && made->components == type_->components && (made->is_integer || !type_->is_integer);
    const bool scalar = made != nullptr && made->components == 1 && (made->is_integer || !type_->is_integer);
    if (!same && !scalar) reader_.fail("#iUniform: '" + name + "' is not a value of type " + type_name_);
    reader_.expect("(");
    int count = 0;
    do {
      if (count == made->components)
        reader_.fail("#iUniform: " + name + " takes " + std::to_string(made->components) + " values");
      result[count++] = number();
    } while (reader_.take_if(","));
    reader_.expect(")");
    if (count != 1 && count != made->components)
      reader_.fail("#iUniform: " + name + " takes " + std::to_string(made->components) + " values");
    if (count == 1)
      for (int i = 1; i < type_->components; ++i) result[i] = result[0];
    return result;
  }

  float number() {
    float sign = 1.0F;
    if (reader_.take_if("-"))
      sign = -1.0F;
    else
      reader_.take_if("+");
    const std::optional<Number> parsed =
        reader_.peek().kind == Token::Kind::number ? parse_number(reader_.peek().text) : std::nullopt;
    if (!parsed || !std::isfinite(parsed->value))
      reader_.fail("#iUniform: expected a number" + reader_.found());
    reader_.take();
    if (type_->is_integer && !parsed->integer) reader_.fail("#iUniform: an integer is needed");
    return sign * parsed->value;
  }

  DirectiveReader& reader_;
  const UniformTypeInfo* type_ = nullptr;
  std::string type_name_;  // as it is written
};

}  // namespace

CustomUniform read_uniform(DirectiveReader& reader) {
  return UniformReader(reader).read();
}

}  // namespace shadertwin
