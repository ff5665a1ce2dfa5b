// The macros with which builtins.def turns the templates of the built-in functions into GLSL's overloads, for
// the types that Float, Int, vec2, ivec2, mat2x2 ... are where builtins.def is included. Plain overloads and
// not templates: they win over GLM's templates of the same name, which argument-dependent lookup would find
// too, and a float becomes a Float by itself.
//
// Arguments and results are named by families: vec is Float or vec2 to vec4, by the overload; Float is always
// Float. `f` is the function, which detail::f_of computes.
#pragma once

// --- Families: the type for N components, and component i of a value --------

#define SHADERTWIN_TYPE(family, N) SHADERTWIN_##family##_##N
#define SHADERTWIN_AT(family, value, i) SHADERTWIN_AT_##family(value, i)

#define SHADERTWIN_Float_1 Float
#define SHADERTWIN_Float_2 Float
#define SHADERTWIN_Float_3 Float
#define SHADERTWIN_Float_4 Float
#define SHADERTWIN_Int_1 Int
#define SHADERTWIN_Int_2 Int
#define SHADERTWIN_Int_3 Int
#define SHADERTWIN_Int_4 Int
#define SHADERTWIN_Uint_1 Uint
#define SHADERTWIN_Uint_2 Uint
#define SHADERTWIN_Uint_3 Uint
#define SHADERTWIN_Uint_4 Uint
#define SHADERTWIN_Bool_2 Bool
#define SHADERTWIN_Bool_3 Bool
#define SHADERTWIN_Bool_4 Bool
#define SHADERTWIN_vec_1 Float
#define SHADERTWIN_vec_2 vec2
#define SHADERTWIN_vec_3 vec3
#define SHADERTWIN_vec_4 vec4
#define SHADERTWIN_ivec_1 Int
#define SHADERTWIN_ivec_2 ivec2
#define SHADERTWIN_ivec_3 ivec3
#define SHADERTWIN_ivec_4 ivec4
#define SHADERTWIN_uvec_1 Uint
#define SHADERTWIN_uvec_2 uvec2
#define SHADERTWIN_uvec_3 uvec3
#define SHADERTWIN_uvec_4 uvec4
#define SHADERTWIN_bvec_1 Bool
#define SHADERTWIN_bvec_2 bvec2
#define SHADERTWIN_bvec_3 bvec3
#define SHADERTWIN_bvec_4 bvec4
#define SHADERTWIN_out_vec_1 Float&
#define SHADERTWIN_out_vec_2 vec2&
#define SHADERTWIN_out_vec_3 vec3&
#define SHADERTWIN_out_vec_4 vec4&
#define SHADERTWIN_mat_2 mat2
#define SHADERTWIN_mat_3 mat3
#define SHADERTWIN_mat_4 mat4

#define SHADERTWIN_AT_Float(value, i) value
#define SHADERTWIN_AT_Int(value, i) value
#define SHADERTWIN_AT_Uint(value, i) value
#define SHADERTWIN_AT_vec(value, i) value.i
#define SHADERTWIN_AT_ivec(value, i) value.i
#define SHADERTWIN_AT_uvec(value, i) value.i
#define SHADERTWIN_AT_bvec(value, i) value.i
#define SHADERTWIN_AT_out_vec(value, i) value.i

// --- Of N components as a whole ---------------------------------------------

#define SHADERTWIN_OVERLOAD_1(f, N, R, A)                              \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, N) f(SHADERTWIN_TYPE(A, N) a) { \
    return detail::f##_of(a);                                          \
  }
#define SHADERTWIN_OVERLOAD_2(f, N, R, A, B)                                                    \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, N) f(SHADERTWIN_TYPE(A, N) a, SHADERTWIN_TYPE(B, N) b) { \
    return detail::f##_of(a, b);                                                                \
  }
#define SHADERTWIN_OVERLOAD_3(f, N, R, A, B, C)                                      \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, N)                                            \
      f(SHADERTWIN_TYPE(A, N) a, SHADERTWIN_TYPE(B, N) b, SHADERTWIN_TYPE(C, N) c) { \
    return detail::f##_of(a, b, c);                                                  \
  }
