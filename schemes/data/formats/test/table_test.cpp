#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/formats/dates.hpp>
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
  CHECK(parse_table("t\n\n \n5", "f").lines.front() == 4);
  CHECK(parse_table("sep=;\n1;2", "f").columns == 2);
  CHECK(error_of("1\nsep=;\n") == "f, line 2, column 1: expected a number; found 'sep=;'");
}

TEST_CASE("errors name file, line and column") {
  CHECK(error_of("") == "f: expected rows of numbers; found none");
  CHECK(error_of("\n\n# x\n") == "f: expected rows of numbers; found none");
  CHECK(error_of("x,y\n") == "f: expected rows of numbers; found a header alone");
  CHECK(error_of("1,2\n3,x4\n") == "f, line 2, column 2: expected a number; found 'x4'");
  CHECK(error_of("a\n1\nb\n") == "f, line 3, column 1: expected a number; found 'b'");
  CHECK(error_of("1,a\n") ==
        "f, line 1, column 2: expected a number; found 'a'; a header has no number, as column 1 has with '1'");
  CHECK(error_of("1,2\n3\n") == "f, line 2, column 2: expected 2 columns as in the first row; found 1");
  CHECK(error_of("1,2\n3,4,5\n") == "f, line 2, column 3: expected 2 columns as in the first row; found 3");
  CHECK(error_of("x,y\n1,2,3\n") == "f, line 2, column 3: expected 2 columns as in the first row; found 3");
  CHECK(error_of("1\nnan\n") == "f, line 2, column 1: expected a finite number; found 'nan'");
  CHECK(error_of("1\n-inf\n") == "f, line 2, column 1: expected a finite number; found '-inf'");
  CHECK(error_of("1\n1e999\n") == "f, line 2, column 1: expected a finite number; found '1e999'");
  CHECK(error_of("1,2\n,4\n") == "f, line 2, column 1: expected a finite number; found nothing");
  CHECK(error_of("1\n\n2\n") == "f, line 2: expected a row; found an empty line between rows");
  CHECK(error_of("1,5;2,5\n") ==
        "f, line 1, column 1: expected a number; found '1,5', a number with a comma for the decimal point");
  CHECK(error_of("1,\"2\n") == "f, line 1, column 2: expected a closing quote on the same line");
  CHECK(error_of(std::string_view("1\0 2\n", 5)).find("zero byte") != std::string::npos);
  CHECK(error_of("1\n\x1b[31m\n") == "f, line 2, column 1: expected a number; found '\\u001b[31m'");
}

TEST_CASE("a header has a name and no number") {
  for (const char* header : {"x,E", "t,e", "E,nu", "E1", "e1,e2", "x,-", "E+,E-", "x,Na", "2theta,-", "\"Na\"", "x,",
                             "T\xc2\xb0"
                             "C)"}) {
    CAPTURE(header);
    const std::string row = std::string(header).find(',') == std::string::npos ? "1\n" : "1,2\n";
    for (const Missing missing : {Missing::keep, Missing::refuse}) {
      const Table table = parse_table(header + ("\n" + row), "f", missing);
      CHECK(table.header.size() == table.columns);
      CHECK(table.rows() == 1);
    }
  }
  // Single quotes around all names are none of them; of some they are.
  CHECK(parse_table("'a'\t'b c'\n1\t2\n", "f").header == std::vector<std::string>{"a", "b c"});
  CHECK(parse_table("'a',b\n1,2\n", "f").header == std::vector<std::string>{"'a'", "b"});
  for (const char* row : {"1,2", "1e3,.5", "-1,+2", "1,NA", ",2"}) {
    CAPTURE(row);
    CHECK(parse_table(std::string(row) + "\n3,4\n", "f", Missing::keep).rows() == 2);
  }
  for (const char* refused : {"x,2020", "x,inf", "x,1.", "x,1.2.3", "x,1e", "-,-", "-", "?,."})
    CHECK(error_of(std::string(refused) + "\n1,2\n", Missing::keep).starts_with("f, line 1, column 1: expected a "));
  CHECK(error_of("x,2020\n") ==
        "f, line 1, column 1: expected a number; found 'x'; a header has no number, as column 2 has with '2020'");
  for (const char* word : {"Na", "NA", "nan", "null"})
    for (const Missing missing : {Missing::keep, Missing::refuse})
      CHECK(error_of(std::string(word) + "\n1\n2\n", missing) ==
            "f, line 1, column 1: expected a header or numbers; found '" + std::string(word) +
                "', a name or a missing value: a name stands in quotes, and missing values below a header");
}

