#!/bin/sh
# Exit codes, --show, and the theorems on primal:n=5 as they are checked in. Usage: command_line.sh PROGRAM CORPUS
set -eu
program=$1
corpus=$2
here=$(cd "$(dirname "$0")" && pwd)
cd "$corpus"

# expect CODE ARGUMENTS...
expect() {
  code=$1
  shift
  status=0
  output=$("$program" "$@" 2>&1) || status=$?
  if [ "$status" -ne "$code" ] || { [ "$code" -ne 0 ] && echo "$output" | grep -q ^VERIFIED; }; then
    echo "$*: exit code $status, not $code: $output"
    exit 1
  fi
}

expect 0 --help
expect 64
expect 64 golden.cert
expect 64 --matrices golden.mat golden.cert
expect 64 --matrices golden.mat --upper 2
expect 64 --matrices golden.mat --upper 2/0 golden.cert
expect 64 --matrices golden.mat --upper 2 --other 2 golden.cert
expect 64 --matrices golden.mat --upper 2 --theorem 'a.b' golden.cert
expect 65 --matrices golden.cert --upper 2 golden.cert
expect 66 --matrices none.mat --upper 2 golden.cert
expect 66 --matrices golden.mat --upper 2 none.cert
expect 66 --matrices golden.mat --upper 2 .
expect 1 --matrices golden.mat --upper 2 golden.mat
expect 1 --matrices golden.mat --upper -1 golden.cert
hat='[1/2,1,1/2]@-1'
expect 0 --mask "$hat" --arity 2 --lower 1 bspline-1.cert
expect 0 --mask "$hat" --arity 2 --lower 1 --show bspline-1.cert
echo "$output" | grep -qx 'coefficient -1 is 1/2'
expect 1 --mask '[1,2,1]/2@-1' --arity 2 --lower 1 bspline-1.cert
expect 1 --mask "$hat" --arity 2 --lower 1000001/1000000 bspline-1.cert
expect 1 --mask "$hat" --arity 2 --lower 0 bspline-1.cert
expect 1 --mask "$hat" --arity 2 --lower -1 bspline-1.cert
expect 0 --mask "$hat" --arity 2 --lower 1 --upper 1 bspline-1.cert
expect 1 --mask "$hat" --arity 2 --lower 1/2 --upper 999/1000 bspline-1.cert
expect 1 --mask "$hat" --arity 2 --lower 1 --upper -1 bspline-1.cert
expect 1 --mask "$hat" --arity 2 --lower 1 --upper C2 bspline-1.cert
linear='[1,2,1]/2@-1'
expect 0 --mask "$linear" --arity 2 --lower 1 --upper C2 hat-full.cert
expect 0 --mask "$linear" --arity 2 --upper C2 --show hat-rough.cert
echo "$output" | grep -qx 'limits, if there are any, are not C^2'
expect 0 --mask "$linear" --arity 2 --upper C3 hat-rough.cert
expect 1 --mask "$linear" --arity 2 --upper C1 hat-rough.cert
expect 64 --mask "$linear" --arity 2 --upper C0 hat-rough.cert
expect 64 --mask "$linear" --arity 2 --upper C hat-rough.cert
expect 64 --mask "$linear" --arity 2 --upper C2 --logarithm 0 hat-rough.cert
expect 64 --matrices golden.mat --upper C2 golden.cert
expect 1 --mask '[1,1,1,1]/2' --arity 2 --upper C2 trapezoid-rough.cert
expect 2 --mask "$hat" --arity 2 bspline-1.cert --within 1/100,1 --lower 9/10
expect 2 --l1 6,1 --contraction 1,1,3/5 l1-6.cert
expect 2 --l1 6,1 --lower 7/10 l1-6.cert
expect 64 --l1 6,1 l1-6.cert
expect 2 --l1 6,1 --lower 7/10 --upper 2 l1-6.cert
expect 64 --l1 6,1 --upper 2 l1-6.cert
expect 0 --mask '[1,1,1,1]/2' --arity 2 --lower 1 trapezoid-reduced.cert
expect 0 --mask '[1,1,1,1]/2' --arity 2 --lower 1 --upper 1 --show trapezoid-reduced.cert
echo "$output" | grep -qx 'coefficient 3 is 1/2'
expect 1 --mask '[1,1,1,1]/2' --arity 2 --lower 1001/1000 trapezoid-reduced.cert
expect 1 --mask '[1,1,1,1]/2' --arity 2 --lower 1 --upper 999/1000 trapezoid-reduced.cert
expect 1 --mask '[1,1,1,1]/2@1' --arity 2 --lower 1 trapezoid-reduced.cert
expect 64 --mask "$hat" --lower 1 bspline-1.cert
four='[-1,0,9,16,9,0,-1]/16@-3'
exactly() {
  code=$1
  shift
  expect "$code" --mask "$four" --arity 2 "$@" four-point-exact.cert
}
exactly 0 --exact '4-log|[-4,1]@4,0,1|^1/1' --show
echo "$output" | grep -q '^exactly 4 less the logarithm, .* of the zero within 1 of 4 + i 0 of'
echo "$output" | grep -qx 'coefficient of x^1 is 1'
exactly 0 --exact '4-log|[-4,1]@4,0,1|^1/1' --lower 2 --upper 2
exactly 1 --exact '4-log|[-4,1]@4,0,1|^1/1' --lower 201/100
exactly 1 --exact '4-log|[-4,1]@4,0,1|^1/1' --upper 199/100
exactly 1 --exact '3-log|[-4,1]@4,0,1|^1/1'
exactly 1 --exact '4-log|[-4,1]@4,0,1|^1/2'
exactly 1 --exact '4-log|[-4,1]@4,0,1|^1/1' --logarithm 1
exactly 64 --lower 2 --logarithm 0
exactly 1 --exact '4-log|[-4,1]@4,0,1|^1/1' --upper C4
expect 0 --mask '[1,2,1]/2' --arity 2 --exact '2-log|[-2,1]@2,0,1|^1/1' --logarithm 0 --show single-spline-2-1.cert
echo "$output" | grep -q 'has the power 0 of the logarithm$'
expect 1 --mask '[1,2,1]/2' --arity 2 --exact '2-log|[-2,1]@2,0,1|^1/1' --logarithm 1 single-spline-2-1.cert
expect 0 --mask '[-1,0,9,16,9,0,-1]/16' --arity 2 --exact '4-log|[-4,1]@4,0,1|^1/1' --logarithm 1 \
  single-four-point.cert