// detail::f_of<R>(a), where the argument doesn't tell the result.
#define SHADERTWIN_OVERLOAD_TO_1(f, N, R, A)                           \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, N) f(SHADERTWIN_TYPE(A, N) a) { \
    return detail::f##_of<SHADERTWIN_TYPE(R, N)>(a);                   \
  }

// Vectors, and numbers too.
#define SHADERTWIN_VECTORS_1(f, R, A) \
  SHADERTWIN_OVERLOAD_1(f, 2, R, A)   \
  SHADERTWIN_OVERLOAD_1(f, 3, R, A)   \
  SHADERTWIN_OVERLOAD_1(f, 4, R, A)
#define SHADERTWIN_VECTORS_2(f, R, A, B) \
  SHADERTWIN_OVERLOAD_2(f, 2, R, A, B)   \
  SHADERTWIN_OVERLOAD_2(f, 3, R, A, B)   \
  SHADERTWIN_OVERLOAD_2(f, 4, R, A, B)
#define SHADERTWIN_VECTORS_3(f, R, A, B, C) \
  SHADERTWIN_OVERLOAD_3(f, 2, R, A, B, C)   \
  SHADERTWIN_OVERLOAD_3(f, 3, R, A, B, C)   \
  SHADERTWIN_OVERLOAD_3(f, 4, R, A, B, C)
#define SHADERTWIN_WHOLE_1(f, R, A) \
  SHADERTWIN_OVERLOAD_1(f, 1, R, A) \
  SHADERTWIN_VECTORS_1(f, R, A)
#define SHADERTWIN_WHOLE_2(f, R, A, B) \
  SHADERTWIN_OVERLOAD_2(f, 1, R, A, B) \
  SHADERTWIN_VECTORS_2(f, R, A, B)
#define SHADERTWIN_WHOLE_3(f, R, A, B, C) \
  SHADERTWIN_OVERLOAD_3(f, 1, R, A, B, C) \
  SHADERTWIN_VECTORS_3(f, R, A, B, C)

// --- Component by component -------------------------------------------------

// The overloads for vectors, by those for numbers.
#define SHADERTWIN_CALL_1(f, A, i) f(SHADERTWIN_AT(A, a, i))
#define SHADERTWIN_CALL_2(f, A, B, i) f(SHADERTWIN_AT(A, a, i), SHADERTWIN_AT(B, b, i))
#define SHADERTWIN_CALL_3(f, A, B, C, i) \
  f(SHADERTWIN_AT(A, a, i), SHADERTWIN_AT(B, b, i), SHADERTWIN_AT(C, c, i))
#define SHADERTWIN_SPREAD_1(f, R, A)                                                      \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 2) f(SHADERTWIN_TYPE(A, 2) a) {                    \
    return SHADERTWIN_TYPE(R, 2)(SHADERTWIN_CALL_1(f, A, x), SHADERTWIN_CALL_1(f, A, y)); \
  }                                                                                       \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 3) f(SHADERTWIN_TYPE(A, 3) a) {                    \
    return SHADERTWIN_TYPE(R, 3)(SHADERTWIN_CALL_1(f, A, x), SHADERTWIN_CALL_1(f, A, y),  \
                                 SHADERTWIN_CALL_1(f, A, z));                             \
  }                                                                                       \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 4) f(SHADERTWIN_TYPE(A, 4) a) {                    \
    return SHADERTWIN_TYPE(R, 4)(SHADERTWIN_CALL_1(f, A, x), SHADERTWIN_CALL_1(f, A, y),  \
                                 SHADERTWIN_CALL_1(f, A, z), SHADERTWIN_CALL_1(f, A, w)); \
  }
