#!/bin/sh
# Compiles the proofs anew, lets coqchk check what was compiled, extracts the checker and compares it with the source
# that is checked in, and compares the axioms of the theorems with assumptions.txt. coqchk has no fast evaluation: it
# leaves out the files that prove by computation, which the kernel of coqc has checked. At last coqc checks what
# --theorem prints of masks and matrices. Usage: proofs.sh DIRECTORY PROGRAM CORPUS
set -eu
if ! command -v coqc >/dev/null; then
  echo "no Coq: skipped"
  exit 77
fi
here=$(cd "$(dirname "$0")/.." && pwd)
rm -rf "$1"
mkdir -p "$1"
cp "$here"/theory/* "$here"/examples/* "$1"
cd "$1"
if grep -nE '\b(Admitted|admit|Axiom|Parameter|Conjecture)\b' ./*.v; then
  echo "a proof is missing"
  exit 1
fi
modules=
for file in $(sed 1d _CoqProject); do
  coqc -Q . Subcert "$file" >"${file%.v}.out"
  case $file in
    S5.v | S5Exact.v | Scheme.v | Assumptions.v | Extract.v) ;;
    *) modules="$modules Subcert.${file%.v}" ;;
  esac
done
for file in verified.ml verified.mli; do
  diff "$here/extracted/$file" $file
done
diff "$here/test/assumptions.txt" Assumptions.out
# shellcheck disable=SC2086
coqchk -silent -o -Q . Subcert $modules
theorem() {
  name=$1
  shift
  (cd "$corpus" && "$program" "$@" --theorem "$name") >"$name.v"
  coqc -Q . Subcert "$name.v"
}
program=$2
corpus=$3
four='[-1,0,9,16,9,0,-1]/16@-3'
theorem FourLower --mask "$four" --arity 2 --lower 2 four-point.cert
theorem FourBoth --mask "$four" --arity 2 --lower 2 --upper 2 four-point.cert
theorem FourExact --mask "$four" --arity 2 --exact '4-log|[-4,1]@4,0,1|^1/1' four-point-exact.cert
theorem SingleLower --mask '[1,6,15,20,15,6,1]/32' --arity 2 --lower 3/2 single-transfer.cert
theorem SingleExact --mask '[3,0,-25,0,150,256,150,0,-25,0,3]/256@-5' --arity 2 --exact '6-log|[-9,1]@9,0,1|^1/1' \
  --logarithm 0 single-dd3.cert
theorem Logarithm3 --mask '[1,4,10,16,19,16,10,4,1]/27' --arity 3 --exact '4-log|[-3,1]@3,0,1|^1/1' --logarithm 0 \
  single-spline-3-3.cert
theorem FourLogarithm --mask '[-1,0,9,16,9,0,-1]/16' --arity 2 --exact '4-log|[-4,1]@4,0,1|^1/1' --logarithm 1 \
  single-four-point.cert
theorem ReducedLower --mask '[1,2,3,4,3,2,1]/8' --arity 2 --lower 3 single-reduced-second.cert
theorem ReducedBoth --mask '[1,1,1,1]/2' --arity 2 --lower 1 --upper 1 trapezoid-reduced.cert
reduced='[-1,1,7,9,9,7,1,-1]/16@-3'
theorem ReducedExact --mask "$reduced" --arity 2 --lower 2 --upper 2 --exact '4-log|[-4,1]@4,0,1|^1/1' \
  reduced-exact.cert
theorem ReducedLogarithm --mask "$reduced" --arity 2 --exact '4-log|[-4,1]@4,0,1|^1/1' --logarithm 1 single-reduced.cert
theorem HatFull --mask '[1,2,1]/2@-1' --arity 2 --lower 1 --upper 2 hat-full.cert
theorem HatRough --mask '[1,2,1]/2@-1' --arity 2 --upper C2 hat-rough.cert
theorem SingleRough --mask '[-1,0,9,16,9,0,-1]/16' --arity 2 --lower 2 --upper C4 single-rough.cert
theorem ReducedFull --mask '[1,1,1,1]/2' --arity 2 --lower 1 --upper 2 trapezoid-rough.cert
theorem ReducedRough --mask '[1,1,1,1]/2' --arity 2 --lower 1 --upper C2 trapezoid-rough.cert
theorem ReducedExactRough --mask "$reduced" --arity 2 --exact '4-log|[-4,1]@4,0,1|^1/1' --upper C4 \
  reduced-exact-rough.cert
pair='[-1,0,9,16,9,0,-1]/16@-3;[1,4,6,4,1]/8'
theorem ListAny --masks "$pair" --arity 2 --order any --lower 19/10 list-wide.cert
theorem ListFollows --masks "$pair" --arity 2 --order follows=0-1,1-0 --lower 2 list-in-turn.cert
theorem SequencesOfValues --mask '[-w,0,1/2+w,1,1/2+w,0,-w]@-3' --arity 2 --levels w=1/50..1/10 --lower 1 \
  four-point-levels.cert
theorem QuotientOfValues --mask '[1,v,v,1]/(1+v)' --arity 2 --for v=3/2..9 --lower 0 quotient-converges.cert
theorem SquareOfValues --mask '[w^2,1/2,1-2*w^2,1/2,w^2]@-2' --arity 2 --for w=1/5..2/5 --lower 1 square-range.cert
corner="--mask [w,1-w,1-w,w] --arity 2 --levels w=1/100..49/100 --lower 0"
# shellcheck disable=SC2086
theorem FollowRoot $corner --recurrence 'sqrt[1/20+1/10*w]' --start 0..inf --from some follow-root-open.cert
# shellcheck disable=SC2086
theorem FollowQuotient $corner --recurrence '[1]/(3+w)' --start 1/5..1/5 --from 0 follow-quotient.cert
theorem PeriodBoth --masks "$pair" --arity 2 --order period=0,1 --lower 2 --upper 5/2 period.cert
theorem PeriodExact --masks "$pair" --arity 2 --order period=0,1 --exact '4-log|[-8,1]@8,0,1/1000|^1/1' --logarithm 0 \
  period-exact.cert
theorem VectorHats --refinable '[[[2,0],[0,0]],[[4,0],[0,1]],[[2,0],[4,1]]]/4@-1' --dilation '[2]' --lower 1 \
  vector-by-hand.cert
theorem VectorGhm --refinable '[[[6,8],[-1,-3]],[[6,0],[9,10]],[[0,0],[9,-3]],[[0,0],[-1,0]]]/10@0' --dilation '[2]' \
  --lower 1 vector-ghm.cert
theorem VectorMerrien --refinable '[[[4,2],[-1,1]],[[8,0],[0,4]],[[4,-2],[1,1]]]/8@-1' --dilation '[2]' \
  --lower 1415/1000 --upper 1416/1000 vector-merrien.cert
theorem VectorExact --refinable '[[[2,0],[0,0]],[[4,0],[0,3]],[[2,0],[4,3]]]/4@-1' --dilation '[2]' \
  --exact '0-log|[-3,4]@3/4,0,1/4|^1/1' --upper 1/2 vector-exact.cert
component="--refinable [[[2,0],[0,0]],[[4,0],[0,3]],[[2,0],[4,3]]]/4@-1 --dilation [2] --component"
# shellcheck disable=SC2086
theorem VectorComponent $component 0 --lower 1 --upper 1 vector-component-blocks.cert
# shellcheck disable=SC2086
theorem VectorComponentWhole $component 0 --lower 1/5 vector-component-whole.cert
# shellcheck disable=SC2086
theorem VectorComponentExact $component 0 --exact '0-log|[-1,2]@1/2,0,1/4|^1/1' vector-component-exact.cert
vectors() {
  sed -n "s/^$1 --[a-z]* \([^ ]*\) .*/\1/p" "$corpus/claims.txt"
}
theorem VectorScheme --vectors "$(vectors vectors-one-holder)" --arity 2 --lower 99/100 vectors-one-holder.cert
theorem VectorList --vectors "$(vectors vector-list-in-turn)" --arity 2 --order follows=0-1,1-0 --lower 3/4 \
  vector-list-in-turn.cert
