// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Area lights in plain Vulkan, without a window: a quad and a star over a dark floor, as in
// scenes/engines.glb.
//
//   glslangValidator -V vulkan.comp -o vulkan.spv
//   c++ -std=c++17 -I../../.. vulkan.cpp -lvulkan -o vulkan
//   ./vulkan vulkan.spv picture.pfm [DEVICE]
//
// picture.pfm holds radiance. DEVICE is a part of the name of the graphics processor to take. Exit
// code 2: there is none.

#include "scene.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace {

constexpr std::uint32_t k_group = 8; // pixels a side, as in vulkan.comp

// The process ends with the picture, so nothing is freed.

void check(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  std::fprintf(stderr, "%s gives VkResult %d\n", what, int(result));
  std::exit(1);
}
#define CHECK(call) check(call, #call)

/// A structure of Vulkan, empty but for its type.
template <class T> T make(VkStructureType type) {
  T made{};
  made.sType = type;
  return made;
}

VkPhysicalDevice find_device(const std::string& wanted) {
  auto application = make<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.apiVersion = VK_API_VERSION_1_1;
  auto info = make<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  VkInstance instance = nullptr;
  std::uint32_t count = 0;
  std::vector<VkPhysicalDevice> all;
  if (vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS) {
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    all.resize(count);
    vkEnumeratePhysicalDevices(instance, &count, all.data());
  }
  for (VkPhysicalDevice device : all) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    if (std::strstr(properties.deviceName, wanted.c_str()) == nullptr) continue;
    std::printf("%s\n", properties.deviceName);
    return device;
  }
  std::fprintf(stderr, "no Vulkan device whose name contains \"%s\"\n", wanted.c_str());
  std::exit(2);
}

struct Device {
  VkPhysicalDevice physical = nullptr;
  VkDevice device = nullptr;
  std::uint32_t family = 0; ///< of its queues, one that computes
};

