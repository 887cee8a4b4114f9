"""Answers with proof: three-valued, comparable, picklable; and what is raised where there is none."""

import copy
import pickle
from fractions import Fraction

import numpy
import pytest
import subcert
import sympy


def test_three_valued_answers_are_no_bools():
    decision = subcert.scheme("primal:n=2").converges()
    assert decision.is_yes
    for answer in (decision, decision.truth, subcert.scheme("primal:n=2").holder() > 1):
        with pytest.raises(TypeError, match="no bool"):
            bool(answer)
        with pytest.raises(TypeError, match="no bool"):
            if answer:
                pass
        with pytest.raises(TypeError, match="no bool"):
            not answer


def test_an_exponent():
    h = subcert.scheme("four-point:w=1/16").holder()
    assert h.lower <= h.upper and h.exact and h.closed and h.stable.is_yes
    assert float(h) == pytest.approx(2)
    assert (h > 1).is_yes and (h > 3).is_no and (h < 3).is_yes and (h <= 1).is_no
    narrow = subcert.scheme("primal:n=4").holder(width="1e-60")
    assert narrow.enclosure.width <= Fraction(1, 10**60)


def test_divergence_has_no_exponent():
    h = subcert.scheme("four-point:w=1/2").holder()
    assert h.converges.is_no and h.lower is None and h.upper is None
    with pytest.raises(subcert.DomainError):
        float(h)
    with pytest.raises(subcert.DomainError, match="no limit function"):
        subcert.scheme("four-point:w=1/2").limit(2)


def test_certificates(tmp_path):
    h = subcert.scheme("primal:n=5").holder()
    certificate = h.certificate
    assert certificate.verify().accepted
    certificate.save(tmp_path / "s5.cert")
    found = subcert.verify(tmp_path / "s5.cert")
    assert found.accepted and "exponent" in found.answer
    assert certificate.logarithm == 0 and "with |log h|^0" in found.answer
    four = subcert.scheme("dd:n=2").holder().certificate
    assert (four.lower, four.upper, four.logarithm) == ("2", "2", 1) and four.exact.startswith("4-log|[-4,1]@4,")
    text = (tmp_path / "s5.cert").read_text()
    lines = text.splitlines()
    lines[2] = f"bounds 3 {lines[2].split()[2]}"
    (tmp_path / "wrong.cert").write_text("\n".join(lines) + "\n")
    assert not subcert.verify(tmp_path / "wrong.cert").accepted
    (tmp_path / "none.cert").write_text("hello\n")
    with pytest.raises(subcert.DataError, match="not a certificate"):
        subcert.verify(tmp_path / "none.cert")
    with pytest.raises(subcert.MissingFileError):
        subcert.verify(tmp_path / "absent.cert")
    with pytest.raises(subcert.MissingFileError):
        certificate.save(tmp_path / "no folder" / "s5.cert")


def test_algebraic_masks_are_exact():
    h = subcert.scheme("daubechies:n=10").holder()
    assert h.exact and h.product == (1, 1, 0, 0) and h.logarithm == (0, 0)
    assert (h.certificate.attains, h.certificate.exact, h.certificate.logarithm) == ("1,1,0,0", None, 0)
    answer = h.certificate.verify().answer
    assert answer.startswith("VERIFIED ") and "-log rho(1,1,0,0)^1/4" in answer
    printed = "[0.48296291314453,0.83651630373780,0.22414386804201,-0.12940952255126]"
    near = subcert.scheme(f"mask:{printed},nearly=1e-12")
    assert abs(float(near.holder()) - 0.5500156865) < 1e-9 and "2 sum rules" in near.title


def test_a_single_spectral_radius_gets_a_certificate_too():
    h = subcert.scheme("dd:n=2").holder()
    assert h.method == "single spectral radius"
    assert h.verify().accepted


def test_surfaces():
    h = subcert.scheme("butterfly:w=1/16").holder()
    assert h.converges.is_yes and h.verify().accepted
    tensor = subcert.scheme("tensor:(primal:n=3)x(primal:n=3)")
    assert tensor.holder().enclosure.lower == subcert.scheme("primal:n=3").holder().enclosure.lower
    assert sum(tensor.mask.values()) == 4
    points, values = tensor.limit(2)
    assert points.shape == (values.size, 2) and abs(values.sum() - 16) < 1e-9
    exact = subcert.scheme("quincunx").limit(3, exact=True)
    assert sum(exact[1]) == 8 and len(exact[0]) == len(exact[1])


