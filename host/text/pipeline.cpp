#include "host/text/pipeline.h"

#include "host/text/define_undefined.h"
#include "host/text/make_precise.h"
#include "host/text/resolve_macros.h"

namespace shadertwin {

namespace {

// Sound keeps its text: it is judged by ear, and every operation in order costs time.
bool wants_precise(const Project& project, const Pass& pass) {
  return project.precise && pass.kind != PassKind::sound;
}

PassSource precise_source(const Project& project, const Pass& pass) {
  if (project.undefined == Undefined::raw) return make_precise(project, pass.source);
  return make_precise(project, define_undefined(project, pass.source).value_or(pass.source));
}

}  // namespace

std::vector<PassSource> driver_sources(const Project& project, const Pass& pass) {
  throw_if_refused(pass.source);
  if (pass.vertex.has_value()) throw_if_refused(*pass.vertex);
  if (wants_precise(project, pass)) return {precise_source(project, pass)};
  std::vector<PassSource> sources;
  if (project.undefined == Undefined::zero)
    if (auto defined = define_undefined(project, pass.source)) sources.push_back(*std::move(defined));
  sources.push_back(pass.source);
  return sources;
}

PassSource twin_source(const Project& project, const Pass& pass) {
  throw_if_refused(pass.source);
  return wants_precise(project, pass) ? precise_source(project, pass) : pass.source;
}

}  // namespace shadertwin
