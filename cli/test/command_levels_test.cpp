#include "program.hpp"

#include <filesystem>

using namespace subcert::testing;

namespace {

const std::string conic = "'mask:[-1,0,1+4*v+4*v^2,8*v+8*v^2,1+4*v+4*v^2,0,-1]/(8*v+8*v^2)'";
const std::string mirrored = "'mask:[-1/2+7/5*w,1/10+7/5*w,3/2-7/5*w,9/10-7/5*w]'";

bool says(const Run& run, const std::string& text) { return run.out.find(text) != std::string::npos; }

}  // namespace

TEST_CASE("levels: all sequences of an interval, with a certificate") {
  const Folder folder;
  const std::string certificates = folder / "proofs";
  const Run page = run("levels four-point:w --over w=1/1000..19/100 --property C1 --certificate " + certificates);
  CHECK(page.code == 0);
  CHECK(says(page, "answer       C1 for every sequence of w from 1/1000 to 19/100, one value for each level\n"));
  const Run verified = run("verify " + certificates + "/01-proved.cert");
  CHECK(verified.code == 0);
  CHECK(says(verified, "VERIFIED 1 < Hoelder exponent of"));
  CHECK(says(verified, "for all sequences of levels with w=1/1000..19/100"));
  CHECK(run("verify " + certificates + "/01-proved.cert --claim '1 <= four-point:w for all levels w=1/1000..19/100'")
            .code == 0);
  // One value at all levels is a sequence, too.
  CHECK(run("verify " + certificates + "/01-proved.cert --claim '1 <= four-point:w for w=1/1000..19/100'").code == 0);
  const auto json = run_json("levels four-point:w --over w=1/1000..19/100 --property C1");
  CHECK(json.at("family") == "four-point:w");
  CHECK(json.at("property") == "C1");
  REQUIRE(json.at("pieces").size() == 1);
  CHECK(json.at("pieces")[0].at("verdict") == "proved");
  CHECK(json.at("pieces")[0].at("from") == "1/1000");
}

TEST_CASE("levels: sequences without the property") {
  const Run in_turn = run("levels " + mirrored + " --over w=0..1 --property convergent");
  CHECK(in_turn.code == 1);
  CHECK(says(in_turn, "not convergent for every sequence: not for w = 0 and w = 1 in turn\n"));
  // Though each value alone converges.
  CHECK(run("range " + mirrored + " --over w=0..1 --property convergent").code == 0);
  const Run constant = run("levels four-point:w --over w=0..1/4 --property C1");
  CHECK(constant.code == 1);
  CHECK(says(constant, " at all levels\n"));
  CHECK(run("levels six-point:w --over w=13/1000..16/1000 --property C3").code == 3);
}

TEST_CASE("levels: several letters") {
  const std::string six =
      "levels 'mask:[t,0,-w-3*t,0,1/2+w+2*t,1,1/2+w+2*t,0,-w-3*t,0,t]' --over w=1/32..1/16 --over "
      "t=0..1/100 --property C1";
  const Run page = run(six);
  CHECK(page.code == 0);
  CHECK(says(page, "every sequence of w from 1/32 to 1/16 and t from 0 to 1/100"));
  CHECK(run_json(six).at("pieces")[0].at("to")[1] == "1/100");
  check_fails(run(six + " --certificate proofs"), 64,
              "--certificate: expected one range, got 2; certificates know one letter");
}

TEST_CASE("levels: a recurrence") {
  const std::string family = "levels " + conic + " --over v=9/20..1000 --property C1 --recurrence 'v=sqrt((1+v)/2)' ";
  const Run all = run(family + "--start v0=-1..1000000");
  CHECK(all.code == 0);
  CHECK(says(all,
             "answer       C1 for v = sqrt((1+v)/2) from level to level, for all v0 from -1 to 1000000 that have a\n   "
             "          mask at each level\n"));
  check_fails(run(family + "--start v0=0"), 64, "--start: expected a value that has a mask, got v = 0");
  CHECK_FALSE(says(run(family + "--start v0=1/100..5"), "mask at each level"));
  CHECK(says(all, "from level 2 on\n"));
  CHECK(run(family + "--start v=0.54").code == 0);
  CHECK(run_json(family + "--start v0=1").at("recurrence").at("first_level") == 0);
  // Values below -1 have no next one; what leads out of the range proves nothing.
  CHECK(run(family + "--start v0=-2..1").code == 3);
  CHECK(run("levels " + conic + " --over v=9/20..1000 --property C1 --recurrence 'v=2*v^2-1' --start v0=1").code == 3);
  // The property fails for some sequence of the range, which this one need not be.
  CHECK(run("levels four-point:w --over w=0..1/4 --property C1 --recurrence 'w=w/2' --start w0=1/8").code == 3);
  CHECK(run("levels four-point:omega --over omega=1/32..1/8 --property C1 --recurrence 'omega=omega/2+1/32' --start "
            "omega=-100..1000")
            .code == 0);
}

