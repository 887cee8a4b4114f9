#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("matrices from a file") {
  const Folder folder;
  const std::string file = folder / "file.json";
  const auto with = [&](const std::string& text, const std::string& options = "") {
    std::ofstream(file, std::ios::binary) << text;
    return run("jsr " + file + options);
  };
  const Run golden = with(R"({"matrices": [[["1","1"],["0","1"]], [[1,0],["2/2",1]]]})",
                          " --json --certificate " + file + ".cert");
  CHECK(golden.code == 0);
  CHECK(nlohmann::json::parse(golden.out).at("product").size() == 2);
  CHECK(has_digits(nlohmann::json::parse(golden.out).at("radius"), "lower", "1.6180339887"));
  CHECK(run("verify " + file + ".cert").code == 0);
  const Run blocks = with(R"({"matrices": [[["2","7"],["0","1"]], [["1","5"],["0","-3"]]]})",
                          " --json --certificate " + file + ".cert");
  CHECK(blocks.code == 0);
  CHECK(nlohmann::json::parse(blocks.out).at("blocks") == nlohmann::json({1, 1}));
  CHECK(nlohmann::json::parse(blocks.out).at("exact") == true);
  CHECK(nlohmann::json::parse(blocks.out).at("radius").at("upper") == "3");
  CHECK(run("verify " + file + ".cert").code == 0);
  const Run nilpotent = with(R"({"matrices": [[["0","7"],["0","0"]], [["0","5"],["0","0"]]]})",
                             " --json --certificate " + file + ".cert");
  CHECK(nilpotent.code == 0);
  CHECK(nlohmann::json::parse(nilpotent.out).at("radius").at("upper") == "0");
  CHECK(run("verify " + file + ".cert").code == 0);
  for (const char* text :
       {"", "{", "[]", "{}", R"({"matrices": []})", R"({"matrices": 5})", R"({"matrices": [[]]})",
        R"({"matrices": [[["1","0"],["1"]]]})", R"({"matrices": [[["1/0"]]]})", R"({"matrices": [[[1.5.2]]]})",
        R"({"matrices": [[["1"]],[["1","0"],["0","1"]]]})", R"({"matrices": [[[null]]]})"}) {
    CAPTURE(text);
    CHECK(with(text).code == 65);
  }
  for (const char* text :
       {"matrices", "matrices 1", "matrices 1 1", "matrices 1 1\nrow", "matrices 1 1\nrow x", "matrices 1 1\nrow 1 2",
        "matrices 0 1\n", "matrices 1 257\n", "matrices 99999 256\n", R"({"matrices": [[[1]]], "edges": 5})",
        R"({"matrices": [[[1]]], "edges": []})", R"({"matrices": [[[1]]], "edges": [[0,1]]})",
        R"({"matrices": [[[1]]], "edges": [[0,1,1]]})", R"({"matrices": [[[1]]], "edges": [[0,-1,0]]})",
        R"({"matrices": [[[1]]], "edges": [[0,1.5,0]]})"}) {
    CAPTURE(text);
    CHECK(with(text).code == 65);
  }
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {R"({"matrices": [[[1]]], "edge": [[0,0,0]]})",
            "line 1, column 23: unknown key 'edge'; the keys of a file of matrices are matrices, edges"},
           {"{\"matrices\": [[[1]]],\n \"Edges\": [[0,0,0]]}", "line 2, column 2: unknown key 'Edges'"},
           {R"({"matrices": [[[1]]], "matrices": [[[2]]]})", "line 1, column 23: the key 'matrices' is there twice"},
           {"{\"matrices\": [[[1],\n]]}", "line 2, column 1: not JSON: expected a value, got ']'"},
           {R"({"matrices": [[[NaN]]]})", "line 1, column 17: not JSON: expected a value, got 'NaN'"},
           {"{\"matrices\": // two\n[[[1]]]}", "line 1, column 14: not JSON: expected a value, got '/'"},
           {R"({"matrices": [[[1/2]]]})", "column 18: not JSON: expected the end of a number, got '/'"},
           {R"({"matrices": [[[01]]]})", "not JSON: expected a number without leading zeros, got '01'"},
           {R"({"matrices": [[[1]]]} 2)", "not JSON: expected nothing after the value, got '2'"},
           {"{\"matrices\": [[[\xe2\x88\x92"
            "1]]]}",
            "got '\xe2\x88\x92' (with U+2212)"},
           {R"({"matrices": [[["1e-401"]]]})",
            "line 1, column 17: expected an exact number, as 1, 1/2 or 0.5, of at most"},
           {"matrices 1 1\n\n# two\nrow 1\n", "line 3: expected 'row' and 1 numbers, row 0 of matrix 0, got '#'"},
           {"matrices 1 2\nrow 1 2\nrow 3\n", "line 4: expected 2 numbers in row 1 of matrix 0, got the end"},
           {"# a note\nmatrices 1 1\nrow 1\n", "line 1: expected JSON"}}) {
    CAPTURE(text);
    const Run refused = with(text);
    CHECK(refused.code == 65);
    CHECK(contains(refused.err, message));
  }
  // As MATLAB writes matrices of one entry.
  CHECK(nlohmann::json::parse(with(R"({"matrices": [2, -2.5]})", " --json").out).at("radius").at("lower") == "2.5");
  CHECK(with("\xef\xbb\xbf{\"matrices\": [[[2]]]}").code == 0);
  std::filesystem::remove(file);
  CHECK(run("jsr " + file).code == 66);
}

