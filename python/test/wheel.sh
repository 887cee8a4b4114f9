#!/bin/sh
# Installs the package by pip into a folder of its own and uses it. Usage: wheel.sh PYTHON SOURCE FOLDER
set -eu
rm -rf "$3"
"$1" -m pip install --quiet --no-build-isolation --no-deps --target "$3" "$2"
cd "$3"
PYTHONPATH="$3" "$1" -c "
import subcert
assert subcert.__file__.startswith('$3'), subcert.__file__
exponent = subcert.scheme('primal:n=5').holder()
assert exponent.exact and exponent.verify().accepted
print(subcert.__version__, exponent)"