TEST_CASE("levels: certificates of a recurrence") {
  const Folder folder;
  const std::string certificates = folder / "proofs", proof = "verify " + certificates + "/01-proved.cert",
                    family = "levels " + conic + " --over v=9/20..1000 --property C1 --recurrence 'v=sqrt((1+v)/2)' " +
                             "--certificate " + certificates + " --start v0=";
  CHECK(run(family + "-1..1000000").code == 0);
  CHECK(says(run(proof), "from level 2 on of v -> sqrt[1/2+1/2*v] with v=-1..1000000 at level 0, all in v=9/20..1000"));
  const Run open = run(family + "-1..inf");
  CHECK(open.code == 0);
  CHECK(says(open, "for all v0 from -1 on that have a mask at\n             each level"));
  CHECK(says(open, "v is from 9/20 to 1000 from some level on\n"));
  CHECK(says(run(proof), "from some level on of v -> sqrt[1/2+1/2*v] with v=-1..inf at level 0"));
  // It is about these sequences alone.
  CHECK(run(proof + " --claim '1 <= conic-four-point:v for all levels v=9/20..1000'").code == 1);
  const auto json = run_json(family + "-1..inf").at("recurrence");
  CHECK((json.at("to").is_null() && json.at("first_level").is_null()));
  // What is proved for all sequences is certified where the values are not proved to come.
  CHECK(run(family + "2000..inf").code == 3);
  CHECK(says(run(proof), "for all sequences of levels with v=9/20..1000"));
  check_fails(run(family + "x..inf"), 64, "--start: expected v0=VALUE, v0=LOW..HIGH or v0=LOW..inf, got 'v0=x..inf'");
}

TEST_CASE("levels: certificates of the exponent in the limit of a recurrence") {
  const Folder folder;
  const std::string scheme = "conic-four-point:v", certificates = folder / "proofs",
                    proof = "verify " + certificates + "/02-limit.cert",
                    halved = " --recurrence 'v=sqrt((1+v)/2)' --certificate " + certificates + " --start v0=",
                    family = "levels " + conic + " --over v=9/20..1000 --property C1" + halved,
                    levels = scheme + " for all levels v=9/20..1000", step = ", v=sqrt((1+v)/2), v0=";
  const auto claim = [&](const std::string& words) { return run(proof + " --claim '" + words + "'").code; };
  CHECK(says(run(family + "-1..inf"), "certificates 2 in"));
  CHECK(says(run(proof), "VERIFIED 2 <= Hoelder exponent = 4-log|[-4,1]@4,0,1/1000|^1/1 <= 2 of "));
  CHECK(says(run(proof), "at level 0, all in v=9/20..1000, tending to 1"));
  CHECK(claim("2 <= " + levels + step + "0.5..3, limit 1") == 0);
  CHECK(claim("2 <= " + scheme + " <= 2 for all levels v=9/20..1000" + step + "0.5..inf, limit 1") == 0);
  CHECK(claim(scheme + " = 4-log|[-4,1]@4,0,1/1000|^1/1 for all levels v=9/20..1000" + step + "1/2, limit 1") == 0);
  CHECK(claim("2 <= " + levels + step + "-2..3, limit 1") == 1);
  CHECK(claim("2 <= " + levels + step + "0.5..3, limit 2") == 1);
  CHECK(claim("2 < " + levels + step + "0.5..3, limit 1") == 1);
  CHECK(says(run(proof + " --claim '21/10 <= " + levels + step + "0.5..3, limit 1'"), "FALSE"));
  // Without a limit more is said than that: exponents above 2.
  CHECK(claim("2 <= " + levels + step + "0.5..3") == 1);
  CHECK(claim("19/10 <= " + levels + step + "0.5..3") == 0);
  CHECK(claim("19/10 <= " + levels) == 1);
  for (const char* words : {", limit 1", ", limit x", ", v=sqrt((1+v)/2), limit 1", ", v0=1, limit 1"})
    CHECK(claim("2 <= " + levels + words) == 64);
  CHECK(claim("2 <= " + levels + " <= 2" + step + "1/2") == 64);
  // The lower end alone, where the mask in the limit has more sum rules than all of them.
  CHECK(run("levels four-point:v --over v=1/32..1/8 --property C1 --recurrence 'v=v/2+1/32' --start v0=1/16..1/8 "
            "--certificate " +
            certificates)
            .code == 0);
  CHECK(says(run(proof), "VERIFIED 2 <= Hoelder exponent of [-v,0,1/2+v,1,1/2+v,0,-v]@-3"));
  // Values that come near to their limit in steps, and an end that no word reaches.
  CHECK(run("levels 'mask:[v/4,1-v/4,1-v/4,v/4]' --over v=1/16..4 --property convergent --recurrence 'v=sqrt(v)' "
            "--start v0=1/16..4 --certificate " +
            certificates)
            .code == 0);
  CHECK(says(run(proof), "VERIFIED 1 <= Hoelder exponent"));
  // None where values tend to no rational number, and none of a run before stays.
  CHECK(run("levels four-point:v --over v=1/32..1/8 --property C1 --recurrence 'v=sqrt(v/30+1/200)' --start "
            "v0=1/16..1/8 --certificate " +
            certificates)
            .code == 0);
  CHECK_FALSE(std::filesystem::exists(certificates + "/02-limit.cert"));
}

