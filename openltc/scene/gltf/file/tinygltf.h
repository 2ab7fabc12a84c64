// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// tinygltf without its own readers and writers of pictures: image/ has them. Private to the .cpp
// files of this folder.

#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>
