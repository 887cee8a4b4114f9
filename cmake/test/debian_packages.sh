#!/bin/sh
# Makes the Debian packages of a finished build, has lintian look at them, and installs them in a bare root.
# Usage: debian_packages.sh BUILD WORK. Exit code: 0 all is well, 1 not, 77 not checked, or not installed for lack of
# root or of a mirror.
set -eu
build=$1 work=$2
. "$(dirname "$0")/bare_root.sh"
command -v dpkg-shlibdeps >/dev/null || skip "need dpkg-dev"
rm -rf "$work"
mkdir -p "$work"
(cd "$build" && cpack -G DEB -B "$work") >"$work/cpack.txt" || { cat "$work/cpack.txt"; exit 1; }
ls "$work"/*.deb

# The packages name no address to write to, so the contact is none in lintian's eyes; see docs/installing.md.
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error --suppress-tags malformed-contact,bogus-mail-host-in-debian-changelog \
    "$work"/*.deb
else
  echo "lintian is not there: the packages are not looked at"
fi

make_bare_root
cp "$work"/*.deb "$root/root"
inside sh -c 'apt-get install -y -qq --no-install-recommends /root/subcert_*.deb' >"$work/install.txt" 2>&1 ||
  { cat "$work/install.txt"; exit 1; }
check "subcert $(sed -n 's/^CPACK_PACKAGE_VERSION "\(.*\)"/\1/p; s/^set(CPACK_PACKAGE_VERSION "\(.*\)")/\1/p' \
  "$build/CPackConfig.cmake")" subcert --version
check "[-1,0,9,16,9,0,-1]/16@-3" subcert mask four-point:w=1/16
inside subcert regularity dual:n=2 --certificate /root/c.cert >/dev/null
check VERIFIED subcert verify /root/c.cert
check "mask                 mask:[1,3,3,1]/4@0" unshare --net subcert atlas chaikin --no-add
check ",dd:n=3" unshare --net subcert atlas query "holder > 2 and support <= 10 and interpolatory"
for file in man/man1/subcert.1.gz man/man1/subcert-range.1.gz bash-completion/completions/subcert \
  zsh/vendor-completions/_subcert fish/vendor_completions.d/subcert.fish doc/subcert/copyright \
  doc/subcert/changelog.gz; do
  [ -s "$root/usr/share/$file" ] || { echo "/usr/share/$file is not installed"; exit 1; }
done
inside sh -c 'apt-get install -y -qq --no-install-recommends /root/libsubcert-dev_*.deb g++ pkg-config' \
  >"$work/install.txt" 2>&1 || { cat "$work/install.txt"; exit 1; }
cp "$(dirname "$0")/consumer/consumer.cpp" "$root/root"
inside sh -c 'g++ -std=c++20 /root/consumer.cpp $(pkg-config --cflags --libs subcert) -o /root/consumer'
check "is C^1, phi(0) = 1/2" /root/consumer
inside sh -c 'apt-get purge -y -qq subcert libsubcert-dev' >/dev/null 2>&1
left=$(find "$root/usr" -name '*subcert*')
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
echo "installed, run and removed in a bare $VERSION_CODENAME"