@pytest.mark.parametrize(
    "matrices",
    [
        [[[1, 1], [0, 1]], [[1, 0], [1, 1]]],
        [numpy.array([[1, 1], [0, 1]]), numpy.array([[1, 0], [1, 1]])],
        numpy.array([[[1, 1], [0, 1]], [[1, 0], [1, 1]]]),
        [sympy.Matrix([[1, 1], [0, 1]]), sympy.Matrix([[1, 0], [1, 1]])],
        [[[Fraction(1), "1"], ["0", 1]], [[1, 0], [1, 1]]],
    ],
)
def test_radii_of_matrices_of_all_kinds(matrices):
    radius = subcert.jsr(matrices)
    assert radius.exact and float(radius) == pytest.approx((1 + 5**0.5) / 2)


def test_radii():
    pair = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]
    with pytest.raises(TypeError, match="exact"):
        subcert.jsr([[[0.5]]])
    with pytest.raises(subcert.DomainError, match="entries"):
        subcert.jsr([[[1, 2], [3]]])
    with pytest.raises(subcert.DomainError):
        subcert.jsr([])
    # After each other only: the radius of the product.
    alternating = subcert.jsr(pair, edges=[(0, 1, 0), (1, 0, 1)])
    assert float(alternating) == pytest.approx((1 + 5**0.5) / 2)
    alone = subcert.jsr(pair, edges=[(0, 0, 0)])
    assert alone.lower == alone.upper == 1
    assert alone.verify().accepted
    assert subcert.p_radius(pair, 2).lower > Fraction(3, 2)
    with pytest.raises(subcert.DomainError, match="even"):
        subcert.p_radius([[[1, -1], [1, 1]]], 3)
    slow = subcert.subradius([[[7, 2], [0, 3]], [[2, 0], [4, 8]]], width="1e-50")
    assert slow.exact and slow.closed and len(slow.product) == 8 and slow.upper - slow.lower < Fraction(1, 10**50)
    assert slow.verify().accepted and pickle.loads(pickle.dumps(slow)) == slow
    with pytest.raises(subcert.DomainError, match="negative"):
        subcert.subradius([[[1, -1], [0, 1]]])


def test_families():
    family = subcert.family("four-point:w")
    found = family.range("C1", "1/100", "1/4")
    assert found.complete and [p.holds.value for p in found.pieces] == ["yes", "unknown", "no"]
    [end] = found.ends
    w = end.value.lower
    assert end.polynomial(w) * end.polynomial(end.value.upper) <= 0  # the zero of 32 w^3 + 4 w - 1
    assert end.value.width <= Fraction(1, 10**9) and abs(32 * w**3 + 4 * w - 1) < Fraction(1, 10**7)
    assert found.summary.startswith("C1 for ") and "-1 + 4*w + 32*w^3" in found.summary and found.summary in repr(found)
    assert all(c.certificate.verify().accepted for c in found.certificates()[:3])
    curve = family.curve("1/10", "1/5", pieces=8)
    assert len(curve.pieces) == 8
    here = family.at("3/20").holder()
    piece = next(p for p in curve.pieces if p.low <= Fraction(3, 20) <= p.high)
    assert piece.exponent.lower <= here.lower and here.upper <= piece.exponent.upper
    with pytest.raises(subcert.UsageError):
        family.range("smooth", 0, 1)
    with pytest.raises(subcert.Error):
        family.range("C1", 1, 0)


def test_everything_can_be_pickled():
    scheme = subcert.scheme("primal:n=5")
    h = scheme.holder()
    for value in (
        scheme,
        h,
        subcert.scheme("loop"),
        subcert.scheme("l1:points=6"),
        subcert.family("four-point:w"),
        scheme.symbol,
        scheme.variance_range(),
        subcert.Truth.yes,
        h.converges,
        h.enclosure,
        subcert.jsr([[[2]]]),
        h.certificate,
    ):
        for again in (pickle.loads(pickle.dumps(value)), copy.deepcopy(value)):
            assert again == value
    assert pickle.loads(pickle.dumps(h)).verify().accepted
    assert pickle.loads(pickle.dumps(subcert.jsr([[[2]]]))).verify().accepted


@pytest.mark.parametrize(
    "call, kind, base",
    [
        (lambda: subcert.scheme("primal:n=0"), subcert.UsageError, ValueError),
        (lambda: subcert.scheme("nothing"), subcert.UsageError, ValueError),
        (lambda: subcert.mask([1, 1, 1], 2).holder(), subcert.Error, Exception),
        (lambda: subcert.scheme("primal:n=2").limit(-1), subcert.DomainError, ValueError),
        (lambda: subcert.scheme("primal:n=2").limit(40), subcert.SizeError, ValueError),
        (lambda: subcert.scheme("primal:n=2").limit(2, derivative=3), subcert.DomainError, ValueError),
        (lambda: subcert.scheme("mask:[1,1,2,2,1,1]/4").limit(2, derivative=1), subcert.UndecidedError, RuntimeError),
        (lambda: subcert.check("absent.toml"), subcert.MissingFileError, OSError),
        (lambda: subcert.check("x = \n"), subcert.DataError, ValueError),
        (lambda: subcert.statements("none/at-all"), subcert.UsageError, ValueError),
        (lambda: subcert.reproduce("no-paper"), subcert.UsageError, ValueError),
        (lambda: subcert.scheme("primal:n=2").holder(width=0), subcert.DomainError, ValueError),
    ],
)
def test_errors_have_one_line_and_the_right_type(call, kind, base):
    with pytest.raises(kind) as caught:
        call()
    assert isinstance(caught.value, base) and isinstance(caught.value, subcert.Error)
    assert str(caught.value) and "\n" not in str(caught.value)


