# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Every library comes from the distribution; tools/packages.txt lists the packages.

find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(fmt REQUIRED)
if(OPENLTC_TOOL)
  find_package(CLI11 REQUIRED)
endif()
find_package(PNG REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(draco REQUIRED)
find_package(hwy QUIET)
if(NOT TARGET hwy::hwy) # Ubuntu 22.04's package has no CMake file
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(hwy REQUIRED IMPORTED_TARGET GLOBAL libhwy)
  add_library(hwy::hwy ALIAS PkgConfig::hwy)
endif()
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)

# Embree 3 or 4; render/embree.h hides the difference.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()

# Optional: not every distribution packages it.
find_package(meshoptimizer QUIET)
if(NOT meshoptimizer_FOUND)
  message(STATUS "meshoptimizer not found: glTF files with EXT_meshopt_compression will be refused")
endif()

# Optional: PNG pictures of figures.
find_package(PkgConfig QUIET)
option(OPENLTC_PNG_FIGURES "PNG pictures of figures, where librsvg is" ON)
if(PKG_CONFIG_FOUND AND OPENLTC_PNG_FIGURES)
  pkg_check_modules(rsvg QUIET IMPORTED_TARGET GLOBAL librsvg-2.0)
endif()
if(NOT TARGET PkgConfig::rsvg)
  message(STATUS "librsvg not found: openltc plot writes .svg only")
endif()

# Optional: textures in WebP.
if(PKG_CONFIG_FOUND)
  pkg_check_modules(webp QUIET IMPORTED_TARGET GLOBAL libwebp)
endif()
if(NOT TARGET PkgConfig::webp)
  message(STATUS "libwebp not found: WebP textures will be left out, with a warning")
endif()

# Debian's CMake may otherwise pick a Python that is not the distribution's.
find_program(OPENLTC_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
