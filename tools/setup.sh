# Sourced by tools/run and tools/test: installs what is missing, configures and builds. Says what it does on
# stderr; does nothing, and needs no network, when everything is there.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

say() { printf '%s\n' "$*" >&2; }

die() {
  say "${0##*/}: $*"
  exit 1
}

# packages KIND...: the packages of tools/packages.txt that are of one of these kinds.
packages() {
  local kind
  for kind; do awk -v kind="$kind" '$1 == kind { print $2 }' "$root/tools/packages.txt"; done
}

# without_commands NAMES: those that are no command. One that is was installed in another way (Node.js from its own
# makers, say), beside which Debian's package may not stand.
without_commands() {
  local name
  for name in $1; do command -v "$name" >/dev/null || echo "$name"; done
}

# install_packages KIND...: gets the packages that this machine lacks.
install_packages() {
  if ! command -v dpkg-query apt-get >/dev/null; then
    say "This is no Debian: going on with what is installed. Needed are (Debian's names): $(packages "$@" | xargs)"
    return
  fi
  local installed missing as_root=()
  # dpkg-query fails when it doesn't know one of the names, which only means that it isn't installed.
  installed=$(packages "$@" | xargs dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null |
    awk '$1 == "installed" { print $2 }' || true)
  missing=$(packages "$@" | grep -vxF -e "$installed" || true)
  missing=$(without_commands "$missing")
  [[ -n $missing ]] || return 0

  if ((EUID != 0)); then
    command -v sudo >/dev/null || die "as root, run: apt-get install $(xargs <<<"$missing")"
    as_root=(sudo)
  fi
  say "Installing $(wc -l <<<"$missing") Debian packages: $(xargs <<<"$missing")"
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
  local log
  log=$(mktemp)
  # shellcheck disable=SC2086  # one word a package
  if ! { "${as_root[@]}" "${apt[@]}" update &&
    "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    die "apt-get could not install them"
  fi
  rm -f "$log"
}

# configure [CMAKE-OPTION...]: a Release build in build/. Without options, an existing one is kept as it is.
configure() {
  [[ $# -eq 0 && -f $build/build.ninja ]] && return
  local log
  log=$(mktemp)
  say "Configuring build/"
  if ! cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    die "CMake failed"
  fi
  rm -f "$log"
}

# build TARGET...
build() {
  say "Building $*"
  cmake --build "$build" --target "$@" >&2 || die "the build failed"
}
