"""Cases of sections `quadratic` with several forms, and with many letters."""
# (1, 1)^T (1, 0) and (1, -1)^T (0, 1): radius 1, and sqrt(2) is the least bound by one form and words of one letter
SWITCHED = "--matrices switched.mat --lower 1 --upper 1001/1000"
# (1, 1, 1)^T e_t^T: radius 1; the group permutes the coordinates, the first generator does not keep the first form
COLUMNS = "--matrices columns.mat --lower 1 --upper 501/500"
LETTERS = 257

# name, rows of its matrices
MATRICES = [
    ("switched.mat", [[["1", "0"], ["1", "0"]], [["0", "1"], ["0", "-1"]]]),
    ("columns.mat", [[[str(int(t == j)) for j in range(3)] for _ in range(3)] for t in range(3)]),
    ("letters.mat", [[[f"{t}/{LETTERS}"]] for t in range(1, LETTERS + 1)]),
]

# name, options of the claim, and the lines after the first one
ACCEPTED = [
    ("switched-forms", SWITCHED,
     "radius 2 2; bounds 1 1001/1000; product 0 1 0 0; block 0 quadratic 4 1001/1000 forms:2; form 1000; form 0 1; form 1; "
     "form 0 1000; word 0 0 0; word 0 1 1; word 1 0 0; word 1 1 1; end"),
    ("columns-forms", COLUMNS,
     "radius 3 3; bounds 1 501/500; product 0 1 0 0; block 0 quadratic 3 501/500 forms:2 group:2; generator 1 0 2; map 0 1 0; "
     "map 1 0 0; map 0 0 1; generator 0 2 1; map 1 0 0; map 0 0 1; map 0 1 0; form 1000; form 0 1; form 0 0 1; form 1; form 0 1; "
     "form 0 0 1; word 0 0 0; word 0 0AB 2; word 1 0 0; end"),
    ("one-forms", "--matrices one.mat --upper 2",
     "radius 1 1; bounds - 2; block 0 quadratic 2 2 forms:2; form 1; form 4; word 0 1 0; word 1 0 0; end"),
    ("four-point-forms", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 167/100",
     "exponent [-1,0,9,16,9,0,-1]/16@-3 2; bounds 167/100 -; sum-rules 4; block 0 quadratic 3 5 forms:2 group:1; generator 1 0; "
     "map 0 1; map 1 0; form 10; form 0 10; form 10; form 0 11; word 0 1 0; word 1 0A 0; word 1 1A 1; end"),
    # words of other lengths from each form
    ("golden-forms", "--matrices golden.mat --lower 1618/1000 --upper 17/10",
     "radius 2 2; bounds 1618/1000 17/10; product 0 2618034/1000000 0 0 1; block 0 quadratic 6 17/10 forms:2; form 100; form 0 100; "
     "form 100; form 1 101; word 0 0 0 0; word 0 1 0 1; word 1 1 0; word 0 1 1; word 1 0 1 0; word 1 1 1 1; end"),
    # the most forms, and the longest words
    ("forms-1000", "--matrices one.mat --upper 2",
     "radius 1 1; bounds - 2; block 0 quadratic 1000 2 forms:1000; "
     f"{'; '.join(['form 1'] * 1000)}; {'; '.join(f'word {j} {(j + 1) % 1000} 0' for j in range(1000))}; end"),
    ("forms-long-word", "--matrices one.mat --upper 2",
     f"radius 1 1; bounds - 2; block 0 quadratic 2 2 forms:2; form 1; form 2; word 0 1{1000 * ' 0'}; word 1 0 0; end"),
    # more letters than a byte holds
    ("letters", "--matrices letters.mat --lower 1 --upper 1",
     f"radius {LETTERS} 1; bounds 1 1; product 0 1 0 {LETTERS - 1}; block 0 quadratic {LETTERS} 1; form 1; "
     f"{'; '.join(f'word {t}' for t in range(LETTERS))}; end"),
]

# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    ("columns-forms-word", "columns-forms", None, [("word 1 0 0\n", f"word 1 0{16 * 'A'} 0\n")]),
    # a word that is the image of another one as well
    ("columns-forms-image", "columns-forms", None, [("quadratic 3", "quadratic 4"), ("word 1 0 0\n", "word 1 0 0\nword 1 0AB 2\n")]),
]

INCOMPLETE, ABOVE = "not those of a complete tree", "a product is not below the bound in the quadratic form"
FIRST_LINE = "expected 'quadratic', a number of words, a bound and perhaps forms and a group"

