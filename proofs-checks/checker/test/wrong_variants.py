#!/usr/bin/env python3
"""Wrong variants of the checker's sources: each must fail on a file of the corpus.

    wrong_variants.py COMPILER GMP_FLAGS BUILD CORPUS [--checks] [--only REGEX] [--lines FIRST-LAST] [--list]

A variant drops one check, or changes one comparison, condition, rounding, end or sign. All are compiled into one program,
where a number in the environment chooses one; it is run on those cases of the corpus where something of it would have
another value, the quickest first, until an outcome is wrong. Variants that no file can tell from the checker stand in
`same.txt`, each with its reason. Prints the variants that survive; exit code 1 if there are any, or if a line of
`same.txt` fits none."""
import argparse
import concurrent.futures
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import variants

test = Path(__file__).resolve().parent
sources = test.parent
files = sorted((file for file in sources.rglob("*.cpp") if test not in file.parents), key=lambda file: file.name)

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
    (r"mpz_cdiv_q\b", "(wrong::there(%d) ? mpz_fdiv_q : mpz_cdiv_q)", "mpz_cdiv_q -> mpz_fdiv_q"),
    (r"mpz_fdiv_q\b", "(wrong::there(%d) ? mpz_cdiv_q : mpz_fdiv_q)", "mpz_fdiv_q -> mpz_cdiv_q"),
    (r"std::floor\(", "wrong::Floor{%d}(", "floor -> ceil"),
    (r"std::max\(", "wrong::Max{%d}(", "max -> min"),
    (r"std::min\(", "wrong::Min{%d}(", "min -> max"),
    (r"std::max_element\(", "wrong::MaxElement{%d}(", "max_element -> min_element"),
    (r"(?<![:\w])abs\(", "wrong::Abs{%d}(", "abs -> nothing"),
    (r" \+= (?!\")", " += wrong::Sum{%d} += ", "+= -> -="),
]
CHECKS = [
    (r"(?<!void )\brequire\(", "wrong::Require{%d}(", "no check"),
    (r"(?:(?<=\n) +|(?<=\)) )(?=(?:surface->)?(?:check|show)_\w+\()", " wrong::there(%d) ? void() : ", "a hypothesis of the claim is not checked"),
]

