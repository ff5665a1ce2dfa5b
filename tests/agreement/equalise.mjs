// A shader's text with its transcendental functions replaced by plain arithmetic, so that two devices that round alike
// compute alike: SwiftShader's sine is 2e-4 off, and no two drivers have the same exp2.
//
// What stays the device's own: + - * /, sqrt, floor and what follows from them by one rounding, integers, textures.

const names = [
  'sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'sinh', 'cosh', 'tanh', 'asinh', 'acosh', 'atanh', 'exp', 'exp2', 'log',
  'log2', 'pow', 'inversesqrt', 'normalize', 'length', 'distance', 'mix', 'smoothstep', 'mod', 'reflect', 'refract',
];
const prefix = 'equal_';

// By Cody and Waite to a quadrant, then Taylor's polynomials; powers of two by the bits of the exponent.
const scalars = `
float equal_quarter(float x, int shift) {
  float turns = floor(x * 0.636619772 + 0.5);
  float r = (x - turns * 1.5703125) - turns * 0.000483826792;
  float s = r * r;
  float sine = r * (1.0 + s * (-0.166666667 + s * (0.00833333333 + s * (-0.000198412698 + s * 0.00000275573192))));
  float cosine = 1.0 + s * (-0.5 + s * (0.0416666667 + s * (-0.00138888889 + s * 0.0000248015873)));
  int quarter = int(turns - 4.0 * floor(turns * 0.25)) + shift;
  float value = (quarter & 1) == 0 ? sine : cosine;
  return (quarter & 2) == 0 ? value : -value;
}
float equal_sin(float x) { return equal_quarter(x, 0); }
float equal_cos(float x) { return equal_quarter(x, 1); }
float equal_tan(float x) { return equal_sin(x) / equal_cos(x); }
float equal_atan(float x) {
  float a = abs(x);
  float base = a > 2.414213562 ? 1.570796327 : a > 0.414213562 ? 0.785398163 : 0.0;
  float r = a > 2.414213562 ? -1.0 / a : a > 0.414213562 ? (a - 1.0) / (a + 1.0) : a;
  float s = r * r;
  float value = base + (((0.0805374449 * s - 0.138776856) * s + 0.199777106) * s - 0.333329491) * s * r + r;
  return x < 0.0 ? -value : value;
}
float equal_atan(float y, float x) {
  if (x == 0.0) return y == 0.0 ? 0.0 : y > 0.0 ? 1.570796327 : -1.570796327;
  float value = equal_atan(y / x);
  return x > 0.0 ? value : y < 0.0 ? value - 3.141592654 : value + 3.141592654;
}
float equal_asin(float x) { return equal_atan(x, sqrt((1.0 - x) * (1.0 + x))); }
float equal_acos(float x) { return 1.570796327 - equal_asin(x); }
float equal_exp2(float x) {
  if (!(x > -126.0)) return 0.0;
  if (x > 127.999) return intBitsToFloat(2139095040);
  float whole = floor(x);
  float r = (x - whole) * 0.693147181;
  float value = 1.0 + r * (1.0 + r * (0.5 + r * (0.166666667 + r * (0.0416666667 + r * (0.00833333333 + r * (0.00138888889 + r * 0.000198412698))))));
  return value * intBitsToFloat((int(whole) + 127) << 23);
}
float equal_log2(float x) {
  if (!(x > 0.0)) return x == 0.0 ? -intBitsToFloat(2139095040) : intBitsToFloat(2143289344);
  int bits = floatBitsToInt(x);
  float power = float((bits >> 23) - 127);
  float m = intBitsToFloat((bits & 8388607) | 1065353216);
  if (m > 1.414213562) { m *= 0.5; power += 1.0; }
  float r = (m - 1.0) / (m + 1.0);
  float s = r * r;
  return power + 2.885390082 * r * (1.0 + s * (0.333333333 + s * (0.2 + s * (0.142857143 + s * 0.111111111))));
}
float equal_exp(float x) { return equal_exp2(x * 1.442695041); }
float equal_log(float x) { return equal_log2(x) * 0.693147181; }
float equal_pow(float x, float y) { return y == 0.0 ? 1.0 : x == 0.0 ? 0.0 : equal_exp2(y * equal_log2(x)); }
float equal_sinh(float x) { return 0.5 * (equal_exp(x) - equal_exp(-x)); }
float equal_cosh(float x) { return 0.5 * (equal_exp(x) + equal_exp(-x)); }
float equal_tanh(float x) { float e = equal_exp(2.0 * min(abs(x), 10.0)); return sign(x) * (e - 1.0) / (e + 1.0); }
float equal_asinh(float x) { return sign(x) * equal_log(abs(x) + sqrt(x * x + 1.0)); }
float equal_acosh(float x) { return equal_log(x + sqrt(x * x - 1.0)); }
float equal_atanh(float x) { return 0.5 * equal_log((1.0 + x) / (1.0 - x)); }
float equal_inversesqrt(float x) { return 1.0 / sqrt(x); }
float equal_mix(float a, float b, float t) { return a * (1.0 - t) + b * t; }
float equal_mix(float a, float b, bool t) { return t ? b : a; }
float equal_smoothstep(float a, float b, float x) { float t = min(max((x - a) / (b - a), 0.0), 1.0); return t * t * (3.0 - 2.0 * t); }
float equal_mod(float x, float y) { return x - y * floor(x / y); }
`;

