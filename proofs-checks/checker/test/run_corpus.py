#!/usr/bin/env python3
"""Runs a checker on the corpus and on wrong command lines. Usage: run_corpus.py CHECKER... accept|reject|usage DIRECTORY

Where CHECKER is several words it is started once, with --many: a command line in, a result out, as lists of JSON. Where it is
`many PROGRAM`, that is made of many.cpp."""
import json
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import convergence_cases
import not_c1_cases
import vertex_cases
import vertices_cases

MORE, MANY, LARGE = FILES = [f"FOLDER/{name}.mat" for name in ("more", "many", "large")]
GOLDEN = "--matrices golden.mat --upper 2"
# Exit codes of command lines.
USAGE = [
    (64, ""), (64, "golden.cert"), (64, f"{GOLDEN}"), (64, f"{GOLDEN} golden.cert golden.cert"),
    (64, f"{GOLDEN} --upper 2 golden.cert"), (64, f"{GOLDEN} --other 2 golden.cert"), (64, "golden.cert --upper"),
    (64, "--matrices golden.mat golden.cert"), (64, "--matrices golden.mat --upper 2/0 golden.cert"),
    (64, "--mask [1,1] --lower 1 golden.cert"), (64, "--mask [1,1] --arity 2 --upper 1 golden.cert"),
    (64, "--mask [1,1] --arity 1 --lower 1 golden.cert"), (64, "--mask [1,1]/0 --arity 2 --lower 1 golden.cert"),
    (64, "--mask [0] --arity 2 --lower 1 golden.cert"), (64, "--mask 1,1 --arity 2 --lower 1 golden.cert"),
    (64, "--mask [w,1-w] --arity 2 --lower 1 golden.cert"), (64, "--mask [w,1-w] --arity 2 --for t=0..1 golden.cert"),
    (64, "--mask [w^13,1] --arity 2 --for w=0..1 golden.cert"), (64, "--mask [w*w,1] --arity 2 --for w=0..1 golden.cert"),
    (64, "--mask [2w,1] --arity 2 --for w=0..1 golden.cert"), (64, "--mask [*w,1] --arity 2 --for w=0..1 golden.cert"),
    (64, "--mask [w^,1] --arity 2 --for w=0..1 golden.cert"), (64, "--mask [,w] --arity 2 --for w=0..1 golden.cert"),
    (64, "--mask [w+,1] --arity 2 --for w=0..1 golden.cert"), (64, "--mask [w,1] --arity 2 --for w=1..1 golden.cert"),
    (64, "--mask [w,1] --arity 2 --for w=0.1 golden.cert"), (64, "--mask [w,1] --arity 2 --for 1=0..1 golden.cert"),
    (64, "--mask [w,1] --arity 2 --for w= golden.cert"), (64, "--mask [w,1] --arity 2 --for w=..1 golden.cert"),
    (64, "--matrices golden.mat --for w=0..1 --upper 2 golden.cert"),
    (64, "--matrices golden.mat --levels w=0..1 --upper 2 golden.cert"),
    *((64, f"--mask [w,1-w,1-w,w] --arity 2 --levels w=0..1 {more}golden.cert") for more in (
        "", "--upper 1 ", "--lower 0 --upper 1 ", "--upper C1 ", "--lower 0 --for w=0..1 ", "--lower 0 --within 1/9,1 ",
        "--lower 0 --levels w=0..1 ", "--lower 0 --exact 1-log|[-1,1]@1,0,1|^1/1 ")),
    *((64, f"--mask [w,1-w,1-w,w] --arity 2 --each-point w=0..1 {more}golden.cert") for more in (
        "", "--upper 1 ", "--lower 1 --upper 1 ", "--upper C1 ", "--lower 1 --for w=0..1 ", "--lower 1 --levels w=0..1 ", "--lower 1 --within 1/9,1 ",
        "--lower 1 --exact 1-log|[-1,1]@1,0,1|^1/1 ", "--lower 1 --recurrence [w] --start 0..1 --from 0 ")),
    (64, "--masks [1,2,1]/2 --arity 2 --order any --each-point w=0..1 --lower 1 golden.cert"),
    (64, "--vectors [[[w]],[[1]]] --arity 2 --each-point w=0..1 --lower 0 golden.cert"),
    (64, "--mask [w,1-w,1-w,w] --arity 2 --levels w=1..1 --lower 0 golden.cert"),
    (64, "--mask [w,1-w,1-w,w] --arity 2 --levels v=0..1 --lower 0 golden.cert"),
    *((64, f"--mask [w,1-w,1-w,w] --arity 2 --levels w=0..1 --lower 0 {more} golden.cert") for more in (
        "--recurrence [w]", "--recurrence [w] --start 0..1", "--start 0..1 --from 0", "--recurrence [w] --start 1 --from 0",
        "--recurrence [w] --start 1..0 --from 0", "--recurrence [w] --start 0..1..2 --from 0", "--recurrence [w] --start 0..inf --from 0",
        "--recurrence [w] --start 0..1 --from some", "--recurrence [w] --start 0..1 --from 1001", "--recurrence [v] --start 0..1 --from 0",
        "--recurrence [w,1] --start 0..1 --from 0", "--recurrence root[w] --start 0..1 --from 0", "--recurrence [[w]] --start 0..1 --from 0")),
    (64, "--mask [w,1-w,1-w,w] --arity 2 --for w=0..1 --lower 0 --recurrence [w] --start 0..1 --from 0 golden.cert"),
    *((64, f"--mask [w,1-w,1-w,w] --arity 2 {more} golden.cert") for more in (
        "--levels w=0..1 --lower 1 --limit 1/4", "--for w=0..1 --lower 1 --limit 1/4", "--lower 1 --limit 1/4",
        *(f"--levels w=0..1 --recurrence [1/4] --start 0..1 --from 1 {other}" for other in (
            "--limit 1/4", "--limit 1/4 --upper 1", "--limit x --lower 1", "--limit 1/4 --lower 1 --upper C1", "--limit 1/4 --upper C1",
            "--limit 1/4 --lower 1 --logarithm 0", "--limit 1/4 --exact 1-log|[-1,1]@1,0,1|^1/1 --logarithm 0", "--limit 1/4 --lower 1 --within 1/9,1",
            "--exact 1-log|[-1,1]@1,0,1|^1/1", "--limit 1/4 --exact |[-1,1]@1,0,1|^1/1")))),
    *((64, f"--mask {mask} --arity 2 --levels w=0..1 --recurrence [1/4] --start 0..1 --from 1 --limit 1/4 --lower 1 golden.cert") for mask in (
        "[w,1,w]/(1/4-w)", "[1/4-w,1/2-2*w]", "[0*w]")),
    (64, "--vectors [[[w]],[[1]]] --arity 2 --levels w=0..1 --recurrence [1/4] --start 0..1 --from 1 --limit 1/4 --lower 0 golden.cert"),
    (64, "--matrices golden.mat --limit 1/4 --upper 2 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0,2] --limit 1/4 --lower 1 golden.cert"),
    (64, "--masks [1,2,1]/2 --arity 2 --order any --limit 1/4 --lower 1 golden.cert"),
    (64, f"--masks [{'1,' * 1000}1]/2 --arity 2 --order any --lower 0 golden.cert"),
    *((64, f"--vectors {more} golden.cert") for more in (
        "[[[1]],[[1]]] --arity 2 --order any", "[[[1]],[[1]]] --order any --lower 1", "[[[1]],[[1]]] --arity 2 --order any --upper 0",
        "[[[1]],[[1]]] --arity 2 --order any --lower 1 --upper 0", "[[[1]],[[1]]] --arity 2 --order any --lower 1 --for w=0..1",
        "[[[1]],[[1]]] --arity 2 --order any --lower 1 --levels w=0..1", "[[[1]],[[1]]] --arity 2 --order any --lower 1 --masks [1,2,1]/2",
        "[[[1]],[[1]]] --arity 2 --order any --lower 1 --hermite [[[1]],[[1]]]", "[[[1]],[[1]]] --arity 2 --order any --lower 1 --exact 1-log|[-1,1]@1,0,1|^1/1",
        "[[[1]],[[1]]] --arity 2 --order all --lower 1", "[[[1]],[[1]]] --arity 2 --order period=1 --lower 1", "[[[1]],[[1]]] --arity 2 --order follows=0-1 --lower 1",
        "[[[1]],[[1]]]; --arity 2 --order any --lower 1", "[[[1]],[[1]]];[[[1,0],[0,1]]] --arity 2 --order any --lower 1",
        "[[[sqrt(2)]],[[1]]] --arity 2 --order any --lower 1", "[[[w]],[[1]]] --arity 2 --order any --lower 1", "[[[1]],[[1]]];[[[1]],[[1]]]@999 --arity 2 --order any --lower 1",
        "[1,2,1]/2 --arity 2 --order any --lower 1", f"[{'[[1]],' * 1000}[[1]]] --arity 2 --order any --lower 1",
        f"{'[[[1]]];' * 64}[[[1]]] --arity 2 --order any --lower 1", "[[[[1]]]] --arity 2 --order any --lower 1")),
    *((64, f"--masks {more} golden.cert") for more in (
        "[1,2,1]/2 --arity 2 --lower 1", "[1,2,1]/2 --order any --lower 1", "[1,2,1]/2 --arity 2 --order any",
        "[1,2,1]/2 --arity 2 --order any --lower 1 --upper C1", "[1,2,1]/2 --arity 2 --order any --upper C1", "[1,2,1]/2 --arity 2 --order any --upper 1",
        "[1,2,1]/2 --arity 2 --order any --lower 1 --exact 2-log|[-2,1]@2,0,1|^1/1", "[1,2,1]/2 --arity 2 --order any --lower 1 --mask [1,2,1]/2",
        "[1,2,1]/2 --arity 2 --order all --lower 1", "[1,2,1]/2 --arity 2 --order period= --lower 1", "[1,2,1]/2 --arity 2 --order period=1 --lower 1",
        "[1,2,1]/2 --arity 2 --order period=0,0,0,0,0,0,0 --lower 1", "[1,2,3,2,1]/3 --arity 3 --order period=0,0,0,0 --lower 1",
        "[1,2,1]/2 --arity 2 --order follows=0 --lower 1", "[1,2,1]/2 --arity 2 --order follows=0-0-0 --lower 1", "[1,2,1]/2 --arity 2 --order follows=0-1 --lower 1",
        f"[1,2,1]/2 --arity 2 --order follows={'0-0,' * 4096}0-0 --lower 1", "[1,2,1]/2; --arity 2 --order any --lower 1",
        "[0,1,1] --arity 2 --order any --lower 1", "[1,1,0] --arity 2 --order any --lower 1", "[[1,1],[1,1]] --arity 2 --order any --lower 1",
        f"{'[1,2,1]/2;' * 64}[1,2,1]/2 --arity 2 --order any --lower 1", "[1,2,1]/2 --arity 17 --order any --lower 1",
        "[1,2,1]/2 --arity 2 --order any --lower 1 --levels w=0..1", "[1,2,1]/2 --arity 2 --order period=0 --lower 1 --within 1/9,1",
        "[1,2,1]/2 --arity 2 --order period=0 --for w=0..1 --lower 1", f"[{'1,' * 700}1];[{'1,' * 700}1] --arity 2 --order period=0,1 --lower 1")),
    (64, "--mask [1,2,1]/2 --arity 2 --order any --lower 1 golden.cert"),
    (64, "--matrices golden.mat --within 1/9,1 --upper 2 golden.cert"),
    (64, "--mask [1,1] --arity 2 --within 0,1 golden.cert"), (64, "--mask [1,1] --arity 2 --within 1/9 golden.cert"),
    (64, "--mask [1,1] --arity 2 --within 1/9,0 golden.cert"), (64, "--mask [1,1] --arity 2 --within -1,1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --within 1/9,1,1 golden.cert"), (64, "--mask [1,1] --arity 2 --within , golden.cert"),
    (64, "--mask [w,1] --arity 2 --within 1/9,1 --for w=0..1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --upper C golden.cert"), (64, "--mask [1,1] --arity 2 --upper C0 golden.cert"),
    (64, "--mask [1,1] --arity 2 --upper C501 golden.cert"), (64, "--mask [1,1] --arity 2 --upper C-1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --within 1/9,1 --upper C1 golden.cert"), (64, "--matrices golden.mat --upper C1 golden.cert"),
    *((64, f"--refinable {mask} --dilation [2] --lower 1 golden.cert") for mask in (
        "[[[sqrt(4),0],[0,1]]]", "[[[sqrt(1),0],[0,1]]]", "[[[sqrt(0),0],[0,1]]]", "[[[sqrt(-2),0],[0,1]]]", "[[[sqrt(1000000001),0],[0,1]]]",
        "[[[sqrt(2),0],[0,sqrt(3)]]]", "[[[sqrt(2)*2,0],[0,1]]]", "[[[2sqrt(2),0],[0,1]]]", "[[[1/sqrt(2),0],[0,1]]]", "[[[sqrt(2)^2,0],[0,1]]]",
        "[[[sqrt(2),0],[0,w]]]", "[[[sqrt(2),0],[0,1]]]/sqrt(2)", "[[[sqrt(2),0],[0,1]]]/(2)", "[[[sqrt(2,0],[0,1]]]", "[[[sqrt(),0],[0,1]]]",
        "[[[sqrt(2)+,0],[0,1]]]", "[[[sqrt(2),0]]]", "[[[sqrt(1/2),0],[0,1]]]", "[[[1,0],[0,1]]]/sqrt(2)", "[[[sqrt(2),0],[0,1]]]@sqrt(2)",
        f"[{'[[sqrt(2),0],[0,1]],' * 625}[[1,0],[0,1]]]")),
    *((64, f"--refinable [[[sqrt(2),0],[0,1]]] --dilation [2] {more} --lower 1 golden.cert") for more in (
        "--integral 0,0", "--integral 1", "--integral 1,0,0,0", "--integral 1,sqrt(3)", "--integral 1,w", "--integral 1,2sqrt(2)", "--integral 0,sqrt(2)-sqrt(2)", "--integral sqrt(2)", "--integral 1,sqrt(2)^2", "--component 2", "--component 3")),
    (64, "--surface [[[sqrt(2),0],[0,1]]] --dilation [2] --lower 1 golden.cert"),
    (64, "--vectors [[[sqrt(2),0],[0,1]]] --arity 2 --for w=0..1 --lower 0 golden.cert"), (64, "--vectors [[[sqrt(4),0],[0,1]]] --arity 2 --lower 0 golden.cert"),
    (64, "--vectors [[[[sqrt(2)]]]] --arity 2 --lower 0 golden.cert"),
    (64, f"--vectors [{'[[sqrt(2),0],[0,1]],' * 625}[[1,0],[0,1]]] --arity 2 --lower 0 golden.cert"), (64, f"--vectors [{'[[sqrt(2),0],[0,1]],' * 250}[[1,0],[0,1]]] --arity 2 --lower 0 golden.cert"), (64, "--mask [sqrt(2),1] --arity 2 --lower 1 golden.cert"),
    (64, "--surface [[sqrt(2),1],[1,1]] --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0,2] --lower 1 --upper C1 golden.cert"),
    *((64, f"--matrices golden.mat --exact {exact} golden.cert") for exact in (
        "", "2-log|[-1,1]@1,0,1|^1/1", "[-1,1]@1,0,1^1/1", "|[-1,1]@1,0,1|", "|[-1,1]@1,0|^1/1", "|[-1,1]@1,0,0|^1/1",
        "|[-1,1]@1,0,1|^1/0", "|[-1,1]@1,0,1|^1/1001", "|[1]@1,0,1|^1/1", "|[1,0]@1,0,1|^1/1", "|[1/2,1]@1,0,1|^1/1",
        "|[]@1,0,1|^1/1", "|x-1,1]@1,0,1|^1/1", "|[-1,1]@1,0,-1|^1/1", "|[-1,1]@1,,1|^1/1", "|@1,0,1|^1/1", "|[-1,1|^1/1]@1,0,1")),
    *((64, f"--mask [1,2,1]/2 --arity 2 --exact {exact} golden.cert") for exact in (
        "|[-1,1]@1,0,1|^1/1", "log|[-1,1]@1,0,1|^1/1", "501-log|[-1,1]@1,0,1|^1/1", "-1-log|[-1,1]@1,0,1|^1/1")),
    (64, "--mask [w,1] --arity 2 --for w=0..1 --exact 1-log|[-1,1]@1,0,1|^1/1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --within 1/9,1 --exact 1-log|[-1,1]@1,0,1|^1/1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --logarithm 1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --attains 0 golden.cert"), (64, "--matrices golden.mat --upper 2 --attains 0 golden.cert"),
    (64, "--mask [w,1] --arity 2 --for w=0..1 --lower 0 --attains 0 golden.cert"),
    (64, "--surface [1,1] --dilation [2] --lower 1 --attains 0 golden.cert"),
    *((64, f"--mask [1,1] --arity 2 --within 1/9,1 {more} golden.cert") for more in (
        "--attains", "--attains ,", "--attains 16", "--attains -1", "--attains 0,", f"--attains {'0,' * 1000}0", "--attains 0 --attains 0",
        "--attains 0 --exact 1-log|[-1,1]@1,0,1|^1/1", "--attains 0 --upper C1", "--attains 0 --logarithm 257", "--logarithm 0")),
    (64, "--mask [1,1] --arity 2 --within 1/9,1,symmetric,1 --attains 0 golden.cert"),
    (64, "--mask [1,1] --arity 2 --within 1/9,1, --attains 0 golden.cert"),
    (64, "--mask [1,1] --arity 2 --exact 1-log|[-1,1]@1,0,1|^1/1 --logarithm 257 golden.cert"),
    (64, "--mask [1,1] --arity 2 --exact 1-log|[-1,1]@1,0,1|^1/1 --logarithm -1 golden.cert"),
    (64, f"{GOLDEN} --exact |[-1,1]@1,0,1|^1/1 --logarithm 0 golden.cert"),
    (64, "--mask [w,1]/(w --arity 2 --for w=0..1 golden.cert"), (64, "--mask [w,1]/() --arity 2 --for w=0..1 golden.cert"),
    (64, "--mask [1,1]/(2) --arity 2 --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --lower 1 golden.cert"), (64, "--mask [1,1] --dilation [2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1]] --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1] --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]]@0 --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0,65] --lower 1 golden.cert"),
    (64, "--surface [1] --mask [1] --dilation [2] --arity 2 --lower 1 golden.cert"),
    (64, "--matrices golden.mat --upper 2/1/1 golden.cert"), (64, "--mask [3.w,1] --arity 2 --for w=0..1 golden.cert"),
    (64, "--mask [2+wx2,1] --arity 2 --for w=0..1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --for 1=0..1 --lower 1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --for w:0..1 --lower 1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --for w=..1 --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation 2,0;0,2 --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0,2} --lower 1 golden.cert"),
    (64, "--surface [1,2,1]/2@0@0 --dilation [2] --lower 1 golden.cert"),
    (64, "--surface [[[[1,1],[1,1]]]] --dilation [2] --lower 1 golden.cert"),
    (64, "--surface 1,2,1 --dilation [2] --lower 1 golden.cert"),
    (64, "--surface [1,2,1]]/2 --dilation [2] --lower 1 golden.cert"),
    (64, "--mask [1 --arity 2 --lower 1 golden.cert"), (64, "--mask [1,1]x --arity 2 --lower 1 golden.cert"),
    (64, "--mask [1,1]x2 --arity 2 --lower 1 golden.cert"), (64, "--mask 1,1] --arity 2 --lower 1 golden.cert"),
    (64, "--mask [1,0] --arity 2 --lower 1 golden.cert"), (64, "--mask [[1,1],[1,1]] --arity 2 --lower 1 golden.cert"),
    (64, f"--mask [{'1,' * 1000}1] --arity 2 --lower 1 golden.cert"),
    (64, "--mask [1,1] --arity 2 --for {=0..1 golden.cert"), (64, "--mask [1,1] --arity 2 --for _=0..1 golden.cert"),
    (64, "--surface [1,1] --dilation 2 --lower 1 golden.cert"),
    (64, "--surface [1,1] --dilation [2;2;2;2] --lower 1 golden.cert"),
    (64, f"--matrices golden.mat --exact |[{'1,' * 257}1]@1,0,1|^1/1 golden.cert"),
    (64, "--mask [0,1] --arity 2 --lower 1 golden.cert"),
    (64, "--mask [+1,1] --arity 2 --lower 1 golden.cert"), (64, "--mask [1,1] --arity 2 --for w --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,12] --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation 12,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [1,2,1]/2@-1 --dilation [-65] --lower 1 golden.cert"),
    (64, "--surface [1,2,1] --dilation [2,0,0,0;0,2,0,0;0,0,2,0;0,0,0,2] --lower 1 golden.cert"),
    *((64, f"--mask [1/{2**6000},1]/{3**4100} --arity 2{range_} --lower 1 golden.cert") for range_ in ("", " --for w=0..1")),
    (64, "--mask [1,1]/-1 --arity 2 --lower 1 golden.cert"), (64, "--lower 1 golden.cert"), (64, "--help golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0,2] --upper 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]]/-1 --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,15] --dilation [2,0;0,2] --lower 1 golden.cert"),
    (64, "--surface [[1,1],[1,1]] --dilation [2,0;0,-65] --lower 1 golden.cert"),
    (64, f"--surface [{'1,' * 10000}1] --dilation [2] --lower 1 golden.cert"),
    (65, f"--matrices {MORE} --upper 2 golden.cert"), (65, f"--matrices {MANY} --upper 2 golden.cert"),
    (65, f"--matrices {LARGE} --upper 2 golden.cert"),
    (64, "--subradius golden.mat golden.cert"), (64, "--subradius golden.mat --upper C1 golden.cert"),
    (64, "--subradius golden.mat --matrices golden.mat --upper 2 golden.cert"),
    (64, "--subradius golden.mat --mask [1,1] --arity 2 --lower 1 golden.cert"),
    (64, "--subradius golden.mat --surface [1,1] --dilation [2] --lower 1 golden.cert"),
    *((64, f"--subradius golden.mat --lower 1 {option} golden.cert") for option in (
        "--exact 1-log|[-1,1]@1,0,1|^1/1", "--logarithm 0", "--for w=0..1", "--levels w=0..1", "--within 1/9,1",
        "--arity 2", "--dilation [2]")),
    (64, "--subradius golden.mat --exact |[-1,1]@1,0,1|^1/1 --logarithm 0 golden.cert"),
    (64, "--subradius golden.mat --exact |[-1,1]@1,0,0|^1/1 golden.cert"), (64, "--subradius golden.mat --lower 1"),
    (65, "--subradius golden.cert --upper 2 golden.cert"), (66, "--subradius none.mat --upper 2 golden.cert"),
    (66, "--subradius golden.mat --upper 2 none.cert"),
    (65, "--matrices golden.cert --upper 2 golden.cert"), (66, "--matrices none.mat --upper 2 golden.cert"),
    *((64, f"--l1 {rule} golden.cert") for rule in (
        "6,1", "6,1 --upper 1", "6,1 --contraction 1,1,1 --upper 1", "6,1 --lower 1/2 --upper C1", "6,1 --lower 1/2 --upper x", "14,1 --lower 1", "6,1 --lower 1 --mask [1,1]", "6,1 --lower 1 --arity 2", "6 --lower 1",
        "6,1,1 --lower 1", "6,1,2 --lower 1", "6,1,17 --lower 1", "6,1,x --lower 1", "6,1,3,3 --lower 1", "6,1, --lower 1", "6,1,3 --contraction 6,1,1", "6,5 --lower 1", "1,0 --lower 1", "17,1 --lower 1", "16,7 --lower 1", "6,-1 --lower 1", "x,1 --lower 1",
        "6,1 --lower x", "6,1 --exact |[-1,1]@1,0,1|^1/1", "6,1 --lower 1 --matrices golden.mat", "6,1 --lower 1 --logarithm 0",
        *(f"6,1 --contraction {fields}" for fields in ("1,1", "1,1,1,1", "0,1,1", "9,1,1", "1,0,1", "1,3,1", "1,1,-1", "1,1,x", "")))),
    (64, "--contraction 1,1,1 golden.cert"), (64, "--contraction 1,1,1 --lower 1/2 golden.cert"), (64, "--contraction 1,1,1 --mask [1,1] golden.cert"),
    (64, "--l1 6,1 --contraction 1,1,1"), (64, "--l1 6,1 --lower 1"), (64, "--l1 6,1 --lower 1 --arity 2"), (66, "--l1 6,1 --lower 1 none.cert"), (66, "--l1 13,1 --lower 1 none.cert"),
    (64, "--contraction 1,1,1 --mask [1,2,1]/2 --arity 2 --lower 1 golden.cert"),
    (66, f"{GOLDEN} none.cert"), (66, f"{GOLDEN} ."), (66, f"{GOLDEN} /dev/null"), (64, f"{GOLDEN} --FILE golden.cert"),
    *((64, f"--refinable {options} golden.cert") for options in (
        "[[[1]]]", "[[[1]]] --dilation [2]", "[[[1]]] --lower 1", "[[[1]]] --dilation [2] --upper 1", "[[[1]]] --arity 2 --lower 1",
        "[[[1]]] --dilation [2] --lower 1 --surface [1]", "[[[1]]] --dilation [2] --lower 1 --mask [1] --arity 2",
        "[[[1]]] --dilation [2] --lower 1 --matrices golden.mat", "[[[1]]] --dilation [2] --lower 1 --logarithm 0",
        "[[[1]]] --dilation [2] --lower 1 --upper C1", "[[[1]]] --dilation [2] --lower 1 --within 1/9,1", "[[[1]]] --dilation [2] --lower 1 --for w=0..1",
        *(f"{mask} --dilation [2] --lower 1" for mask in (
            "[[1]]", "[1]", "1", "[]", "[[[[1]]]]", "[[[[[[1]]]]]]", "[[[1,2]]]", "[[[1],[2]]]", "[[[1,0],[0,1]],[[1]]]", "[[[1,0],[0]]]", "[[[1]]", "[[[1]]]]",
            "[[[1]]]/0", "[[[1]]]@1,1", "[[[1]]]@", "[[[1]]]/2@x", "[[[w]]]", "[[[]]]", "[[[1]],[[]]]", "[[[1]]]2", "[[[1]]]/2/2")))),
    *((64, f"--{kind} [[[w,0],[0,1]]] --arity 2 --for w=0..1 {more} golden.cert") for kind, more in (
        ("vectors", ""), ("vectors", "--lower 0 --upper 0"), ("vectors", "--upper 1"), ("vectors", "--upper C1"), ("vectors", "--lower 0 --component 0"),
        ("vectors", "--lower 0 --hermite [[[w,0],[0,1]]]"), ("vectors", "--lower 0 --mask [1]"), ("vectors", "--lower 0 --exact 0-log|[-1,1]@1,0,1|^1/1"),
        ("hermite", "--lower 1/2"), ("hermite", "--upper 3/2"), ("hermite", "--lower -1"), ("hermite", "--lower 501"), ("hermite", "--lower 1 --within 1/9,1"))),
    (64, "--vectors [[[w,0],[0,1]]] --arity 2 --lower 0 golden.cert"), (66, "--vectors [[[w,0],[0,1]]] --arity 2 --levels w=0..1 --lower 0 none.cert"),
    *((64, f"--{kind} [[[w,0],[0,1]]] --arity 2 --levels w=0..1 {more} golden.cert") for kind in ("vectors", "hermite") for more in (
        "", "--upper 0", "--upper 1", "--lower 0 --upper 0", "--lower 1 --for w=0..1", "--lower 1 --recurrence [w]", "--lower 1 --exact 0-log|[-1,1]@1,0,1|^1/1",
        "--lower 1 --start 0..1 --from 0", "--lower 1 --recurrence [v] --start 0..1 --from 0")),
    (64, "--vectors [[[w,0],[0,1]]] --arity 2 --for w=0..1 --lower 0 --recurrence [w] --start 0..1 --from 0 golden.cert"),
    *((64, f"--vectors [[[1,0],[0,1]]] --arity 2 {more} golden.cert") for more in (
        "", "--lower 0 --upper 0", "--upper 1", "--lower 0 --exact 0-log|[-1,1]@1,0,1|^1/1", "--lower 0 --levels w=0..0", "--lower 0 --logarithm 0",
        "--lower 0 --within 1/9,1", "--upper C1", "--lower 0 --integral 1,0", "--exact 0-log|[-1,1]@1,0,1|^1/1")),
    (66, "--vectors [[[0,0],[0,1]]] --arity 2 --lower 0 none.cert"), (66, "--hermite [[[1,0],[0,0]]] --arity 2 --upper 1 none.cert"),
    (64, "--vectors [[[w,0],[0,1]]] --for w=0..1 --lower 0 golden.cert"), (64, "--vectors [[[w,0]]] --arity 2 --for w=0..1 --lower 0 golden.cert"),
    (64, "--vectors [[[[1]]]] --arity 2 --for w=0..1 --lower 0 golden.cert"), (66, "--vectors [[[w,0],[0,1]]] --arity 2 --for w=0..1 --lower 0 none.cert"),
    *((64, f"{subject} --component {component} golden.cert") for subject, component in (
        ("--refinable [[[1]]] --dilation [2] --lower 1", "1"), ("--refinable [[[1]]] --dilation [2] --lower 1", "-1"),
        ("--refinable [[[1]]] --dilation [2] --lower 1", "x"), ("--surface [1] --dilation [2] --lower 1", "0"),
        ("--mask [1] --arity 2 --lower 1", "0"), (GOLDEN, "0"), ("--subradius golden.mat --lower 1", "0"),
        ("--l1 6,1 --lower 1/2", "0"))),
    *((64, f"{subject} --integral {integral} golden.cert") for subject, integral in (
        ("--refinable [[[1]]] --dilation [2] --lower 1", "0"), ("--refinable [[[1]]] --dilation [2] --lower 1", "1,0"),
        ("--refinable [[[1]]] --dilation [2] --lower 1", "x"), ("--surface [1] --dilation [2] --lower 1", "1"),
        ("--refinable [[[1]]] --dilation [2] --lower 1", "sqrt(4)"), ("--refinable [[[1]]] --dilation [2] --lower 1", "sqrt(2"),
        ("--refinable [[[1]]] --dilation [2] --lower 1", "sqrt(2)+sqrt(3)"), ("--refinable [[[1]]] --dilation [2] --lower 1", "0*sqrt(2)"),
        ("--mask [1] --arity 2 --lower 1", "1"), (GOLDEN, "1"), ("--subradius golden.mat --lower 1", "1"), ("--l1 6,1 --lower 1/2", "1"),
        ("--vectors [[[w,0],[0,1]]] --arity 2 --for w=0..1 --lower 0", "1,0"))),
    (66, "--refinable [[[1]]] --dilation [2] --integral -1/2 --lower 1 none.cert"),
    (66, "--refinable [[[1]]] --dilation [2] --component 0 --lower 1 none.cert"),
    (66, "--refinable [[[1]]] --dilation [2] --lower 1 none.cert"), (66, "--refinable [[[[[1]]]]] --dilation [2,0,0;0,2,0;0,0,2] --lower 1 none.cert"),
    (64, "--surface [1,2,1]/2 --dilation [2] --lower 1 --FILE golden.cert"), (0, "--help"), (0, f"{GOLDEN} golden.cert"),
]


