# Sourced: a Debian that has little, as the system that runs the test; as root, with a mirror, or the test is skipped.
skip() { echo "skipped: $1"; exit 77; }

# mirror_of_this_system: prints where apt has its packages from.
mirror_of_this_system() {
  [ "$(id -u)" -eq 0 ] || skip "the bare root needs root"
  command -v mmdebstrap >/dev/null || skip "the bare root needs mmdebstrap"
  . /etc/os-release
  [ -n "${VERSION_CODENAME:-}" ] || skip "the system has no code name"
  found=$(apt-get indextargets --format '$(SITE) $(RELEASE) $(IDENTIFIER)' | awk -v release="$VERSION_CODENAME" \
    '$2 == release && $3 == "Packages" { print $1; exit }')
  [ -n "$found" ] || skip "no mirror with $VERSION_CODENAME is configured"
  echo "$found"
}

# make_bare_root [PACKAGE,...]: sets $root, which is removed at the end. It is for one run: nothing waits for the
# disk, and its locales and most of its papers stay away.
make_bare_root() {
  mirror=$(mirror_of_this_system) || { echo "$mirror"; exit 77; }
  . /etc/os-release
  root=$(mktemp -d)
  trap 'rm -rf "$root"' EXIT
  trap 'trap "" HUP INT TERM; exit 143' HUP INT TERM
  said=$(mmdebstrap --quiet --mode=root --variant=apt --dpkgopt=force-unsafe-io --aptopt='Acquire::Languages "none"' \
    --dpkgopt='path-exclude=/usr/share/locale/*' --dpkgopt='path-exclude=/usr/share/info/*' \
    --dpkgopt='path-include=/usr/share/man/*' ${1:+"--include=$1"} "$VERSION_CODENAME" "$root" "$mirror" 2>&1) ||
    skip "no bare $VERSION_CODENAME from $mirror: $(echo "$said" | grep '^E: ' | head -n 1)"
  inside sh -c 'test -c /dev/null && echo >/dev/null' 2>/dev/null ||
    skip "${TMPDIR:-/tmp} takes no devices, or nothing may be mounted"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  cp -r /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
  inside apt-get update -qq >/dev/null 2>&1 || skip "the bare root does not reach $mirror"
}

# inside COMMAND...: in the root, with its own /proc, by which a program that is started finds the libraries beside it.
inside() {
  unshare --mount sh -c 'mount -t proc proc "$1/proc" && exec chroot "$@"' sh "$root" \
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+"http_proxy=$http_proxy"} "$@"
}

# check TEXT COMMAND...: the command runs in the root and prints the text.
check() {
  wanted=$1
  shift
  got=$(inside "$@") || { echo "$*: exit code $?"; exit 1; }
  case "$got" in
    *"$wanted"*) ;;
    *) echo "$*: expected $wanted, got $got"; exit 1 ;;
  esac
}
