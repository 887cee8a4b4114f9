"""What a run may not do. A judge gets the case and its run and yields findings: the kind and what is wrong."""
import glob
import json
import math
import os
from decimal import Decimal
from fractions import Fraction

from oracles import DifferenceScheme, VectorEquation, Words

ENDINGS = {0, 1, 2, 3}  # of what is well formed
# Reasons for no certificate: the mask's own bounds, not those of its factors; more time; tensor products, several
# solutions and square roots have none.
NO_CLAIM = ("need a positive lower bound", "the only one up to a factor", "rational entries",
            "with a longer budget a proof may be found", "certify the factors")
LONG_CHECK = "more work than"  # says the checker, after some ten seconds
MEMORY_BESIDE = 160  # MiB beside those of --memory: the program and what it has read
MOST_SAMPLES = 7  # of a range
ROUNDED = 2**200  # denominators beyond are of rounded square roots
GUARD = 1e-9  # of logarithms in double precision, relative to 1


def budget_seconds(case):
    """Processor time that a run may take."""
    return 1.2 * case.budget + 1 + case.facts.get("beside", 0)


def end(enclosure, side):
    """'lower' or 'upper' as a fraction; None where there is no such end."""
    text = enclosure and enclosure[side]
    return None if text in (None, "-inf", "inf") else Fraction(text)