def test_papers():
    assert "table1" in subcert.papers()["dyn-2015"]
    found = subcert.reproduce("dyn-2015", ["table1"])
    assert len(found) > 5 and {c.verdict for c in found} == {"match"}
    assert "<table>" in found._repr_html_()
    [checked] = subcert.check_statements("dyn-2015/eq-2")
    assert checked.as_recorded
    answers = subcert.check('[[scheme]]\nmask = "primal:n=3"\nsum_rules = 3\n')
    assert [a.answer.is_no for a in answers] == [True]


def test_pictures():
    assert "<svg" in subcert.scheme("primal:n=3")._repr_html_()
    assert "no limit function" in subcert.scheme("four-point:w=1/2")._repr_html_()
    assert "<td>1/" in subcert.scheme("loop")._repr_html_()
    assert subcert.scheme("primal:n=2")._repr_latex_().startswith("$a(z) = ")
    assert subcert.scheme("primal:n=2").holder()._repr_latex_().startswith("$")
    assert "exact" in subcert.scheme("primal:n=2").holder()._repr_html_()


def test_facts_are_those_of_the_command_line():
    curve, surface = subcert.scheme("dd:n=2"), subcert.scheme("loop:")
    assert curve.facts["sum_rules"] == curve.sum_rules == 4
    assert Fraction(curve.facts["operator_norm"]) == Fraction(5, 4)
    assert Fraction(curve.facts["support"]["upper"]) == curve.support[1] == 3
    assert surface.facts["factors"] == [2, 2]
    page = curve.analyze()
    assert page["convergence"]["verdict"] == "yes" and {**page, **curve.facts} == page
    assert surface.analyze(budget=2)["stable"]["verdict"] == "yes"
    h = curve.holder()
    assert h.facts["exact"] is h.exact and h.facts["method"] == h.method and h.facts["sum_rules"] == h.sum_rules
    assert pickle.loads(pickle.dumps(h)).facts == h.facts
    assert surface.holder().facts["variables"] == 2


def test_surfaces_at_vertices_of_any_valence():
    three, seven = subcert.vertices("loop", [3, 7])
    assert (three.valence, three.frequency, three.curvature) == (3, 1, "unbounded")
    assert three.c1.is_yes and seven.c1.is_yes
    assert three.subdominant.lower <= Fraction(1, 4) <= three.subdominant.upper
    assert three.exponent.lower <= Fraction(3, 2) <= three.exponent.upper
    eight = subcert.vertices(subcert.scheme("butterfly:w=1/16"), [8])[0]
    assert eight.c1.is_no and eight.frequency == 2 and eight.exponent is None and eight.curvature is None
    assert subcert.vertices("sqrt3", []) == []
    with pytest.raises(subcert.DomainError, match="valences from 3 to 1000"):
        subcert.vertices("loop", [2])
    with pytest.raises(subcert.DomainError, match="no rules at vertices"):
        subcert.vertices("primal:n=2")
    assert subcert.vertices("loop", 7) == [seven]
    for wrong in ("3..5", [5.5], 5.0):
        with pytest.raises(TypeError, match="valence"):
            subcert.vertices("loop", wrong)
    with pytest.raises(subcert.MissingFileError, match="nowhere.toml: No such file"):
        subcert.vertices("nowhere.toml")


def test_wrong_types_are_named_with_what_would_be_right():
    with pytest.raises(TypeError, match="a list of matrices, each a list of rows"):
        subcert.jsr([[1, 1], [0, 1]])
    with pytest.raises(TypeError, match="json.load"):
        subcert.jsr("pair.json")
    with pytest.raises(TypeError, match="ids of statements or papers, one after another"):
        subcert.check_statements(["dyn-2015"])
    with pytest.raises(TypeError, match="savefig"):
        subcert.scheme("chaikin").plot("chaikin.png")