TEST_CASE("levels: where values tend to any number the exponent is that of its mask, if no more sum rules are there") {
  const Folder folder;
  const std::string certificates = folder / "proofs", scheme = "mask:[w,1-w,1-w,w]";
  for (const auto& [value, slope] :
       {std::pair("1/8", "1/2"), {"3/16", "-1/3"}, {"5/16", "0"}, {"3/8", "2/5"}, {"2/7", "3/4"}}) {
    const std::string to = value, by = slope;
    const auto limit = run_json("levels '" + scheme +
                                "' --over w=1/16..7/16 --property convergent --recurrence 'w=" + to + "+(" + by +
                                ")*(w-" + to + ")' --start w0=" + to + "..7/16 --certificate " + certificates)
                           .at("recurrence")
                           .at("limit");
    CHECK(limit.at("value") == to);
    const auto one = run_json("regularity 'mask:[" + to + ",1-" + to + ",1-" + to + "," + to + "]'");
    CHECK(limit.at("exact") == true);
    CHECK(limit.at("holder").at("lower") == one.at("holder").at("lower"));
    const Run verified = run("verify " + certificates + "/02-limit.cert");
    CHECK(verified.code == 0);
    CHECK(says(verified, "tending to " + to));
  }
}

TEST_CASE("levels: exponents over ranges that grow, as text and picture") {
  const Folder folder;
  const std::string picture = folder / "levels.svg";
  const Run page = run("levels four-point:w --over w=1/32..1/8 --property C1 --boxes 3 --plot " + picture);
  CHECK(page.code == 0);
  CHECK(says(page, "exponent     w from 1/32 to 1/8: at least 1.22844"));
  CHECK(std::filesystem::file_size(picture) > 1000);
  CHECK(run_json("levels four-point:w --over w=1/32..1/8 --property C1 --boxes 3").at("growing").size() == 3);
}

TEST_CASE("levels: claims in words about recurrences and lists") {
  const Folder folder;
  const std::string certificates = folder / "proofs", proof = "verify " + certificates;
  const auto claim = [&](const std::string& words) { return run(proof + " --claim '" + words + "'").code; };
  const std::string family = "levels " + conic + " --over v=9/20..1000 --property C1 --recurrence 'v=sqrt((1+v)/2)' " +
                             "--certificate " + certificates + " --start v0=",
                    levels = "1 <= conic-four-point:v for all levels ", step = ", v=sqrt((1+v)/2), v0=";
  CHECK(run(family + "-1..1000000").code == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "-1..1000000") == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "0.5..3") == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "1/2") == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "-1..1000001") == 1);
  CHECK(claim(levels + "v=9/20..1000" + step + "0..inf") == 1);
  CHECK(claim(levels + "v=1/2..1000" + step + "1/2") == 1);  // nothing says that values come there
  CHECK(claim(levels + "v=9/20..1000, v=sqrt((2+v)/3), v0=1") == 1);
  CHECK(claim("2 <= conic-four-point:v for all levels v=9/20..1000" + step + "1/2") == 1);
  CHECK(claim("1/2 <= conic-four-point:v for all levels v=9/20..1000" + step + "1/2") == 0);
  CHECK(claim("1 <= conic-four-point:w for all levels w=9/20..1000, w=sqrt((1+w)/2), w0=1/2") == 0);
  for (const char* words : {"v=9/20..1000, v=sqrt((1+v)/2)", "v=9/20..1000, v0=1", "v=9/20..1000, v=sin(v), v0=1",
                            "v=9/20..1000, v=sqrt((1+v)/2), v0=3..1", "v=9/20..1000, v=sqrt((1+v)/2), v1=1"})
    CHECK(claim(levels + words) == 64);
  CHECK(run(family + "-1..inf").code == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "0..inf") == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "-1..7") == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "-2..inf") == 1);
  CHECK(run(family + "2000..inf").code == 3);  // then it is about all sequences, and nothing comes there
  CHECK(claim(levels + "v=9/20..1000") == 0);
  CHECK(claim(levels + "v=9/20..1000" + step + "1/2") == 1);

  const std::string masks = "masks = [\"dd:n=2\", \"bspline:degree=3\", \"dd:n=2\"]\n";
  const std::string any = folder.write("any.toml", masks), turn = folder.write("turn.toml", masks + "period = [0, 1]");
  CHECK(run("levels lists:" + any + " --certificate " + certificates).code == 0);
  CHECK(claim("2 <= lists:" + any) == 0);
  CHECK(claim("3/2 < lists:" + any) == 0);
  CHECK(claim("2 < lists:" + any) == 1);
  CHECK(claim("2 <= lists:" + any + " <= 2") == 0);
  CHECK(claim("3/2 <= lists:" + any + " <= 5/2") == 0);
  CHECK(claim("3/2 <= lists:" + any + " <= 199/100") == 1);
  CHECK(claim("2 <= lists:" + turn) == 1);
  CHECK(claim("2 <= lists:" + folder.write("other.toml", "masks = [\"dd:n=3\"]")) == 1);
  CHECK(claim("2 <= lists:" + (folder / "none.toml")) == 66);
  CHECK(run("levels lists:" + turn + " --certificate " + certificates).code == 0);
  CHECK(claim("5/2 <= lists:" + turn + " <= 5/2") == 0);
  CHECK(claim("2 <= lists:" + turn) == 0);
}

