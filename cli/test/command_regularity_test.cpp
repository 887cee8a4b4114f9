#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("regularity: more time keeps the product that less time finds") {
  const auto upper = [](const std::string& budget) {
    const auto answer = run_json("regularity primal:n=9,d=5 --memory 64 --budget " + budget, 2);
    return answer.at("holder").at("upper").get<std::string>();
  };
  const std::string later = upper("1.65");
  CHECK(later.starts_with("3.5018068"));
  CHECK(std::stod(later) <= std::stod(upper("0.55")));
}

TEST_CASE("regularity: by frequencies, at once for large masks, and refused where it does not apply") {
  const auto large = run_json("regularity primal:n=200 --method frequency");
  CHECK(large.at("method") == "frequency");
  CHECK(large.at("converges") == "yes");
  CHECK(has_digits(large.at("holder"), "lower", "1.99999999999"));
  CHECK(large.at("holder").at("upper") == "inf");
  CHECK(run("regularity 'mask:[-2,1,6,1,-2]/2' --method frequency").code == 2);
  for (const char* scheme : {"mask:[3,4,3,2]/6", "bspline:degree=2,a=3"})
    CHECK(run("regularity '" + std::string(scheme) + "' --method frequency").code == 0);
  for (const char* scheme : {"butterfly:w=1/16", "daubechies:n=3"})
    check_fails(run("regularity '" + std::string(scheme) + "' --method frequency"), 64,
                "--method frequency: need a mask of exact numbers, in one variable, with coset sums 1, got " +
                    std::string(scheme));
}

TEST_CASE("regularity: a bound by frequencies has a certificate") {
  const Folder folder;
  const std::string file = folder / "f.cert";
  for (const char* scheme : {"primal:n=30", "dual:n=4,d=2", "ary:a=3,points=4,d=3", "mask:[3,4,3,2]/6"}) {
    CHECK(run(std::string("regularity '") + scheme + "' --method frequency --certificate " + file).code == 0);
    CHECK(run("verify " + file).code == 0);
  }
  const auto written = run_json("regularity dd:n=2 --certificate " + file).at("certificate");
  CHECK(written.at("file") == file);
  CHECK(written.at("verified") == true);
  CHECK(written.at("id") == run_json("verify " + file).at("certificates")[0].at("id"));
  const auto large = run_json("regularity primal:n=200 --method frequency --certificate " + file);
  CHECK(large.at("certificate").is_null());
  CHECK(large.at("certificate_reason").is_string());
  // Beside an upper end by a product, where polytopes stay open.
  const auto open = run_json("regularity primal:n=30 --budget 1 --certificate " + file, 2);
  CHECK(open.at("method") == "frequencies");
  CHECK(has_digits(open.at("holder"), "lower", "1.99999"));
  CHECK(run("verify " + file).code == 0);
}

TEST_CASE("regularity: the fields of the contract") {
  const auto regularity = run_json("regularity 'dual:n=7' --levels 16 --budget 4", -1);
  CHECK(regularity.at("sum_rules") == 3);
  CHECK(regularity.at("bound").at("levels") == 16);
  CHECK(regularity.at("bound").at("norm").is_string());
  CHECK(has_digits(regularity.at("bound").at("holder"), "lower", "2.633"));
  CHECK(regularity.at("stable") == true);
  CHECK(regularity.at("product").is_string());
  CHECK(has_digits(regularity.at("holder"), "upper", "2.994"));

  const auto closed = run_json("regularity primal:n=5");
  CHECK(closed.at("closed") == true);
  CHECK(closed.at("exact") == true);
  CHECK(closed.at("method") == "invariant polytope");
  CHECK(has_digits(closed.at("holder"), "lower", "1.99014395938"));

  const auto single = run_json("regularity 'mask:[-5,-7,35,105,105,35,-7,-5]/128'");
  CHECK(single.at("method") == "single spectral radius");
  CHECK(single.at("exact") == true);
  CHECK(has_digits(single.at("holder"), "lower", "2.830074998557"));
  CHECK(single.at("logarithm").at("at_most") == 0);
  CHECK(run_json("regularity four-point:w=1/16").at("logarithm").at("at_least") == 1);
  for (const char* command : {"regularity", "analyze"}) {
    const auto sobolev = run_json(std::string(command) + " dd:n=2").at("sobolev");
    CHECK(has_digits(sobolev.at("exponent"), "lower", "2.440765"));
    CHECK(sobolev.at("stable") == true);
    // Dependent shifts: by the reduced mask, that of the quadratic spline.
    const auto unstable = run_json(std::string(command) + " 'mask:[1,2,2,2,1]/4'", -1).at("sobolev");
    CHECK(unstable.at("exponent").at("upper") == "2.5");
    CHECK(unstable.at("stable") == false);
  }
}