TEST_CASE("jsr: exact numbers, lines, graphs and targets") {
  const Folder folder;
  const std::string file = folder / "file";
  const auto with = [&](const std::string& text, const std::string& options = "", int code = 0) {
    std::ofstream(file, std::ios::binary) << text;
    const Run done = run("jsr " + file + " --json" + options);
    CAPTURE(text, done.err);
    CHECK(done.code == code);
    return nlohmann::json::parse(done.out);
  };
  // 0.1 is no double, and no double holds 23 digits.
  CHECK(with(R"({"matrices": [[[0.1]]]})").at("radius").at("upper") == "0.1");
  CHECK(with(R"({"matrices": [[[12345678901234567890123]]]})").at("radius").at("lower") == "1.234567890123456789e22");
  CHECK(with("matrices 2 1\nrow 1/2\nrow -25e-2\n").at("radius").at("upper") == "0.5");
  const std::string golden = R"({"matrices": [[[1,1],[0,1]], [[1,0],[1,1]]])";
  CHECK(with(golden + "}").at("exact") == true);
  // The matrix 1 never twice in a row; both alternate all the same.
  const auto graph = with(golden + R"(, "edges": [[0,0,0],[0,1,1],[1,0,0]]})", " --certificate " + file + ".cert");
  CHECK(has_digits(graph.at("radius"), "lower", "1.6180339887"));
  CHECK(run("verify " + file + ".cert").code == 0);
  // Each matrix must be followed by itself: no growth.
  CHECK(with(golden + R"(, "edges": [[0,0,0],[1,1,1]]})").at("radius").at("upper") == "1");
  // No cycle: nothing remains.
  CHECK(with(golden + R"(, "edges": [[0,1,0],[1,2,1]]})").at("radius").at("upper") == "0");
  CHECK(with(golden + "}", " --lower 1.618").at("lower").at("verdict") == "proved");
  CHECK(with(golden + "}", " --upper 1.62").at("upper").at("verdict") == "proved");
  CHECK(with(golden + "}", "").at("formula") == "(3/2+1/2*sqrt(5))^(1/2)");
  CHECK(with(golden + "}", " --lower 1.7 --budget 20", 1).at("lower").at("verdict") == "refuted");
  CHECK(with(golden + "}", " --lower 1.619", 1).at("lower").at("verdict") == "refuted");
  CHECK(with(golden + "}", " --lower 1.6 --upper 1.618", 1).at("upper").at("verdict") == "refuted");
  CHECK(run("jsr " + file + " --lower x").code == 64);
  const auto fine = with(golden + "}", " --width 1e-60").at("radius");
  CHECK(has_digits(fine, "lower", "1.618033988749894848204586834365638117720309179805762862135448"));
  CHECK(has_digits(fine, "upper", "1.618033988749894848204586834365638117720309179805762862135448"));
  // Twice its square is (5 + sqrt 17)/2.
  // 2)...
  const auto square = with(golden + "}", " --p 2");
  CHECK(square.at("size") == 3);
  CHECK(has_digits(square.at("radius"), "lower", "1.510"));
  // Averages: of the matrices themselves for p = 1.
  CHECK(with(golden + "}", " --p 1").at("radius").at("upper") == "1.5");
  CHECK(run("jsr " + file + " --p 2 --lower 1").code == 64);
  CHECK(run("jsr " + file + " --p 65").code == 64);
  for (const char* width : {"0", "-1", "x", "2", "1e-1001", "1/0"})
    CHECK(run("jsr " + file + " --width " + width).code == 64);
}

