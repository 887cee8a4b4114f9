#!/bin/sh
# Makes the archive of a finished build and runs it in a root that has the C library and the archive, nothing else: no
# shell, no other library, no network. As any user. Usage: archive.sh BUILD WORK. Exit code: 0 all is well, 1 not, 77
# not checked.
set -eu
build=$1 work=$2
. "$(dirname "$0")/bare_root.sh"
alone="$(command -v unshare) --user --map-root-user --net --pid --fork"
$alone --mount-proc true 2>/dev/null || skip "need user namespaces"
rm -rf "$work"
mkdir -p "$work/root/tmp" "$work/root/proc"
(cd "$build" && cpack -G TGZ -B "$work") >"$work/cpack.txt" 2>&1 || { cat "$work/cpack.txt"; exit 1; }
tar -xzf "$work"/subcert-*.tar.gz -C "$work/root"
top=$(cd "$work/root" && echo subcert-*)
# Where it stands is not where it was made for.
mv "$work/root/$top" "$work/root/elsewhere"
program=$work/root/elsewhere/bin/subcert
for file in README.md docs/commands.md docs/images/chaikin.png share/man/man1/subcert.1 \
  share/doc/subcert/LICENSE lib/subcert/libgmp10.copyright; do
  [ -s "$work/root/elsewhere/$file" ] || { echo "$file is not in the archive"; exit 1; }
done
# What README names is there.
grep -o '](\([^)#:]*\))' "$work/root/elsewhere/README.md" | sed 's/](\(.*\))/\1/' | while read -r file; do
  [ -e "$work/root/elsewhere/$file" ] || { echo "README names $file, which is not in the archive"; exit 1; }
done
# All that lies outside of it belongs to the C library.
outside=$(ldd "$program" | grep -o '/[^ ]*' | grep -v "^$work/") || true
for library in $outside; do
  case "${library##*/}" in
    ld-linux* | libc.so.* | libm.so.* | libmvec.so.* | libpthread.so.* | libdl.so.* | librt.so.*) ;;
    *) echo "not brought: $library"; exit 1 ;;
  esac
  mkdir -p "$work/root$(dirname "$library")"
  cp -L "$library" "$work/root$library"
done

inside() {
  name=$1
  shift
  env -i $alone --root="$work/root" --mount-proc "/elsewhere/bin/$name" "$@"
}
check "subcert $(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")/\1/p' "$build/CPackConfig.cmake")" subcert --version
check "[-1,0,9,16,9,0,-1]/16@-3" subcert mask four-point:w=1/16
check "exponent     1.9901439593863" subcert regularity primal:n=5 --certificate /tmp/s5.cert
check "6,1" subcert refine chaikin /elsewhere/docs/tutorials/points.csv --levels 0
check VERIFIED subcert verify /tmp/s5.cert
check "mask                 mask:[1,3,3,1]/4@0" subcert atlas chaikin --no-add
check ",dd:n=3" subcert atlas query "holder > 2 and support <= 10 and interpolatory"
check "usage: subcert-check" subcert-check --help
awk 'BEGIN { srand(1); for (i = 0; i < 200; i++) print sin(i / 20) + rand() / 5 }' >"$work/root/tmp/data.csv"
check "x,column 1,column 1_sd,column 1_lower,column 1_upper" subcert smooth /tmp/data.csv --x none
echo "made, unpacked elsewhere and run with the C library alone"
