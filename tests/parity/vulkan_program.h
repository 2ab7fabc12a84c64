// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What programs that give shaders to Vulkan share: a device, and pipelines of compute shaders. Such
// a program ends with its process, so nothing is freed, and what fails ends it with a message.

#pragma once

#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace openltc::testing {

/// Ends the program with exit code 1 unless `result` is VK_SUCCESS; `what` names the call.
void check(VkResult result, const char* what);

/// The bytes of a file; without any the program ends with exit code 1.
std::vector<char> read_bytes(const char* path);

/// Ends the program with exit code 77, and a line on standard output that says `why`.
[[noreturn]] void skip(const char* why);

/// A device, and one queue of it that computes.
struct Device {
  VkPhysicalDevice physical = nullptr;
  VkDevice device = nullptr;
  VkQueue queue = nullptr;
  VkCommandPool commands = nullptr;
  std::string name;
};

/// The first device whose name contains `wanted`, in capitals or not, with an extension and its
/// structure of features, or without where these are null. Where there is none, `skip`.
Device open_device(const std::string& wanted, const char* extension = nullptr,
                   const void* features = nullptr);

/// Set 0 of a compute shader: storage buffers in the first bindings, then textures with samplers.
VkDescriptorSetLayout make_set_layout(const Device& d, int buffers, int textures = 0);

/// A layout of that set alone.
VkPipelineLayout make_layout(const Device& d, VkDescriptorSetLayout set);

/// The pipeline of a compute shader, whose entry point is "main".
VkPipeline make_pipeline(const Device& d, VkPipelineLayout layout, const std::vector<char>& spirv,
                         VkPipelineCreateFlags flags = 0);

} // namespace openltc::testing
