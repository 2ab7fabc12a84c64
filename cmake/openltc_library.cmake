# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# openltc_library(NAME SOURCES files... PUBLIC targets... PRIVATE targets...)
# makes the folder's library openltc_NAME, known to others as openltc::NAME. Whoever links it finds
# the headers and gets C++20, of what is headers alone C++17, but not our flags: those are openltc::options.

function(openltc_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  if(ARG_SOURCES)
    add_library(openltc_${name} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    set(standard cxx_std_20)
    target_link_libraries(openltc_${name}
      PUBLIC ${ARG_PUBLIC} PRIVATE $<BUILD_INTERFACE:openltc::options> ${ARG_PRIVATE})
    openltc_precompile(openltc_${name})
  else()
    add_library(openltc_${name} INTERFACE)
    set(scope INTERFACE)
    set(standard cxx_std_17)
    target_link_libraries(openltc_${name} INTERFACE ${ARG_PUBLIC})
  endif()
  target_include_directories(openltc_${name} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(openltc_${name} ${scope} ${standard})
  set_property(GLOBAL APPEND PROPERTY OPENLTC_LIBRARIES ${name}) # for cmake/install.cmake
  set_target_properties(openltc_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(openltc::${name} ALIAS openltc_${name})
endfunction()

# Compiles these targets so that a shared library can be made of them. With hidden names, code for any
# address is that of a program. Names that are no targets are passed over.
function(openltc_position_independent)
  foreach(target ${ARGN})
    if(TARGET ${target})
      get_target_property(type ${target} TYPE)
      if(NOT type STREQUAL "INTERFACE_LIBRARY")
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON
          CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
      endif()
    endif()
  endforeach()
endfunction()
