#include "reference/emit/cpp_context.h"

#include <array>
#include <charconv>
#include <cmath>

namespace shadertwin::emit {

using namespace glslang;

namespace {

class TypeCollector : public TIntermTraverser {
 public:
  std::vector<const TType*> types;

  void visitSymbol(TIntermSymbol* node) override { types.push_back(&node->getType()); }
  void visitConstantUnion(TIntermConstantUnion* node) override { types.push_back(&node->getType()); }
  bool visitBinary(TVisit, TIntermBinary* node) override { return note(*node); }
  bool visitUnary(TVisit, TIntermUnary* node) override { return note(*node); }
  bool visitAggregate(TVisit, TIntermAggregate* node) override { return note(*node); }
  bool visitSelection(TVisit, TIntermSelection* node) override { return note(*node); }

 private:
  bool note(const TIntermTyped& node) {
    types.push_back(&node.getType());
    return true;
  }
};

class ConstantCollector : public TIntermTraverser {
 public:
  std::vector<const TIntermConstantUnion*> constants;

  void visitConstantUnion(TIntermConstantUnion* node) override { constants.push_back(node); }
};

// Whether `exact` is `values` but for rounding.
bool is_same_constant(const TConstUnionArray& exact, const TConstUnionArray& values) {
  if (exact.size() != values.size()) return false;
  for (int i = 0; i < values.size(); ++i) {
    if (exact[i].getType() != values[i].getType()) return false;
    const double value = number_of(values[i]);
    if (!(std::fabs(number_of(exact[i]) - value) <= 1e-5 * std::fabs(value))) return false;
  }
  return true;
}

template <class T>
std::string shortest(T value) {
  std::array<char, 40> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), result.ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string matrix_name(const TType& type) {
  const std::string columns = std::to_string(type.getMatrixCols());
  const std::string rows = std::to_string(type.getMatrixRows());
  return columns == rows ? "mat" + columns : "mat" + columns + "x" + rows;
}

const char* sampler_name(const TSampler& sampler) {
  switch (sampler.dim) {
    case Esd3D:
      return "sampler3D";
    case EsdCube:
      return "samplerCube";
    default:
      return "sampler2D";
  }
}

bool is_large(const TType& type) {
  return type.isArray() || type.isStruct() || type.isMatrix();
}

}  // namespace

bool is_wide_constant(const TType& type) {
  return type.isStruct() || (type.isArray() && type.getBasicType() == EbtBool);
}

StructTable::StructTable(const Program& program) {
  for (const TIntermSymbol* symbol : program.globals()) add(symbol->getType());
  TypeCollector collector;
  const_cast<TIntermAggregate&>(program.tree().root()).traverse(&collector);  // it has no const traversal
  for (const TType* type : collector.types) add(*type);
}

int StructTable::find(const TType& type) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].type->getStruct() == type.getStruct()) return static_cast<int>(i);
  }
  return -1;
}

void StructTable::add(const TType& type) {
  if (!type.isStruct() || find(type) >= 0) return;
  for (const TTypeLoc& member : *type.getStruct()) add(*member.type);
  const std::string name = type.getTypeName().c_str();
  Entry entry{&type, names_.take(name.empty() ? "Anonymous" : global_cpp_name(name)), {}};
  // C++ wants no member to be called like its own type.
  NameScope fields = names_;
  for (const TTypeLoc& member : *type.getStruct())
    entry.fields.push_back(fields.take(cpp_name(member.type->getFieldName().c_str())));
  entries_.push_back(std::move(entry));
}

const StructTable::Entry& StructTable::entry(const TType& type) const {
  return entries_[find(type)];
}