TEST_CASE("jsr --subradius") {
  const Folder folder;
  const std::string file = folder / "pair", certificate = folder / "pair.cert";
  const auto with = [&](const std::string& text, const std::string& options, int code = 0) {
    std::ofstream(file, std::ios::binary) << text;
    Run done = run("jsr " + file + " --subradius" + options);
    CAPTURE(text, done.out, done.err);
    CHECK(done.code == code);
    return done;
  };
  const std::string slow = R"({"matrices": [[[7,2],[0,3]], [[2,0],[4,8]]]})";
  const auto json = nlohmann::json::parse(with(slow, " --json --certificate " + certificate).out);
  CHECK(json.at("product") == nlohmann::json({1, 0, 1, 0, 0, 1, 0, 0}));
  CHECK(json.at("exact") == true);
  CHECK(has_digits(json.at("subradius"), "lower", "6.009313489530125114"));
  CHECK(json.at("certificate").at("exact").is_string());
  CHECK(run("verify " + certificate).code == 0);
  CHECK(run("verify " + certificate + " --claim '6 <= subradius " + file + ".mat <= 6.01'").code == 66);
  std::filesystem::rename(certificate + ".matrices", file + ".mat");
  CHECK(run("verify " + certificate + " --claim '6 <= subradius " + file + ".mat <= 6.01'").code == 0);
  CHECK(run("verify " + certificate + " --claim '6.01 <= subradius " + file + ".mat'").code == 1);
  CHECK(contains(with(slow, "").out, "proved to attain the joint spectral subradius"));
  const auto fine = nlohmann::json::parse(with(slow, " --json --width 1e-60").out).at("subradius");
  CHECK(has_digits(fine, "upper", "6.009313489530125114150906576551805313658780636323343183441916"));
  CHECK(contains(with(slow, " --lower 6 --upper 7").out, "lower        6: proved"));
  CHECK(contains(with(slow, " --upper 6", 1).out, "upper        6: refuted"));
  // A product is nilpotent.
  CHECK(contains(with(R"({"matrices": [[[0,1],[0,0]], [[1,1],[1,1]]]})", " --certificate " + certificate).out,
                 "subradius    0"));
  CHECK(run("verify " + certificate).code == 0);
  CHECK(contains(with("matrices 1 1\nrow -1\n", "", 64).err, "without negative entries"));
  CHECK(contains(with(R"({"matrices": [[[1]]], "edges": [[0,0,0]]})", "", 64).err, "without a graph"));
  with(slow, " --p 2", 64);
}

