#!/usr/bin/env python3
"""Wrong variants of the checker's sources: each must fail on a file of the corpus.

    wrong_variants.py COMPILER GMP_FLAGS BUILD CORPUS [--checks] [--only REGEX] [--list]

A variant drops one check, or changes one comparison, condition, rounding, end or sign. All are compiled into one program,
where a number in the environment chooses one; it is run on the corpus until an outcome is wrong. Variants that no file can
tell from the checker stand in `same.txt`, each with its reason. Prints the variants that survive; exit code 1 if there are
any, or if a line of `same.txt` fits none."""
import argparse
import concurrent.futures
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import variants

test = Path(__file__).resolve().parent
sources = test.parent

# What is looked for, what stands in its place, and what the variant does. `a < b` becomes `(a < Less) < b` and so on, which
# keeps the order of evaluation; `a && b` becomes `(a && Right) && b`.
CHANGES = [
    (r" <= ", " <= wrong::AtMost{%d} <= ", "<= -> <"),
    (r" >= ", " >= wrong::AtLeast{%d} >= ", ">= -> >"),
    (r"(?<!operator) < (?!=)", " < wrong::Less{%d} < ", "< -> <="),
    (r" > (?!=)", " > wrong::Greater{%d} > ", "> -> >="),
    (r" == ", " == wrong::Equal{%d} == ", "== -> !="),
    (r" != ", " != wrong::Unequal{%d} != ", "!= -> =="),
    (r" && ", " && wrong::Right{%d} && ", "&& -> the right side alone"),
    (r" \+ 1\b", " + wrong::one(%d)", "+ 1 -> nothing"),
    (r" - 1\b", " - wrong::one(%d)", "- 1 -> nothing"),
    (r"mpz_cdiv_q\b", "(wrong::on(%d) ? mpz_fdiv_q : mpz_cdiv_q)", "mpz_cdiv_q -> mpz_fdiv_q"),
    (r"mpz_fdiv_q\b", "(wrong::on(%d) ? mpz_cdiv_q : mpz_fdiv_q)", "mpz_fdiv_q -> mpz_cdiv_q"),
    (r"std::floor\(", "(wrong::on(%d) ? wrong::ceil : wrong::floor)(", "floor -> ceil"),
    (r"std::max\(", "wrong::Max{%d}(", "max -> min"),
    (r"std::min\(", "wrong::Min{%d}(", "min -> max"),
    (r"std::max_element\(", "wrong::MaxElement{%d}(", "max_element -> min_element"),
    (r"(?<![:\w])abs\(", "wrong::Abs{%d}(", "abs -> nothing"),
    (r" \+= (?!\")", " += wrong::Sum{%d} += ", "+= -> -="),
]
CHECKS = [
    (r"(?<!void )\brequire\(", "(wrong::on(%d) ? wrong::ignore : require)(", "no check"),
    (r"(?:(?<=\n) +|(?<=\)) )(?=(?:surface->)?(?:check|show)_\w+\()", " wrong::on(%d) ? void() : ", "a hypothesis of the claim is not checked"),
]

HEADER = """
#pragma once
#include <gmpxx.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <type_traits>
namespace wrong {
inline bool on(int id) {
  static const int number = std::getenv("WRONG_VARIANT") ? std::atoi(std::getenv("WRONG_VARIANT")) : 0;
  return number == id;
}
inline int one(int id) { return on(id) ? 0 : 1; }
inline void ignore(bool, std::string_view) {}
inline double floor(double x) { return std::floor(x); }
inline double ceil(double x) { return std::ceil(x); }
#define COMPARISON(Name, right, other)                                                                             \\
  struct Name { int id; };                                                                                         \\
  template <class T> struct Name##Of { const T& left; int id; };                                                   \\
  template <class T> Name##Of<T> operator right(const T& left, Name mark) { return {left, mark.id}; }              \\
  template <class T> Name##Of<std::optional<T>> operator right(const std::optional<T>& left, Name mark) {          \\
    return {left, mark.id};                                                                                        \\
  }                                                                                                                \\
  template <class T, class U> bool operator right(const Name##Of<T>& x, const U& y) {                              \\
    return on(x.id) ? x.left other y : x.left right y;                                                             \\
  }                                                                                                                \\
  template <class T, class U> bool operator right(const Name##Of<T>& x, const std::optional<U>& y) {               \\
    return on(x.id) ? x.left other y : x.left right y;                                                             \\
  }
COMPARISON(AtMost, <=, <)
COMPARISON(AtLeast, >=, >)
COMPARISON(Less, <, <=)
COMPARISON(Greater, >, >=)
COMPARISON(Equal, ==, !=)
COMPARISON(Unequal, !=, ==)
struct Right { int id; };
struct RightOf { bool left; explicit operator bool() const { return left; } };
template <class T> RightOf operator&&(const T& left, Right mark) { return {static_cast<bool>(left) || on(mark.id)}; }
struct Max {
  int id;
  template <class T> T operator()(const T& x, const T& y) const { return on(id) ? std::min(x, y) : std::max(x, y); }
};
struct Min {
  int id;
  template <class T> T operator()(const T& x, const T& y) const { return on(id) ? std::max(x, y) : std::min(x, y); }
};
struct MaxElement {
  int id;
  template <class T> T operator()(T x, T y) const { return on(id) ? std::min_element(x, y) : std::max_element(x, y); }
};
struct Abs {
  int id;
  template <class U> mpz_class operator()(const __gmp_expr<mpz_t, U>& x) const { return on(id) ? mpz_class(x) : mpz_class(abs(x)); }
  template <class U> mpq_class operator()(const __gmp_expr<mpq_t, U>& x) const { return on(id) ? mpq_class(x) : mpq_class(abs(x)); }
};
struct Sum {
  int id;
  template <class U> mpz_class operator+=(const __gmp_expr<mpz_t, U>& x) const { return on(id) ? mpz_class(-x) : mpz_class(x); }
  template <class U> mpq_class operator+=(const __gmp_expr<mpq_t, U>& x) const { return on(id) ? mpq_class(-x) : mpq_class(x); }
  template <class T> requires(std::is_arithmetic_v<T>) T operator+=(T x) const { return static_cast<T>(on(id) ? -x : x); }
};
}  // namespace wrong
"""


