// The way of a pass's text from the user's files to a device's compiler. Each stage takes a PassSource and
// gives one; none looks for what another one wrote.
//
//   read_project      files, includes, directives      host/project/project.h
//   resolve_macros    directives and macros            host/text/resolve_macros.h
//   canonicalise      WebGL's text as all take it      host/text/canonicalise.h
//   assign_globals... initialisers of GLSL ES 1.00     host/text/global_initialisers.h
//   adopt_other_...   uniforms of other hosts          host/text/other_uniforms.h
//   empty_uniform_... blocks, which no host fills      host/text/uniform_blocks.h
//   write_host_text   uniforms and main()              host/text/host_text.h
//   define_undefined  zero where GLSL gives anything   host/text/define_undefined.h
//   work_around       for a driver with faults         host/text/work_around.h
//   hide_known_...    for a precise text               host/text/hide_known_values.h
//   make_precise      operations in the text's order   host/text/make_precise.h
//   render            the whole text for a device      host/text/render.h
//
// load_project (host/text/load.h) runs the first seven; the functions below choose among the others.
#pragma once

#include <vector>

#include "host/project/project.h"
#include "host/text/work_around.h"

namespace shadertwin {

// What a driver is to compile, as Project::undefined and Project::precise ask: to be tried in this order,
// since some driver may refuse what only browsers' rules add. The last one is the shader as it is written.
// `shows_fault`: of that driver. Throws Error(shader) if browsers refuse its directives, or if a precise text
// is asked for and it can't be read.
std::vector<PassSource> driver_sources(const Project& project, const Pass& pass,
                                       const ShowsFault& shows_fault);

// The same for the twin, which defines by itself what GLSL leaves undefined.
PassSource twin_source(const Project& project, const Pass& pass);

}  // namespace shadertwin
