#!/bin/sh
# Makes the wheel, installs it into a virtual environment and uses it. With BUILD it is the wheel of that finished
# build; without, one is built for it and, as root, also installed in a bare Debian that has Python, numpy and pip, as a
# user who is not root. Usage: wheel.sh PYTHON SOURCE FOLDER [BUILD]
set -eu
python=$1 source=$2 folder=$3
. "$source/cmake/test/bare_root.sh"
rm -rf "$folder"
mkdir -p "$folder"
SUBCERT_BUILD=${4-} "$python" -m pip wheel --quiet --no-build-isolation --no-deps --wheel-dir "$folder/dist" "$source"
"$python" -m venv --system-site-packages "$folder/venv" # numpy is there
"$folder/venv/bin/pip" install --quiet --no-index --no-deps "$folder"/dist/*.whl
cat >"$folder/use.py" <<'END'
import subcert
exponent = subcert.scheme('primal:n=5').holder()
assert exponent.exact and exponent.verify().accepted
print(subcert.__version__, exponent, subcert.__file__)
END
cat >"$folder/look_up.py" <<'END'
import subcert
atlas = subcert.Atlas() # the one in the package, as the user has none
assert atlas.find('chaikin', add=False)['mask'] == 'mask:[1,3,3,1]/4@0'
found = atlas.query('holder > 2 and support <= 10 and interpolatory')
assert 'dd:n=3' in [name for entry in found for name in entry.names]
END
cd "$folder"
venv/bin/python use.py | grep "1.9901439593863 $folder/venv"
if [ -z "${4-}" ] || [ -s "$4/atlas.sqlite" ]; then
  env -u XDG_DATA_HOME HOME="$folder" venv/bin/python look_up.py
else
  echo "the build has no atlas: its target 'atlas' was not made"
fi
[ -z "${4-}" ] || exit 0
make_bare_root python3,python3-numpy,python3-pip
cp dist/*.whl use.py look_up.py "$root/tmp"
inside useradd --create-home someone
as_someone() { inside setpriv --reuid someone --regid someone --clear-groups env HOME=/home/someone "$@"; }
as_someone sh -c 'pip install --quiet --break-system-packages --no-deps --user /tmp/subcert-*.whl'
as_someone python3 /tmp/use.py | grep "1.9901439593863 /home/someone"
inside unshare --net setpriv --reuid someone --regid someone --clear-groups env HOME=/home/someone \
  python3 /tmp/look_up.py