TEST_CASE("jsr: families whose radius is plain are exact, with certificates") {
  const Folder folder;
  const std::string file = folder / "file.json", certificate = file + ".cert";
  for (const char* text : {
           R"([[[1,-1],[1,4]]])",
           R"([[[-3,-1],[-1,-5]]])",
           R"([[[0.288526,-0.144024],[0.021767,0.897103]]])",
           R"([[[0,-1,-1,-1],[5,-1,1,5],[-2,-1,2,3],[5,1,-4,-3]]])",
           R"([[[2,1,0],[0,2,1],[0,0,2]]])",
           R"([[[0,1],[0,0]]])",
           R"([[[0,-1],[1,1]]])",
           R"([[["3/5","-4/5"],["4/5","3/5"]]])",
           R"([[[1,-1],[1,4]],[[0,0],[0,0]]])",
           R"([[[1,-1],[1,4]],[[1,-1],[1,4]]])",
           R"([[[9e40,6000000,7000000],[6000000,9000000,5],[0,0,9e40]]])",
           R"([[[1,1],[1,0]],[[-1,-1],[-1,0]]])",
           R"([[[0,-1],[1,0]],[[0,0],[0,0]]])",
           R"([[[-1,0],[0,0]],[[0,-1],[1,0]]])",
           R"([[[-1,-1],[0,0]],[[-1,-1],[1,0]]])",
           R"([[[-1,-1],[-1,1]],[[-1,-1],[0,0]]])",
           R"([[[0,-2],[-1,0]],[[-2,0],[0,-2]]])",
           R"([[[1e-100,1e-100,0],[-1e-100,0,-1e-100],[1e-100,0,0]],)"
           R"([[1e-100,0,-1e-100],[1e-100,-1e-100,0],[0,1e-100,0]]])",
       }) {
    std::ofstream(file, std::ios::binary) << R"({"matrices": )" << text << "}";
    const Run done = run("jsr " + file + " --json --budget 10 --certificate " + certificate);
    CAPTURE(text, done.out, done.err);
    CHECK(done.code == 0);
    CHECK(nlohmann::json::parse(done.out).at("exact") == true);
    CHECK(run("verify " + certificate).code == 0);
  }
  // A graph whose only cycle is a loop.
  std::ofstream(file, std::ios::binary)
      << R"({"matrices": [[[3,1],[1,-2]],[[5,0],[1,1]]], "edges": [[0,1,1],[1,2,0],[2,2,0],[2,3,1]]})";
  const Run loop = run("jsr " + file + " --json --budget 10 --certificate " + certificate);
  CHECK(loop.code == 0);
  CHECK(nlohmann::json::parse(loop.out).at("exact") == true);
  CHECK(has_digits(nlohmann::json::parse(loop.out).at("radius"), "lower", "3.1925824035"));
  CHECK(run("verify " + certificate).code == 0);
}

TEST_CASE("jsr: certificates name what is exact, and say so where they do not") {
  const Folder folder;
  const std::string file = folder / "file.json", certificate = file + ".cert";
  struct Case {
    const char* matrices;
    bool named;
  };
  for (const auto& [matrices, named] : {
           Case{R"([[[1,1],[1,0]],[[-1,-1],[-1,0]]])", true},
           Case{R"([[[0,-1],[1,1]],[[0,1],[-1,-1]],[[1,1],[-1,2]]])", true},
           Case{R"([[[1e160,1e160,0],[-1e160,0,-1e160],[1e160,0,0]],)"
                R"([[1e160,0,-1e160],[1e160,-1e160,0],[0,1e160,0]]])",
                true},
           Case{R"([[["-999999","1000000"],["-1000000","1000001"]],)"
                R"([["1000002","-1000000"],["1000002000001/1000000","-1000000"]]])",
                true},
           Case{R"([[[1,1],[1,-1]],[[1,-1],[-1,-1]]])", true},  // the square root of 2, by products of two letters
           Case{R"([[["3/5","-4/5"],["4/5","3/5"]],[["-3/5","4/5"],["-4/5","-3/5"]],[["3/5","4/5"],["4/5","-3/5"]]])",
                true},  // isometries of a form
       }) {
    std::ofstream(file, std::ios::binary) << R"({"matrices": )" << matrices << "}";
    const Run done = run("jsr " + file + " --json --budget 10 --certificate " + certificate);
    CAPTURE(matrices, done.out, done.err);
    const auto json = nlohmann::json::parse(done.out);
    CHECK(json.at("exact") == true);
    CHECK(json.at("certificate").at("exact").is_string() == named);
    const Run verified = run("verify " + certificate);
    CHECK(verified.code == 0);
    CHECK(contains(verified.out, "joint spectral radius = ") == named);
    const std::string text = joined(run("jsr " + file + " --budget 10 --certificate " + certificate).out);
    CHECK(contains(text, named ? "and that the product attains" : "but not that the product attains"));
  }
}

