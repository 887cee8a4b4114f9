#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/json_file.hpp>

using namespace subcert;

namespace {

std::string error_of(const std::string& text) {
  try {
    static_cast<void>(parse_json(text));
  } catch (const FileError& error) {
    CHECK(error.kind() == ErrorKind::data);
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("JSON is read with its places, and numbers as they are written") {
  const JsonNode node = parse_json(
      " {\"a\": [1, -2.50e+3, \"x\\n\\u00e9\\ud83d\\ude00\"],\n  \"b\": {\"c\": null}, \"\": []}\n");
  using Kind = JsonNode::Kind;
  REQUIRE(node.find("a"));
  CHECK(node.find("d") == nullptr);
  CHECK(node.find("a")->kind == Kind::array);
  CHECK(node.find("a")->items[0].text == "1");
  CHECK(node.find("a")->items[1].text == "-2.50e+3");
  CHECK(node.find("a")->items[2].text == "x\n\xc3\xa9\xf0\x9f\x98\x80");
  CHECK(node.find("b")->place.line == 2);
  CHECK(node.find("b")->place.column == 8);
  CHECK(node.find("b")->key_place.column == 3);
  CHECK(node.find("b")->find("c")->text == "null");
  CHECK(node.find("")->items.empty());
  CHECK(parse_json("0").text == "0");
  CHECK(parse_json(std::string(400, '1')).text == std::string(400, '1'));
}

TEST_CASE("what is no JSON is refused with line and column") {
  for (const char* text : {"",
                           " ",
                           "{",
                           "[",
                           "[1,]",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{a:1}",
                           "{\"a\":1,}",
                           "[1 2]",
                           "01",
                           "-",
                           "1.",
                           ".5",
                           "1e",
                           "+1",
                           "tru",
                           "nul",
                           "NaN",
                           "Infinity",
                           "'a'",
                           "\"a",
                           "\"\\x\"",
                           "\"\\u12\"",
                           "\"\\ud800\"",
                           "\"\\udc00\"",
                           "\"\\ud800\\u0041\"",
                           "\"\x01\"",
                           "\"\xff\"",
                           "[1]]",
                           "1 2",
                           "/**/1",
                           "\xef\xbb",
                           "{\"a\":1 \"b\":2}",
                           "truex"}) {
    CAPTURE(text);
    CHECK(error_of(text).starts_with("line 1, column "));
  }
  CHECK(error_of("[1,\n 2,,]") == "line 2, column 4: not JSON: expected a value, got ','");
  CHECK(error_of("{\"a\": 1,\n\"a\": 2}") == "line 2, column 1: the key 'a' is there twice");
  CHECK(error_of("[{\"\\u0061\": 1, \"a\": 2}]") == "line 1, column 16: the key 'a' is there twice");
  CHECK(error_of(std::string(101, '[')).find("at most 100 levels") != std::string::npos);
  CHECK(error_of(std::string(1000000, '[')).find("at most 100 levels") != std::string::npos);
  CHECK(error_of("\"a\nb\"") == "line 1, column 3: not JSON: expected a closing quote on the same line, got '\\u000a'");
}