def test_stencils_at_vertices():
    regular = subcert.vertex_stencils("catmull-clark", 4)
    assert [(at.point, at.exact) for at in regular.limit[::4]] == [((0, 0), "4/9"), ((1, 0), "1/9"), ((1, 1), "1/36")]
    assert sum(at.weight.lower for at in regular.limit) <= 1 <= sum(at.weight.upper for at in regular.limit)
    assert len(regular.tangents) == 2 and regular.tangents[0][0].sector == 0
    assert subcert.vertex_stencils("butterfly:w=1/16", 8).tangents == ([], [])
    with pytest.raises(subcert.DomainError, match="from 3 to 1000"):
        subcert.vertex_stencils("loop", 2)


LETTERS = """
scheme = "loop"
letter = ["a", "b"]
value = ["1", "0"]
[[rule]]
weights = {vertex = "1 - a*b", neighbours = "a*b/n"}
"""


def test_for_which_weights_surfaces_are_smooth_at_vertices():
    rules = subcert.vertex_rules(LETTERS)
    three, four = subcert.vertex_ranges(rules, "b", 0, "4/5", [3, 4])
    assert (three.valence, four.valence, three.parameter) == (3, 4, "b")
    assert [end.exact for end in (*three.ends, *four.ends)] == ["3/8", "1/4"]
    assert three.ends[0].value.lower <= Fraction(3, 8) <= three.ends[0].value.upper
    assert three.pieces[0].low == 0 and three.pieces[-1].high == Fraction(4, 5)
    assert all(piece.low >= Fraction(3, 8) for piece in three.proved())
    curved = subcert.vertex_ranges(rules, "b", "3/10", "4/5", [4], property="bounded-curvature")[0]
    assert [end.exact for end in curved.ends] == ["31/64", "49/64"] and curved.ends[0].holds.is_yes
    for letter, property in (("x", "C1"), ("b", "C2")):
        with pytest.raises(subcert.UsageError):
            subcert.vertex_ranges(rules, letter, 0, 1, [3], property=property)
    with pytest.raises(subcert.UsageError, match="need rules with a letter"):
        subcert.vertex_ranges("triangular:L=17/10,d=1,power=1", "b", 0, 1, [3])
    with pytest.raises(subcert.DomainError, match="low < high"):
        subcert.vertex_ranges(rules, "b", 1, 0, [3])
    with pytest.raises(subcert.DomainError, match="valences from 3"):
        subcert.vertex_ranges(rules, "b", 0, 1, [2])


def test_a_map_of_weights_at_vertices():
    rules = subcert.vertex_rules(LETTERS)
    found = subcert.vertex_map(rules, {"a": (0, 2), "b": (0, 1)}, 4, resolution=8)
    assert found.complete and found.parameters == ("a", "b")
    assert sum(cell.volume for cell in found.cells) == 2
    assert sum(found.share(holds) for holds in subcert.Truth) == 1
    for cell in found.cells:  # C1 for 1/4 < a b < 1 (and at the ends, or not)
        if cell.holds.is_yes:
            assert cell.low[0] * cell.low[1] > Fraction(1, 4) and cell.high[0] * cell.high[1] < 1
        if cell.holds.is_no:
            assert cell.high[0] * cell.high[1] < Fraction(1, 4) or cell.low[0] * cell.low[1] > 1
    assert found.share(subcert.Truth.yes) > Fraction(1, 10)
    with pytest.raises(subcert.UsageError):
        subcert.vertex_map(rules, {"a": (0, 2), "x": (0, 1)}, 4)
    with pytest.raises(subcert.DomainError):
        subcert.vertex_map(rules, {"a": (0, 2)}, 4)
    with pytest.raises(subcert.DomainError):
        subcert.vertex_map(rules, {"a": (0, 2), "b": (1, 0)}, 4)


def test_surfaces_at_vertices_of_every_valence():
    assert subcert.every_valence("loop", 7).c1.is_yes
    butterfly = subcert.every_valence("butterfly:w=1/16")
    assert butterfly.c1.is_unknown and butterfly.open == [(13, None)] and butterfly.intervals == 0
    for first in (6, 1001):
        with pytest.raises(subcert.DomainError, match="from 7 to 1000"):
            subcert.every_valence("loop", first)
    with pytest.raises(subcert.DomainError, match="no rules at vertices"):
        subcert.every_valence("primal:n=2")


def test_values_with_a_square_root():
    pair = subcert.scheme("cl:2")
    points, values = pair.limit(1, exact=True)
    assert values[0] == (Fraction(1, 2), "-1/4*sqrt(7)") and points[0] == (Fraction(1, 2),)
    assert pair.limit(1)[1][0][1] == pytest.approx(-(7**0.5) / 4)
    certificate = pair.holder().certificate
    assert certificate.exact.startswith("0-log|[-7,0,16]") and certificate.verify().accepted
