// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   vkrun [--device NAME] POLYGONS.bin {SHADER.spv CASES.bin RESULTS.bin}...
//
// Runs compute shaders over cases by Vulkan and writes what each gives. A shader has storage
// buffers of set 0: 0 the cases, 112 bytes each; 1 the polygons; 2 the results, 16 bytes a case; it
// is dispatched in groups of 64 of them. Of several devices it takes the first whose name contains
// NAME. It prints the name of the device, then a line for each shader: milliseconds to make the
// pipeline, nanoseconds a case, the best of three runs.
//
// Exit code 77: there is no such device.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace {

constexpr std::size_t k_case_bytes = 112, k_result_bytes = 16, k_group = 64;

void check(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  std::fprintf(stderr, "vkrun: %s gives VkResult %d\n", what, int(result));
  std::exit(1);
}

std::vector<char> read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty()) {
    std::fprintf(stderr, "vkrun: cannot read %s\n", path);
    std::exit(1);
  }
  return bytes;
}

double now() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return text;
}

/// A device, one queue of it, and what is needed of both. The process ends with it, so nothing is
/// freed.
struct Device {
  VkPhysicalDevice physical = nullptr;
  VkDevice device = nullptr;
  VkQueue queue = nullptr;
  VkCommandPool commands = nullptr;
  std::string name;
};

std::uint32_t compute_family(VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i)
    if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return i;
  return count;
}

[[noreturn]] void skip(const char* what) {
  std::printf("skipped: %s\n", what);
  std::exit(77);
}

Device open_device(const std::string& wanted) {
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
  check(vkCreateDevice(d.physical, &info, nullptr, &d.device), "vkCreateDevice");
  vkGetDeviceQueue(d.device, queue.queueFamilyIndex, 0, &d.queue);
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.queueFamilyIndex = queue.queueFamilyIndex;
  check(vkCreateCommandPool(d.device, &pool, nullptr, &d.commands), "vkCreateCommandPool");
  return d;
}

/// A storage buffer that the processor reads and writes too.
struct Buffer {
  VkBuffer buffer = nullptr;
  void* bytes = nullptr;
};

Buffer make_buffer(const Device& d, std::size_t size) {
  Buffer b;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = size;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  check(vkCreateBuffer(d.device, &info, nullptr, &b.buffer), "vkCreateBuffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(d.device, b.buffer, &needs);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(d.physical, &memory);
  constexpr VkMemoryPropertyFlags k_shared =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  VkMemoryAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocate.allocationSize = needs.size;
  while (allocate.memoryTypeIndex < memory.memoryTypeCount &&
         !((needs.memoryTypeBits >> allocate.memoryTypeIndex & 1) &&
           (memory.memoryTypes[allocate.memoryTypeIndex].propertyFlags & k_shared) == k_shared))
    ++allocate.memoryTypeIndex;
  VkDeviceMemory held = nullptr;
  check(vkAllocateMemory(d.device, &allocate, nullptr, &held), "vkAllocateMemory");
  check(vkBindBufferMemory(d.device, b.buffer, held, 0), "vkBindBufferMemory");
  check(vkMapMemory(d.device, held, 0, VK_WHOLE_SIZE, 0, &b.bytes), "vkMapMemory");
  return b;
}

Buffer make_buffer(const Device& d, const std::vector<char>& content) {
  const Buffer b = make_buffer(d, content.size());
  std::memcpy(b.bytes, content.data(), content.size());
  return b;
}

VkDescriptorSetLayout make_set_layout(const Device& d) {
  VkDescriptorSetLayoutBinding bindings[3] = {};
  for (std::uint32_t i = 0; i < 3; ++i)
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = 3;
  info.pBindings = bindings;
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

VkPipeline make_pipeline(const Device& d, VkPipelineLayout layout, const std::vector<char>& spirv) {
  std::vector<std::uint32_t> words(spirv.size() / 4);
  std::memcpy(words.data(), spirv.data(), words.size() * 4);
  VkShaderModuleCreateInfo source{};
  source.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  source.codeSize = words.size() * 4;
  source.pCode = words.data();
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
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

VkDescriptorSet make_set(const Device& d, VkDescriptorSetLayout layout,
                         const Buffer (&buffers)[3]) {
  const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 3};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  VkDescriptorSetAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &layout;
  check(vkCreateDescriptorPool(d.device, &pool, nullptr, &allocate.descriptorPool),
        "vkCreateDescriptorPool");
  VkDescriptorSet set = nullptr;
  check(vkAllocateDescriptorSets(d.device, &allocate, &set), "vkAllocateDescriptorSets");
  for (std::uint32_t i = 0; i < 3; ++i) {
    const VkDescriptorBufferInfo whole = {buffers[i].buffer, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &whole;
    vkUpdateDescriptorSets(d.device, 1, &write, 0, nullptr);
  }
  return set;
}

/// Runs it; seconds.
double dispatch(const Device& d, VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set,
                std::uint32_t groups) {
  VkCommandBufferAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  allocate.commandPool = d.commands;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = nullptr;
  check(vkAllocateCommandBuffers(d.device, &allocate, &commands), "vkAllocateCommandBuffers");
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
  vkCmdDispatch(commands, groups, 1, 1);
  VkMemoryBarrier written{};
  written.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                       0, 1, &written, 0, nullptr, 0, nullptr);
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  const double start = now();
  check(vkQueueSubmit(d.queue, 1, &submit, nullptr), "vkQueueSubmit");
  check(vkQueueWaitIdle(d.queue), "vkQueueWaitIdle");
  return now() - start;
}

void run(const Device& d, const Buffer& polygons, char** files) {
  const std::vector<char> cases = read(files[1]);
  const std::size_t count = cases.size() / k_case_bytes;
  const Buffer buffers[3] = {make_buffer(d, cases), polygons,
                             make_buffer(d, count * k_result_bytes)};
  const VkDescriptorSetLayout set_layout = make_set_layout(d);
  const VkPipelineLayout layout = make_layout(d, set_layout);
  const double start = now();
  const VkPipeline pipeline = make_pipeline(d, layout, read(files[0]));
  const double made = now() - start;
  const VkDescriptorSet set = make_set(d, set_layout, buffers);
  double best = 1e9;
  for (int i = 0; i < 3; ++i)
    best = std::min(best, dispatch(d, pipeline, layout, set, std::uint32_t(count / k_group)));
  std::ofstream out(files[2], std::ios::binary);
  out.write(static_cast<const char*>(buffers[2].bytes), std::streamsize(count * k_result_bytes));
  if (!out) {
    std::fprintf(stderr, "vkrun: cannot write %s\n", files[2]);
    std::exit(1);
  }
  std::printf("%.0f %.1f\n", made * 1e3, best / double(count) * 1e9);
}

} // namespace

int main(int argc, char** argv) {
  int first = 1;
  std::string wanted;
  if (argc > 3 && std::strcmp(argv[1], "--device") == 0) {
    wanted = argv[2];
    first = 3;
  }
  if (argc - first < 4 || (argc - first - 1) % 3 != 0) {
    std::fprintf(
        stderr,
        "usage: vkrun [--device NAME] POLYGONS.bin {SHADER.spv CASES.bin RESULTS.bin}...\n");
    return 2;
  }
  const Device d = open_device(wanted);
  std::printf("%s\n", d.name.c_str());
  const Buffer polygons = make_buffer(d, read(argv[first]));
  for (int i = first + 1; i < argc; i += 3)
    run(d, polygons, argv + i);
  return 0;
}