TEST_CASE("regularity: reduced masks") {
  const auto reduced = run_json("regularity 'mask:[1,3,3,2,3,3,1]/8'", -1);
  CHECK(reduced.at("stable") == false);
  CHECK(reduced.at("reduced").at("mask") == "[1,4,6,4,1]/8@-3");
  CHECK(reduced.at("reduced").at("factor") == "1 + z + z^2");
  CHECK(reduced.at("holder").at("upper") == "3");
  CHECK(run_json("regularity dd:n=2").at("reduced").is_null());
}

TEST_CASE("regularity: several roots on one line, with the flip") {
  const Folder folder;
  const std::string certificate = folder / "c.cert";
  const std::string mask = "mask:[7,14,21,28,35,28,15,2,-11,-24,-30,-24,-11,2,15,28,35,28,21,14,7]/40,arity=5";
  const auto json = nlohmann::json::parse(run("regularity " + mask + " --json --certificate " + certificate).out);
  CHECK(json.at("certificate").at("upper") == "270741929774503/250000000000000");
  CHECK(run("verify " + certificate).code == 0);
}

TEST_CASE("regularity: width on demand") {
  const auto fine = run_json("regularity primal:n=5 --width 1e-60");
  const std::string digits = "1.99014395938625596641873752702416512012704326974351205988261";
  CHECK(has_digits(fine.at("holder"), "lower", digits));
  CHECK(has_digits(fine.at("holder"), "upper", digits));
  CHECK(has_digits(run_json("regularity quincunx: --width 1e-40").at("holder"), "upper",
                   "0.611516172738765396522419466202809553072"));
  CHECK(run("regularity primal:n=5 --width 0").code == 64);
  // 1e-30 below and above the zero of 32 w^3 + 4 w - 1, where the 4-point scheme ceases to be C^1.
  const std::string w = "0.19272924926481202520628659232";
  const auto below = run_json("regularity four-point:w=" + w + "5"),
             above = run_json("regularity four-point:w=" + w + "7");
  CHECK(below.at("holder").at("lower").get<std::string>().starts_with("1.00000000000000000000000000000"));
  CHECK(above.at("holder").at("upper").get<std::string>().starts_with("0.99999999999999999999999999999"));
  CHECK(run("regularity four-point:w=" + w + "5").out.find("exponent     1.000000000000000000000000000") !=
        std::string::npos);
  // No product attains the radius within that time.
  CHECK(run("regularity primal:n=6,d=3 --budget 1 --width 1e-3").code == 2);
}