def usage_cases(directory, scratch):
    """(name, words, whether a result is right) for each command line of USAGE; files that they name are made in `scratch`."""
    texts = [(directory / "golden.mat").read_text() + "row 1 1\n", "matrices 4096 256\n",
             f"matrices 1 2\nrow 1/{2**6001} 0\nrow 0 1/{2**3999 + 1}\n"]
    for name, text in zip(FILES, texts):
        Path(name.replace("FOLDER", scratch)).write_text(text)
    for code, arguments in [*USAGE, *convergence_cases.usage(), *vertex_cases.usage(), *vertices_cases.usage(), *not_c1_cases.usage()]:
        yield arguments, arguments.replace("FOLDER", scratch).split(), lambda result, code=code: (
            result[0] == code and bool(result[2] if code else result[1]) and (code == 0 or "VERIFIED" not in result[1])
            and "internal error" not in result[2])


def printed(arguments):
    """What a checker prints where it accepts a claim."""
    values = dict(zip(arguments[::2], arguments[1::2]))
    lower, upper, within = (values.get(f"--{option}") for option in ("lower", "upper", "within"))
    levels, each_point, vertex, broken = (values.pop(name, None) for name in ("--levels", "--each-point", "--vertex", "--not-c1"))
    order, step, start, level, limit = (values.pop(name, None) for name in ("--order", "--recurrence", "--start", "--from", "--limit"))
    range_ = levels or values.get("--for")
    exact, logarithm, component, integral = (values.pop(name, None) for name in ("--exact", "--logarithm", "--component", "--integral"))
    if attains := values.pop("--attains", None):
        exact = f"{within.split(',')[1]}-log rho({attains})^1/{attains.count(',') + 1}"
    what = "joint spectral radius" if "--matrices" in values else "Hoelder exponent"
    what = "joint spectral subradius" if "--subradius" in values else what
    what = f"{what} = {exact}" if exact else what if lower or upper else "stable integer shifts of the refinable distribution"
    subject = " with ".join(f"{name.strip('-')} {value}" if name in ("--arity", "--dilation") else value
                            for name, value in values.items() if name not in ("--lower", "--upper", "--for", "--within"))
    subject = f"the refinable functions of {subject}" if "--refinable" in values else subject
    subject = f"{subject} and integral {integral}" if integral else subject
    subject = f"{subject}, and C^1 limits of almost all data around {vertex}" if vertex else subject
    subject = f"{subject}, and no C^1 limits of almost all data around {broken}" if broken else subject
    subject = f"component {component} of {subject}" if component else subject
    what = "least " + what if "--masks" in values and upper and not order.startswith("period") else what
    relation = "<" if range_ and not limit else "<="
    rough = upper and upper.startswith("C")
    if rough:
        what = (f"{what} and no C^" if lower or exact else "no C^") + upper[1:] + " limits"
    elif range_ and upper and not lower:
        what = "no convergence, or " + what
    text = "VERIFIED " + (f"{Fraction(lower)} {relation} " if lower else "") + what
    text += f" {relation} {Fraction(upper)}" if upper and not rough else ""
    text += (f" with |log h|^{logarithm}" if logarithm else "") + f" of {subject}"
    over = f" for all {'sequences of levels with ' if levels else ''}{range_}" if range_ else ""
    if step:
        level = "some level" if level == "some" else f"level {level}"
        over = f" from {level} on of {levels[0]} -> {step} with {levels[0]}={start} at level 0, all in {levels}" + (f", tending to {limit}" if limit else "")
    over = f" for all choices for each new point of {each_point}" if each_point else over
    text = text.replace("no convergence, or Hoelder exponent < 0", "no convergence") + over
    if order:
        text = text.replace("--masks ", "").replace("masks ", "") + (" for levels" if order.startswith("period") else " for all sequences of levels")
        text += "" if order == "any" else f" with {order}"
    text += f" for all masks within={within}" if within else ""
    if "--vectors" in values or "--hermite" in values:
        end = f"{'' if lower else 'no '}HC^{lower or upper}" if "--hermite" in values else f"{Fraction(lower)} {'<=' if order else '<'} Hoelder exponent" if lower else "no convergence"
        scheme = f"Hermite scheme of {values['--hermite']}" if "--hermite" in values else f"vector scheme of {values['--vectors']}"
        over = over if not order else " for all sequences of levels" + ("" if order == "any" else f" with {order}")
        text = f"VERIFIED {end} of the {scheme} with {'arity' if '--arity' in values else 'dilation'} {values.get('--arity') or values['--dilation']}{over}"
    if "--l1" in values:
        steps, order, bound = values.get("--contraction", "0,0,0").split(",")
        parts = [f"{Fraction(lower)} <= Hoelder exponent" + (f" <= {Fraction(upper)}" if upper else "")] if lower else []
        parts += [f"|D^{order} S^{steps} f| <= {Fraction(bound)} |D^{order} f|"] if "--contraction" in values else []
        text = f"VERIFIED {' and '.join(parts)} of least absolute deviations {values['--l1']}"
    return text