expect 2 --mask '[-1,1,13,22,13,1,-1]/24' --arity 2 --exact '3-log|[-5,3]@5/3,0,1/10|^1/1' --logarithm 0 \
  blocks-exponent-exact.cert
for exact in '' '4-log' '|[-4,1]@4,0,1|^1/1' '4-log|[-4,0]@4,0,1|^1/1' '4-log|[-4]@4,0,1|^1/1' '4-log|[-4,1]@4,0|^1/1' \
  '4-log|[-4,1]@4,0,0|^1/1' '4-log|[-4,1]@4,0,1|^1/0' '4-log|[-4,1]@4,0,1|' 'x-log|[-4,1]@4,0,1|^1/1' \
  '4-log|[-4,,1]@4,0,1|^1/1'; do
  exactly 64 --exact "$exact"
done
expect 64 --matrices slow.mat --exact '1-log|[81,-270,100]@47/20,0,1/10|^1/2' slow-exact.cert
expect 1 --matrices slow.mat --exact '|[81,-270,100]@7/20,0,1/10|^1/2' slow-exact.cert
# bounds by kept words: those of the number of the certificate
expect 0 --matrices kept-numbers.mat --upper 2 kept-least.cert
expect 1 --matrices kept-numbers.mat --upper 1999/1000 kept-least.cert
expect 0 --mask "$four" --arity 2 --lower 2 kept-four-point.cert
expect 1 --mask "$four" --arity 2 --lower 201/100 kept-four-point.cert
expect 2 --mask "$hat" --arity 2 bspline-1.cert
expect 64 --mask "$hat" --arity 2 --matrices golden.mat --lower 1 bspline-1.cert
expect 64 --mask "$hat" --arity 17 --lower 1 bspline-1.cert
for mask in '' '1,2,1' '[1,2,1' '[]' '[1,,1]' '[0,2]' '[1,1]/0' '[1,1]/-1' '[1,1]2' '[1,1]@' '[1,1]@1@2' '[[1],[1]]'; do
  expect 64 --mask "$mask" --arity 2 --lower 1 bspline-1.cert