TEST_CASE("regularity: surfaces") {
  const auto quincunx = run_json("regularity quincunx:");
  CHECK(quincunx.at("dilation") == nlohmann::json::parse("[[1,-1],[1,1]]"));
  CHECK(quincunx.at("digits").size() == 2);
  CHECK(quincunx.at("sum_rules") == 2);
  CHECK(quincunx.at("dimension") == 23);
  CHECK(quincunx.at("blocks").is_array());
  CHECK(quincunx.at("bound").at("holder").is_object());
  CHECK(quincunx.at("exact") == true);
  CHECK(quincunx.at("stable") == true);
  CHECK(quincunx.at("method") == "invariant polytope");
  CHECK(has_digits(quincunx.at("holder"), "lower", "0.6115161727387"));
  CHECK(has_digits(quincunx.at("sobolev").at("exponent"), "upper", "1.5776445337926"));

  const auto unstable = run_json("regularity zwart-powell:");
  CHECK(unstable.at("stable") == false);
  CHECK(unstable.at("holder").at("lower") == "2");
  CHECK(unstable.at("holder").at("upper") == "2");

  const auto factors = run_json("regularity 'tensor:(primal:n=3)x(bspline:degree=3,a=3)'");
  CHECK(factors.at("exact") == true);
  CHECK(has_digits(factors.at("holder"), "lower", "1.936308790456"));

  check_fails(run("regularity 'mask2:[[1,2,1],[2,4,2],[1,2,1]]/4,dilation=[1,1;0,2]'"), 64,
              "scheme specification, position 44: '[1,1;0,2]'; expected eigenvalues larger than 1 in modulus, all of "
              "them, got [1,1;0,2]");
  check_fails(run("regularity 'mask2:[[1,1],[1,1]]@0,0,dilation=[2,1;0,2]'"), 64,
              "regularity: need a dilation without Jordan blocks whose conjugate eigenvalues have one modulus, or a "
              "tensor product, got the dilation [2,1;0,2]");
}

TEST_CASE("regularity: whether the scheme of a vector converges itself") {
  const auto merrien = run_json("regularity merrien:lambda=-1/8,mu=1/2");
  CHECK(merrien.at("converges") == "yes");
  CHECK(merrien.at("hermite").at("order") == 1);
  CHECK(merrien.at("hermite").at("next") == "no");
  const auto rough = run_json("regularity merrien:lambda=-1/8,mu=1");
  CHECK(rough.at("continuous") == "yes");
  CHECK(rough.at("converges") == "no");
  CHECK(rough.at("hermite").at("order").is_null());
  // Six points: HC^3, as the exponent is 3.617.
  CHECK(run_json("regularity hermite-dd:points=6,order=2").at("hermite").at("order") == 3);
  CHECK(run_json("regularity ghm").at("hermite").is_null());
  const Run kept = run("regularity 'vector:[[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-1'");
  CHECK(kept.code == 0);  // of the functions all is known
  CHECK(contains(kept.out, "\nconverges    no: the differences of its data do not shrink"));
  CHECK(run_json("analyze cl:2").at("converges") == "yes");
}

