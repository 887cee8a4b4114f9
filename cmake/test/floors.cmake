cmake_minimum_required(VERSION 3.25)
# A floor includes only floors below it (SOURCE: the source tree).

# may_use(FLOOR FOLDERS...): the files of FLOOR may include only these folders of subcert, beside their own.
function(may_use floor)
  file(GLOB_RECURSE files "${SOURCE}/${floor}/*.hpp" "${SOURCE}/${floor}/*.cpp")
  foreach(file IN LISTS files)
    if(file MATCHES "/(test|fuzz)/" OR (floor STREQUAL "analysis" AND file MATCHES "/analysis/symbol/") OR
       (floor STREQUAL "schemes" AND file MATCHES "/schemes/data/"))
      continue()
    endif()
    file(STRINGS "${file}" includes REGEX "#include <subcert/")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE ".*<subcert/([^>]*)>.*" "\\1" path "${include}")
      set(allowed FALSE)
      foreach(folder IN LISTS ARGN ITEMS ${floor})
        if(path MATCHES "^${folder}/")
          set(allowed TRUE)
        endif()
      endforeach()
      if(NOT allowed)
        message(SEND_ERROR "${file}: ${floor}/ may not include <subcert/${path}>")
      endif()
    endforeach()
  endforeach()
endfunction()

may_use(analysis/symbol)
may_use(analysis analysis/symbol)
may_use(schemes analysis/symbol)
may_use(schemes/data schemes analysis)
may_use(reports analysis schemes proofs-checks)
may_use(proofs-checks analysis schemes)
may_use(cli analysis schemes proofs-checks reports)

# Nothing at the top but what the design names.
file(GLOB entries RELATIVE "${SOURCE}" "${SOURCE}/*")
set(known analysis schemes proofs-checks reports cli bench docs cmake CMakeLists.txt CMakePresets.json README.md
  CHANGELOG.md LICENSE reproduce check build out)
foreach(entry IN LISTS entries)
  if(NOT entry IN_LIST known AND NOT entry MATCHES "^[.]")
    message(SEND_ERROR "the top level has no place for ${entry}")
  endif()
endforeach()
