// A pass that compiles, parsed once for all rules that look at its tree.
#pragma once

#include "host/text/storage.h"
#include "reference/emit/program.h"

namespace shadertwin::check {

struct ParsedPass {
  // Throws Error(shader) with all errors of an ES 3.00 front end, and for recursion and functions without a
  // body.
  ParsedPass(const Project& project, const Pass& pass);

  const Project& project;
  const Pass& pass;
  SyntaxTree tree;
  emit::Program program;
  Storage storage;
};

}  // namespace shadertwin::check
