// The variables of a random program, and what can be read and written of them.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace shadertwin::random_program {

enum class Base { real, integer, natural, truth };

struct Structure;

// A scalar has one row and one column, a vector one column, a matrix more.
struct Type {
  Base base = Base::real;
  int rows = 1;
  int columns = 1;
  int count = 0;  // of an array; 0: none
  const Structure* structure = nullptr;

  bool operator==(const Type&) const = default;
  bool is_scalar() const { return !structure && count == 0 && rows == 1 && columns == 1; }
  bool is_vector() const { return !structure && count == 0 && rows > 1 && columns == 1; }
  bool is_matrix() const { return !structure && count == 0 && columns > 1; }
  Type element() const {
    if (count > 0) return {base, rows, columns, 0, structure};
    return columns > 1 ? Type{base, rows} : Type{base};
  }
  Type with_rows(int n) const { return {base, n}; }
};

struct Member {
  Type type;
  std::string name;
};

struct Structure {
  std::string name;
  std::vector<Member> members;
};

struct Variable {
  Type type;
  std::string name;
  bool writable = true;
  bool global = false;
};

enum class Passing { in, const_in, out, inout };

struct Function {
  std::string name;
  bool returns = true;
  Type result;
  std::vector<Type> types;
  std::vector<Passing> passing;
  bool writes = false;  // globals, or through its parameters
  bool discards = false;
  int cost = 1;
};

const Type real{Base::real};
const Type integer{Base::integer};
const Type truth{Base::truth};

std::string name_of(const Type& type);

// A seeded generator, and the names and types that the program has so far.
class RandomValues {
 protected:
  explicit RandomValues(std::uint32_t seed) : state_(seed * 747796405u + 2891336453u) {}

  std::uint32_t next();
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint32_t>(n)); }

  bool chance(int percent) { return below(100) < percent; }

  template <class T>
  const T& one_of(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }

  // A name that is not taken in this scope; now and then one that hides another's.
  std::string fresh(const char* stem);
  // A scalar, a vector or a matrix.
  Type basic();
  // These, structures, and arrays of all of them.
  Type any();
  const Structure* some_structure() { return one_of(structures_); }

  std::string literal(Base base);
  // A constant expression.
  std::string constant(const Type& type);
  // Elements, members, columns or components.
  static int parts(const Type& type);
  static Type part(const Type& type, int i);
  bool may_read(const Variable& variable) const { return reserved_.count(variable.name) == 0; }

  // The ways into what a variable holds, of the type wanted. An index is `index`, kept in bounds.
  void paths(const Type& from, const std::string& text, const Type& wanted, bool as_place,
             std::vector<std::string>& found, int depth);
  // With `distinct` it can be written to.
  std::string swizzle(int rows, int count, bool distinct);
  // Of an array of `count` elements, always inside.
  std::string index(int count);
  std::string read(const Type& type);
  // Something of a type that no variable has.
  std::string made(const Type& type);
  // A place to write of that type, whose variable may be written now; empty if there is none.
  std::string place(const Type& type, const std::set<std::string>& among);

  int names_ = 0;
  std::set<std::string> taken_;  // names of the scope
  std::vector<const Structure*> structures_;
  std::vector<Variable> variables_;
  std::set<std::string> reserved_;  // variables that only effects touch

 private:
  std::uint32_t state_;
};

}  // namespace shadertwin::random_program
