"""Sweeps and the atlas: the program's answers as Python has them, and its errors."""

from fractions import Fraction

import pytest
import subcert


def test_answers_come_in_order_with_their_errors():
    answers = list(subcert.sweep(["dd:n=1..2", "nosuch:3", subcert.scheme("chaikin")], ask=["regularity", "variance"]))
    assert [one.scheme for one in answers] == ["dd:n=1", "dd:n=2", "nosuch:3", "bspline:degree=2"]
    assert answers[1].keys == {"n": "2"} and answers[1]["n"] == "2"
    assert answers[1]["holder"] == 2 and (answers[1]["sobolev.exponent"] > 2).is_yes
    assert Fraction(answers[1]["mean"]) < 1
    assert answers[1]["nothing"] is None and answers[1].expected is None
    assert answers[2].answers == {} and "nosuch" in answers[2].errors["regularity"]
    assert not answers[3].errors


def test_questions_with_settings_and_properties():
    [loop] = subcert.sweep("loop", ask=["vertex --valence 3,5", "check smoothness >= 1", "check reproduces 3"])
    assert loop["valences.1.valence"] == 5 and loop["valences.2.c1"] is None
    assert (loop["check.smoothness"], loop["check.reproduces"]) == (True, False)
    with pytest.raises(subcert.UsageError, match="'smothness'; expected a property"):
        list(subcert.sweep("loop", ask=["check smothness >= 1"]))


def test_a_sweep_that_is_left_goes_on_from_its_journal(tmp_path):
    journal = tmp_path / "journal"
    for answer in subcert.sweep("dd:n=1..6", journal=journal):
        break
    assert answer["holder"] == 1
    again = list(subcert.sweep("dd:n=1..6", journal=journal, where="n >= 3", expect="holder > 4"))
    assert [str(one.expected) for one in again] == ["no", "no", "yes", "yes"]


def test_wrong_questions():
    with pytest.raises(subcert.UsageError, match="A <= B"):
        list(subcert.sweep("primal:n=3..1"))
    with pytest.raises(subcert.UsageError):
        list(subcert.sweep("dd:n=1", expect="holder 2"))
    with pytest.raises(TypeError, match="expected schemes"):
        list(subcert.sweep([3]))


def test_atlas(tmp_path):
    atlas = subcert.Atlas(tmp_path / "atlas.sqlite")
    with pytest.raises(subcert.MissingFileError):
        atlas.query("interpolatory")
    assert atlas.find("dd:n=2", add=False) is None
    entry = atlas.find(subcert.scheme("dd:n=2"))
    assert entry["holder"] == 2 and entry["attained"] is False and entry.names == ["dd:n=2"]
    assert set(entry) >= {"id", "mask", "formula"} and len(entry) == len(list(entry))
    assert entry.scheme().sum_rules == 4
    assert atlas.find(entry.id)["mask"] == entry["mask"]
    assert "<th>holder</th><td>2</td>" in entry._repr_html_()
    assert atlas.build("dd:n=1..4") == 3 and atlas.build("dd:n=1..4") == 0
    found = atlas.query("holder >= 2 and interpolatory")
    assert found.rows("names", "sum_rules")[0] == {"names": ["dd:n=2"], "sum_rules": 4}
    assert len(found) == 3 and found.open == [] and "dd:n=4" in found._repr_html_()
    atlas.save_certificate("dd:n=2", tmp_path / "dd.cert")
    assert subcert.verify(tmp_path / "dd.cert").accepted
    with pytest.raises(subcert.UsageError, match="rational numbers"):
        atlas.find("daubechies:n=2")
    with pytest.raises(subcert.UsageError, match="holdr"):
        atlas.query("holdr > 2")
    (tmp_path / "text").write_text("x" * 5000)
    with pytest.raises(subcert.DataError, match="is no atlas"):
        subcert.Atlas(tmp_path / "text").query("interpolatory")