CppContext::CppContext(const Program& program, const CppOptions& options, const SyntaxTree* in_double)
    : program_(program), options_(options), structs_(program), places_(program.tree()) {
  if (in_double != nullptr) {
    ConstantCollector collector;
    const_cast<TIntermAggregate&>(in_double->root()).traverse(&collector);  // it has no const traversal
    for (const TIntermConstantUnion* constant : collector.constants)
      in_double_.emplace(in_double->token_of(*constant), constant);
  }
  for (const StructTable::Entry& entry : structs_.entries()) {
    names_.reserve(entry.name);
    used_names_.insert(entry.name);
    used_names_.insert(entry.fields.begin(), entry.fields.end());
  }
  std::set<std::string> builtins;
  for (const Function& function : program.functions()) {
    functions_[function.name] = global_cpp_name(function.name);
    names_.reserve(functions_[function.name]);
    used_names_.insert(functions_[function.name]);
    builtins.insert(function.builtins.begin(), function.builtins.end());
  }
  for (const std::string& name : builtins) names_.reserve(name);
  for (const TIntermSymbol* symbol : program.globals()) {
    if (symbol->getQualifier().isFrontEndConstant()) {
      constants_[symbol->getName().c_str()] = symbol;
      continue;
    }
    globals_[symbol->getId()] = names_.take(global_cpp_name(symbol->getName().c_str()));
    used_names_.insert(globals_[symbol->getId()]);
  }
}

std::string CppContext::type(const TType& type, bool varying) const {
  if (type.isArray()) {
    const TType element(type, 0);
    return "array<" + this->type(element, varying) + ", " + std::to_string(type.getOuterArraySize()) + ">";
  }
  if (type.isStruct()) return structs_.entry(type).name;
  const bool packed = options_.packets && varying;
  const std::string space = options_.packets && !varying ? "uniform::" : "";
  if (type.isMatrix()) return space + matrix_name(type);
  const std::string size = type.isVector() ? std::to_string(type.getVectorSize()) : "";
  const auto either = [&](const char* scalar, const char* packet, const char* vector) {
    return type.isVector() ? space + vector + size : packed ? packet : scalar;
  };
  switch (type.getBasicType()) {
    case EbtFloat:
      return either(options_.packets ? "float" : "Float", "Float", "vec");
    case EbtInt:
      return either("int", "Int", "ivec");
    case EbtUint:
      return either("uint", "Uint", "uvec");
    case EbtBool:
      return either("bool", "Bool", "bvec");
    case EbtSampler:
      return sampler_name(type.getSampler());
    default:
      return "void";
  }
}

bool CppContext::is_finite(double value) const {
  return options_.double_precision ? std::isfinite(value) : std::isfinite(static_cast<float>(value));
}

std::string CppContext::literal(double value, double exact) const {
  if (!is_finite(value)) {
    if (std::isnan(value)) return "uintBitsToFloat(0x7fc00000u)";
    return value > 0 ? "uintBitsToFloat(0x7f800000u)" : "uintBitsToFloat(0xff800000u)";
  }
  if (options_.shadows) {
    const auto rounded = static_cast<float>(value);
    const bool agrees = static_cast<float>(exact) == rounded;
    return agrees ? "Float(" + shortest(exact) + ")"
                  : "Float(" + shortest(rounded) + "f, " + shortest(exact) + ")";
  }
  return options_.double_precision ? shortest(value) : shortest(static_cast<float>(value)) + 'f';
}

std::string CppContext::global(const TIntermSymbol& symbol) const {
  const auto found = globals_.find(symbol.getId());
  return found == globals_.end() ? symbol.getName().c_str() : found->second;
}

std::string CppContext::function(const std::string& glsl_name) const {
  const auto found = functions_.find(glsl_name);
  return found == functions_.end() ? global_cpp_name(glsl_name) : found->second;
}

std::string CppContext::local(const TIntermSymbol& symbol) {
  return *used_names_.insert(cpp_name(symbol.getName().c_str())).first;
}

std::string CppContext::builtin(const std::string& glsl_name) const {
  // The one whose steps Mesa rearranges, but not in a precise text.
  if (glsl_name == "atan" && program_.tree().is_precise()) return "atan_strict";
  return cpp_name(glsl_name);
}

std::string CppContext::field(const TType& structure, int index) const {
  return structs_.entry(structure).fields[static_cast<std::size_t>(index)];
}

Expression CppContext::scalar(const TConstUnion& number, double exact) const {
  const auto signed_text = [](bool is_negative, const std::string& text) {
    return is_negative ? Expression{text, Binding::prefix, '-'} : Expression{text};
  };
  switch (number.getType()) {
    case EbtInt:
      if (number.getIConst() == -2147483647 - 1) return {"(-2147483647 - 1)"};
      return signed_text(number.getIConst() < 0, std::to_string(number.getIConst()));
    case EbtUint:
      return {std::to_string(number.getUConst()) + 'u'};
    case EbtBool:
      return {number.getBConst() ? "true" : "false"};
    default:
      return signed_text(is_finite(number.getDConst()) && std::signbit(number.getDConst()),
                         literal(number.getDConst(), exact));
  }
}