# With WRONG_TRACE in the environment, a file, the numbers of the variants that would have had another value somewhere (or may
# have had) are written to it at the end.
HEADER = """
#pragma once
#include <gmpxx.h>
#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>
#include <type_traits>
namespace subcert_check {
void require(bool condition, std::string_view why);
}
namespace wrong {
struct Trace {
  std::bitset<1 << 16> differs;
  ~Trace() {
    if (!std::getenv("WRONG_TRACE")) return;
    std::ofstream file(std::getenv("WRONG_TRACE"));
    for (std::size_t id = 0; id < differs.size(); ++id)
      if (differs[id]) file << id << ' ';
  }
};
inline Trace trace;
inline bool on(int id) {
  static const int number = std::getenv("WRONG_VARIANT") ? std::atoi(std::getenv("WRONG_VARIANT")) : 0;
  return number == id;
}
inline bool there(int id) {
  trace.differs[static_cast<std::size_t>(id)] = true;
  return on(id);
}
template <class T> T either(int id, const T& right, const T& other) {
  return right != other && there(id) ? other : right;
}
inline int one(int id) { return either(id, 1, 0); }
struct Require {
  int id;
  void operator()(bool condition, std::string_view why) const { subcert_check::require(either(id, condition, true), why); }
};
struct Floor {
  int id;
  double operator()(double x) const { return either(id, std::floor(x), std::ceil(x)); }
};
#define COMPARISON(Name, right, other)                                                                             \\
  struct Name { int id; };                                                                                         \\
  template <class T> struct Name##Of { const T& left; int id; };                                                   \\
  template <class T> Name##Of<T> operator right(const T& left, Name mark) { return {left, mark.id}; }              \\
  template <class T> Name##Of<std::optional<T>> operator right(const std::optional<T>& left, Name mark) {          \\
    return {left, mark.id};                                                                                        \\
  }                                                                                                                \\
  template <class T, class U> bool operator right(const Name##Of<T>& x, const U& y) {                              \\
    return either(x.id, x.left right y, x.left other y);                                                           \\
  }                                                                                                                \\
  template <class T, class U> bool operator right(const Name##Of<T>& x, const std::optional<U>& y) {               \\
    return either(x.id, x.left right y, x.left other y);                                                           \\
  }
COMPARISON(AtMost, <=, <)
COMPARISON(AtLeast, >=, >)
COMPARISON(Less, <, <=)
COMPARISON(Greater, >, >=)
COMPARISON(Equal, ==, !=)
COMPARISON(Unequal, !=, ==)
struct Right { int id; };
struct RightOf { bool left; explicit operator bool() const { return left; } };
template <class T> RightOf operator&&(const T& left, Right mark) { return {either(mark.id, static_cast<bool>(left), true)}; }
struct Max {
  int id;
  template <class T> T operator()(const T& x, const T& y) const { return either(id, std::max(x, y), std::min(x, y)); }
};
struct Min {
  int id;
  template <class T> T operator()(const T& x, const T& y) const { return either(id, std::min(x, y), std::max(x, y)); }
};
struct MaxElement {
  int id;
  template <class T> T operator()(T x, T y) const { return either(id, std::max_element(x, y), std::min_element(x, y)); }
};
struct Abs {
  int id;
  template <class U> mpz_class operator()(const __gmp_expr<mpz_t, U>& x) const { return either(id, mpz_class(abs(x)), mpz_class(x)); }
  template <class U> mpq_class operator()(const __gmp_expr<mpq_t, U>& x) const { return either(id, mpq_class(abs(x)), mpq_class(x)); }
};
struct Sum {
  int id;
  template <class U> mpz_class operator+=(const __gmp_expr<mpz_t, U>& x) const { return either(id, mpz_class(x), mpz_class(-x)); }
  template <class U> mpq_class operator+=(const __gmp_expr<mpq_t, U>& x) const { return either(id, mpq_class(x), mpq_class(-x)); }
  template <class T> requires(std::is_arithmetic_v<T>) T operator+=(T x) const { return either(id, x, static_cast<T>(-x)); }
};
}  // namespace wrong
"""


def variants_of(changes):
    return variants.variants(files, changes, '"', ("#", "template", "for ("))


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
    parser.add_argument("--checks", action="store_true", help="only dropped checks")
    arguments = variants.arguments_of(parser)
    chosen = variants.chosen(variants_of(CHECKS if arguments.checks else CHECKS + CHANGES), arguments)
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
            line = [*compile_line, f"-I{file.parent}", "-c", source, "-o", source.with_suffix(".o")]
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

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        dropped = set(sum(pool.map(compiled, [*files, test / "many.cpp"]), []))
    objects = [build / f"{file.stem}.o" for file in files if file.stem != "main"]
    for program in ("main", "many"):
        link = [arguments.compiler, build / f"{program}.o", *objects, "-o", build / program, *libraries]
        subprocess.run(link, check=True)

    def trace(folder, words):
        with tempfile.TemporaryDirectory() as scratch:
            file = Path(scratch) / "trace"
            subprocess.run([build / "main", *words], cwd=folder, capture_output=True, check=False, env={**os.environ, "WRONG_TRACE": str(file)})
            return {int(number) for number in file.read_text().split()} if file.exists() else None

    corpus = variants.Corpus(arguments.corpus.resolve(), trace, arguments.jobs, ["many", build / "many"], "ulimit -v 2000000; ")

    def outcome(numbered):
        number, (_, file, *_) = numbered
        if number in dropped:
            return "do not compile"
        checker = [build / "main"] if file.stem == "main" else ["many", build / "many"]
        return "fail" if corpus.fails(checker, number, WRONG_VARIANT=str(number)) else "survive"

    return variants.report(chosen, outcome, corpus, arguments.jobs, variants_of(CHECKS + CHANGES), test / "same.txt")


if __name__ == "__main__":
    sys.exit(main())