TEST_CASE("regularity: masks of matrices that are meant otherwise, or have no one answer") {
  check_fails(
      run("regularity 'refinable:[[[1,0],[1]],[[2,1],[0,1]]]/2@0'"), 64,
      "scheme specification, position 19: '[1]'; expected rows of one length: a list of 2, as before, not of 1");
  check_fails(run("regularity 'refinable:[[[1,0],[1,2]],[[2,1],[0,1]]],arity=1'"), 64,
              "scheme specification, position 47: '1'; expected arity as an integer from 2 to 64");
  // steps have values at the ends alone: no solution
  const Run none = run("regularity 'refinable:[[[1,0],[0,1]],[[1,0],[0,1]]]@0'");
  CHECK(none.code == 1);
  CHECK(joined(none.out).find("none that is continuous") != std::string::npos);
  const Run ends = run("regularity 'refinable:[[[1,0],[0,0]],[[2,0],[0,2]],[[1,0],[0,2]]]/2@-1'");
  CHECK(ends.code == 0);  // the hat beside a step, which is 0 as a continuous function
  CHECK(joined(ends.out).find("phi_2 is 0") != std::string::npos);
  // two solutions, and one of them
  const std::string both = "refinable:[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1";
  const auto all = run_json("regularity '" + both + "'"), one = run_json("regularity '" + both + ",integral=[0,1]'");
  CHECK(all.at("solutions") == 2);
  CHECK(all.at("integrals") == nlohmann::json::parse(R"([["1","0"],["0","1"]])"));
  CHECK(all.at("holder").at("lower") == "1");
  CHECK(one.at("solutions") == 1);
  CHECK(one.at("holder").at("lower") == "2");
  const Run other = run("regularity 'hermite:[[[4,-1],[6,-1]],[[8,0],[0,4]],[[4,1],[-6,-1]]]/8@-1,integral=[0,1]'");
  CHECK(other.code == 1);
  CHECK(joined(other.out).find("none that is continuous has the integral [0,1]; their integrals are combinations of "
                               "[1,0]") != std::string::npos);
  // Hermite masks in other conventions
  const Run transposed = run("regularity 'hermite:[[[4,6],[-1,-1]],[[8,0],[0,4]],[[4,-6],[1,-1]]]/8@-1'");
  CHECK(joined(transposed.out).find("their transposes keep those of polynomials up to degree 3") != std::string::npos);
  const Run undivided = run("regularity 'hermite:[[[4,-1],[12,-2]],[[8,0],[0,8]],[[4,1],[-12,-2]]]/8@-1'");
  CHECK(joined(undivided.out).find("row k divided by 2^k, k = 0, 1, ... keep those of polynomials up to degree 3") !=
        std::string::npos);
  // ten thousand numbers
  std::string many = "refinable:[";
  for (int k = 0; k < 100; ++k) {
    many += k > 0 ? ",[" : "[";
    for (int i = 0; i < 100; ++i)
      many += (i % 10 > 0 ? "," : i > 0 ? "],[" : "[") + std::to_string(k == 0 && i % 11 == 0 ? 1 : 0);
    many += "]]";
  }
  CHECK(run("regularity '" + many + "]@0'").code == 1);  // phi(x) = phi(2x)
}

TEST_CASE("regularity: whether a vector scheme converges has a certificate of its own") {
  const Folder folder;
  const std::string file = folder / "scheme.cert";
  const auto asked = [&](const std::string& claim) { return run("verify " + file + " --claim '" + claim + "'").code; };
  const auto written = [&](const std::string& scheme) {
    return joined(run("regularity '" + scheme + "' --scheme-certificate " + file).out);
  };
  CHECK(contains(written("hermite-dd:points=4,order=2"), "verified: that the scheme is HC^2"));
  CHECK(asked("2 <= HC of hermite-dd:points=4,order=2") == 0);
  CHECK(asked("HC of hermite-dd:points=4,order=2 <= 2") == 1);
  CHECK(contains(written("merrien:lambda=-1/8,mu=1"), "verified: that the scheme is not HC^1"));
  CHECK(asked("HC of merrien:lambda=-1/8,mu=1 <= 1") == 0);
  CHECK(contains(written("bspline:degree=3,multiplicity=2"), "verified: that the scheme converges"));
  CHECK(asked("0 <= scheme of bspline:degree=3,multiplicity=2") == 0);
  CHECK(contains(written("vector:[[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-1"),
                 "verified: that the scheme does not converge"));
  CHECK(asked("scheme of vector:[[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-1 <= 0") == 0);
  CHECK(run("verify --print-claim " + file).out.starts_with("--vectors '"));
  CHECK(contains(written("dd:n=2"), "not written: need a scheme of matrices, got dd:n=2"));
  const std::string plane = "tensor:(ghm)x(bspline:degree=1)";
  CHECK(contains(written(plane), "verified: that the scheme converges"));
  CHECK(asked("0 <= scheme of " + plane) == 0);
  CHECK(asked("scheme of " + plane + " <= 0") == 1);
  CHECK(asked("0 <= scheme of tensor:(ghm)x(ghm)") == 1);
  CHECK(asked("1 <= scheme of " + plane) != 0);
  CHECK(asked("0 <= HC of " + plane) == 64);
  const std::string two = "vector:[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1";
  CHECK(contains(written(two), "verified: that the scheme converges"));
  CHECK(asked("0 <= scheme of " + two) == 0);
  CHECK(contains(written("cl:2"), "verified: that the scheme converges"));
  CHECK(asked("0 <= scheme of cl:2") == 0);
  CHECK(asked("0 <= scheme of cl:3") == 1);
  const std::string merrien =
      "hermite:[[[1/2,-1/8],[1/2-sqrt(2)/8,sqrt(2)/16]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)/8-1/2,sqrt(2)/16]]]@-1";
  CHECK(contains(written(merrien), "verified: that the scheme is HC^1"));
  CHECK(asked("1 <= HC of " + merrien) == 0);
  CHECK(asked("1 <= HC of ghm") == 64);
  for (const char* command : {"regularity", "analyze"}) {
    const auto json = run_json(std::string(command) + " merrien:lambda=-1/8,mu=1/2 --scheme-certificate " + file);
    CHECK(json.at("scheme_certificate").at("lower") == "1");
  }
  CHECK(contains(joined(run("analyze merrien:lambda=-1/8,mu=1 --scheme-certificate " + file).out),
                 "verified: that the scheme is not HC^1"));
  for (const char* other : {"dd:n=2", "four-point:w", "merrien:lambda,mu=1/2", "l1:points=4"}) {
    const auto refused = run(std::string("analyze '") + other + "' --scheme-certificate " + file);
    CHECK(refused.code == 64);
    CHECK(contains(refused.err, "expected a vector or Hermite scheme without a parameter"));
  }
}

