#include "host/text/pipeline.h"

#include "host/project/kinds.h"
#include "host/text/define_undefined.h"
#include "host/text/hide_known_values.h"
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

// What is to be made precise.
PassSource defined_source(const Project& project, const Pass& pass, const ShowsFault& shows_fault) {
  if (project.undefined == Undefined::raw) return pass.source;
  return work_around(define_undefined(project, pass.source).value_or(pass.source), shows_fault);
}

}  // namespace

std::vector<PassSource> driver_sources(const Project& project, const Pass& pass,
                                       const ShowsFault& shows_fault) {
  throw_if_refused(pass.source);
  if (pass.vertex.has_value()) throw_if_refused(*pass.vertex);
  if (project.undefined == Undefined::raw) refuse_large_variables(project, pass.source);
  if (wants_precise(project, pass))
    return {make_precise(project, hide_known_values(project, defined_source(project, pass, shows_fault)))};
  std::vector<PassSource> sources;
  if (project.undefined == Undefined::zero)
    if (auto defined = define_undefined(project, pass.source))
      sources.push_back(work_around(*defined, shows_fault));
  sources.push_back(pass.source);
  return sources;
}

PassSource twin_source(const Project& project, const Pass& pass) {
  throw_if_refused(pass.source);
  if (!wants_precise(project, pass)) return pass.source;
  return make_precise(project, defined_source(project, pass, no_fault));
}

}  // namespace shadertwin