def is_rejected(result, reason):
    rejected = result[0] == 1 and result[1].startswith("REJECTED ") and ", line " in result[1] and not result[2]
    return rejected and reason in result[1] and "internal error" not in result[1]


def claim_cases(mode, directory):
    """(name, words, whether a result is right) for each line of claims.txt."""
    for line in (directory / "claims.txt").read_text().splitlines():
        claim, _, reason = line.partition(" | ")
        name, *arguments = claim.split()
        if mode == "accept":
            yield name, [*arguments, f"{name}.cert"], lambda result, text=printed(arguments): result == (0, text, "")
        else:
            yield name, [*arguments, f"{name}.cert"], lambda result, reason=reason: is_rejected(result, reason)


def cases(mode, directory, scratch):
    return usage_cases(directory, scratch) if mode == "usage" else claim_cases(mode, directory)


class Checker:
    """A program, or one that is started once in a folder, for many command lines; with limits, words of the shell."""

    def __init__(self, words, directory, limits="true", environment=None):
        self.options = {"cwd": directory, "env": environment}
        self.is_many, self.server = words[0] == "many", None
        self.words = ["sh", "-c", f'{limits} && exec "$@"', "limited", *words[self.is_many:]]
        if len(words) > 1:
            command = self.words if self.is_many else [*self.words, "--many"]
            self.server = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=not self.is_many,
                                           stderr=subprocess.DEVNULL if environment else None, **self.options)

    def run(self, arguments):
        """Exit code, standard output, standard error."""
        if self.is_many:
            self.server.stdin.write(b"".join(word.encode() + b"\0" for word in [str(len(arguments)), *arguments]))
            self.server.stdin.flush()
            code, _, line = self.server.stdout.readline().decode("latin-1").partition(" ")
            return (int(code or -1), line.strip(), "") if code in ("", "0", "1") else (int(code), "", line.strip())
        if self.server:
            self.server.stdin.write(json.dumps(arguments) + "\n")
            self.server.stdin.flush()
            answer = json.loads(self.server.stdout.readline())
            return (answer["exit"], answer["line"], "") if answer["exit"] < 2 else (answer["exit"], "", answer["line"])
        done = subprocess.run([*self.words, *arguments], capture_output=True, text=True, check=False, **self.options)
        return done.returncode, done.stdout.strip(), done.stderr.strip()

    def close(self):
        if self.server:
            self.server.kill()
            self.server.communicate()


def folder_of(mode):
    return "reject" if mode == "reject" else "accept"


def run_all(words, mode, directory, scratch):
    checker, count, failures = Checker(words, directory), 0, []
    for name, arguments, is_right in cases(mode, directory, scratch):
        count += 1
        result = checker.run(arguments)
        if not is_right(result):
            failures.append(f"{name}: {result}")
    checker.close()
    print(f"{count} cases, {len(failures)} failures")
    for failure in failures:
        print(failure)
    return bool(failures) or count == 0


if __name__ == "__main__":
    *program, what, where = sys.argv[1:]
    with tempfile.TemporaryDirectory() as made:
        sys.exit(run_all(program, what, Path(where), made))
