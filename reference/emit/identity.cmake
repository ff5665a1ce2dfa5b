# Writes the digest of FILES, the emitter's own sources, into OUTPUT.
foreach(file IN LISTS FILES)
  file(SHA256 ${file} digest)
  string(APPEND digests ${digest})
endforeach()
string(SHA256 digest "${digests}")
file(
  WRITE ${OUTPUT}
  "#include \"reference/emit/emit_cpp.h\"\n\nnamespace shadertwin {\nconst char* emit_identity() {\n  return \"${digest}\";\n}\n}  // namespace shadertwin\n")