done
expect 66 --mask "$hat" --arity 2 --lower 1 none.cert
# a mask for each level
pair='[-1,0,9,16,9,0,-1]/16@-3;[1,4,6,4,1]/8'
expect 0 --masks "$pair" --arity 2 --order follows=0-1,1-0 --lower 2 --show list-in-turn.cert
echo "$output" | grep -qx 'coefficient -1 of mask 0 is 9/16'
echo "$output" | grep -qx 'mask 1 may be followed by mask 0'
expect 1 --masks "$pair" --arity 2 --order follows=0-1,1-0 --lower 51/20 list-in-turn.cert
expect 1 --masks "$pair" --arity 2 --order follows=0-1,1-1 --lower 2 list-in-turn.cert
expect 1 --masks "$pair" --arity 2 --order any --lower 2 list-in-turn.cert
expect 1 --masks "$pair" --arity 3 --order follows=0-1,1-0 --lower 2 list-in-turn.cert
expect 1 --masks '[-1,0,9,16,9,0,-1]/16@-3;[1,4,6,4,2]/8' --arity 2 --order follows=0-1,1-0 --lower 2 list-in-turn.cert
expect 0 --masks "$pair" --arity 2 --order any --lower 19/10 --show list-wide.cert
echo "$output" | grep -qx 'all sequences of these masks'
expect 0 --masks "$pair" --arity 2 --order period=0,1 --lower 2 --upper 5/2 --show period.cert
echo "$output" | grep -qx 'in turn the masks 0, 1'
expect 1 --masks "$pair" --arity 2 --order period=0,1 --lower 2 --upper 12/5 period.cert
expect 1 --masks "$pair" --arity 2 --order period=1,0 --lower 2 --upper 5/2 period.cert
expect 2 --masks "$pair" --arity 2 --order period=0,1 period-stable.cert
for order in none any= follows follows= follows=0 follows=0-2 follows=0-1-0 period= period=2 period=0,0,0,0,0,0,0; do
  expect 64 --masks "$pair" --arity 2 --order "$order" --lower 1 list-wide.cert
done
expect 64 --masks "$pair" --arity 2 --order any list-wide.cert
expect 2 --masks "$pair" --arity 2 --order any --lower 1 --upper 2 list-wide.cert
expect 64 --masks "$pair" --arity 2 --order any --exact '4-log|[-8,1]@8,0,1/1000|^1/1' list-wide.cert
expect 64 --masks "$pair" --arity 2 --lower 1 list-wide.cert
expect 64 --masks "$pair;" --arity 2 --order any --lower 1 list-wide.cert
expect 64 --masks "$pair" --arity 9 --order period=0,1 --lower 1 period.cert
expect 64 --masks "$pair" --mask "$hat" --arity 2 --order any --lower 1 list-wide.cert
expect 64 --mask "$hat" --arity 2 --order any --lower 1 bspline-1.cert
expect 66 --masks "$pair" --arity 2 --order any --lower 1 none.cert
expect 0 --matrices golden.mat --upper 2 --show golden.cert
echo "$output" | grep -qx 'row 1 1'
# values of a parameter
tension='[-w,0,1/2+w,1,1/2+w,0,-w]@-3'
expect 0 --mask "$tension" --arity 2 --levels w=1/50..1/10 --lower 1 --show four-point-levels.cert
echo "$output" | grep -qx 'the Hoelder exponents are above 1 for all sequences of levels with x from 1/50 to 1/10'
echo "$output" | grep -qx 'coefficient -1 is (1 x^0 + 2 x^1) / q'
echo "$output" | grep -qx 'q is 2 x^0 + 0 x^1'
expect 0 --mask "$tension" --arity 2 --for w=1/50..4/25 --lower 1 --show four-point-range.cert
echo "$output" | grep -qx 'the Hoelder exponents are above 1 for all x from 1/50 to 4/25'
expect 1 --mask "$tension" --arity 2 --levels w=1/50..1/10 --lower 3/2 four-point-levels.cert
expect 1 --mask "$tension" --arity 2 --levels w=1/50..1/10 --lower 2 four-point-levels.cert
expect 1 --mask "$tension" --arity 2 --levels w=1/50..1/10 --lower -1 four-point-levels.cert
expect 1 --mask "$tension" --arity 2 --levels w=1/50..4/25 --lower 1 four-point-range.cert
expect 1 --mask "$tension" --arity 2 --for w=1/50..1/5 --lower 1 four-point-range.cert
expect 0 --mask '[1,v,v,1]/(1+v)' --arity 2 --for v=3/2..9 --lower 0 --show quotient-converges.cert
echo "$output" | grep -qx 'q is 1 x^0 + 1 x^1'
# the lower end of a claim with both
expect 0 --mask '[w,1-w,1-w,w]' --arity 2 --for w=3/10..2/5 --lower 0 corner-full.cert
expect 2 --mask '[w,1-w,1-w,w]' --arity 2 --for w=3/10..2/5 --lower 0 --upper 1000001/1000000 corner-full.cert
expect 2 --mask '[w,1-w,1-w,w]' --arity 2 --for w=-2..-1/10 --upper 0 corner-diverges.cert
for range in '' w w=1 w=1..1 w=2..1 w=1,2 w=1..2..3 9=1..2 w:1..2 ww=1..2 w=1/0..2; do
  expect 64 --mask "$tension" --arity 2 --levels "$range" --lower 1 four-point-levels.cert
