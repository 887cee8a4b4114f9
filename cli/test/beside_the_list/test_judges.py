"""The judges find wrong answers and let right ones pass, in cases whose answers are known by hand."""
import unittest
from fractions import Fraction
from types import SimpleNamespace

import judges
from generators import Case
from oracles import DifferenceScheme, VectorEquation, Words


def run(answer, **more):
    return SimpleNamespace(**{"code": 0, "answer": answer, "output": "", "errors": "", "seconds": 0.1, "mebibytes": 20,
                              "folder": "/nonexistent", **more})


def kinds(judge, case, answer, **more):
    return [kind for kind, _ in judge(case, run(answer, **more))]


def enclosure(lower, upper):
    return {"lower": lower, "upper": upper}


class Bounds(unittest.TestCase):
    def test_golden_mean(self):
        words = Words([[[1, 1], [0, 1]], [[1, 0], [1, 1]]])
        lower, upper = words.bounds()
        for right in ("1.618034", "1.62", "5"):
            self.assertTrue(words.is_at_least(right, lower))
        for right in ("1.618033", "0", "-1"):
            self.assertTrue(words.is_at_most(right, upper))
        self.assertFalse(words.is_at_least("1.5", lower))
        self.assertFalse(words.is_at_most("2.1", upper))

    def test_one_matrix_with_fractions(self):
        words = Words([[[Fraction(1, 2), 5], [0, Fraction(-2, 3)]]])
        lower, upper = words.bounds()
        self.assertTrue(words.is_at_least("0.67", lower) and words.is_at_most("0.66", upper))
        self.assertFalse(words.is_at_least("0.5", lower))

    def test_graph_without_cycles(self):
        words = Words([[[7]]], [[0, 1, 0]])
        lower, upper = words.bounds()
        self.assertEqual((lower[0], upper[0]), (0, 0))
        self.assertTrue(words.is_at_most("0", upper))
        self.assertFalse(words.is_at_most("0.1", upper))

    def test_splines_and_four_points(self):
        cubic = DifferenceScheme([Fraction(c, 8) for c in (1, 4, 6, 4, 1)], 2)
        self.assertEqual(cubic.rules, 4)
        self.assertAlmostEqual(cubic.exponent_at_least(), 3)
        self.assertAlmostEqual(cubic.exponent_at_most(), 3)
        four_point = DifferenceScheme([Fraction(c, 16) for c in (-1, 0, 9, 16, 9, 0, -1)], 2)
        self.assertEqual(four_point.rules, 4)
        self.assertTrue(1.6 < four_point.exponent_at_least() <= 2 <= four_point.exponent_at_most() < 2.4)
        ternary = DifferenceScheme([Fraction(c, 3) for c in (1, 2, 3, 2, 1)], 3)
        self.assertAlmostEqual(ternary.exponent_at_least(), 1)


    def test_vectors(self):
        diagonal = lambda *entries: [[Fraction(e) if i == j else Fraction(0) for j in range(len(entries))]
                                     for i, e in enumerate(entries)]
        hats = VectorEquation([diagonal("1/2", "1/2"), diagonal(1, 1), diagonal("1/2", "1/2")], -1, 2)
        self.assertTrue(hats.keeps_constants())
        lower, upper = Words(hats.of_differences()).bounds()
        self.assertFalse(Words(hats.of_differences()).is_at_most("0.51", upper))
        self.assertIsNone(hats.of_values(1))  # two solutions
        kept = VectorEquation([diagonal("1/2", 0), diagonal(1, 2), diagonal("1/2", 0)], -1, 2)
        self.assertFalse(Words(kept.of_differences()).is_at_least("0.99", Words(kept.of_differences()).bounds()[0]))


