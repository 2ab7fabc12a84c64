# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# openltc_library(NAME SOURCES files... PUBLIC targets... PRIVATE targets...)
# makes the folder's library openltc_NAME, known to others as openltc::NAME.

function(openltc_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  if(ARG_SOURCES)
    add_library(openltc_${name} STATIC ${ARG_SOURCES})
    target_link_libraries(openltc_${name} PUBLIC openltc::options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  else()
    add_library(openltc_${name} INTERFACE)
    target_link_libraries(openltc_${name} INTERFACE openltc::options ${ARG_PUBLIC})
  endif()
  add_library(openltc::${name} ALIAS openltc_${name})
endfunction()
