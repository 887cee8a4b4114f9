#!/bin/sh
# Builds the image of cmake/Containerfile and runs it, by podman or docker. Usage: container.sh SOURCE. Exit code: 0 all
# is well, 1 not, 77 there is no engine that runs, or it cannot have the image of Debian.
set -eu
cd "$1"
. cmake/test/bare_root.sh
for engine in podman docker; do
  "$engine" info >/dev/null 2>&1 && break
  engine=
done
[ -n "$engine" ] || skip "neither podman nor docker runs"
"$engine" pull debian:12 >/dev/null 2>&1 || skip "$engine cannot have debian:12"
"$engine" build --quiet -f cmake/Containerfile -t subcert-test .
trap '"$engine" rmi subcert-test >/dev/null' EXIT
inside() { "$engine" run --rm -v "$data:/data" subcert-test "$@"; }
data=$(mktemp -d)
check "exponent     1.9901439593863" regularity primal:n=5 --certificate s5.cert
check VERIFIED verify s5.cert
echo "built and run by $engine"