TEST_CASE("regularity: vectors of functions by name") {
  const Folder folder;
  const std::string file = folder / "vector.cert";
  CHECK(run("regularity ghm --certificate " + file).code == 0);
  CHECK(run("verify " + file + " --claim '1 <= ghm <= 1'").code == 0);
  CHECK(run("regularity ghm --help").out.find("hermite-dd:points=4,order=2,a=2") != std::string::npos);
  const std::string with_root = folder / "root.cert";
  const auto rounded = run_json("regularity cl:2 --certificate " + with_root);
  CHECK(has_digits(rounded.at("holder"), "lower", "0.59632253897"));
  CHECK(has_digits(rounded.at("holder"), "upper", "0.59632253897"));
  CHECK(rounded.at("exact") == true);
  CHECK(rounded.at("certificate").at("exact").get<std::string>().starts_with("0-log|[-7,0,16]"));
  CHECK(run("verify " + with_root + " --claim '0.59632 <= cl:2 <= 0.59633'").code == 0);
  CHECK(run("verify " + with_root + " --claim '0.5964 <= cl:2'").code == 1);
  CHECK(run("verify " + with_root + " --claim '0.5 <= bat:2'").code == 1);
  CHECK(run("verify " + with_root + " --claim '0.5 <= component 1 of cl:2'").code == 1);
  const std::string of_one = folder / "one.cert",
                    mixed =
                        "'refinable:[[[2,-sqrt(2)],[0,1]],[[4,-sqrt(2)],[0,3]],[[2,sqrt(2)],[0,3]],[[0,sqrt(2)],[0,1]]"
                        "]/4@-1,integral=[0,1]'";
  CHECK(contains(joined(run("regularity cl:2 --component 1 --certificate " + of_one).out),
                 "verified: the bounds, and that the product attains the radius"));
  CHECK(run("verify " + of_one + " --claim '0.5 <= component 1 of cl:2'").code == 0);
  CHECK(run("verify " + of_one + " --claim '0.5 <= component 2 of cl:2'").code == 1);
  CHECK(run("regularity " + mixed + " --component 2 --certificate " + of_one).code == 0);
  CHECK(contains(run("verify " + of_one).out, " <= 2 of component 1 of the refinable functions of "));
  check_fails(run("regularity bat:4"), 64,
              "scheme specification, position 5: '4'; expected the number of bat as an integer from 1 to 3");
  CHECK(run("regularity hermit-dd:points=4,order=2").err.ends_with("did you mean 'hermite-dd'?\n"));
}