TEST_CASE("levels: vectors and Hermite schemes") {
  const Folder folder;
  const std::string certificates = folder / "proofs", proof = "verify " + certificates + "/01-proved.cert";
  const std::string merrien = "levels merrien:lambda=-1/8,mu --over mu=-1..", saved = " --certificate " + certificates;
  const Run page = run(merrien + "0 --property HC1" + saved);
  CHECK(page.code == 0);
  CHECK(says(page, "answer       HC1 for every sequence of mu from -1 to 0, one value for each level\n"));
  const Run verified = run(proof);
  CHECK((verified.code == 0 && says(verified, "HC^1 of the Hermite scheme of")));
  CHECK(says(verified, "for all sequences of levels with m=-1..0"));
  const auto claim = [&](const std::string& words) { return run(proof + " --claim '" + words + "'").code; };
  CHECK(claim("1 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1..0") == 0);
  CHECK(claim("1 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1/2..0") == 0);
  CHECK(claim("1 <= HC of merrien:lambda=-1/8,mu for mu=-1..0") == 0);
  CHECK(claim("1 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1..1/2") == 1);
  CHECK(claim("2 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1..0") == 1);
  // What holds for each value is not what holds for all sequences.
  CHECK(run("range merrien:lambda=-1/8,mu --over mu=-1..0 --property HC1" + saved).code == 0);
  CHECK(run("verify " + certificates + " --claim '1 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1..0'").code ==
        1);
  const Run refuted = run(merrien + "2 --property HC1");
  CHECK((refuted.code == 1 && says(refuted, "not HC1 for every sequence: not for mu = 2 at all levels\n")));
  CHECK(run(merrien + "0 --property convergent" + saved).code == 0);
  CHECK(says(run(proof), "0 < Hoelder exponent of the vector scheme of"));
  CHECK(run(merrien + "0 --property C1").code == 0);
  CHECK(run("levels merrien:lambda,mu --over lambda=-0.132..-0.095 --over mu=-0.52..-0.41 --property HC1").code == 0);
  // Values that follow from each other.
  const std::string step = " --recurrence 'mu=mu/2-1/4' --start mu0=";
  CHECK(run(merrien + "0 --property HC1" + step + "-9..5" + saved).code == 0);
  const Run follows = run(proof);
  CHECK((follows.code == 0 && says(follows, "of m -> [-1/4+1/2*m] with m=-9..5 at level 0, all in m=-1..0")));
  CHECK(claim("1 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1..0, mu=mu/2-1/4, mu0=-9..0") == 0);
  CHECK(claim("1 <= HC of merrien:lambda=-1/8,mu for all levels mu=-1..0") == 1);
  CHECK(run_json(merrien + "0 --property convergent --boxes 2").at("growing").size() == 2);
  CHECK(run("levels four-point:w --over w=1/32..1/8 --property HC1").code == 64);
  CHECK(run(merrien + "0 --property HC0").code == 64);
  CHECK(run(merrien + "0 --property C1 --each-point").code == 64);
}