TEST_CASE("what cannot be seen in a field is named") {
  CHECK(error_of("1\n\xe2\x88\x92"
                 "3.5\n") ==
        "f, line 2, column 1: expected a number; found '\xe2\x88\x92"
        "3.5' (with U+2212)");
  CHECK(error_of("1\n2.5\xc2\xa0\n") == "f, line 2, column 1: expected a number; found '2.5\\u00a0' (with U+00A0)");
  CHECK(error_of("1\n\xff\n") == "f, line 2, column 1: expected a number; found '\\xff'");
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

TEST_CASE("text beside numbers, other marks, headers that are said to be") {
  TableForm form(Missing::keep);
  form.text = true;
  form.kept = {0, 2};
  const Table mixed = parse_table("make,speed,note\nVW,1,\n\"A, B\",2,007\nBMW,inf,x\n", "f", form);
  CHECK(mixed.rows() == 3);
  CHECK(mixed.contents[0].is_text());
  CHECK(mixed.contents[0].text == "VW");
  CHECK(mixed.contents[1].numbers == 2);
  CHECK(mixed.contents[1].why == "f, line 4, column 2: expected a finite number; found 'inf'");
  CHECK_FALSE(mixed.contents[2].is_text());  // 007 is a number
  CHECK(mixed.fields == std::vector<std::vector<std::string>>{{"VW", "A, B", "BMW"}, {"", "007", "x"}});
  CHECK(std::isnan(mixed.values[7]));

  form = TableForm();
  form.decimal = ',';
  const Table comma = parse_table("a;b\n1,5;-2e3\n,25;3\n", "f", form);
  CHECK(comma.values == std::vector<double>{1.5, -2000, 0.25, 3});
  CHECK(to_text(comma) == "a;b\n1,5;-2000\n0,25;3\n");
  CHECK(parse_table("1,5\n2,5\n", "f", form).columns == 1);
  form = TableForm();
  form.separator = '|';
  CHECK(parse_table("1|2\n", "f", form).values == std::vector<double>{1, 2});
  form = TableForm();
  form.header = true;
  CHECK(parse_table("1960,1961\n1,2\n", "f", form).header == std::vector<std::string>{"1960", "1961"});
  form.header = false;
  CHECK_THROWS(parse_table("x,y\n1,2\n", "f", form));

  const Table rows = parse_table("\"x\" \"y\"\n\"first\" 1 2\n\"2\" 3 4\n", "f");
  CHECK(rows.row_names);
  CHECK(rows.header == std::vector<std::string>{"", "x", "y"});
  CHECK(rows.values[1] == 1);
  CHECK(rows.values[5] == 4);
  CHECK(error_of("x y\n1 2\n3 4 5\n") == "f, line 3, column 3: expected 2 columns as in the first row; found 3");
  for (const char* mark : {"\xff\xfe", "\xfe\xff"})
    CHECK(error_of(mark + std::string("1\n")) ==
          "f: expected text in UTF-8; found UTF-16 (save it as UTF-8, or as CSV UTF-8)");
}

TEST_CASE("files that are no tables are known by their first bytes") {
  using namespace std::string_literals;
  const std::vector<std::pair<std::string, std::string>> files{
      {"\x1f\x8b\b\0\0"s, "packed by gzip (gunzip unpacks it)"},
      {"PK\3\4\x14\0\6\0[Content_Types].xml"s, "an Excel workbook"},
      {"PK\3\4\x14\0mimetypeapplication/vnd.oasis.opendocument.spreadsheet"s, "an OpenDocument workbook"},
      {"PK\3\4\x14\0a.csv"s, "a zip file (unzip unpacks it)"},
      {"\xfd\x37zXZ\0\0"s, "packed by xz"},
      {"\x28\xb5\x2f\xfd\0"s, "packed by zstd"},
      {"BZh91AY&SY\0"s, "packed by bzip2"},
      {"PAR1\x15\0"s, "a Parquet file"},
      {"\x93NUMPY\1\0"s, "an array of NumPy"},
      {"SQLite format 3\0"s, "a database of SQLite"}};
  for (const auto& [content, meaning] : files) {
    CAPTURE(meaning);
    CHECK(error_of(content).find("f: expected text in UTF-8; found ") == 0);
    CHECK(error_of(content).find(meaning) != std::string::npos);
  }
  CHECK(parse_table("PAR1,BZh\n1,2\n", "f").header == std::vector<std::string>{"PAR1", "BZh"});
}

namespace {

/// The most likely reading.
Date date_of(const std::string& text) { return readings_of_date(text).at(0); }

}  // namespace

TEST_CASE("dates are read and written as ISO 8601 has them") {
  CHECK(date_of("1970-01-02").value == 1);
  CHECK(date_of("2024-02-29").value - date_of("2023-02-28").value == 366);
  CHECK(date_of("1969-12-31T23:59:58.5Z").value == -1.5);
  CHECK(date_of("2024-03-01 12:00").form == DateForm{true, " ", ""});
  CHECK(date_of("2024-03-01T12:00:01+05:30").form.zone == "+05:30");
  for (const char* text : {"",
                           "2024",
                           "2024-2-1",
                           "2024-13-01",
                           "2023-02-29",
                           "0000-01-01",
                           "2024-02-29 ",
                           "20240229",
                           "2024-02-29T",
                           "2024-02-29T24:00",
                           "2024-02-29T12",
                           "2024-02-29T12:00:60",
                           "2024-02-29T12:00z",
                           "2024-02-29T12:00+5",
                           "2024-02-29T12:00:01.",
                           "x2024-02-29",
                           "2024-02-29T12:00-05:60",
                           "2024-13",
                           "2024-00",
                           "2024Q0",
                           "2024Q5",
                           "2024-02 ",
                           "Feb 24",
                           "feb 2024",
                           "Febr 2024",
                           "2024M13",
                           "2024M00",
                           "2024-02T12:00",
                           "Feb-30-2024",
                           "Feb-0-2024",
                           "30.02.2024",
                           "2.29.2024",
                           "29.02.24",
                           "29.02.2024T12:30:00",
                           "29/02/2024"}) {
    CAPTURE(text);
    CHECK(readings_of_date(text).empty());
  }
  for (const char* text : {"0001-01-01",
                           "1582-10-10",
                           "9999-12-31",
                           "2024-02-29T00:00:00Z",
                           "1969-12-31 23:59:59.999999",
                           "2024-12-31T23:59:59.5-11:00",
                           "2024-02",
                           "0001-01",
                           "9999-12",
                           "1969Q4",
                           "2024-Q1",
                           "2024 Q3",
                           "2024q2",
                           "Q2 1960",
                           "2024M03",
                           "2024M3",
                           "2024m11",
                           "May 2024",
                           "September 1968",
                           "Dec-1969",
                           "Jan-1-1995",
                           "29.02.2024",
                           "1.2.2024",
                           "10.12.2024",
                           "29.02.2024 12:30:00"}) {
    CAPTURE(text);
    for (const Date& date : readings_of_date(text)) {
      CHECK(to_text(date.value, date.form) == text);
      CHECK(parse_date(text, date.form) == date.value);
    }
    CHECK_FALSE(readings_of_date(text).empty());
  }
  CHECK(to_text(0.5, date_of("29.02.2024").form) == "01.01.1970 12:00:00");
  CHECK(
      error_of("1\n29/02/2024\n") ==
      "f, line 2, column 1: expected a number; found '29/02/2024', a date that does not say which number is the month "
      "(2024-02-29 and 29.2.2024 do)");
  CHECK(to_text(0.5, DateForm{}) == "1970-01-01T12:00:00");
  CHECK(to_text(-0.25, DateForm{}) == "1969-12-31T18:00:00");
  CHECK_THROWS(to_text(1e12, DateForm{}));
  std::mt19937_64 engine(3);
  for (int i = 0; i < 2000; ++i) {
    const auto days = static_cast<double>(static_cast<long>(engine() % 3'600'000) - 719'000);
    CHECK(date_of(to_text(days, DateForm{})).value == days);
  }
}

TEST_CASE("months and quarters count by themselves, and run evenly from one to the next") {
  CHECK(date_of("1970-03").value == 2);
  CHECK(date_of("1969-12").value == -1);
  CHECK(date_of("1971Q2").value == 5);
  CHECK(date_of("Dec 1969").form.unit() == DateUnit::month);
  CHECK(date_of("2024Q1").form.unit_name() == "quarters");
  CHECK(date_of("Jan-1-1995").form.unit_name() == "days");
  CHECK(readings_of_date("May 2024").size() == 2);
  CHECK(readings_of_date("2024M12").size() == 2);
  const DateForm month = date_of("2024-02").form, quarter = date_of("2024Q1").form;
  const double february = date_of("2024-02").value;
  CHECK(to_text(february + 0.5, month) == "2024-02-15T12:00:00");
  CHECK(to_text(february - 1e-12, month) == "2024-02");
  CHECK(to_text(date_of("1969Q4").value + 0.25, quarter) == "1969-10-24");
  CHECK(time_of(february, month) == date_of("2024-02-01").value);
  CHECK(time_of(february + 1, month) == date_of("2024-03-01").value);
  CHECK(time_of(date_of("2024Q2").value, quarter) == date_of("2024-04-01").value);
  CHECK(time_of(7.25, DateForm{}) == 7.25);
  CHECK_THROWS(to_text(1e6, month));
  CHECK(may_be_two_years("2001-02", month));
  CHECK_FALSE(may_be_two_years("2001-03", month));
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