#define SHADERTWIN_SPREAD_2(f, R, A, B)                                                         \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 2) f(SHADERTWIN_TYPE(A, 2) a, SHADERTWIN_TYPE(B, 2) b) { \
    return SHADERTWIN_TYPE(R, 2)(SHADERTWIN_CALL_2(f, A, B, x), SHADERTWIN_CALL_2(f, A, B, y)); \
  }                                                                                             \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 3) f(SHADERTWIN_TYPE(A, 3) a, SHADERTWIN_TYPE(B, 3) b) { \
    return SHADERTWIN_TYPE(R, 3)(SHADERTWIN_CALL_2(f, A, B, x), SHADERTWIN_CALL_2(f, A, B, y),  \
                                 SHADERTWIN_CALL_2(f, A, B, z));                                \
  }                                                                                             \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 4) f(SHADERTWIN_TYPE(A, 4) a, SHADERTWIN_TYPE(B, 4) b) { \
    return SHADERTWIN_TYPE(R, 4)(SHADERTWIN_CALL_2(f, A, B, x), SHADERTWIN_CALL_2(f, A, B, y),  \
                                 SHADERTWIN_CALL_2(f, A, B, z), SHADERTWIN_CALL_2(f, A, B, w)); \
  }
#define SHADERTWIN_SPREAD_3(f, R, A, B, C)                                                            \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 2)                                                             \
      f(SHADERTWIN_TYPE(A, 2) a, SHADERTWIN_TYPE(B, 2) b, SHADERTWIN_TYPE(C, 2) c) {                  \
    return SHADERTWIN_TYPE(R, 2)(SHADERTWIN_CALL_3(f, A, B, C, x), SHADERTWIN_CALL_3(f, A, B, C, y)); \
  }                                                                                                   \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 3)                                                             \
      f(SHADERTWIN_TYPE(A, 3) a, SHADERTWIN_TYPE(B, 3) b, SHADERTWIN_TYPE(C, 3) c) {                  \
    return SHADERTWIN_TYPE(R, 3)(SHADERTWIN_CALL_3(f, A, B, C, x), SHADERTWIN_CALL_3(f, A, B, C, y),  \
                                 SHADERTWIN_CALL_3(f, A, B, C, z));                                   \
  }                                                                                                   \
  SHADERTWIN_INLINE SHADERTWIN_TYPE(R, 4)                                                             \
      f(SHADERTWIN_TYPE(A, 4) a, SHADERTWIN_TYPE(B, 4) b, SHADERTWIN_TYPE(C, 4) c) {                  \
    return SHADERTWIN_TYPE(R, 4)(SHADERTWIN_CALL_3(f, A, B, C, x), SHADERTWIN_CALL_3(f, A, B, C, y),  \
                                 SHADERTWIN_CALL_3(f, A, B, C, z), SHADERTWIN_CALL_3(f, A, B, C, w)); \
  }

// The overload for numbers and those for vectors.
#define SHADERTWIN_MAP_1(f, R, A)   \
  SHADERTWIN_OVERLOAD_1(f, 1, R, A) \
  SHADERTWIN_SPREAD_1(f, R, A)
#define SHADERTWIN_MAP_2(f, R, A, B)   \
  SHADERTWIN_OVERLOAD_2(f, 1, R, A, B) \
  SHADERTWIN_SPREAD_2(f, R, A, B)
#define SHADERTWIN_MAP_3(f, R, A, B, C)   \
  SHADERTWIN_OVERLOAD_3(f, 1, R, A, B, C) \
  SHADERTWIN_SPREAD_3(f, R, A, B, C)
#define SHADERTWIN_MAP_TO_1(f, R, A)   \
  SHADERTWIN_OVERLOAD_TO_1(f, 1, R, A) \
  SHADERTWIN_SPREAD_1(f, R, A)

// --- Matrices ---------------------------------------------------------------

#define SHADERTWIN_EACH_MATRIX(DO) \
  DO(2, 2) DO(2, 3) DO(2, 4) DO(3, 2) DO(3, 3) DO(3, 4) DO(4, 2) DO(4, 3) DO(4, 4)