TEST_CASE("levels: closed forms of exponents") {
  const auto limit = [](const std::string& family) {
    return run_json("levels " + family + " --property C1 --recurrence 'v=sqrt((1+v)/2)' --start v0=1/2")
        .at("recurrence")
        .at("limit");
  };
  CHECK(limit("exponential-six-point:v --over v=1/2..10").at("formula") == "6 - log_2(9)");
  CHECK(limit("conic-four-point:v --over v=9/20..1000").at("formula").is_null());  // 2
  const Folder folder;
  const std::string list = "levels lists:" + folder.write("list.toml", "masks = [\"dual:n=2\", \"dual:n=2\"]");
  CHECK(says(run(list), "\nformula      3 - log_2(8/5)\n"));
  CHECK(run_json(list).at("radius_number").at("polynomial").dump() == "[\"-8\",\"5\"]");
}

TEST_CASE("levels: lists of masks") {
  const Folder folder;
  const std::string masks = "masks = [\"dd:n=2\", \"bspline:degree=3\"]\n";
  const std::string any = folder.write("any.toml", masks),
                    in_turn = folder.write("turn.toml", masks + "period = [0, 1]"),
                    graph = folder.write("graph.toml", masks + "follows = [[0, 1], [1, 0]]");
  const std::string certificates = folder / "proofs";
  const Run page = run("levels lists:" + any + " --certificate " + certificates);
  CHECK(page.code == 0);
  CHECK(says(page, "exponent     2  (the least of all sequences, exact)\n"));
  CHECK(says(page, "least for    0 at all levels\n"));
  CHECK(says(run("verify " + certificates + "/01-all.cert"), "VERIFIED 2 <= least Hoelder exponent <= 2 of"));
  const Run one = run("verify " + certificates + "/02-sequence.cert");
  CHECK((one.code == 0 && says(one, "Hoelder exponent = 4-log|") && says(one, "for levels with period=0")));
  CHECK(run_json("levels lists:" + graph + " --certificate " + certificates).at("certificates") == 2);
  const Run pairs = run("verify " + certificates + "/01-all.cert");
  CHECK((pairs.code == 0 && says(pairs, "for all sequences of levels with follows=0-1,1-0")));
  CHECK(says(pairs, "<= least Hoelder exponent <= 250"));
  CHECK(run_json("levels lists:" + in_turn + " --certificate " + certificates).at("certificates") == 1);
  CHECK_FALSE(std::filesystem::exists(certificates + "/01-all.cert"));
  CHECK(
      says(run("verify " + certificates + "/01-sequence.cert"), "5/2 <= Hoelder exponent = 4-log|[-8,1]@8,0,1/1000|"));
  CHECK(says(run("levels lists:" + in_turn), "exponent     2.5  (the least"));
  CHECK(run("levels lists:" + in_turn + " --property C2").code == 0);
  CHECK(run("levels lists:" + any + " --property C2").code == 3);
  CHECK(run("levels lists:" + any + " --property 'holder>=5/2'").code == 1);
  CHECK(run_json("levels lists:" + graph).at("order") == "1 after 0, 0 after 1");
  const auto refused = [&](const std::string& text, const std::string& message) {
    check_fails(run("levels lists:" + folder.write("bad.toml", text)), 65, folder / "bad.toml" + ", line " + message);
  };
  refused("", "1, column 1: no masks; expected masks = [\"dd:n=2\", ...]");
  refused("masks = [\"dd:n=2\"]\nperiod = [1]\n", "2, column 11: expected the number of a mask, 0 to 0");
  refused("masks = [\"dd:n=2\"]\nperiod = [0]\nfollows = [[0, 0]]\n",
          "3, column 11: 'follows' beside 'period'; expected one of them");
  refused("masks = [\"dd:n=2\"]\norder = 1\n", "2, column 1: unknown key 'order'; expected masks, period or follows");
  refused(masks + "follows = [[1, 0]]\n",
          "2, column 11: no sequence of masks goes on for ever; expected pairs that come round again");
  CHECK(run("levels lists:" + folder.write("end.toml", masks + "follows = [[1, 0], [0, 0]]")).code == 0);
  CHECK(run("levels lists:" + folder.write("loop.toml", "masks = [\"loop\"]")).code == 65);
  refused("masks = [\"daubechies:n=5\"]\n",
          "1, column 10: expected a scheme with exact coefficients, got daubechies:n=5");
  refused("masks = [\"dd:n=2\", \"bspline:degree=2,a=3\"]\n", "1, column 20: expected masks of one arity, got 2 and 3");
  CHECK(run("levels lists:" + folder.write("many.toml", masks + "follows = [[0, 1, 1]]")).code == 65);
  CHECK(run("levels lists:" + (folder / "none.toml")).code == 66);
  check_fails(run("levels lists:" + any + " --over w=0..1"), 64, "--over: cannot be asked for with a list of masks");
}