# name, accepted case that is changed, other options or None, reason, changes of its text
REJECTED = [
    *((f"forms-{name}", "switched-forms", None, reason, [(" forms:2\n", f" {words}\n")]) for name, words, reason in (
        ("0", "forms:0", "number outside 2..1000"), ("1", "forms:1", "number outside 2..1000"),
        ("1001", "forms:1001", "number outside 2..1000"), ("none", "forms:", "not an integer"),
        ("twice", "forms:2 forms:2", FIRST_LINE), ("group-0", "forms:2 group:0", "number outside 1..8"),
        ("group-twice", "forms:2 group:1 group:1", FIRST_LINE), ("other", "forms:2 symmetric", FIRST_LINE),
        ("more", "forms:3", "expected 'form'"))),
    ("quadratic-no-bound", "golden-quadratic", None, FIRST_LINE, [("quadratic 3 16181/10000", "quadratic 3")]),
    ("forms-after-group", "columns-forms", None, FIRST_LINE, [(" forms:2 group:2\n", " group:2 forms:2\n")]),
    ("forms-unannounced", "switched-forms", None, "expected 'word'", [(" forms:2\n", "\n")]),
    ("forms-missing", "switched-forms", None, "expected 'form'", [("form 1\nform 0 1000\n", "")]),
    ("forms-row", "switched-forms", None, "wrong number of fields", [("form 0 1000\n", "form 0 1000 0\n")]),
    ("forms-indefinite", "switched-forms", None, "a form is not positive definite", [("form 0 1000\n", "form 0 -1000\n")]),
    ("forms-zero", "switched-forms", None, "a form is not positive definite", [("form 1\nform 0 1000\n", "form 0\nform 0 0\n")]),
    *((f"forms-word-{name}", "switched-forms", None, reason, [("word 1 1 1\n", f"word{words}\n")]) for name, words, reason in (
        ("empty", "", "wrong number of fields"), ("no-letters", " 1 1", "wrong number of fields"),
        ("long", " 1 1" + 1001 * " 1", "wrong number of fields"), ("from-high", " 2 1 1", "number outside 0..1"),
        ("from-negative", " -1 1 1", "number outside 0..1"), ("to-high", " 1 2 1", "number outside 0..1"),
        ("to-negative", " 1 -1 1", "not an integer"), ("from-turned", " 1A 1 1", "not an integer"),
        ("letter-high", " 1 1 2", "number outside 0..1"), ("no-group", " 1 1A 1", "unknown generator"))),
    *((f"forms-turn-{name}", "columns-forms", None, reason, [("word 0 0AB 2\n", f"word 0 {to} 2\n")]) for name, to, reason in (
        ("unknown", "0AC", "unknown generator"), ("low", "0A@", "unknown generator"), ("small", "0ab", "unknown generator"),
        ("flip", "0f", "unknown generator"), ("alone", "AB", "not an integer"), ("none", "0", ABOVE), ("first", "0A", ABOVE),
        ("order", "0BA", ABOVE), ("long", f"0{17 * 'A'}", "more than 16 generators"), ("from", "1AB", ABOVE))),
    ("forms-bound", "switched-forms", None, ABOVE, [("quadratic 4 1001/1000", "quadratic 4 1")]),
    ("forms-other-to", "switched-forms", None, ABOVE, [("word 0 1 1\n", "word 0 0 1\n")]),
    ("forms-other-from", "one-forms", None, ABOVE, [("quadratic 2 2", "quadratic 2 199/100")]),
    ("forms-exchanged", "switched-forms", None, ABOVE, [("word 0 1 1\n", "word 1 0 1\n")]),
    *((f"forms-incomplete-{name}", "switched-forms", None, INCOMPLETE, [("quadratic 4", "quadratic 3"), (word, "")])
      for name, word in (("first", "word 0 1 1\n"), ("second", "word 1 1 1\n"))),
    # together the words of both forms are a complete tree
    ("forms-together", "switched-forms", None, INCOMPLETE, [("quadratic 4", "quadratic 2"), ("word 0 1 1\nword 1 0 0\n", "")]),
    ("forms-none-from-second", "switched-forms", None, INCOMPLETE, [("quadratic 4", "quadratic 2"), ("word 1 0 0\nword 1 1 1\n", "")]),
    # images under a map that keeps the other form only
    ("forms-not-kept", "columns-forms", None, INCOMPLETE, [("quadratic 3", "quadratic 2"), ("word 0 0AB 2\n", "")]),
    ("forms-second-not-kept", "columns-forms", None, INCOMPLETE, [("form 0 0 1\nword 0 0 0\n", "form 0 0 2\nword 0 0 0\n")]),
    ("forms-word-twice", "columns-forms", None, "a word occurs twice", [("quadratic 3", "quadratic 4"), ("word 1 0 0\n", "word 1 0 0\nword 1 0B 0\n")]),
    ("letters-incomplete", "letters", None, INCOMPLETE, [(f"quadratic {LETTERS}", f"quadratic {LETTERS - 1}"), (f"word {LETTERS - 1}\n", "")]),
]
