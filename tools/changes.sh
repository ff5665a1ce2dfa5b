# Sourced by tools/test: which folders of tests passed as a whole, and with what.

stamps=$build/passed

# test_names: as CTest knows them.
test_names() { ctest --test-dir "$build" -N | sed -nE 's/^ *Test +#[0-9]+: (.*)$/\1/p'; }

# What tests of every folder may read: the libraries that are loaded when they are needed, the headers that twins are
# compiled from, every file that is no C++, and the list of tests, to which tests/tools holds the README.
shared_sum=
shared_checksum() {
  [[ -n $shared_sum ]] || shared_sum=$({
    cd "$root"
    test_names
    sha256sum "$build"/*.so
    git ls-files -z --cached --others --exclude-standard |
      grep -zvE '^(host|tests|tools)/.*\.(cpp|h)$|^reference/.*\.cpp$' | xargs -0 sha256sum 2>/dev/null || true
  } | sha256sum | cut -c 1-64)
}

# programs FOLDER: those that its tests start. They have their paths from CMake: of one program, or of the whole build.
programs() {
  local lists=$root/tests/$1/CMakeLists.txt
  [[ -e $lists ]] || lists=$root/tests/CMakeLists.txt  # two programs in one folder: glsl and glsl_probes
  echo "$1_test"
  sed -nE 's/.*TARGET_FILE:([a-z_-]+).*/\1/p' "$lists"
  grep -q CMAKE_BINARY_DIR "$lists" && echo shadertwin shadertwin-emit | tr ' ' '\n' || true
}

# stamp FOLDER: a checksum of all that its tests run and read. Call shared_checksum first.
stamp() {
  { echo "$shared_sum" && cd "$build" && programs "$1" | sort -u | xargs sha256sum 2>/dev/null || true; } |
    sha256sum | cut -c 1-64
}

# unchanged_folders: those whose tests passed with the stamp that they have now.
unchanged_folders() {
  local folder
  shared_checksum
  for folder in $(test_names | sed -n 's/\..*//p' | sort -u); do
    [[ $(cat "$stamps/$folder" 2>/dev/null) == "$(stamp "$folder")" ]] && echo "$folder"
  done
  true
}

# remember_passed_folders: after a run of all tests of each folder that it ran, by its report.
remember_passed_folders() {
  local report=$build/ctest.xml folder
  shared_checksum
  mkdir -p "$stamps"
  for folder in $(sed -nE 's/^.*<testcase name="([^."]+)\..*$/\1/p' "$report" | sort -u); do
    if grep "<testcase name=\"$folder\\." "$report" | grep -qv 'status="run"'; then
      rm -f "$stamps/$folder"
    else
      stamp "$folder" >"$stamps/$folder"
    fi
  done
}