TEST_CASE("levels: lists of masks of matrices") {
  const Folder folder;
  const std::string pair = "masks = [\"merrien:lambda=-1/8,mu=3/2\", \"merrien:lambda=-1/8,mu=-1/2\"]\n";
  const std::string graph = "levels lists:" + folder.write("graph.toml", pair + "follows = [[0, 1], [1, 0], [1, 1]]"),
                    any = "levels lists:" + folder.write("any.toml", pair);
  const Run page = run(graph + " --property HC1");
  CHECK(page.code == 0);
  CHECK(says(page, "sum rules    3 in common\n"));
  CHECK(says(page, "exponent     1.83903595256  (the least of all sequences, exact)\n"));
  CHECK(says(page, "formula      3 - log_2(5)/2\n"));
  CHECK(says(page, "Hermite      HC^1 for all sequences, not HC^2\n"));
  CHECK(says(page, "by itself    3, 4 sum rules\n"));
  CHECK(says(page, "least for    0, 1 in turn\n"));
  CHECK(run(any + " --property HC1").code == 1);
  CHECK(run(any + " --property convergent").code == 0);
  CHECK(run_json(any).at("hermite").at("next") == "no");
  const auto json = run_json("levels lists:" +
                             folder.write("data.toml", "masks = [\"ghm\", \"bspline:degree=3,multiplicity=2\"]"));
  CHECK(json.at("hermite").is_null());
  // One mask is that scheme.
  const std::string one = "levels lists:" + folder.write("one.toml", "masks = [\"hermite-dd:points=4,order=2\"]");
  CHECK(says(run(one), "(the least of all sequences, exact)\n"));
  CHECK(run_json(one).at("holder") == run_json("regularity hermite-dd:points=4,order=2").at("holder"));
  const auto refused = [&](const std::string& text, const std::string& message) {
    check_fails(run("levels lists:" + folder.write("bad.toml", text)), 65, folder / "bad.toml" + ", line " + message);
  };
  refused("masks = [\"ghm\", \"dd:n=2\"]", "1, column 17: expected matrices of one size, got 2 and 1 rows");
  refused("masks = [\"ghm\", \"merrien:lambda=-1/8,mu=0\"]",
          "1, column 17: expected Hermite schemes alone or none, got ghm and merrien:lambda=-1/8,mu=0");
  refused("masks = [\"vector:[[[1,0],[0,1/2]],[[1,0],[0,1/2]]]@0\", \"vector:[[[1/2,0],[0,1]],[[1/2,0],[0,1]]]@0\"]",
          "1, column 9: expected constant data that all masks of matrices keep, one vector up to a factor, got none "
          "(perhaps the matrices are transposed)");
  CHECK(run("levels lists:" + folder.write("nan.toml", "masks = [\"hermite:[[[nan]]]\"]")).code == 65);
  CHECK(run("levels lists:" + folder.write("root.toml", "masks = [\"refinable:[[[sqrt(2),0],[0,1]]]\"]")).code == 65);
  CHECK(run("levels lists:" + folder.write("none.toml", "masks = []")).code == 65);
  check_fails(run(any + " --property HC0"), 64, "levels: need HC1 or more, as there are 1 derivatives, got HC0");
  check_fails(run("levels lists:" + folder.write("ghm.toml", "masks = [\"ghm\"]") + " --property HC1"), 64,
              "--property: expected convergent, C1, C2, ... or holder>=3/2, got 'HC1'");
}

