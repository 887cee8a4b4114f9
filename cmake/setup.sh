# Sourced by ./reproduce and ./check: installs what is missing and builds.
set -eu

readonly build=build/release

# What the program and its reports need, as Debian names it.
readonly packages_to_run="g++ cmake ninja-build libboost-dev libboost-filesystem-dev libboost-iostreams-dev
  libboost-system-dev libeigen3-dev libgmp-dev libmpfr-dev libflint-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libsqlite3-dev libtomlplusplus-dev libgnuplot-iostream-dev gnuplot-nox libopenmpi-dev openmpi-bin fonts-dejavu-core"
# What tests and benchmarks need beside.
readonly packages_to_check="catch2 libbenchmark-dev python3 python3-jsonschema python3-yaml git clang-format clang-tidy
  man-db pkg-config zsh fish pybind11-dev python3-dev python3-numpy python3-sympy python3-pytest python3-hypothesis mypy
  python3-nbconvert python3-ipykernel python3-matplotlib python3-pandas ocaml ocaml-findlib libzarith-ocaml-dev nodejs"
# What makes Debian packages, and what tries them in the long tests.
readonly packages_to_pack="dpkg-dev file"
readonly packages_to_try="$packages_to_pack lintian mmdebstrap buildah coq chromium firefox-esr"
# Beside FLINT 2 the library Arb is a package of its own; FLINT 3 contains it.
readonly packages_where_they_exist="libflint-arb-dev"
packages=$packages_to_run

# refuse COMMAND WORDS: the one line about wrong usage.
refuse() {
  command=$1
  shift
  echo "$command: $*" >&2
  exit 64
}

# is_one_of WORD WORD...
is_one_of() {
  sought=$1
  shift
  for one; do
    [ "$one" != "$sought" ] || return 0
  done
  return 1
}

has_package() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing_packages() {
  for package in $packages $packages_where_they_exist; do
    has_package "$package" || printf '%s\n' "$package"
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_missing() {
  command -v dpkg-query >/dev/null || {
    echo "not a Debian system: install by hand what docs/developing/dependencies.md lists" >&2
    return
  }
  missing=$(missing_packages)
  if [ "${1:-}" = list ]; then
    echo "missing packages:" ${missing:-none}
    return 0
  fi
  [ -n "$missing" ] || return 0
  as_root apt-get update -qq
  wanted=
  for package in $missing; do
    case " $packages_where_they_exist " in
      *" $package "*) apt-cache show "$package" >/dev/null 2>&1 || continue ;;
    esac
    wanted="$wanted $package"
  done
  [ -n "$wanted" ] || return 0
  echo "installing:$wanted"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $wanted >/dev/null
}

# build TARGET: progress is one line that moves on a terminal, and nothing elsewhere.
build() {
  if [ -t 1 ]; then
    NINJA_STATUS="building %f of %t: " ninja -C "$build" "$1"
  else
    ninja -C "$build" --quiet "$1"
  fi
}

# Lets `import subcert` find the package in the build tree: a line in a file of its own among the user's packages.
offer_python() {
  if ! PYTHONPATH="$build/python" python3 -c "import subcert" 2>/dev/null; then
    [ -d "$build/python" ] && echo "python3 on the PATH is not the one that $build/python was built for" >&2
    return 0
  fi
  file=$(python3 -c "import site, sysconfig
print(site.getusersitepackages() if site.ENABLE_USER_SITE else sysconfig.get_path('purelib'))")/subcert.pth
  mkdir -p "$(dirname "$file")"
  printf '%s\n' "$PWD/$build/python" >"$file"
  echo "import subcert: by $file"
}