def variants_of(changes):
    return variants.variants(sorted(sources.glob("*.cpp")), changes, '"', ("#", "template", "for ("))


def with_variants(file, numbered):
    """The text of a file with those of the numbered variants that are in it."""
    text = file.read_text()
    for number, (_, _, begin, end, new) in sorted(numbered.items(), key=lambda item: -item[1][2]):
        text = text[:begin] + new % number + text[end:]
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("compiler")
    parser.add_argument("flags", help="of GMP, as one argument")
    parser.add_argument("build", type=Path)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("--only", default="", help="variants whose name this matches")
    parser.add_argument("--checks", action="store_true", help="only dropped checks")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    chosen = {n: v for n, v in enumerate(variants_of(CHECKS if arguments.checks else CHECKS + CHANGES), 1) if re.search(arguments.only, v[0])}
    if arguments.list:
        print("\n".join(name for name, *_ in chosen.values()))
        return 0
    build = arguments.build.resolve()
    build.mkdir(parents=True, exist_ok=True)
    (build / "wrong.hpp").write_text(HEADER)
    flags = shlex.split(arguments.flags)
    libraries = [flag for flag in flags if not flag.startswith("-I")]
    compile_line = [arguments.compiler, "-std=c++20", "-O1", "-w", "-D_GLIBCXX_ASSERTIONS", f"-I{sources}"]
    compile_line += ["-include", build / "wrong.hpp", *(flag for flag in flags if flag.startswith("-I"))]

    def compiled(file):
        """The numbers of the variants that do not compile."""
        numbered, dropped = {n: v for n, v in chosen.items() if v[1] == file}, []
        source = build / file.name
        while True:
            source.write_text(with_variants(file, numbered))
            line = [*compile_line, "-c", source, "-o", source.with_suffix(".o")]
            done = subprocess.run(line, capture_output=True, text=True, check=False)
            if done.returncode == 0:
                return dropped
            lines = {int(n) for n in re.findall(rf"{re.escape(str(source))}:(\d+):\d+:", done.stderr)}
            bad = [n for n, v in numbered.items() if file.read_text()[: v[2]].count("\n") + 1 in lines and v[4] != CHECKS[0][1]]
            if not bad:
                sys.exit(f"{file.name} does not compile\n{done.stderr}")
            dropped += bad
            for n in bad:
                del numbered[n]

    files = sorted(sources.glob("*.cpp"))
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        dropped = set(sum(pool.map(compiled, [*files, test / "many.cpp"]), []))
    objects = [build / f"{file.stem}.o" for file in files if file.stem != "main"]
    for program in ("main", "many"):
        link = [arguments.compiler, build / f"{program}.o", *objects, "-o", build / program, *libraries]
        subprocess.run(link, check=True)

    def outcome(numbered):
        number, (_, file, *_) = numbered
        if number in dropped:
            return "do not compile"
        checker = [build / "main"] if file.stem == "main" else ["many", build / "many"]
        return "fail" if variants.fails(checker, arguments.corpus, "ulimit -v 2000000; ulimit -t 20", WRONG_VARIANT=str(number)) else "survive"

    if outcome((0, (None, test / "many.cpp"))) != "survive":
        sys.exit("the checker itself fails")
    return variants.report(chosen, outcome, arguments.jobs, variants_of(CHECKS + CHANGES), test / "same.txt")


if __name__ == "__main__":
    sys.exit(main())
