// The functions of one matrix, in the number type that its constants are folded in.
#pragma once

#include <cstddef>
#include <vector>

#include "host/text/syntax_tree.h"

namespace shadertwin {

template <class T>
using Columns = std::vector<std::vector<T>>;

// Without that column and row.
template <class T>
Columns<T> minor(Columns<T> m, std::size_t column, std::size_t row) {
  m.erase(m.begin() + static_cast<std::ptrdiff_t>(column));
  for (auto& rows : m) rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(row));
  return m;
}

template <class T>
T determinant(const Columns<T>& m) {
  if (m.size() == 1) return m[0][0];
  T sum = 0;
  for (std::size_t row = 0; row < m.size(); ++row)
    sum += (row % 2 == 0 ? m[0][row] : -m[0][row]) * determinant(minor(m, 0, row));
  return sum;
}

// The columns of transpose() and inverse(), or determinant() alone.
template <class T>
std::vector<T> matrix_function(glslang::TOperator op, const Columns<T>& m) {
  if (op == glslang::EOpDeterminant) return {determinant(m)};
  std::vector<T> values;
  if (op == glslang::EOpTranspose) {
    for (std::size_t row = 0; row < m[0].size(); ++row)
      for (const auto& column : m) values.push_back(column[row]);
    return values;
  }
  const T whole = determinant(m);
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < m.size(); ++j) {
      const T cofactor = determinant(minor(m, j, i));
      values.push_back(((i + j) % 2 == 0 ? cofactor : -cofactor) / whole);
    }
  return values;
}

}  // namespace shadertwin
