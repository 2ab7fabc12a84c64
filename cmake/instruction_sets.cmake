# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# The instruction sets that a file is compiled for, and their flags. At run time openltc/base/processor.h
# says which of them the machine has; the two change together.
#
# openltc_per_instruction_set(TARGET FILE.cpp NAME [FUSE] [BASELINE] [SETS set...] [DEFINE PREFIX]
#   [LINK target...] [OPTIONS flag...])
# compiles the file once for each set, as the object library NAME_SET, and adds the objects to TARGET.
# The file finds OPENLTC_ISA, the set's name, and OPENLTC_LANES, its registers' width in floats.
#   FUSE      multiply and add may be fused, as in the shading kernels
#   BASELINE  on other machines than x86 once, as the set `baseline`
#   SETS      those of them that the machine's compiler can make; by default all but `baseline`
#   DEFINE    TARGET finds PREFIX_SET, in capitals, defined for each

# What the compiler makes without flags.
set(OPENLTC_LANES_baseline 4)

# Highway chooses its instruction set by the compiler's flags and wants AES and PCLMUL beside each;
# without them it falls back to a narrower one.
set(OPENLTC_INSTRUCTION_SETS)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(OPENLTC_ARCHITECTURE x86)
  set(OPENLTC_INSTRUCTION_SETS sse4 avx2 avx512)
  set(OPENLTC_LANES_sse4 4)
  set(OPENLTC_LANES_avx2 8)
  set(OPENLTC_LANES_avx512 16)
  set(OPENLTC_FLAGS_sse4 -msse4.2 -maes -mpclmul)
  set(OPENLTC_FLAGS_avx2 ${OPENLTC_FLAGS_sse4} -mavx2 -mfma -mbmi -mbmi2 -mf16c)
  set(OPENLTC_FLAGS_avx512 ${OPENLTC_FLAGS_avx2} -mavx512f -mavx512bw -mavx512cd -mavx512dq -mavx512vl)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  set(OPENLTC_ARCHITECTURE arm)
  set(OPENLTC_INSTRUCTION_SETS neon)
  set(OPENLTC_LANES_neon 4)
endif()

function(openltc_per_instruction_set target file name)
  cmake_parse_arguments(ARG "FUSE;BASELINE" "DEFINE" "SETS;LINK;OPTIONS" ${ARGN})
  set(sets ${OPENLTC_INSTRUCTION_SETS})
  if(ARG_BASELINE AND NOT OPENLTC_ARCHITECTURE STREQUAL "x86")
    set(sets baseline)
  elseif(ARG_SETS)
    set(sets)
    foreach(isa ${ARG_SETS})
      if(isa STREQUAL "baseline" OR isa IN_LIST OPENLTC_INSTRUCTION_SETS)
        list(APPEND sets ${isa})
      endif()
    endforeach()
  endif()
  foreach(isa ${sets})
    set(objects ${name}_${isa})
    add_library(${objects} OBJECT ${file})
    target_link_libraries(${objects} PRIVATE openltc::options ${ARG_LINK})
    target_compile_definitions(${objects} PRIVATE OPENLTC_ISA=${isa} OPENLTC_LANES=${OPENLTC_LANES_${isa}})
    target_compile_options(${objects} PRIVATE ${ARG_OPTIONS} ${OPENLTC_FLAGS_${isa}})
    if(ARG_FUSE)
      set_target_properties(${objects} PROPERTIES OPENLTC_FUSE ON)
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
    set_property(GLOBAL APPEND PROPERTY OPENLTC_OBJECTS ${objects}) # for python/CMakeLists.txt
    if(ARG_DEFINE)
      string(TOUPPER ${ARG_DEFINE}_${isa} defined)
      target_compile_definitions(${target} PRIVATE ${defined})
    endif()
  endforeach()
endfunction()
