# subcert_embed_text(TARGET OUTPUT VARIABLE FILES...): compiles text files into TARGET as
#   const std::map<std::string, std::string_view> subcert::VARIABLE, keyed by the name of the folder of each, or, with
#   BY_FILE before the files, by their own without the extension, but README by that of its folder.
function(subcert_embed_text target output variable)
  cmake_parse_arguments(PARSE_ARGV 3 arg "BY_FILE" "" "")
  set(entries "")
  foreach(file IN LISTS arg_UNPARSED_ARGUMENTS)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(GET folder FILENAME key)
    cmake_path(GET file STEM name)
    if(arg_BY_FILE AND NOT name STREQUAL README)
      set(key "${name}")
    endif()
    file(READ "${file}" text)
    string(APPEND entries "    {\"${key}\", R\"subcert(${text})subcert\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT
"#include <map>
#include <string>
#include <string_view>

namespace subcert {
extern const std::map<std::string, std::string_view> @variable@;
const std::map<std::string, std::string_view> @variable@{
@entries@};
}  // namespace subcert
")
  target_sources(${target} PRIVATE "${output}")
endfunction()
