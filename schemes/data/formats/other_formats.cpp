#include "other_formats.hpp"

#include <array>

namespace subcert::data {
namespace {

using namespace std::string_view_literals;

struct Format {
  std::string_view first_bytes;
  const char* meaning;
};

constexpr std::array formats{
    Format{"\xff\xfe"sv, "UTF-16 (save it as UTF-8, or as CSV UTF-8)"},
    Format{"\xfe\xff"sv, "UTF-16 (save it as UTF-8, or as CSV UTF-8)"},
    Format{"\x1f\x8b"sv, "a file packed by gzip (gunzip unpacks it)"},
    Format{"BZh91AY&SY"sv, "a file packed by bzip2 (bunzip2 unpacks it)"},
    Format{"\xfd"
           "7zXZ\0"sv,
           "a file packed by xz (unxz unpacks it)"},
    Format{"\x28\xb5\x2f\xfd"sv, "a file packed by zstd (unzstd unpacks it)"},
    Format{"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, "an old workbook or document (save the sheet as CSV UTF-8)"},
    Format{"PAR1\x15"sv, "a Parquet file (subcert.smooth in Python reads it)"},
    Format{"ARROW1\0"sv, "an Arrow file (subcert.smooth in Python reads it)"},
    Format{"\x93NUMPY"sv, "an array of NumPy (subcert.smooth in Python reads it)"},
    Format{"\x89HDF\r\n\x1a\n"sv, "an HDF5 file (export the table as CSV)"},
    Format{"SQLite format 3\0"sv, "a database of SQLite (sqlite3 -csv -header prints a table)"},
    Format{"%PDF-"sv, "a PDF file (save the table as CSV)"},
};

/// A zip file may be a workbook, whose parts are named in its beginning.
std::string kind_of_zip(std::string_view content) {
  const std::string_view beginning = content.substr(0, 4096);
  if (beginning.find("[Content_Types].xml") != std::string_view::npos ||
      beginning.find("xl/") != std::string_view::npos)
    return "an Excel workbook (save the sheet as CSV UTF-8)";
  if (beginning.find("opendocument.spreadsheet") != std::string_view::npos)
    return "an OpenDocument workbook (save the sheet as CSV)";
  return "a zip file (unzip unpacks it)";
}

}  // namespace

std::string other_format(std::string_view content) {
  if (content.starts_with("PK\3\4")) return kind_of_zip(content);
  for (const Format& format : formats)
    if (content.starts_with(format.first_bytes)) return format.meaning;
  return "";
}

}  // namespace subcert::data
