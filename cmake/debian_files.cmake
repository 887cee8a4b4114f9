# Run by cpack on the files of each Debian package before they are packed: what Debian's policy asks for and an
# installation elsewhere does not.
file(STRINGS "${CPACK_SUBCERT_SOURCE}/CHANGELOG.md" release REGEX "^## ${CPACK_PACKAGE_VERSION} \\(.*\\)$")
string(REGEX REPLACE "^.*\\((.*)\\)$" "\\1" date "${release}")
if(NOT date MATCHES "^[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]$")
  message(FATAL_ERROR "CHANGELOG.md has no heading '## ${CPACK_PACKAGE_VERSION} (YEAR-MONTH-DAY)'")
endif()
execute_process(COMMAND date --utc --rfc-email --date "${date}" OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)

set(contact "${CPACK_PACKAGE_CONTACT}")
if(NOT contact MATCHES "<.*>")
  string(APPEND contact " <>")
endif()

file(READ "${CPACK_SUBCERT_SOURCE}/LICENSE" licence)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)\n+(.*)$" matched "${licence}")
set(holder "${CMAKE_MATCH_1}")
string(STRIP "${CMAKE_MATCH_2}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")

function(compressed)
  execute_process(COMMAND gzip -9n ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component IN ITEMS PROGRAM DEVELOPMENT)
  string(TOLOWER ${component} folder)
  set(package "${CPACK_DEBIAN_${component}_PACKAGE_NAME}")
  set(share "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${folder}${CPACK_PACKAGING_INSTALL_PREFIX}/share")
  set(doc "${share}/doc/${package}")
  file(WRITE "${doc}/copyright" "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: subcert

Files: *
Copyright: ${holder}
License: Expat
 ${licence}
")
  file(WRITE "${doc}/changelog.Debian"
    "${package} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Release ${CPACK_PACKAGE_VERSION}; changelog.gz beside this file says what is new.

 -- ${contact}  ${date}
")
  file(COPY_FILE "${CPACK_SUBCERT_SOURCE}/CHANGELOG.md" "${doc}/changelog")
  compressed("${doc}/changelog" "${doc}/changelog.Debian")
  file(GLOB pages "${share}/man/man1/*.1")
  if(pages)
    compressed(${pages})
  endif()
  # The system has the libraries.
  file(GLOB programs "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${folder}${CPACK_PACKAGING_INSTALL_PREFIX}/bin/*")
  foreach(program IN LISTS programs)
    file(RPATH_REMOVE FILE "${program}")
  endforeach()
  # Where zsh of Debian looks for what packages bring.
  if(EXISTS "${share}/zsh/site-functions")
    file(RENAME "${share}/zsh/site-functions" "${share}/zsh/vendor-completions")
  endif()
  file(GLOB_RECURSE files LIST_DIRECTORIES true "${share}/doc/*")
  foreach(file IN LISTS files)
    if(IS_DIRECTORY "${file}")
      file(CHMOD "${file}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
        WORLD_EXECUTE)
    else()
      file(CHMOD "${file}" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    endif()
  endforeach()
endforeach()