done
for mask in '' '[w' 'w,1' '[]' '[w,,1]' '[w*w]' '[w^0]' '[w^13]' '[2w]' '[v,1]' '[+w,1]' '[w+,1]' \
  '[1]/0' '[1]/()' '[1]/w' '[1]@' '[1]@1@2'; do
  expect 64 --mask "$mask" --arity 2 --levels w=1/50..1/10 --lower 1 four-point-levels.cert
done
expect 64 --mask "$tension" --arity 17 --levels w=1/50..1/10 --lower 1 four-point-levels.cert
expect 2 --mask "$tension" --arity 2 --levels w=1/50..1/10 --for w=1/50..1/10 --lower 1 four-point-levels.cert
expect 66 --mask "$tension" --arity 2 --levels w=1/50..1/10 --lower 1 none.cert
# values that follow from each other
corner='[w,1-w,1-w,w]'
rooted() {
  code=$1
  shift
  expect "$code" --mask "$corner" --arity 2 --levels w=1/100..49/100 --lower 0 "$@" follow-root-open.cert
}
step='sqrt[1/20+1/10*w]'
rooted 0 --recurrence "$step" --start 0..inf --from some --show
echo "$output" | grep -qx 'each x is followed by the root of (1 x^0 + 2 x^1) / (20 x^0 + 0 x^1)'
echo "$output" | grep -qx 'the first x is from 0 on'
rooted 1 --recurrence "$step" --start 1/5..inf --from some
rooted 1 --recurrence '[1/20+1/10*w]' --start 0..inf --from some
rooted 2 --recurrence "$step" --start 0..inf
rooted 2 --recurrence "$step" --start 0..inf --from some --limit 1/4
for start in '' 0 0..inf 1..0 inf..1; do
  rooted 64 --recurrence "$step" --start "$start" --from 1
done
for from in '' -1 1001 all; do
  rooted 64 --recurrence "$step" --start 0..1 --from "$from"
done
for other in '' sqrt '[w' '[1,w]' '[v]' '[1]/(0*w'; do
  rooted 64 --recurrence "$other" --start 0..inf --from some
