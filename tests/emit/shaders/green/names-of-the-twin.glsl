// Names that the twin, its headers or C++ use, as names of everything: none is the shader's business.
struct Quad { float Lod; vec2 Quad_; };
struct PixelLoop { Quad quad; float PixelLoop_; };
struct ray { vec3 d; };
struct hit { ray ray; float hit_; };
struct Lods { float lod_; };
struct place_ { float x_; };
struct exp2 { float min; };
float uses_stop = 1., stop_ = 2., end_ = 3., rounds_ = 4., quad_ = 5., lane_ = 6., M_PIf = 7., uses_derivatives = 8.;
int alloca = 1, le32toh = 2, SHADERTWIN_EXPORT = 3, SHADERTWIN_INLINE = 4, _mm_pause = 5, _MM_HINT_T0 = 6, major = 7;
float new_ = 1., delete_ = 2., make_ = 3., at_ = 4.;
float exchange(float stop) { return stop + 1.; }
float lod(float setjmp) { return setjmp * 2.; }
float watch(float initialise) { return initialise - 1.; }
float delete(float new) { return new + new_; }
float bind(float Bind) { return Bind; }
float make(float at) { float loop = at, tmp = 2., result = 3.; return loop + tmp + result; }
float get(hit hit) { return hit.ray.d.x + hit.hit_; }
void mainImage(out vec4 o, vec2 p) {
  float select = 1., any = 2., set = 3., same = 4., alive = 5., keep = 6., mask_out = 7., spread = 8., std = 9.;
  float float8 = p.x - p.x, Denormals = 2., as_pixel = 3., Request = 4., NULL = 5., _Float64 = 6.;
  Quad quad = Quad(1., vec2(2.));
  PixelLoop loop = PixelLoop(quad, 3.);
  hit hit = hit(ray(vec3(1. + float8)), 2.);
  exp2 e = exp2(4.);
  bool ok = uses_stop + stop_ + end_ + rounds_ + quad_ + lane_ + M_PIf + uses_derivatives == 36.;
  ok = ok && alloca + le32toh + SHADERTWIN_EXPORT + SHADERTWIN_INLINE + _mm_pause + _MM_HINT_T0 + major == 28;
  ok = ok && exchange(1.) == 2. && lod(2.) == 4. && watch(3.) == 2. && delete(4.) == 5. && bind(5.) == 5. && make(6.) == 11.;
  ok = ok && delete_ + make_ + at_ == 9. && get(hit) == 3. && loop.quad.Quad_.y == 2. && loop.PixelLoop_ == 3.;
  ok = ok && select + any + set + same + alive + keep + mask_out + spread + std == 45. && e.min == 4. && Lods(1.).lod_ + place_(2.).x_ == 3.;
  ok = ok && Denormals + as_pixel + Request + NULL + _Float64 == 20. && pow(2., float8 + 3.) == 8.;
  if (p.x < 8.) ok = ok && max(1., float8 + 2.) == 2.;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}
