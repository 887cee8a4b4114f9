#!/bin/sh
# Builds the preset dev and runs its quick tests.
set -eu
cmake --preset dev >/dev/null
ninja -C build/dev --quiet
exec ctest --preset dev --no-tests=error -j "$(nproc)" -LE "style|long"