class Judges(unittest.TestCase):
    case = Case("jsr", [], 1.0, facts={"family": [[[1, 1], [0, 1]], [[1, 0], [1, 1]]], "edges": None})

    def test_radius(self):
        self.assertEqual(kinds(judges.radius, self.case, {"radius": enclosure("1.618", "1.6181")}), [])
        self.assertEqual(kinds(judges.radius, self.case, {"radius": enclosure("1.4", "1.5")}), ["wrong"])
        self.assertEqual(kinds(judges.radius, self.case, {"radius": enclosure("2.1", "2.2")}), ["wrong"])
        self.assertEqual(kinds(judges.radius, self.case, {"radius": enclosure("-inf", "inf")}), [])

    def test_exponent(self):
        case = Case("regularity", [], 1.0, facts={"scheme": "", "surface": False})
        mask = {"arity": 2, "coefficients": ["1/8", "1/2", "3/4", "1/2", "1/8"]}

        def judged(lower, upper, **more):
            answer = {"holder": enclosure(lower, upper), "sum_rules": 4, "converges": "yes", "stable": True, **more}
            return kinds(judges.exponent, case, answer, ask=lambda *_: mask)

        self.assertEqual(judged("3", "3"), [])
        self.assertEqual(judged("2.5", "2.9"), ["wrong"])
        self.assertEqual(judged("3.1", "3.2"), ["wrong"])
        self.assertEqual(judged("3.1", "3.2", stable=False), [])
        self.assertEqual(judged("3", "3", sum_rules=3), ["wrong"])
        self.assertEqual(judged("3", "3", converges="no"), ["wrong"])

    def test_vector(self):
        # The hat function on [0, 2] and Takagi's function on [0, 1].
        case = Case("vector", ["regularity"], 1.0, facts={"scheme": ""})
        mask = {"arity": 2, "first_index": 0, "rounded": None, "coefficients": [
            [["1/2", "0"], ["1", "1/2"]], [["1", "0"], ["0", "1/2"]], [["1/2", "0"], ["0", "0"]]]}

        def judged(lower, upper, **more):
            answer = {"holder": enclosure(lower, upper), "solutions": 1, "converges": "yes", "hermite": None, **more}
            return kinds(judges.vector, case, answer, ask=lambda *_: mask)

        self.assertEqual(judged("1", "1"), [])
        self.assertEqual(judged("1.1", "1.2")[0], "wrong")
        self.assertEqual(judged("0.1", "0.2")[0], "wrong")
        self.assertEqual(judged("1", "1", converges="no"), ["wrong"])

    def test_every_run(self):
        self.assertEqual(kinds(judges.ending, self.case, {}), [])
        self.assertEqual(kinds(judges.ending, self.case, None, code=-8), ["signal", "message"])
        self.assertEqual(kinds(judges.ending, self.case, None, code=64, errors="no"), ["exit 64"])
        self.assertEqual(kinds(judges.ending, self.case, None), ["JSON"])
        self.assertEqual(kinds(judges.resources, self.case, {}, seconds=2.1), [])
        for seconds, found in ((2.3, ["time"]), (2.1, [])):  # of a second run
            self.assertEqual(kinds(judges.resources, self.case, {}, seconds=2.3,
                                   again=lambda _, its=seconds: run({}, seconds=its)), found)
        self.assertEqual(kinds(judges.resources, self.case, {}, mebibytes=1300), ["memory"])
        self.assertEqual(kinds(judges.not_empty, self.case, {"a": [enclosure("1", "2"), enclosure("2", "1")]}),
                         ["empty enclosure"])

    def test_longer_budget(self):
        def judged(*later, repeated=()):
            """Ends of runs with the longer budget; of repeated runs with the first."""
            runs = {"3": list(later), "1": list(repeated)}

            def again(arguments):
                ends = runs[arguments[arguments.index("--budget") + 1]]
                return run({"radius": enclosure(*(ends.pop(0) if len(ends) > 1 else ends[0]))})
            runs["1"] = runs["1"] or [("1.5", "1.7")]
            return kinds(judges.longer, self.case, {"radius": enclosure("1.5", "1.7")}, again=again)

        self.assertEqual(judged(("1.61", "1.62")), [])
        self.assertEqual(judged(("1.5", "1.7")), [])
        self.assertEqual(judged(("1.3", "1.9")), ["longer budget"] * 2)
        self.assertEqual(judged(("1.8", "1.9")), ["wrong", "longer budget"])
        self.assertEqual(judged(("1.5", "inf")), ["longer budget"])
        # One run is luck, two of three are not.
        self.assertEqual(judged(("1.5", "1.9"), ("1.5", "1.6")), [])
        self.assertEqual(judged(("1.5", "1.9"), ("1.5", "1.6"), ("1.5", "1.9")), ["longer budget"])
        self.assertEqual(judged(("1.5", "1.9"), repeated=[("1.5", "1.95")]), [])
        self.assertEqual(judged(("1.3", "1.7"), repeated=[("1.2", "1.7")]), [])

    def test_pieces(self):
        case = Case("range", [], 1.0, facts={"at": str, "property": "C1", "low": Fraction(0), "high": Fraction(1)})
        cubic = {"arity": 2, "coefficients": ["1/8", "1/2", "3/4", "1/2", "1/8"]}

        def judged(*pieces):
            answer = {"pieces": [{"from": a, "to": b, "verdict": v} for a, b, v in pieces]}
            return kinds(judges.pieces, case, answer, ask=lambda *_: cubic)

        self.assertEqual(judged(("0", "1/2", "proved"), ("1/2", "1", "undecided")), [])
        self.assertEqual(judged(("0", "1/2", "refuted"), ("1/2", "1", "undecided")), ["wrong"])
        self.assertEqual(judged(("0", "1/2", "proved")), ["wrong"])
        self.assertEqual(judged(("0", "1/3", "proved"), ("1/2", "1", "proved")), ["wrong"])

    def test_values(self):
        case = Case("limit", [], 1.0)
        answer = {"arity": 2, "level": 1, "first_index": -2, "values": ["0", "1/2", "1", "1/2", "0"]}
        self.assertEqual(kinds(judges.values, case, answer), [])
        self.assertEqual(kinds(judges.values, case, {**answer, "values": ["0", "1/2", "1", "1/3", "0"]}), ["wrong"])
        hermite = Case("limit", [], 1.0, facts={"hermite": True})
        answer = {"dilation": [[2]], "level": 1, "indices": [[-1], [0], [1]],
                  "values": [["1/2", "-1/8"], ["1", "0"], ["1/2", "1/8"]]}
        self.assertEqual(kinds(judges.values, hermite, answer), [])
        wrong = {**answer, "values": [["1/2", "-1/8"], ["2", "0"], ["1/2", "1/8"]]}
        self.assertEqual(kinds(judges.values, hermite, wrong), ["wrong"])


if __name__ == "__main__":
    unittest.main()