TEST_CASE("levels: certificates of lists of masks of matrices") {
  const Folder folder;
  const std::string pair = "masks = [\"merrien:lambda=-1/8,mu=3/2\", \"merrien:lambda=-1/8,mu=-1/2\"]\n",
                    ends = " for all sequences of levels with ";
  const std::string graph = "lists:" + folder.write("graph.toml", pair + "follows = [[0, 1], [1, 0], [1, 1]]"),
                    turn = "lists:" + folder.write("turn.toml", pair + "period = [0, 1]"),
                    any = "lists:" + folder.write("any.toml", pair);
  const std::string certificates = folder / "proofs", proof = "verify " + certificates;
  const auto written = [&](const std::string& list) {
    return run_json("levels " + list + " --certificate " + certificates).at("certificates");
  };
  CHECK(written(graph) == 4);
  CHECK(run(proof).code == 0);
  CHECK(says(run(proof + "/01-all.cert"), "Hoelder exponent of the vector scheme of "));
  CHECK(says(run(proof + "/02-hermite-all.cert"), ends + "follows=0-1,1-0,1-1\n"));
  CHECK(says(run(proof + "/03-sequence.cert"), " of the refinable functions of "));
  CHECK(says(run(proof + "/04-scheme.cert"), "HC^1 of the Hermite scheme of "));
  CHECK(run(proof + " --claim '3/2 < " + graph + "'").code == 0);
  CHECK(run(proof + " --claim '1 <= HC of " + graph + "'").code == 0);
  CHECK(run(proof + " --claim '2 <= " + graph + "'").code == 1);
  CHECK(run(proof + " --claim '2 <= HC of " + graph + "'").code == 1);
  CHECK(run(proof + " --claim '1/2 <= " + any + "'").code == 1);  // the file is about fewer sequences
  CHECK(says(run(proof + "/02-hermite-all.cert --print-claim"), "--order follows=0-1,1-0,1-1 --lower 1 "));
  CHECK(written(turn) == 4);
  CHECK(says(run(proof + "/02-hermite-all.cert"), ends + "period=0,1\n"));
  CHECK(run(proof + " --claim '1 <= HC of " + turn + "'").code == 0);
  CHECK(written(any) == 3);
  CHECK_FALSE(std::filesystem::exists(certificates + "/02-hermite-all.cert"));
  CHECK(run(proof + " --claim '2/3 <= " + any + "'").code == 0);
  // Masks whose windows differ, and scalar lists, which have no derivatives.
  CHECK(written("lists:" + folder.write("dd.toml",
                                        "masks = [\"hermite-dd:points=4,order=2\", "
                                        "\"hermite-dd:points=2,order=2\"]")) == 4);
  CHECK(run(proof).code == 0);
  const std::string scalar = "lists:" + folder.write("scalar.toml", "masks = [\"dd:n=2\"]");
  CHECK(run(proof + " --claim '1 <= HC of " + scalar + "'").code == 64);
}

TEST_CASE("levels: wrong usage") {
  const std::string family = "levels four-point:w --over w=1/32..1/8 ", smooth = family + "--property C1 ";
  const std::string both = "--recurrence and --start: expected both or none",
                    step = "--recurrence: expected w=EXPRESSION or w=sqrt(EXPRESSION), as w=sqrt((1+w)/2), got ";
  check_fails(run(family + "--property stable"), 64,
              "--property: expected convergent, C1, C2, ... or holder>=3/2, got 'stable'");
  check_fails(run(smooth + "--recurrence 'w=w/2'"), 64, both);
  check_fails(run(smooth + "--start w0=1"), 64, both);
  check_fails(run(smooth + "--recurrence 'v=w/2' --start w0=1"), 64, step + "'v=w/2'");
  check_fails(run(smooth + "--recurrence 'w=sin(w)' --start w0=1"), 64, step + "'w=sin(w)'");
  check_fails(run(smooth + "--recurrence 'w=w/2' --start v0=1"), 64,
              "--start: expected w0=VALUE, w0=LOW..HIGH or w0=LOW..inf, got 'v0=1'");
  check_fails(run("levels four-point:w --over w=0..1"), 64,
              "--property is required with a family that has a parameter");
  check_fails(run("levels masks.toml"), 64, "'masks.toml'; a file with a list of masks is lists:masks.toml");
  check_fails(run("levels four-point:w --property C1"), 64, "--over is required with a family that has a parameter");
  CHECK(run("levels four-point:w --over v=0..1 --property C1").code == 64);
  CHECK(run("levels chaikin --over w=0..1 --property C1").code == 64);
  CHECK(run("levels four-point:w --over w=1..0 --property C1").code == 64);
}

TEST_CASE("levels: the exponent in the limit of a recurrence") {
  const std::string halving = " --recurrence 'v=sqrt((1+v)/2)' --start v0=-1/2..9";
  const std::string six = "levels exponential-six-point:v --over v=1/2..10 --property ";
  const Run page = run(six + "C2" + halving);
  CHECK(page.code == 0);
  CHECK(says(page,
             "limit        v tends to 1 for all of them\ngenerates    1, x, e^(+-tx), x e^(+-tx), where v is "
             "cos(t h) at the level with distances h\nexponent     2.83007499"));
  CHECK(says(page, "  (exact)\n"));
  // Though it is not known of all sequences of values.
  CHECK(run(six + "C2").code != 0);
  CHECK(run(six + "C3" + halving).code == 3);
  const auto json = run_json(six + "'holder>=283/100'" + halving).at("recurrence").at("limit");
  CHECK(json.at("value") == "1");
  CHECK(json.at("exponentials") == std::vector<int>{2});
  CHECK(json.at("exact") == true);
  const Run names = run(
      "levels exponential-bspline:mu --over mu=1/2..2 --property C2 --recurrence "
      "'mu = sqrt((1+mu)/2)' --start mu0=1");
  CHECK(names.code == 0);
  CHECK(says(names, "C2 for mu = sqrt((1+mu)/2) from level to level, mu0 = 1\n"));
  // Not for all values of the range, but w tends to 1/16.
  CHECK(run("levels four-point:w --over w=0..1/4 --property C1 --recurrence 'w=w/2+1/32' --start w0=1/8").code == 0);
  // Without a limit the range alone decides.
  CHECK_FALSE(
      says(run("levels four-point:w --over w=1/100..1/8 --property C1 --recurrence 'w=w' --start w0=1/16"), "limit "));
}