Device open_device(const std::string& wanted) {
  Device d;
  d.physical = find_device(wanted);
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(d.physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(d.physical, &count, families.data());
  while (d.family + 1 < count && !(families[d.family].queueFlags & VK_QUEUE_COMPUTE_BIT))
    ++d.family;

  const float priority = 1;
  auto queue = make<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueFamilyIndex = d.family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = make<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  CHECK(vkCreateDevice(d.physical, &info, nullptr, &d.device));
  return d;
}

/// A buffer that the processor reads and writes too.
struct Buffer {
  VkBuffer buffer = nullptr;
  float* numbers = nullptr;
};

Buffer make_buffer(const Device& d, VkBufferUsageFlags usage, std::size_t number_count) {
  Buffer b;
  auto info = make<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = number_count * sizeof(float);
  info.usage = usage;
  CHECK(vkCreateBuffer(d.device, &info, nullptr, &b.buffer));
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(d.device, b.buffer, &needs);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(d.physical, &memory);
  const VkMemoryPropertyFlags wanted =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  auto allocate = make<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
  allocate.allocationSize = needs.size;
  while (!(needs.memoryTypeBits >> allocate.memoryTypeIndex & 1) ||
         (memory.memoryTypes[allocate.memoryTypeIndex].propertyFlags & wanted) != wanted)
    ++allocate.memoryTypeIndex; // there is always one
  VkDeviceMemory bytes = nullptr;
  CHECK(vkAllocateMemory(d.device, &allocate, nullptr, &bytes));
  CHECK(vkBindBufferMemory(d.device, b.buffer, bytes, 0));
  void* mapped = nullptr;
  CHECK(vkMapMemory(d.device, bytes, 0, VK_WHOLE_SIZE, 0, &mapped));
  b.numbers = static_cast<float*>(mapped);
  return b;
}

std::vector<std::uint32_t> read_spirv(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (words.empty()) {
    std::fprintf(stderr, "%s: cannot be read\n", path);
    std::exit(1);
  }
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

/// The compute pipeline, and what binds its two buffers.
struct Kernel {
  VkPipeline pipeline = nullptr;
  VkPipelineLayout layout = nullptr;
  VkDescriptorSet set = nullptr;
};

Kernel make_kernel(const Device& d, const std::vector<std::uint32_t>& spirv, VkBuffer scene,
                   VkBuffer picture) {
  Kernel k;
  const VkDescriptorType types[] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
  VkDescriptorSetLayoutBinding bindings[2];
  VkDescriptorPoolSize sizes[2];
  for (std::uint32_t i = 0; i < 2; ++i) {
    bindings[i] = {i, types[i], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    sizes[i] = {types[i], 1};
  }
  auto set_info =
      make<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  set_info.bindingCount = 2;
  set_info.pBindings = bindings;
  VkDescriptorSetLayout set_layout = nullptr;
  CHECK(vkCreateDescriptorSetLayout(d.device, &set_info, nullptr, &set_layout));
  auto layout = make<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout;
  CHECK(vkCreatePipelineLayout(d.device, &layout, nullptr, &k.layout));

  auto source = make<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  source.codeSize = spirv.size() * sizeof(std::uint32_t);
  source.pCode = spirv.data();
  auto info = make<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
  info.layout = k.layout;
  info.stage =
      make<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.pName = "main";
  CHECK(vkCreateShaderModule(d.device, &source, nullptr, &info.stage.module));
  CHECK(vkCreateComputePipelines(d.device, nullptr, 1, &info, nullptr, &k.pipeline));

  auto pool = make<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  pool.maxSets = 1;
  pool.poolSizeCount = 2;
  pool.pPoolSizes = sizes;
  auto allocate = make<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &set_layout;
  CHECK(vkCreateDescriptorPool(d.device, &pool, nullptr, &allocate.descriptorPool));
  CHECK(vkAllocateDescriptorSets(d.device, &allocate, &k.set));
  const VkBuffer buffers[] = {scene, picture};
  for (std::uint32_t i = 0; i < 2; ++i) {
    const VkDescriptorBufferInfo whole = {buffers[i], 0, VK_WHOLE_SIZE};
    auto write = make<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    write.dstSet = k.set;
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = types[i];
    write.pBufferInfo = &whole;
    vkUpdateDescriptorSets(d.device, 1, &write, 0, nullptr);
  }
  return k;
}

/// Draws, and waits until the picture can be read.
void run(const Device& d, const Kernel& k) {
  auto pool = make<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  pool.queueFamilyIndex = d.family;
  auto allocate = make<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = nullptr;
  CHECK(vkCreateCommandPool(d.device, &pool, nullptr, &allocate.commandPool));
  CHECK(vkAllocateCommandBuffers(d.device, &allocate, &commands));
  const auto begin = make<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  CHECK(vkBeginCommandBuffer(commands, &begin));
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, k.pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, k.layout, 0, 1, &k.set, 0,
                          nullptr);
  vkCmdDispatch(commands, (k_width + k_group - 1) / k_group, (k_height + k_group - 1) / k_group, 1);
  auto written = make<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                       0, 1, &written, 0, nullptr, 0, nullptr);
  CHECK(vkEndCommandBuffer(commands));
  auto submit = make<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  VkQueue queue = nullptr;
  vkGetDeviceQueue(d.device, d.family, 0, &queue);
  CHECK(vkQueueSubmit(queue, 1, &submit, nullptr));
  CHECK(vkQueueWaitIdle(queue));
}

/// A portable float map, whose rows run from the bottom as well.
bool write_pfm(const char* path, const float* rgba) {
  std::ofstream out(path, std::ios::binary);
  out << "PF\n" << k_width << ' ' << k_height << "\n-1.0\n";
  for (std::size_t i = 0; i < std::size_t(k_width) * k_height; ++i)
    out.write(reinterpret_cast<const char*>(rgba + 4 * i), 3 * sizeof(float));
  return bool(out.flush());
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: vulkan SHADER.spv PICTURE.pfm [DEVICE]\n");
    return 1;
  }
  const Device device = open_device(argc > 3 ? argv[3] : "");
  const Block block = make_scene();
  const Buffer scene =
      make_buffer(device, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, block.numbers.size());
  const Buffer picture =
      make_buffer(device, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, std::size_t(4) * k_width * k_height);
  std::memcpy(scene.numbers, block.numbers.data(), block.numbers.size() * sizeof(float));
  run(device, make_kernel(device, read_spirv(argv[1]), scene.buffer, picture.buffer));
  if (!write_pfm(argv[2], picture.numbers)) {
    std::fprintf(stderr, "%s: cannot be written\n", argv[2]);
    return 1;
  }
  return 0;
}
