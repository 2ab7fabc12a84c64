# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# What `cmake --install` puts where, in components of which each can be installed by itself:
#   headers   openltc/openltc.h with what it includes, openltc::openltc for CMake, openltc.pc; needs nothing
#   library   the static libraries and their headers; beside `headers`
#   c         libopenltc_c.so, openltc/openltc_c.h and openltc_c.pc; by itself
#   tool      the tool, its man pages, shell completions and documents: cmake/install_tool.cmake
# find_package(openltc) finds the headers, find_package(openltc COMPONENTS library) both.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/openltc)

# Headers.
install(TARGETS openltc_openltc openltc_api openltc_target openltc_shade EXPORT openltc-headers
  COMPONENT headers INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT openltc-headers NAMESPACE openltc:: DESTINATION ${package_dir} COMPONENT headers)
install(FILES openltc/openltc.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/openltc COMPONENT headers)
install(DIRECTORY openltc/api openltc/target openltc/shade
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/openltc COMPONENT headers
  FILES_MATCHING PATTERN "*.h" PATTERN "*.inc" PATTERN "*.glsl")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT headers)

# Libraries.
if(OPENLTC_LIBRARY)
  get_property(folders GLOBAL PROPERTY OPENLTC_LIBRARIES)
  list(REMOVE_ITEM folders openltc api target shade)
  list(TRANSFORM folders PREPEND openltc_ OUTPUT_VARIABLE libraries)
  install(TARGETS ${libraries} EXPORT openltc-library COMPONENT library
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT openltc-library NAMESPACE openltc:: DESTINATION ${package_dir} COMPONENT library)
  install(FILES openltc/batch.h openltc/openltc_c.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/openltc
    COMPONENT library)
  list(TRANSFORM folders PREPEND openltc/)
  install(DIRECTORY ${folders} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/openltc COMPONENT library
    FILES_MATCHING PATTERN "*.h"
    PATTERN embree.h EXCLUDE PATTERN exr_input.h EXCLUDE PATTERN tinygltf.h EXCLUDE
    PATTERN two_lobe_problem.h EXCLUDE)
  # What was found of that which cmake/dependencies.cmake looks for in two ways, for the configuration of the installed package.
  foreach(package hwy meshoptimizer)
    if(${package}_FOUND AND NOT TARGET PkgConfig::${package})
      list(APPEND found_packages ${package})
    endif()
  endforeach()
  foreach(entry "webp;libwebp" "rsvg;librsvg-2.0" "hwy;libhwy")
    list(GET entry 0 name)
    if(TARGET PkgConfig::${name})
      list(APPEND found_modules ${entry})
    endif()
  endforeach()
endif()

configure_package_config_file(cmake/openltc-config.cmake.in ${PROJECT_BINARY_DIR}/openltc-config.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change anything. Headers alone are of no architecture.
set(any_architecture)
if(NOT OPENLTC_LIBRARY)
  set(any_architecture ARCH_INDEPENDENT)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/openltc-config-version.cmake
  COMPATIBILITY SameMinorVersion ${any_architecture})
install(FILES ${PROJECT_BINARY_DIR}/openltc-config.cmake ${PROJECT_BINARY_DIR}/openltc-config-version.cmake
  DESTINATION ${package_dir} COMPONENT headers)

# The folder may be moved afterwards: its path is relative to the .pc file.
file(RELATIVE_PATH include_from_pc ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/openltc.pc.in ${PROJECT_BINARY_DIR}/openltc.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/openltc.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig COMPONENT headers)

# The C API.
if(TARGET openltc_c)
  install(TARGETS openltc_c LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT c NAMELINK_COMPONENT c)
  install(FILES openltc/openltc_c.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/openltc COMPONENT c)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT c)
  file(RELATIVE_PATH include_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
  configure_file(cmake/openltc_c.pc.in ${PROJECT_BINARY_DIR}/openltc_c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/openltc_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT c)
endif()

if(OPENLTC_TOOL)
  include(cmake/install_tool.cmake)
endif()