function vectors() {
  const size = [2, 3, 4];
  const parts = (n) => [...'xyzw'].slice(0, n);
  const each = (n, make) => `vec${n}(${parts(n).map(make).join(', ')})`;
  const lines = [];
  const one = ['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'sinh', 'cosh', 'tanh', 'asinh', 'acosh', 'atanh', 'exp', 'exp2', 'log', 'log2', 'inversesqrt'];
  for (const n of size) {
    const v = `vec${n}`;
    for (const f of one) lines.push(`${v} equal_${f}(${v} a) { return ${each(n, (c) => `equal_${f}(a.${c})`)}; }`);
    for (const f of ['atan', 'pow', 'mod'])
      lines.push(`${v} equal_${f}(${v} a, ${v} b) { return ${each(n, (c) => `equal_${f}(a.${c}, b.${c})`)}; }`);
    lines.push(`${v} equal_mod(${v} a, float b) { return ${each(n, (c) => `equal_mod(a.${c}, b)`)}; }`);
    lines.push(`${v} equal_mix(${v} a, ${v} b, ${v} t) { return ${each(n, (c) => `equal_mix(a.${c}, b.${c}, t.${c})`)}; }`);
    lines.push(`${v} equal_mix(${v} a, ${v} b, float t) { return ${each(n, (c) => `equal_mix(a.${c}, b.${c}, t)`)}; }`);
    lines.push(`${v} equal_mix(${v} a, ${v} b, bvec${n} t) { return ${each(n, (c) => `equal_mix(a.${c}, b.${c}, t.${c})`)}; }`);
    lines.push(`${v} equal_smoothstep(${v} a, ${v} b, ${v} x) { return ${each(n, (c) => `equal_smoothstep(a.${c}, b.${c}, x.${c})`)}; }`);
    lines.push(`${v} equal_smoothstep(float a, float b, ${v} x) { return ${each(n, (c) => `equal_smoothstep(a, b, x.${c})`)}; }`);
  }
  const dots = { float: 'a * b', vec2: 'a.x * b.x + a.y * b.y', vec3: 'a.x * b.x + a.y * b.y + a.z * b.z', vec4: 'a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w' };
  for (const [v, dot] of Object.entries(dots)) {
    lines.push(`float equal_dot_(${v} a, ${v} b) { return ${dot}; }`);
    lines.push(`float equal_length(${v} a) { return sqrt(equal_dot_(a, a)); }`);
    lines.push(`float equal_distance(${v} a, ${v} b) { return equal_length(a - b); }`);
    lines.push(`${v} equal_normalize(${v} a) { return a / equal_length(a); }`);
    lines.push(`${v} equal_reflect(${v} i, ${v} n) { return i - n * (2.0 * equal_dot_(n, i)); }`);
    lines.push(
      `${v} equal_refract(${v} i, ${v} n, float eta) { float d = equal_dot_(n, i); float k = 1.0 - eta * eta * (1.0 - d * d); ` +
        `return k < 0.0 ? ${v}(0.0) : eta * i - (eta * d + sqrt(k)) * n; }`,
    );
  }
  return lines.join('\n') + '\n';
}

// One line more in messages.
const library = (scalars + vectors()).replaceAll('\n', ' ');

// Calls in functions and in macros. A constant's initialiser has to stay a constant expression, and what a variable, a
// function of one's own or a member is called is no call of the built-in's: a.length().
export function equalise(code) {
  const tokens = code.matchAll(/\/\/[^\n]*|\/\*[^]*?\*\/|[A-Za-z_]\w*|[^]/g);
  let text = '';
  let depth = 0;
  let constant = false;
  let directive = false;
  let fresh = true; // at a line's start
  for (const [token] of tokens) {
    if (token === '#' && fresh) directive = true;
    if (token === '\n' && !text.endsWith('\\')) directive = false;
    fresh = token === '\n' || (fresh && /^\s$/.test(token));
    if (!directive) {
      if (token === '{') depth += 1;
      if (token === '}') depth -= 1;
      if (token === 'const') constant = true;
      if (/[;{)]/.test(token) && (token !== ')' || depth === 0)) constant = false;
    }
    const calls = names.includes(token) && (directive || (depth > 0 && !constant)) && !/\.\s*$/.test(text);
    text += calls ? prefix + token : token;
  }
  return text;
}

export function equaliseProject(passes) {
  const media = (input) => ({ ...input, sampler: { ...input.sampler, filter: 'nearest' } });
  const used = passes.some((pass) => names.some((name) => new RegExp(`\\b${name}\\b`).test(pass.code)));
  const changed = passes.map((pass) => ({ ...pass, code: equalise(pass.code), inputs: pass.inputs.map(media) }));
  if (!used) return changed;
  const common = changed.find((pass) => pass.type === 'common');
  if (common) common.code = `${library}\n${common.code}`;
  else changed.push({ name: 'Common', type: 'common', code: `${library}\n`, inputs: [] });
  return changed;
}
