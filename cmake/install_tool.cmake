# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# The component `tool`, and cpack's .deb and .tar.gz of it. Man pages and completions are made while it
# is installed, from what the tool's --help says.

install(TARGETS openltc RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tool)
install(FILES LICENSE README.md README.zh-CN.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT tool)
install(DIRECTORY docs shaders DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT tool)

# The page of `openltc view`, where `make web` has made it.
install(DIRECTORY out/web/app/ DESTINATION ${CMAKE_INSTALL_DATADIR}/openltc/app COMPONENT tool OPTIONAL)

# Debian has its own places, for what packages bring zsh and for the licence.
install(CODE "
  set(zsh_folder site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\" AND EXISTS /etc/debian_version)
    set(zsh_folder vendor-completions)
    file(INSTALL \"${PROJECT_SOURCE_DIR}/LICENSE\" DESTINATION
      \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}\" RENAME copyright)
  endif()" COMPONENT tool)

if(OPENLTC_PYTHON)
  set(manual ${PROJECT_BINARY_DIR}/manual)
  install(CODE "
    file(REMOVE_RECURSE \"${manual}\")
    execute_process(COMMAND \"${OPENLTC_PYTHON}\" -B \"${PROJECT_SOURCE_DIR}/tools/manual/make_manual.py\"
      \"$<TARGET_FILE:openltc>\" \"${manual}\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT tool)
  install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT tool)
  install(FILES ${manual}/openltc.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME openltc COMPONENT tool)
  install(FILES ${manual}/openltc.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tool)
  install(CODE "
    file(INSTALL \"${manual}/_openltc\" DESTINATION
      \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh/\${zsh_folder}\")
    # What root made in the build folder nobody else could replace.
    file(REMOVE_RECURSE \"${manual}\")" COMPONENT tool)
else()
  message(STATUS "python3 not found: man pages and completions will not be installed")
endif()

if(NOT PROJECT_IS_TOP_LEVEL)
  return() # what is packaged is that project's to say
endif()
set(CPACK_GENERATOR TGZ DEB)
set(CPACK_COMPONENTS_ALL tool)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_NAME openltc)
set(CPACK_PACKAGE_VENDOR "The OpenLTC authors")
set(CPACK_PACKAGE_CONTACT "The OpenLTC authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Physically based area lights by linearly transformed cosines")
set(CPACK_PACKAGE_DESCRIPTION "Renders glTF scenes lit by area lights, in closed form and by an
unbiased reference, compares pictures, fits and converts tables of linearly
transformed cosines.")
string(TOLOWER ${PROJECT_NAME}-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR} CPACK_PACKAGE_FILE_NAME)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # depends on the packages of the libraries that it is linked with
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS fonts-dejavu-core) # letters of openltc plot's .png
include(CPack)