done
# vectors of functions
hats='[[[2,0],[0,0]],[[4,0],[0,1]],[[2,0],[4,1]]]/4@-1'
functions() {
  code=$1
  shift
  expect "$code" --refinable "$hats" --dilation '[2]' "$@" vector-by-hand.cert
}
functions 0 --lower 1 --show
echo "$output" | grep -qx 'matrix 1, row 1: 1 1/4'
functions 1 --lower 1001/1000
functions 1 --lower 0
functions 2
functions 0 --lower 1 --upper 1 --show
echo "$output" | grep -qx 'the Hoelder exponent of 2 functions of arity 2, at least 1, at most 1'
functions 0 --lower 1/2 --upper 10000
functions 1 --lower 1 --upper 999/1000
functions 1 --lower 1 --upper -1
functions 1 --lower 1 --upper 10001
functions 64 --lower 1 --upper 1/0
functions 2 --lower 1 --upper C2
functions 2 --upper 1
functions 1 --lower 1 --component 0
functions 64 --lower 1 --component 2
functions 2 --lower 1 --integral 1,1
functions 64 --lower 1/0
functions 64 --exact '|[-1,2]@1/2,0,1/4|^1/1'
functions 1 --exact '0-log|[-1,2]@1/2,0,1/4|^1/1'
rough='[[[2,0],[0,0]],[[4,0],[0,3]],[[2,0],[4,3]]]/4@-1'
number() {
  code=$1
  shift
  expect "$code" --refinable "$rough" --dilation '[2]' "$@" vector-exact.cert
}
number 0 --exact '0-log|[-3,4]@3/4,0,1/4|^1/1' --show
echo "$output" | grep -q '^exactly 0 less the logarithm, .* of the zero within 1/4 of 3/4 + i 0 of'
number 0 --exact '0-log|[-3,4]@3/4,0,1/4|^1/1' --lower 415/1000 --upper 416/1000
number 0 --lower 415/1000
number 1 --lower 416/1000
number 1 --exact '0-log|[-3,4]@3/4,0,1/4|^1/1' --upper 415/1000
number 1 --exact '0-log|[-3,4]@3/4,0,1/4|^1/2'
number 1 --exact '1-log|[-3,4]@3/4,0,1/4|^1/1'
number 64 --exact '0-log|[-3,4]@3/4,0,0|^1/1'
number 2 --exact '0-log|[-3,4]@3/4,0,1/4|^1/1' --logarithm 0
number 1 --exact '0-log|[-3,4]@3/4,0,1/4|^1/1' --component 0
one() {
  code=$1
  shift
  expect "$code" --refinable "$rough" --dilation '[2]' "$@" vector-component.cert
}
one 0 --component 0 --lower 1 --upper 1 --show
echo "$output" | grep -qx 'the Hoelder exponent of function 0 of 2 functions of arity 2, at least 1, at most 1'
one 0 --component 0 --lower 1/2
one 1 --component 1 --lower 1/5
one 1 --lower 1/5
one 1 --component 0 --lower 1 --upper 999/1000
one 1 --component 0 --lower 1001/1000
one 64 --component 2 --lower 1
one 64 --component x --lower 1
expect 1 --refinable "$hats" --dilation '[3]' --lower 1 vector-by-hand.cert
expect 2 --refinable "$hats" --dilation '[-2]' --lower 1 vector-minus-two.cert
expect 2 --refinable '[[[1,0],[0,sqrt(2)]]]' --dilation '[2]' --lower 1 vector-by-hand.cert
for mask in '' '[' '[[[1]]' '[[1]]' '[[[1,0]]]' '[[[1]],[[1,0],[0,1]]]' '[[[1]]]/0' '[[[1]]]@' '[[[x]]]' '[[[]]]'; do
  expect 64 --refinable "$mask" --dilation '[2]' --lower 1 vector-by-hand.cert
done
for dilation in '' '2' '[]' '[1]' '[65]' '[x]'; do
  expect 64 --refinable "$hats" --dilation "$dilation" --lower 1 vector-by-hand.cert
done
expect 66 --refinable "$hats" --dilation '[2]' --lower 1 none.cert
# schemes of vectors, of one mask and of lists
quarter='[[[1/4,0],[0,1/2]],[[3/4,0],[0,1/2]],[[3/4,0],[0,0]],[[1/4,0],[0,0]]]@0'
corner() {
  code=$1
  shift
  expect "$code" --vectors "$quarter" --arity 2 "$@" vectors-one-holder.cert
}
corner 0 --lower 99/100 --show
echo "$output" | grep -qx 'mask 0, matrix 1, row 1: 0 1/2'
echo "$output" | grep -qx 'exponents above 99/100 of limits of a scheme of vectors of arity 2 and size 2'
corner 0 --lower 0
corner 1 --lower 1
corner 1 --lower -1
corner 64 --lower 1/0
corner 2
corner 2 --upper 0
corner 1 --lower 0 --order any
expect 1 --hermite "$quarter" --arity 2 --lower 1 vectors-one-holder.cert
expect 2 --vectors "$quarter" --dilation '[2]' --lower 0 vectors-one-holder.cert
expect 2 --vectors "$(echo "$quarter" | sed 's/3/sqrt(2)/')" --arity 2 --lower 0 vectors-one-holder.cert
two="$quarter;[[[2/5,0],[0,1/2]],[[3/5,0],[0,1/2]],[[3/5,0],[0,0]],[[2/5,0],[0,0]]]@0"
in_turn() {
  code=$1
  shift
  expect "$code" --vectors "$two" --arity 2 "$@" vector-list-in-turn.cert
}
in_turn 0 --order follows=0-1,1-0 --lower 3/4 --show
echo "$output" | grep -qx 'mask 1, matrix 3, row 0: 2/5 0'
echo "$output" | grep -qx 'mask 1 may be followed by mask 0'
in_turn 0 --order follows=0-1,1-0 --lower 1/2
in_turn 1 --order follows=0-1,1-0 --lower 4/5
in_turn 1 --order follows=0-1,1-0 --lower 0
in_turn 1 --order any --lower 3/4
in_turn 2 --order follows=0-1,1-0
in_turn 2 --order follows=0-1,1-0 --lower 1/2 --upper 1
for order in '' all follows follows= follows=0 follows=0-2 follows=0-1, period= period=2 period=0,1,0,1,0,1,0; do
  in_turn 64 --order "$order" --lower 1/2
