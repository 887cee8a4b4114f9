"""What goes into papers: tables, LaTeX, plain values, pictures; short representations; names of wrong arguments."""

import hashlib
import json
from fractions import Fraction

import numpy
import pytest
import subcert


def test_tables():
    table = subcert.compare("dd:n=2", subcert.scheme("chaikin"), "loop", "four-point:w=1/2")
    assert len(table) == 4 and table[0]["holder"] == 2 and table[2]["sobolev"] == Fraction(7, 2)
    assert table[3]["converges"] == "no" and table[3]["holder"] is None
    lines = table.to_markdown().splitlines()
    assert len(lines) == 6 and all(line.count("|") == lines[0].count("|") for line in lines)
    latex = table.to_latex().splitlines()
    assert latex[0] == "\\begin{tabular}{lccccccc}" and latex[-1] == "\\end{tabular}"
    assert all(line.count("&") == 7 for line in latex if line.endswith("\\\\"))
    assert json.loads(json.dumps(table.to_dict()))[0]["holder"] == {"lower": "2", "upper": "2"}
    assert "<table>" in table._repr_html_() and repr(table) == "<SchemeTable of 4 schemes>"
    with pytest.raises(subcert.UsageError, match="linear"):
        subcert.compare("dd:n=2", "l1:points=6")
    with pytest.raises(subcert.UsageError, match="specification"):
        subcert.compare("nothing")
    both = subcert.compare("dd:n=2", "chaikin").to_dict()
    assert subcert.compare(["dd:n=2", subcert.scheme("chaikin")]).to_dict() == both
    for none in ((), ([],)):
        with pytest.raises(subcert.UsageError, match="one scheme or more"):
            subcert.compare(*none)


def test_latex():
    assert subcert.scheme("primal:n=3").holder().to_latex() == "1.9363087904562\\ldots"
    assert subcert.scheme("dd:n=2").holder().to_latex() == "2"
    assert subcert.Enclosure(None, None).to_latex() == "?"
    assert subcert.Enclosure(None, Fraction(3)).to_latex() == "\\le 3"
    assert subcert.scheme("bspline:degree=1").to_latex() == "\\frac{1}{2}\\left[1,\\,2,\\,1\\right]"
    found = subcert.family("four-point:mu").range("C1", 0, "1/4")
    assert found.to_latex().count("\\;\\mu\\;") == len(found.pieces) and found.parameter == "mu"


def test_printed_pieces_are_true():
    found = subcert.family("four-point:w").range("C1", "1/7", "1/3")
    for piece, row in zip(found.pieces, found.to_latex().splitlines()[2:]):
        low, _, high = (part.strip() for part in row.split("&")[:3])
        if piece.holds.is_unknown:
            assert Fraction(low) <= piece.low and piece.high <= Fraction(high)
        else:
            assert piece.low <= Fraction(low) and Fraction(high) <= piece.high


def test_plain_values():
    for name in ("dd:n=2", "loop"):
        scheme = subcert.scheme(name)
        assert json.loads(json.dumps(scheme.to_dict())) == scheme.facts
        exponent = json.loads(json.dumps(scheme.holder().to_dict()))
        assert exponent["enclosure"]["lower"] == str(scheme.holder().lower) and exponent["exact"] is True
    radius = subcert.jsr([[[1, 1], [0, 1]], [[1, 0], [1, 1]]])
    assert json.loads(json.dumps(radius.to_dict()))["product"] == [1, 0]
    assert subcert.family("four-point:w").range("stable", 0, 1).to_dict()[0]["verdict"] == "proved"


def test_masks_of_surfaces():
    rows = [[1, 2, 1], [2, 4, 2], [1, 2, 1]]
    bilinear = subcert.mask(rows, 4)
    assert bilinear == subcert.scheme("mask2:[[1,2,1],[2,4,2],[1,2,1]]/4")
    assert bilinear.mask[0, 0] == 1 and bilinear.mask[-1, 1] == Fraction(1, 4)
    assert subcert.mask(numpy.array(rows), 4) == bilinear
    assert subcert.mask([[[1, 1], [1, 1]], [[1, 1], [1, 1]]], first=(0, 0, 0)).dimension == 3
    quincunx = subcert.scheme("quincunx")
    square = [[quincunx.mask.get((i, j), 0) for i in (-1, 0, 1)] for j in (-1, 0, 1)]
    assert subcert.mask(square, first=(-1, -1), dilation=quincunx.dilation).mask == quincunx.mask
    with pytest.raises(subcert.UsageError, match="rows of one length"):
        subcert.mask([[1, 1], [1]])
    with pytest.raises(TypeError, match="exact number"):
        subcert.mask([[0.5, 0.5], [0.5, 0.5]])