#define SHADERTWIN_PRODUCTS(C, R)                                                  \
  SHADERTWIN_INLINE vec##R operator*(const mat##C##x##R& m, const vec##C& v) {     \
    return detail::columns_times(m, v);                                            \
  }                                                                                \
  SHADERTWIN_INLINE vec##C operator*(const vec##R& v, const mat##C##x##R& m) {     \
    return detail::row_times(v, m);                                                \
  }                                                                                \
  SHADERTWIN_INLINE mat2x##R operator*(const mat##C##x##R& a, const mat2x##C& b) { \
    return detail::matrix_times(a, b);                                             \
  }                                                                                \
  SHADERTWIN_INLINE mat3x##R operator*(const mat##C##x##R& a, const mat3x##C& b) { \
    return detail::matrix_times(a, b);                                             \
  }                                                                                \
  SHADERTWIN_INLINE mat4x##R operator*(const mat##C##x##R& a, const mat4x##C& b) { \
    return detail::matrix_times(a, b);                                             \
  }
#define SHADERTWIN_QUOTIENT(C, R)                                                          \
  SHADERTWIN_INLINE mat##C##x##R operator/(const mat##C##x##R& a, const mat##C##x##R& b) { \
    return detail::component_quotient(a, b);                                               \
  }
#define SHADERTWIN_MATRIX_COMP_MULT(C, R)                                                       \
  SHADERTWIN_INLINE mat##C##x##R matrixCompMult(const mat##C##x##R& a, const mat##C##x##R& b) { \
    return detail::matrixCompMult_of(a, b);                                                     \
  }
#define SHADERTWIN_TRANSPOSE(C, R)                                  \
  SHADERTWIN_INLINE mat##R##x##C transpose(const mat##C##x##R& m) { \
    return detail::transpose_of(m);                                 \
  }
#define SHADERTWIN_OUTER_PRODUCT(C, R)                                                   \
  SHADERTWIN_INLINE mat##C##x##R outerProduct(const vec##R& column, const vec##C& row) { \
    return detail::outerProduct_of(column, row);                                         \
  }
#define SHADERTWIN_SQUARE(f, R)                   \
  inline SHADERTWIN_TYPE(R, 2) f(const mat2& m) { \
    return detail::f##_of(m);                     \
  }                                               \
  inline SHADERTWIN_TYPE(R, 3) f(const mat3& m) { \
    return detail::f##_of(m);                     \
  }                                               \
  inline SHADERTWIN_TYPE(R, 4) f(const mat4& m) { \
    return detail::f##_of(m);                     \
  }

// --- Integers and relations -------------------------------------------------

#define SHADERTWIN_DIVISION(f, scalar, family)     \
  SHADERTWIN_LANEWISE_2(f, scalar, scalar, scalar) \
  SHADERTWIN_SPREAD_2(f, family, family, family)   \
  SHADERTWIN_SPREAD_2(f, family, family, scalar)   \
  SHADERTWIN_SPREAD_2(f, family, scalar, family)
#define SHADERTWIN_SHIFT(f)                \
  SHADERTWIN_MAP_2(f, ivec, ivec, ivec)    \
  SHADERTWIN_MAP_2(f, ivec, ivec, uvec)    \
  SHADERTWIN_MAP_2(f, uvec, uvec, ivec)    \
  SHADERTWIN_MAP_2(f, uvec, uvec, uvec)    \
  SHADERTWIN_SPREAD_2(f, ivec, ivec, Int)  \
  SHADERTWIN_SPREAD_2(f, ivec, ivec, Uint) \
  SHADERTWIN_SPREAD_2(f, uvec, uvec, Int)  \
  SHADERTWIN_SPREAD_2(f, uvec, uvec, Uint)
#define SHADERTWIN_RELATION(f)        \
  SHADERTWIN_MAP_2(f, bvec, vec, vec) \
  SHADERTWIN_INTEGERS(SHADERTWIN_MAP_2(f, bvec, ivec, ivec) SHADERTWIN_MAP_2(f, bvec, uvec, uvec))