def enclosures(value, path=""):
    """All {"lower", "upper"} of an answer."""
    if isinstance(value, dict):
        if {"lower", "upper"} <= value.keys():
            yield path, end(value, "lower"), end(value, "upper")
        for key, inner in value.items():
            yield from enclosures(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for inner in value:
            yield from enclosures(inner, path + "[]")


def last_digit(number):
    """One unit of the last printed digit."""
    return Fraction(10) ** Decimal(number).as_tuple().exponent


# ---- of every run

def ending(case, run):
    if run.code < 0:
        yield "signal", f"ended by signal {-run.code}"
    elif run.code == 70:
        yield "internal error", run.errors[:300]
    elif run.code not in ENDINGS:
        yield f"exit {run.code}", run.errors[:300]
    if run.code == 0 and run.answer is None:
        yield "JSON", f"no JSON object on standard output, exit {run.code}: {run.output[:80]!r} {run.errors[:200]}"
    if run.code != 0 and run.answer is None and len(run.errors.strip().splitlines()) != 1:
        yield "message", f"not one line: {run.errors[:300]!r}"


def resources(case, run):
    seconds = run.seconds - checking_seconds(case, run)
    if seconds > budget_seconds(case):  # of two runs the smaller: what else the machine does only adds to a time
        again = run.again([*case.arguments, *case.limits])
        seconds = min(seconds, again.seconds - checking_seconds(case, again))
    if seconds > budget_seconds(case):
        yield "time", f"{seconds:.2f} s of processor time with a budget of {case.budget:g} s"
    if run.mebibytes > case.memory + MEMORY_BESIDE:
        yield "memory", f"{run.mebibytes:.0f} MiB with --memory {case.memory}"


def checking_seconds(case, run):
    """What the checker took of the time of the run: it has no budget."""
    if "--certificate" not in case.arguments:
        return 0
    if LONG_CHECK in no_certificate_reason(run):
        return run.seconds
    return run.again(["verify", "proof.cert"]).seconds if has_certificate(run) else 0


def no_certificate_reason(run):
    return (run.answer or {}).get("certificate_reason", "")


def has_certificate(run):
    return os.path.exists(os.path.join(run.folder, "proof.cert"))


def not_empty(case, run):
    for path, lower, upper in enclosures(run.answer):
        if lower is not None and upper is not None and lower > upper:
            yield "empty enclosure", f"{path}: {float(lower)} ... {float(upper)}"


# ---- of one command

def radius(case, run):
    words = Words(case.facts["family"], case.facts["edges"])
    lower, upper = words.bounds()
    found = (run.answer or {}).get("radius")
    if not found:
        return
    if end(found, "upper") is not None and not words.is_at_least(end(found, "upper"), lower):
        yield "wrong", f"upper end {found['upper']} below |trace| / {words.size} of a product of length {lower[1]}"
    if end(found, "lower") is not None and not words.is_at_most(end(found, "lower"), upper):
        yield "wrong", f"lower end {found['lower']} above the norm of products of length {upper[1]}"
    if len(case.facts["family"]) == 1 and not case.facts["edges"] and not run.answer.get("exact"):
        yield "open", "the radius of one matrix"


def exponent(case, run):
    answer = run.answer or {}
    found = answer.get("holder")
    if case.facts["surface"] or not found or answer.get("rounded"):
        return
    scheme = mask_of(run, case.facts["scheme"])
    if scheme is None:
        return
    at_least = scheme.exponent_at_least()
    if answer["sum_rules"] != scheme.rules:
        yield "wrong", f"{answer['sum_rules']} sum rules, here {scheme.rules}"
    if end(found, "upper") is not None and end(found, "upper") < at_least - GUARD:
        yield "wrong", f"upper end {found['upper']} below {at_least}, by norms"
    if answer["converges"] == "no" and at_least > GUARD:
        yield "wrong", f"convergence refuted, but the exponent is at least {at_least}"
    if not answer["stable"] or end(found, "lower") is None:
        return
    at_most = scheme.exponent_at_most()
    if end(found, "lower") > max(at_most, 0) + GUARD:
        yield "wrong", f"lower end {found['lower']} above {at_most}, by a product"
    if answer["converges"] == "yes" and at_most < -GUARD:
        yield "wrong", f"convergence proved, but a product grows like {-at_most}"


def mask_of(run, scheme):
    mask = run.ask("mask", scheme, "--json")
    return mask and DifferenceScheme([Fraction(c) for c in mask["coefficients"]], mask["arity"])


def vector(case, run):
    """Exponent and convergence against products and norms of operators that are made here."""
    answer = run.answer or {}
    mask = run.ask("mask", case.facts["scheme"], "--json") if answer else None
    if not mask or not isinstance(mask["first_index"], int):
        return
    matrices = [[[Fraction(v) for v in row] for row in m] for m in mask["coefficients"]]
    if any(v.denominator > ROUNDED for m in matrices for row in m for v in row):
        return
    equation = VectorEquation(matrices, mask["first_index"], mask["arity"])
    if answer["solutions"] == 1 and "--component" not in case.arguments:
        for order in (1, 3):
            yield from vector_exponent(answer["holder"], equation.of_values(order), mask["arity"], order)
    words = equation.of_differences()
    is_hermite = case.facts["scheme"].startswith(("hermite", "merrien"))  # data of which derivatives are scaled
    if not words or answer["hermite"] or is_hermite:
        return
    words = Words(words)
    at_least, at_most = words.bounds()
    if answer["converges"] == "yes" and not (words.is_at_least(1, at_least) and equation.keeps_constants()):
        yield "wrong", "convergence proved, but a product of differences grows, or no constants are kept"
    if answer["converges"] == "no" and equation.keeps_constants() and not words.is_at_most(1, at_most):
        yield "wrong", "convergence refuted, but products of differences shrink"


def twin(case, run):
    """The same functions in another basis have the same exponent, and the same data converge."""
    other = "twin" in case.facts and run.answer and run.ask("regularity", case.facts["twin"], *case.limits)
    if not other or "--component" in case.arguments:
        return
    for key in ("converges", "continuous"):
        if {run.answer[key], other[key]} == {"yes", "no"}:
            yield "wrong", f"{key} is {run.answer[key]}, and {other[key]} in another basis"
    for one, two in ((run.answer, other), (other, run.answer)):
        low, high = end(one["holder"], "lower"), end(two["holder"], "upper")
        if low is not None and high is not None and low > high:
            yield "wrong", f"an exponent at least {float(low)} and at most {float(high)} in another basis"


def vector_exponent(found, family, arity, order):
    """The radius of differences of this order of the values is arity^-s for an exponent s below the order."""
    if not family:
        return
    words = Words(family)
    at_least, at_most = words.bounds()
    low, high = end(found, "lower"), end(found, "upper")
    radius = lambda exponent: Fraction(float(arity) ** -float(exponent))
    if low is not None and not words.is_at_least(radius(min(low, order) - Fraction(GUARD)), at_least):
        yield "wrong", f"lower end {found['lower']}, but a product of differences of order {order} is too large"
    if high is not None and high < order and not words.is_at_most(radius(high + Fraction(GUARD)), at_most):
        yield "wrong", f"upper end {found['upper']}, but products of differences of order {order} are small"


def pieces(case, run):
    """Samples of decided pieces."""
    answer = run.answer or {}
    at = case.facts["low"]
    for piece in answer.get("pieces", []):
        low, high = Fraction(piece["from"]), Fraction(piece["to"])
        if low != at or high < low:
            yield "wrong", f"the piece {low} ... {high} does not begin at {at}"
        at = high
    if answer and at != case.facts["high"]:
        yield "wrong", f"the pieces end at {at}"
    special = [(Fraction(one["value"]["lower"]), Fraction(one["value"]["upper"])) for one in answer.get("special", [])]
    for piece in [p for p in answer.get("pieces", []) if p["verdict"] != "undecided"][:MOST_SAMPLES]:
        w = (Fraction(piece["from"]) * 2 + Fraction(piece["to"])) / 3
        if any(low <= w <= high for low, high in special):
            continue
        scheme = mask_of(run, case.facts["at"](w))
        if scheme:
            yield from sample(case.facts["property"], piece["verdict"], w, scheme)


def sample(asked, verdict, w, scheme):
    needed = {"convergent": 0, "C1": 1, "C2": 2, "holder>=1/2": 0.5, "holder>=3/2": 1.5}.get(asked)
    if needed is None:
        return
    at_least = scheme.exponent_at_least()
    if verdict == "refuted" and at_least > needed + GUARD:
        yield "wrong", f"{asked} refuted at w = {w}, where the exponent is at least {at_least}"
    if verdict == "proved" and scheme.rules == 1 and scheme.growth_at_least() > GUARD and asked == "convergent":
        yield "wrong", f"convergence proved at w = {w}, where a product of differences grows"


def masks_alone(case, run):
    """No more holds for all sequences than for a mask at all levels; one sequence has the exponent of its mask."""
    found = (run.answer or {}).get("holder")
    if not found:
        return
    for scheme in case.facts["alone"]:
        alone = run.ask("regularity", scheme, *case.limits) or {}
        of_functions = alone.get("solutions") == 1 and alone.get("continuous") == "yes"
        low, high = end(found, "lower"), end(alone.get("holder"), "upper")
        if low is not None and high is not None and (alone.get("stable") is True or of_functions) and low > high:
            yield "wrong", f"lower end {found['lower']}, but {alone['holder']['upper']} for {scheme} at all levels"
        low, high = end(alone.get("holder"), "lower"), end(found, "upper")
        if case.facts["one"] and low is not None and high is not None and low > high:
            yield "wrong", f"upper end {found['upper']}, but {alone['holder']['lower']} for {scheme}, the only mask"


def values(case, run):
    """The shifts of the basic limit function sum to 1, and so do those from the values of a Hermite scheme."""
    answer = run.answer or {}
    if "values" in answer and isinstance(answer.get("first_index"), int):
        arity, pairs = answer["arity"], list(enumerate(answer["values"]))
    elif "values" in answer and case.facts.get("hermite"):
        [[arity]], pairs = answer["dilation"], [(i, v[0]) for (i,), v in zip(answer["indices"], answer["values"])]
    else:
        return
    step, sums = arity ** answer["level"], {}
    for i, value in pairs:
        sums[i % step] = sums.get(i % step, 0) + Fraction(value)
    for k in range(step):
        if sums.get(k, 1 if len(sums) < step and "first_index" in answer else 0) != 1:
            yield "wrong", f"values at {k} + {step} i sum to {sums.get(k, 0)}"
            return


def curve(case, run):
    answer = run.answer or {}
    for name, side, sign in (("sup", "upper", 1), ("inf", "lower", -1)):
        bound = end(answer.get(name), side)
        if bound is not None and answer.get("mean") and sign * (Fraction(answer["mean"]) - bound) > 0:
            yield "wrong", f"mean {answer['mean']} beyond {name} {float(bound)}"


def coefficients(case, run):
    answer = run.answer or {}
    if not answer or not isinstance(answer["first_index"], int) or answer.get("rounded"):
        return
    numbers = [Fraction(c) for c in answer["coefficients"]]
    for k in range(answer["arity"]):
        if sum(numbers[k::answer["arity"]]) != 1:
            yield "wrong", f"coefficients of class {k} sum to {sum(numbers[k::answer['arity']])}"


# ---- of several runs

def certificate(case, run):
    if not has_certificate(run):
        reason = no_certificate_reason(run)
        if "--certificate" in case.arguments and run.code == 0 and not any(claim in reason for claim in NO_CLAIM):
            yield "certificate", f"none was written: {reason[:200]}"
        return
    verified = run.again(["verify", "proof.cert"])
    if verified.code != 0:
        yield "certificate", f"refused: {(verified.output + verified.errors)[-200:]}"
    os.remove(os.path.join(run.folder, "proof.cert"))


def longer(case, run, factor=3):
    """More time does not contradict the enclosure, and does not widen it. Time is that of the processor, so that a
    search that closes just in time does so in one run and not in the next: of three runs with each budget the ones in
    the middle are compared."""
    key = {"regularity": "holder", "jsr": "radius"}.get(case.kind)
    before = (run.answer or {}).get(key)
    if not before or case.budget * factor > 4:
        return

    def ask(seconds):
        return run.again([*case.arguments, "--budget", f"{seconds:g}", "--json", "--quiet"])

    def thrice(seconds, first):
        return [first, *((ask(seconds).answer or {}).get(key) for _ in range(2))]

    later = ask(factor * case.budget)
    after = (later.answer or {}).get(key)
    if not after:
        yield "longer budget", f"no answer with {factor} times the budget: {later.errors[:200]}"
        return
    for side, other, sign in (("lower", "upper", 1), ("upper", "lower", -1)):
        first, opposite = end(before, side), end(after, other)
        if first is not None and opposite is not None and sign * (first - opposite) > 0:
            yield "wrong", f"{side} end {before[side]}, and with more time {other} end {after[other]}"
        if widens(before, after, side) and widens(middle(thrice(case.budget, before), side),
                                                  middle(thrice(factor * case.budget, after), side), side):
            yield "longer budget", f"{side} end {before[side]}, and {after[side]} with {factor} times the budget"


def widens(before, after, side):
    """Whether that end moved outward by more than the last digit of either."""
    first, second = end(before, side), end(after, side)
    if first is None:
        return False
    if second is None:
        return True
    outward = second - first if side == "upper" else first - second
    return outward > max(last_digit(before[side]), last_digit(after[side]))


def middle(enclosures_of_runs, side):
    """The enclosure whose end on that side is the one in the middle; a missing end is the widest."""
    widest = float("inf") if side == "upper" else float("-inf")

    def key(enclosure):
        at = end(enclosure, side)
        return widest if at is None else at
    return sorted(enclosures_of_runs, key=key)[len(enclosures_of_runs) // 2]


# ---- vertices

def vertices(case, run):
    """What is said together, what is known of the rules that were drawn, and certificates."""
    for at in (run.answer or {}).get("valences", ()):
        n, c1, exponent = at["valence"], at["c1"], at.get("exponent")
        if c1 == "yes" and at["frequency"] != 1:
            yield "wrong", f"C1 at valence {n} with frequency {at['frequency']} in front"
        if c1 == "yes" and exponent and end(exponent, "lower") is not None and end(exponent, "lower") < 1:
            yield "wrong", f"C1 at valence {n} with an exponent from {exponent['lower']} on"
        if c1 == "no" and exponent and end(exponent, "lower") is not None and end(exponent, "lower") > 1:
            yield "wrong", f"not C1 at valence {n} with an exponent from {exponent['lower']} on"
        expected = known_at_vertex(case.facts.get("kind"), case.facts.get("b"), n)
        if expected and c1 not in (expected, "unknown"):
            yield "wrong", f"C1 at valence {n}: {c1}, here {expected}"
    if case.facts["certificates"] and run.answer:
        run.again([*case.arguments, *case.limits, "--certificate", "certificates"])
        if glob.glob(os.path.join(run.folder, "certificates/*.cert")):
            checked = run.again(["verify", "certificates"])
            if checked.code != 0:
                yield "certificate", f"verify: exit {checked.code}: {(checked.output + checked.errors)[:300]}"


def known_at_vertex(kind, b, n):
    """'yes' or 'no' where the eigenvalues are known: (3 + 2 cos 2 pi/n)/8 and 5/8 - b; b and 1/4."""
    c = math.cos(2 * math.pi / n)
    if kind == "loop":
        first, other = (3 + 2 * c) / 8, abs(5 / 8 - float(b))
        return None if abs(first - other) < GUARD else "yes" if other < first else "no"
    if kind == "doo-sabin" and (b <= Fraction(1, 4) or b > 1):
        return "no"
    return None


OF_ALL = (ending, resources, not_empty)
OF_COMMAND = {"regularity": (exponent, certificate), "vector": (vector, twin, certificate),
              "jsr": (radius, certificate), "range": (pieces,), "levels": (masks_alone,), "limit": (values,),
              "variance": (curve,), "mask": (coefficients,), "vertex": (vertices,)}



def findings(case, run, with_longer):
    for judge in (*OF_ALL, *OF_COMMAND.get(case.kind, ()), *((longer,) if with_longer else ())):
        try:
            yield from judge(case, run)
        except (KeyError, TypeError, ValueError, ZeroDivisionError) as error:
            yield "form", f"{judge.__name__} cannot read the answer: {error!r}"