TEST_CASE("jsr: a certificate claims no more than the product proves whose eigenvalue is multiple") {
  const Folder folder;
  const std::string file = folder / "file.json";
  for (const char* family :
       {R"({"matrices": [[[5,0,0],[0,5,0],[0,0,1]],[[1,2,1],[2,-3,1],[1,1,0]]]})",
        R"({"matrices": [[["9e-40","4e-12"],[0,"-3e-40"]],[["5e-12",-3],[0,"-6e-12"]],[["-3e-40","-5e-40"],[0,5]],)"
        R"([["-9e-12","-1e-12"],[0,8]],[["9e-40","4e-12"],[0,"-3e-40"]]],)"
        R"("edges": [[1,0,0],[0,0,2],[1,1,2],[0,1,3],[1,1,4]]})"}) {
    std::ofstream(file, std::ios::binary) << family;
    const std::string certificate = (folder / std::to_string(std::string(family).size())) + ".cert";
    const auto json = nlohmann::json::parse(run("jsr " + file + " --json --budget 3 --certificate " + certificate).out);
    CHECK(json.at("radius").at("lower") == "5");
    const std::string claim = run("verify " + certificate).out;
    CAPTURE(claim);
    CHECK(contains(claim, "VERIFIED 4999999999999999/1000000000000000 <= joint spectral radius"));
  }
}

TEST_CASE("jsr: the certificate of a large matrix of huge numbers claims no more than its inverse proves") {
  const Folder folder;
  const std::string file = folder / "file.json", certificate = folder / "c.cert";
  constexpr int size = 24;
  std::ofstream stream(file, std::ios::binary);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      stream << (j > 0   ? ","
                 : i > 0 ? "],["
                         : R"({"matrices": [[[)")
             << '"' << (i * 7 + j * 5 + i * j) % 11 - 5 << ((i + j) % 3 == 0 ? "e40" : "") << '"';
  stream << "]]]}" << std::flush;
  CHECK(run("jsr " + file + " --budget 5 --certificate " + certificate).code == 0);
  CHECK(run("verify " + certificate).code == 0);
}

TEST_CASE("jsr: families on which doubles lose their footing end with an answer") {
  const Folder folder;
  const std::string file = folder / "file.json";
  for (const char* text : {
           R"([[["9000000000043/50","-9000000000033/50"],["9000000000063/50","-9000000000053/50"]],)"
           R"([["999999999998999999999994/25000000000075","-2000000000013000000000023/50000000000150"],)"
           R"(["1000000000009000000000054/25000000000075","-2000000000033000000000093/50000000000150"]]])",
           R"([[["-999999","1000000"],["-1000000","1000001"]],)"
           R"([["1000002","-1000000"],["1000002000001/1000000","-1000000"]]])",
       }) {
    std::ofstream(file, std::ios::binary) << R"({"matrices": )" << text << "}";
    const Run done = run("jsr " + file + " --json --budget 5");
    CAPTURE(text, done.err);
    CHECK((done.code == 0 || done.code == 2));
    CHECK(nlohmann::json::parse(done.out).contains("radius"));
  }
}
