#include "host/text/pipeline.h"

#include "host/project/kinds.h"
#include "host/text/define_undefined.h"
#include "host/text/make_precise.h"
#include "host/text/resolve_macros.h"
#include "host/text/storage.h"

namespace shadertwin {

namespace {

// Sound keeps its text: it is judged by ear, and every operation in order costs time.
bool wants_precise(const Project& project, const Pass& pass) {
  return project.precise && traits(pass).every_frame;
}

bool no_fault(Fault /*fault*/) {
  return false;
}

PassSource precise_source(const Project& project, const Pass& pass, const ShowsFault& shows_fault) {
  if (project.undefined == Undefined::raw) return make_precise(project, pass.source);
  const PassSource defined = define_undefined(project, pass.source).value_or(pass.source);
  return make_precise(project, work_around(defined, shows_fault));
}

}  // namespace

std::vector<PassSource> driver_sources(const Project& project, const Pass& pass,
                                       const ShowsFault& shows_fault) {
  throw_if_refused(pass.source);
  if (pass.vertex.has_value()) throw_if_refused(*pass.vertex);
  if (project.undefined == Undefined::raw) refuse_large_variables(project, pass.source);
  if (wants_precise(project, pass)) return {precise_source(project, pass, shows_fault)};
  std::vector<PassSource> sources;
  if (project.undefined == Undefined::zero)
    if (auto defined = define_undefined(project, pass.source))
      sources.push_back(work_around(*defined, shows_fault));
  sources.push_back(pass.source);
  return sources;
}

PassSource twin_source(const Project& project, const Pass& pass) {
  throw_if_refused(pass.source);
  return wants_precise(project, pass) ? precise_source(project, pass, no_fault) : pass.source;
}

}  // namespace shadertwin