theorem VectorListMerrien --vectors "$(vectors hermite-list-as-vectors)" --arity 2 --order any --lower 1 \
  hermite-list-as-vectors.cert
theorem HermiteList --hermite "$(vectors hermite-list-period)" --arity 2 --order period=0,1 --lower 1 \
  hermite-list-period.cert
theorem Columns --matrices columns.mat --lower 1 --upper 11/10 columns-graph-word.cert
theorem Shears --matrices shears.mat --lower 1618/1000 --upper 17/10 shears-graph.cert
theorem ConeExact --matrices golden.mat --exact '|[-1,-1,1]@8/5,0,1/10|^1/1' golden-cone-exact.cert
theorem KeptThirds --matrices kept-thirds.mat --exact '|[1,-27,81]@3/10,0,1/20|^1/2' kept-thirds-least.cert
theorem KeptTurns --matrices kept-turns.mat --exact '|[7,-2,1]@1,49/20,1/5|^1/1' kept-turns-least.cert
theorem KeptFourPoint --mask "$four" --arity 2 --exact '4-log|[-4,1]@4,0,1|^1/1' --lower 2 kept-four-point.cert
theorem BlocksExact --matrices slow-blocks.mat --exact '|[81,-270,100]@47/20,0,1/10|^1/2' blocks-exact.cert
corpus=$here/test/accept
theorem SlowPair --subradius slow-pair.mat --lower 1 --upper 1 slow-pair.cert
theorem SlowGolden --subradius slow-golden.mat --exact '|[-1,-1,1]@8/5,0,1/10|^1/1' --lower 161803/100000 \
  slow-golden.cert
