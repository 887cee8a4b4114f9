#!/bin/sh
# What a reader's eye should not have to do. Usage: style.sh format | width | tidy  (from the top of the source tree)
#   format  every C++ file is as clang-format 14 leaves it
#   width   no line of C++, CMake or shell, and of the Python package, is longer than 120 characters; nor a line of the
#           pages in docs, but for tables and what is indented as code
#   tidy    no warning of the list in .clang-tidy in the sources that differ from the commit before the last (or from
#           SUBCERT_STYLE_BASE); at most 4 of them unless SUBCERT_STYLE_ALL is set. Their headers go along. Benchmarks
#           are in the style of their library.
# Exit code: 0 clean, 1 not, 77 not checked.
set -eu
sources() { git ls-files --cached --others --exclude-standard "$@"; }
skip() { echo "skipped: $1"; exit 77; }
git rev-parse --git-dir >/dev/null 2>&1 || skip "not a git checkout"

case "$1" in
  format)
    clang-format --version 2>/dev/null | grep -q 'version 14\.' || skip "need clang-format 14"
    sources '*.cpp' '*.hpp' '*.inc' | xargs clang-format --dry-run -Werror
    ;;
  width)
    sources '*.cpp' '*.hpp' '*.inc' '*.cmake' '*CMakeLists.txt' '*.sh' 'python/*.py' 'python/*.pyi' |
      xargs awk 'length($0) > 120 { print FILENAME ":" FNR ": " length($0) " characters"; bad = 1 } END { exit bad }'
    ! sources 'docs/*.md' ':!docs/theorems' ':!docs/site' |
      LC_ALL=C.UTF-8 xargs grep -nE '^[^|].{120}' | grep -vE '^[^:]+:[0-9]+:    '
    ;;
  tidy)
    clang-tidy --version 2>/dev/null | grep -q 'version 14\.' || skip "need clang-tidy 14"
    base=${SUBCERT_STYLE_BASE:-HEAD~1}
    git rev-parse -q --verify "$base" >/dev/null || skip "no commit $base"
    changed=$({ git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } |
      grep -E '\.(cpp|hpp)$' | grep -vE '^bench/|^proofs-checks/checker/|/consumer/|/fuzz/' | sort -u)
    units=$(for file in $changed; do
      unit=${file%.hpp}
      case "$file" in *.hpp) unit=$unit.cpp ;; esac
      [ ! -f "$unit" ] || echo "$unit"
    done | sort -u)
    [ -n "$units" ] || { echo "no source has changed"; exit 0; }
    if [ -z "${SUBCERT_STYLE_ALL:-}" ] && [ "$(echo "$units" | wc -l)" -gt 4 ]; then
      echo "the first 4 of $(echo "$units" | wc -l) sources; ./check --long looks at all of them"
      units=$(echo "$units" | head -n 4)
    fi
    cmake --preset tidy >/dev/null
    filter=$(for file in $changed; do printf '{"name":"%s"},' "$file"; done)
    echo "$units" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet --warnings-as-errors='*' \
      --line-filter="[${filter%,}]" 2>&1 | { ! grep -vE '^[0-9]+ warnings? generated\.$|^Suppressed|^Use -'; }
    ;;
  *) echo "style.sh: unknown argument '$1'; expected format, width or tidy" >&2; exit 64 ;;
esac