TEST_CASE("levels: a value for each new point") {
  const std::string family = "levels four-point:w --property C1 --each-point --over ";
  const Run page = run(family + "w=1/1000..3/20");
  CHECK(page.code == 0);
  CHECK(says(page,
             "answer       C1 for any choice of w from 1/1000 to 3/20, one value for each new point of each "
             "level\n"));
  CHECK(says(page, "exponent     at least 1.00580"));
  // With one value for each level it still is.
  CHECK(run(family + "w=1/100..17/100").code == 3);
  CHECK(run("levels four-point:w --property C1 --over w=1/100..17/100").code == 0);
  CHECK(run(family + "w=1/100..1/4").code == 1);
  const auto json = run_json(family + "w=1/1000..3/20");
  CHECK(json.at("order") == 2);
  CHECK(json.at("matrices") == 16);
  CHECK(json.at("verdict") == "proved");
  const Folder folder;
  const std::string proofs = folder / "proofs", verify = "verify " + proofs;
  CHECK(says(run(family + "w=1/32..3/32 --certificate " + proofs), "1 in " + proofs + ", verified"));
  CHECK(run(verify).code == 0);
  for (const char* claim :
       {"1 <= four-point:w for all points w=1/32..3/32", "1 <= four-point:w for all points w=1/20..1/16",
        "1 <= four-point:w for all levels w=1/32..3/32", "1 <= four-point:w for 1/32 <= w <= 3/32"})
    CHECK(run(verify + " --claim '" + claim + "'").code == 0);
  for (const char* claim :
       {"1 <= four-point:w for all points w=1/32..1/8", "3/2 <= four-point:w for all points w=1/32..3/32"})
    CHECK(run(verify + " --claim '" + claim + "'").code == 1);
  CHECK(says(run(verify + " --print-claim --claim '1 <= four-point:w for all points w=1/32..1/16'"),
             "--arity 2 --each-point w=1/32..1/16 --lower 1 "));
  for (const std::string claim :
       {"four-point:w for all points w=1/32..3/32 <= 2", "1 <= four-point:w for all points w=1/32..3/32 <= C2",
        "four-point:w for all points w=1/32..3/32", "1 <= four-point:w for all levels w=1/32..3/32 <= 2"})
    check_fails(run(verify + " --claim '" + claim + "'"), 64,
                "--claim '" + claim + "': of all levels and of all points a lower end is claimed, and nothing else");
  CHECK(run(verify + " --claim '1 <= four-point:w for all points levels w=1/32..3/32'").code == 64);
  const std::string matrices = "1 <= merrien:lambda=-1/8,mu for all points mu=-1..0";
  check_fails(run(verify + " --claim '" + matrices + "'"), 64,
              "--claim '" + matrices + "': of all points need a mask of numbers");
  // What holds for all levels says nothing of all points.
  const std::string levels = folder / "levels";
  CHECK(run("levels four-point:w --property C1 --over w=1/32..3/32 --certificate " + levels).code == 0);
  CHECK(run("verify " + levels + " --claim '1 <= four-point:w for all points w=1/32..3/32'").code == 1);
  // A polytope of the transposed matrices; and none where nothing positive is proved.
  const std::string narrow = folder / "narrow", none = folder / "none", each = " --each-point --certificate ";
  CHECK(run("levels four-point:w --property C1 --budget 2 --over w=1/16..65537/1048576" + each + narrow).code == 0);
  CHECK(run("verify " + narrow).code == 0);
  CHECK(says(run("levels four-point:w --property C1 --budget 2 --over w=-1..1" + each + none), "there are none"));
  CHECK_FALSE(std::filesystem::exists(none + "/01-proved.cert"));
  CHECK(says(run("levels corner-cutting:w --property convergent --over w=1/5..3/10" + each + narrow), "verified"));
  check_fails(run("levels conic-four-point:v --property C1 --each-point --over v=1..2"), 64,
              "levels: need coefficients of degree 1 in each letter, for a value at each point");
}