std::string CppContext::value(const TType& type, const TConstUnionArray& values, int& at,
                              bool varying) const {
  const auto joined = [&](int count, const auto& part) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + part(i);
    return text;
  };
  if (type.isArray()) {
    const TType element(type, 0);
    return this->type(type, varying) + "{{" +
           joined(type.getOuterArraySize(), [&](int) { return value(element, values, at, varying); }) + "}}";
  }
  if (type.isStruct()) {
    const TTypeList& members = *type.getStruct();
    return this->type(type) + "{" +
           joined(static_cast<int>(members.size()),
                  [&](int i) { return value(*members[i].type, values, at, varying); }) +
           "}";
  }
  const auto component = [&](int) {
    const double in_double = exact(values, at);
    return scalar(values[at++], in_double).text;
  };
  const int count = type.isMatrix() ? type.getMatrixCols() * type.getMatrixRows() : type.getVectorSize();
  if (!type.isMatrix() && !type.isVector()) return component(0);
  bool all_equal = type.isVector();
  for (int i = 1; i < count && all_equal; ++i)
    all_equal = values[at + i] == values[at] && exact(values, at + i) == exact(values, at);
  const std::string name = this->type(type, varying);
  std::string text = (type.isMatrix() && varying ? "make<" + name + ">" : name) + "(";
  if (all_equal && (values[at].getType() != EbtFloat || values[at].getDConst() != 0 ||
                    !std::signbit(values[at].getDConst()))) {
    text += component(0);
    at += count - 1;
  } else {
    text += joined(count, component);
  }
  return text + ")";
}

double CppContext::exact(const TConstUnionArray& values, int at) const {
  return number_of((exact_values_ != nullptr ? *exact_values_ : values)[at]);
}

std::string CppContext::named_constant(const TIntermConstantUnion& node) {
  const SyntaxTree& tree = program_.tree();
  const int token = tree.token_of(node);
  const int declaration = tree.declarations().declaration_of(token);
  if (declaration < 0 || !tree.declarations().is_const(declaration)) return {};
  return tree.tokens()[declaration].text;
}

std::string CppContext::hoist(const std::string& wanted_name, const std::string& type,
                              const std::string& value) {
  const std::string key = wanted_name + ' ' + value;
  const auto found = hoisted_names_.find(key);
  if (found != hoisted_names_.end()) return found->second;
  const std::string name = names_.take(global_cpp_name(wanted_name));
  used_names_.insert(name);
  hoisted_names_[key] = name;
  hoisted_.push_back("const " + type + " " + name + " = " + value + ";");
  return name;
}

// A scalar may be the result of folding an expression that begins with a constant's name, so its value
// decides.
bool CppContext::is_global_constant(const std::string& name, const TIntermConstantUnion& node) const {
  const auto found = constants_.find(name);
  return found != constants_.end() && found->second->getType() == node.getType() &&
         found->second->getConstArray() == node.getConstArray();
}

Expression CppContext::constant(const TIntermConstantUnion& node, bool varying) {
  const TType& type = node.getType();
  const std::string name = named_constant(node);
  const bool named = !name.empty() && (is_large(type) || is_global_constant(name, node));
  const bool wide = options_.packets && (varying || is_wide_constant(type));
  exact_values_ = nullptr;
  const auto [first, last] = in_double_.equal_range(program_.tree().token_of(node));
  for (auto found = first; found != last && exact_values_ == nullptr; ++found)
    if (is_same_constant(found->second->getConstArray(), node.getConstArray()))
      exact_values_ = &found->second->getConstArray();
  const auto value = [&] {
    int at = 0;
    return this->value(type, node.getConstArray(), at, wide);
  };
  if (named || type.isArray()) return {hoist(named ? name : "constant", this->type(type, wide), value())};
  Expression literal =
      type.isScalar() ? scalar(node.getConstArray()[0], exact(node.getConstArray(), 0)) : Expression{value()};
  literal.is_literal = true;
  return literal;
}

}  // namespace shadertwin::emit
