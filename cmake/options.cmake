# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# openltc::options carries the flags of every target of ours.

add_library(openltc_options INTERFACE)
add_library(openltc::options ALIAS openltc_options)
target_compile_features(openltc_options INTERFACE cxx_std_20)
target_include_directories(openltc_options INTERFACE ${PROJECT_SOURCE_DIR})

# -fno-math-errno: without it sqrt() keeps a call for errno and lanes do not vectorise.
# -ffp-contract=off: the same bytes from every compiler. Targets with the property OPENLTC_FUSE, the
# lanes, may fuse multiply and add.
target_compile_options(openltc_options INTERFACE
  -Wall -Wextra -Wshadow -fno-math-errno
  $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion> # Clang's complains of initialisations too
  -ffp-contract=$<IF:$<BOOL:$<TARGET_PROPERTY:OPENLTC_FUSE>>,fast,off>)
if(OPENLTC_WERROR)
  target_compile_options(openltc_options INTERFACE -Werror)
endif()
if(OPENLTC_SANITIZE)
  target_compile_options(openltc_options INTERFACE
    -fsanitize=${OPENLTC_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # Under sanitizers the lanes, large inlined functions, compile for five minutes each and more. The
  # scalar kernel is the same source and has them; lanes are compared with it.
  target_compile_options(openltc_options INTERFACE
    $<$<BOOL:$<TARGET_PROPERTY:OPENLTC_FUSE>>:-fno-sanitize=all>)
  target_link_options(openltc_options INTERFACE -fsanitize=${OPENLTC_SANITIZE})
endif()

# What shortens a release build; docs/decisions.md, 58. Not in debug builds, where one file changes at a
# time, and where a file that lacks an include of its own has to show.

# Compiles the files of a target `size` at a time, for which their headers, of JSON or CLI11, take
# longer than they do themselves.
function(openltc_batch target size)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()

# Reads what nearly every file of a target includes once, and more headers that are named. Not behind a
# launcher: ccache, as it is set up by itself, keeps nothing that was compiled so.
function(openltc_precompile target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE
      <algorithm> <cmath> <span> <string> <vector> <fmt/format.h> ${ARGN})
  endif()
endfunction()

# The same in the build of quick tests, whose files are to show what they lack: only a header of others that all of
# them read anyway.
function(openltc_precompile_quick target)
  if(OPENLTC_QUICK_TESTS AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
