# Run by CPack when the files of a package are together: what Debian wants to know of the package itself, next to what changed in Knead.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
    return()
endif()
file(GLOB_RECURSE copyright ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/copyright)
if(NOT copyright)
    message(FATAL_ERROR "The folder of documentation is not where it was installed: ${CPACK_TEMPORARY_INSTALL_DIRECTORY}")
endif()
cmake_path(GET copyright PARENT_PATH folder)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${folder}/changelog.Debian
"knead (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Made by ./dev package; changelog.gz says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND gzip -9nf ${folder}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
