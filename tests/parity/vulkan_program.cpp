// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/parity/vulkan_program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

namespace openltc::testing {

void check(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  std::fprintf(stderr, "%s gives VkResult %d\n", what, int(result));
  std::exit(1);
}

std::vector<char> read_bytes(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty()) {
    std::fprintf(stderr, "cannot read %s\n", path);
    std::exit(1);
  }
  return bytes;
}

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return text;
}

std::uint32_t compute_family(VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i)
    if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return i;
  return count;
}

} // namespace

void skip(const char* why) {
  std::printf("skipped: %s\n", why);
  std::exit(77);
}

Device open_device(const std::string& wanted, const char* extension, const void* features) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.apiVersion = VK_API_VERSION_1_1;
  VkInstanceCreateInfo create{};
  create.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  create.pApplicationInfo = &application;
  VkInstance instance = nullptr;
  if (vkCreateInstance(&create, nullptr, &instance) != VK_SUCCESS) skip("no Vulkan driver");
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> all(count);
  vkEnumeratePhysicalDevices(instance, &count, all.data());

  Device d;
  for (VkPhysicalDevice physical : all) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    if (lower(properties.deviceName).find(lower(wanted)) == std::string::npos) continue;
    d.physical = physical;
    d.name = properties.deviceName;
    break;
  }
  if (!d.physical) skip("no Vulkan device of that name");

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = compute_family(d.physical);
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.pNext = features;
  info.enabledExtensionCount = extension ? 1 : 0;
  info.ppEnabledExtensionNames = &extension;
  const VkResult made = vkCreateDevice(d.physical, &info, nullptr, &d.device);
  if (made == VK_ERROR_EXTENSION_NOT_PRESENT || made == VK_ERROR_FEATURE_NOT_PRESENT)
    skip((d.name + " has no " + extension).c_str());
  check(made, "vkCreateDevice");
  vkGetDeviceQueue(d.device, queue.queueFamilyIndex, 0, &d.queue);
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.queueFamilyIndex = queue.queueFamilyIndex;
  check(vkCreateCommandPool(d.device, &pool, nullptr, &d.commands), "vkCreateCommandPool");
  return d;
}

VkDescriptorSetLayout make_set_layout(const Device& d, int buffers, int textures) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (int i = 0; i < buffers + textures; ++i)
    bindings.push_back({std::uint32_t(i),
                        i < buffers ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                    : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = std::uint32_t(bindings.size());
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = nullptr;
  check(vkCreateDescriptorSetLayout(d.device, &info, nullptr, &layout),
        "vkCreateDescriptorSetLayout");
  return layout;
}

VkPipelineLayout make_layout(const Device& d, VkDescriptorSetLayout set) {
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  VkPipelineLayout layout = nullptr;
  check(vkCreatePipelineLayout(d.device, &info, nullptr, &layout), "vkCreatePipelineLayout");
  return layout;
}

VkPipeline make_pipeline(const Device& d, VkPipelineLayout layout, const std::vector<char>& spirv,
                         VkPipelineCreateFlags flags) {
  std::vector<std::uint32_t> words(spirv.size() / 4);
  std::memcpy(words.data(), spirv.data(), words.size() * 4);
  VkShaderModuleCreateInfo source{};
  source.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  source.codeSize = words.size() * 4;
  source.pCode = words.data();
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.flags = flags;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.pName = "main";
  info.layout = layout;
  check(vkCreateShaderModule(d.device, &source, nullptr, &info.stage.module),
        "vkCreateShaderModule");
  VkPipeline pipeline = nullptr;
  check(vkCreateComputePipelines(d.device, nullptr, 1, &info, nullptr, &pipeline),
        "vkCreateComputePipelines");
  return pipeline;
}

} // namespace openltc::testing
