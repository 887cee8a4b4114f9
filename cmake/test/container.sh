#!/bin/sh
# Builds the image of cmake/Containerfile and runs it, by podman, docker or buildah. Usage: container.sh SOURCE. Exit
# code: 0 all is well, 1 not, 77 there is no engine that runs, or no image of Debian. Where the engine neither has one
# nor can fetch it, a small Debian is made from the mirror that this system has.
set -eu
cd "$1"
. cmake/test/bare_root.sh
for engine in podman docker buildah; do
  "$engine" info >/dev/null 2>&1 && break
  engine=
done
[ -n "$engine" ] || skip "neither podman nor docker nor buildah runs"
work=$(mktemp -d)
data=$work/data
mkdir "$data"
clean() {
  [ -z "${container:-}" ] || buildah rm "$container" >/dev/null
  "$engine" rmi subcert-test >/dev/null 2>&1 || true
  rm -rf "$work"
}
trap clean EXIT

# buildah runs programs in a chroot: it needs no namespaces.
build() {
  case $engine in
    buildah) buildah bud --isolation chroot --quiet "$@" ;;
    *) "$engine" build --quiet "$@" ;;
  esac
}
inside() {
  case $engine in
    buildah) buildah run --isolation chroot -v "$data:/data" "$container" -- subcert "$@" ;;
    *) "$engine" run --rm -v "$data:/data" subcert-test "$@" ;;
  esac
}
own_debian() {
  mirror=$(mirror_of_this_system) || { echo "$mirror"; exit 77; }
  mmdebstrap --quiet --mode=root --variant=minbase bookworm "$work/debian.tar" "$mirror" ||
    skip "neither a registry nor $mirror gives a Debian 12"
  case $engine in
    buildah)
      base=$(buildah from scratch)
      buildah add --quiet "$base" "$work/debian.tar" / >/dev/null
      buildah commit --quiet --rm "$base" debian:12 >/dev/null
      ;;
    *) "$engine" import "$work/debian.tar" debian:12 >/dev/null ;;
  esac
  rm "$work/debian.tar"
  for name in debian:12-slim docker.io/library/debian:12 docker.io/library/debian:12-slim; do
    "$engine" tag debian:12 "$name"
  done
}
"$engine" inspect --type image debian:12 >/dev/null 2>&1 || "$engine" pull debian:12 >/dev/null 2>&1 || own_debian
build -f cmake/Containerfile -t subcert-test . >/dev/null
[ "$engine" != buildah ] || container=$(buildah from subcert-test)
check "exponent     1.9901439593863" regularity primal:n=5 --certificate s5.cert
check VERIFIED verify s5.cert
check "mask                 mask:[1,3,3,1]/4@0" atlas chaikin --no-add
check ",dd:n=3" atlas query "holder > 2 and support <= 10 and interpolatory"
[ -s "$data/s5.cert" ] || { echo "the certificate is not in the folder that was mounted"; exit 1; }
echo "built and run by $engine"