done
for masks in '' ';' "$quarter;" "$quarter;[[[1]],[[1]]]" "$quarter;$quarter@1" "$quarter;[[[1/2,0],[0,1]]]@1000"; do
  expect 64 --vectors "$masks" --arity 2 --order any --lower 1/2 vector-list-in-turn.cert
done
smooth='[[[1/2,3/4],[-1/8,-1/8]],[[1,0],[0,1/2]],[[1/2,-3/4],[1/8,-1/8]]]@-1'
hermite() {
  code=$1
  shift
  expect "$code" --hermite "$smooth" --arity 2 "$@" hermite-list-one.cert
}
hermite 0 --order any --lower 1 --show
echo "$output" | grep -qx 'HC^1, of Hermite schemes of arity 2 and size 2'
hermite 1 --order any --lower 0
hermite 1 --order any --lower 2
hermite 1 --order follows=0-0 --lower 1
hermite 1 --lower 1
hermite 2 --order any
hermite 2 --upper 1
hermite 64 --order any --lower 1/2
hermite 64 --order any --lower -1
hermite 64 --order any --lower 501
expect 64 --vectors "$two" --arity 17 --order any --lower 1/2 vector-list-in-turn.cert
expect 66 --vectors "$two" --arity 2 --order any --lower 1/2 none.cert

cd "$here/accept"
slow() {
  code=$1
  shift
  expect "$code" --subradius slow-pair.mat "$@" slow-pair.cert
}
slow 0 --lower 1 --show
echo "$output" | grep -qx 'the joint spectral subradius of 2 matrices of size 2, at least 1'
slow 0 --upper 1
slow 1 --lower 1001/1000
slow 1 --upper 999/1000
slow 1 --upper -1
slow 64
slow 64 --upper C1
slow 64 --upper 1 --matrices slow-pair.mat
slow 1 --exact '|[-1,1]@1,0,1/2|^1/1'
slow 64 --exact '1-log|[-1,1]@1,0,1/2|^1/1'
slow 64 --exact '|[-1,1]@1,0,1/2|^1/1' --logarithm 0
golden() {
  code=$1
  shift
  expect "$code" --subradius slow-golden.mat "$@" slow-golden.cert
}
number='|[-1,-1,1]@8/5,0,1/10|^1/1'
golden 0 --exact "$number" --show
echo "$output" | grep -q '^exactly the root 1 of the modulus of the zero within 1/10 of 8/5 + i 0 of'
golden 0 --exact "$number" --lower 161803/100000 --upper 161804/100000
golden 0 --lower 161803/100000
golden 1 --exact "$number" --lower 17/10
golden 1 --exact "$number" --upper 8/5
golden 1 --exact '|[-1,-1,1]@8/5,0,1/5|^1/1'
expect 1 --matrices slow-golden.mat --exact "$number" slow-golden.cert
expect 1 --matrices slow-pair.mat --lower 1 slow-pair.cert
expect 1 --subradius primal-5.mat --lower 0 slow-pair.cert
expect 66 --subradius none.mat --lower 1 slow-pair.cert

# theorem CLAIM NAME: as it is checked in
theorem() {
  # shellcheck disable=SC2046
  "$program" $(grep "^$1 " claims.txt | cut -d ' ' -f 2-) --theorem "$2" "$1.cert" | diff - "$here/../examples/$2.v"
}
theorem primal-5 S5
theorem primal-5-exact S5Exact
