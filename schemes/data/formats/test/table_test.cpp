#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/formats/table.hpp>

#include <cmath>
#include <random>
#include <sstream>

using namespace subcert;
using namespace subcert::data;

namespace {

std::string error_of(std::string_view text, Missing missing = Missing::refuse) {
  try {
    parse_table(text, "f", missing);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::data);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("separators, headers, comments, quotes and line ends") {
  for (const char* text : {"1,2\n3,4\n", "1;2\n3;4", "1\t2\r\n3\t4\r\n", "1 2\n3  4 \n", " 1   2\n3\t4\n",
                           "# note\n\n1,2\n3,4\n\n\n", "\xef\xbb\xbf\"1\",\"2\"\n3 , 4\n", "+1,2e0\r3,4.0\r"}) {
    CAPTURE(text);
    const Table table = parse_table(text, "f");
    CHECK(table.values == std::vector<double>{1, 2, 3, 4});
    CHECK(table.columns == 2);
    CHECK(table.header.empty());
  }
  const Table table = parse_table("x,\"the \"\"y\"\", m\"\n1,2\n\n", "f");
  CHECK(table.header == std::vector<std::string>{"x", "the \"y\", m"});
  CHECK(table.lines == std::vector<std::size_t>{2});
  CHECK(to_text(table) == "x,\"the \"\"y\"\", m\"\n1,2\n");
  CHECK(parse_table("-1e-3\n", "f").values == std::vector<double>{-0.001});
  CHECK(parse_table("t\n5", "f").rows() == 1);
}

TEST_CASE("errors name file, line and column") {
  CHECK(error_of("") == "f: expected rows of numbers; found none");
  CHECK(error_of("\n\n# x\n") == "f: expected rows of numbers; found none");
  CHECK(error_of("x,y\n") == "f: expected rows of numbers; found a header alone");
  CHECK(error_of("1,2\n3,x4\n") == "f, line 2, column 2: expected a number; found 'x4'");
  CHECK(error_of("a\n1\nb\n") == "f, line 3, column 1: expected a number; found 'b'");
  CHECK(error_of("1,a\n") == "f, line 1, column 2: expected a number; found 'a'");
  CHECK(error_of("1,2\n3\n") == "f, line 2, column 2: expected 2 columns as in the first row; found 1");
  CHECK(error_of("1,2\n3,4,5\n") == "f, line 2, column 3: expected 2 columns as in the first row; found 3");
  CHECK(error_of("x,y\n1,2,3\n") == "f, line 2, column 3: expected 2 columns as in the first row; found 3");
  CHECK(error_of("1\nnan\n") == "f, line 2, column 1: expected a finite number; found 'nan'");
  CHECK(error_of("nan\n1\n") == "f, line 1, column 1: expected a finite number; found 'nan'");
  CHECK(error_of("1\n-inf\n") == "f, line 2, column 1: expected a finite number; found '-inf'");
  CHECK(error_of("1\n1e999\n") == "f, line 2, column 1: expected a finite number; found '1e999'");
  CHECK(error_of("1,2\n,4\n") == "f, line 2, column 1: expected a finite number; found nothing");
  CHECK(error_of("1\n\n2\n") == "f, line 2: expected a row; found an empty line between rows");
  CHECK(error_of("1,5;2,5\n") == "f, line 1, column 1: expected a number; found '1,5'");
  CHECK(error_of("1,\"2\n") == "f, line 1, column 2: expected a closing quote on the same line");
  CHECK(error_of(std::string_view("1\0 2\n", 5)).find("zero byte") != std::string::npos);
  CHECK(error_of("1\n\x1b[31m\n") == "f, line 2, column 1: expected a number; found '?[31m'");
}

TEST_CASE("missing values are kept where asked for") {
  const Table table = parse_table("x,y\n1,NA\n,2\nnan,null\n3,4\n", "f", Missing::keep);
  REQUIRE(table.rows() == 4);
  CHECK(std::isnan(table.values[1]));
  CHECK(std::isnan(table.values[2]));
  CHECK(std::isnan(table.values[4]));
  CHECK(table.values[7] == 4);
  CHECK(error_of("1\ninf\n", Missing::keep) == "f, line 2, column 1: expected a finite number; found 'inf'");
}

TEST_CASE("what is written reads back the same") {
  std::mt19937_64 engine(5);
  Table table;
  table.columns = 3;
  for (int i = 0; i < 600; ++i)
    table.values.push_back(std::ldexp(static_cast<double>(engine()), static_cast<int>(engine() % 600) - 400));
  table.values.back() = 5e-324;
  for (const char separator : {',', ';', '\t', ' '}) {
    table.separator = separator;
    const Table back = parse_table(to_text(table), "f");
    CHECK(back.values == table.values);
    CHECK(back.separator == separator);
  }
}

TEST_CASE("rows that are written block by block are those of the whole table") {
  std::mt19937_64 engine(5);
  Table table;
  table.columns = 3;
  for (int row = 0; row < 20000; ++row) {
    table.values.push_back(row * 0.25);
    table.values.push_back(std::ldexp(static_cast<double>(engine()), static_cast<int>(engine() % 2000) - 1060));
    table.values.push_back(row % 4 == 0 ? -0.0 : 1.0 / (row % 4));
  }
  std::string plain;
  for (std::size_t i = 0; i < table.values.size(); ++i)
    plain += shortest_text(table.values[i]) + (i % 3 == 2 ? "\n" : ",");
  CHECK(to_text(table) == plain);
  for (const int threads : {1, 3}) {
    std::ostringstream stream;
    write_rows(stream, {{table.values.data(), 3}, {table.values.data() + 1, 3}, {table.values.data() + 2, 3}}, 20000,
               ',', threads);
    CHECK(stream.str() == plain);
  }
}