def test_pictures():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    scheme = subcert.scheme("dd:n=2")
    [line, _] = scheme.plot(level=3).get_lines()
    x, y = scheme.limit(3)
    assert numpy.allclose(line.get_xdata(), x) and numpy.allclose(line.get_ydata(), y)
    ax = pyplot.figure().add_subplot()
    assert scheme.plot_variance(ax) is ax and len(ax.get_lines()) == 2
    family = subcert.family("four-point:w")
    assert len(family.curve("1/20", "1/10", pieces=8).plot().collections) == 8
    assert len(family.range("C1", 0, "1/4").plot().patches) == 4
    assert len(subcert.smooth([1.0, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3]).plot().get_lines()) == 1
    assert subcert.scheme("loop").plot(level=2).collections
    with pytest.raises(subcert.DomainError, match="two variables"):
        subcert.scheme("tensor:(dd:n=2)x(dd:n=2)x(dd:n=2)").plot()
    with pytest.raises(subcert.DomainError):
        subcert.scheme("four-point:w=1/2").plot()
    pyplot.close("all")


def test_representations_are_short():
    long = subcert.mask([1] * 2 + [0] * 300, first=0)
    values = (long, long.symbol, long.symbol.coefficients and subcert.scheme("dd:n=9").symbol)
    family = subcert.family("four-point:w")
    for value in (*values, family.range("C1", 0, 1), family.curve("1/20", "1/10", pieces=20)):
        assert len(repr(value)) < 200 and "\n" not in repr(value)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda s: s.holder(budget="x"), "budget: expected a number, got str 'x'"),
        (lambda s: s.holder(memory=-1), "memory: expected an integer from 0 on, got int -1"),
        (lambda s: s.limit(2.5), "level: expected an integer below 2"),
        (lambda s: s.limit(2, derivative="1"), "derivative: expected an integer"),
        (lambda s: s.smoothness(10**20), "levels: expected an integer below 2"),
        (lambda s: s.variance(None), "level: expected an integer"),
        (lambda s: subcert.jsr([[[1]]], edges=[(0, 1)]), "edges: expected triples"),
        (lambda s: subcert.p_radius([[[1]]], "2"), "p: expected an integer"),
        (lambda s: subcert.family(["x"]), "expected a text"),
        (lambda s: subcert.family("four-point:w").range(3, 0, 1), "property: expected a text, got int 3"),
        (lambda s: subcert.family("four-point:w").curve(0, 1, pieces="9"), "pieces: expected an integer"),
        (lambda s: subcert.refine(s, [1, 2, 3], levels="x"), "levels: expected an integer"),
        (lambda s: subcert.smooth([1.0] * 9, bands="x"), "bands: expected a number"),
        (lambda s: subcert.smooth([1.0] * 9, noise="x"), "noise: expected a number"),
        (lambda s: subcert.statements(5), "expected ids of statements or papers, one after another, got 5"),
        (lambda s: subcert.reproduce(3), "paper: expected a text"),
        (lambda s: subcert.check(3), "expected TOML"),
        (lambda s: subcert.verify(3), "expected the name of a file"),
    ],
)
def test_wrong_types_of_arguments_are_named(call, message):
    with pytest.raises(TypeError) as raised:
        call(subcert.scheme("dd:n=2"))
    assert message in str(raised.value)
    assert "incompatible" not in str(raised.value) and "subcert._core" not in str(raised.value)


def test_every_function_of_the_extension_has_its_arguments_named():
    from subcert import _calls, _core

    known = _calls._arguments()
    functions = {name for name in dir(_core) if not name.startswith("_") and not isinstance(getattr(_core, name), type)}
    functions = {name for name in functions if callable(getattr(_core, name))}
    assert functions == set(known)
    for name in functions:
        count = getattr(_core, name).__doc__.splitlines()[0].count("arg")
        assert count == len(known[name]), name


def test_digits_are_those_of_the_number():
    def latex(low, high, digits):
        return subcert.Enclosure(Fraction(low), Fraction(high)).to_latex(digits)

    assert latex("1/3", "1/3", 9) == "\\frac{1}{3}"
    assert latex("1.9996", "1.9998", 3) == "1.99\\ldots" and latex("1.5001", "1.5002", 3) == "1.50\\ldots"
    assert latex("1.5", "1.6", 3) == "[1.5,\\,1.6]"


def test_ids(tmp_path):
    certificate = subcert.scheme("dd:n=2").holder().certificate
    certificate.save(tmp_path / "dd.cert")
    assert certificate.id == hashlib.sha256((tmp_path / "dd.cert").read_bytes()).hexdigest()
