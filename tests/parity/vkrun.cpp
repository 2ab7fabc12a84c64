// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   vkrun [--device NAME] POLYGONS.bin {SHADER.spv CASES.bin RESULTS.bin}...
//
// Runs compute shaders over cases by Vulkan and writes what each gives. A shader has storage
// buffers of set 0: 0 the cases, 112 bytes each; 1 the polygons; 2 the results, 16 bytes a case; it
// is dispatched in groups of 64 of them. Of several devices it takes the first whose name contains
// NAME. It prints the name of the device, then a line for each shader: milliseconds to make the
// pipeline, nanoseconds a case, and those of all processors, each the best of three runs.
//
// Exit code 77: there is no such device.

#include "tests/parity/vulkan_program.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace openltc::testing;

constexpr std::size_t k_case_bytes = 112, k_result_bytes = 16, k_group = 64;

double now() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
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

/// What a run took, in seconds: of the clock, and of all processors.
struct Times {
  double wall = 1e9, processor = 1e9;
};

/// Runs it.
Times dispatch(const Device& d, VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set,
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
  const std::clock_t processor = std::clock();
  const double start = now();
  check(vkQueueSubmit(d.queue, 1, &submit, nullptr), "vkQueueSubmit");
  check(vkQueueWaitIdle(d.queue), "vkQueueWaitIdle");
  return {now() - start, double(std::clock() - processor) / CLOCKS_PER_SEC};
}

void run(const Device& d, const Buffer& polygons, char** files) {
  const std::vector<char> cases = read_bytes(files[1]);
  const std::size_t count = cases.size() / k_case_bytes;
  const Buffer buffers[3] = {make_buffer(d, cases), polygons,
                             make_buffer(d, count * k_result_bytes)};
  const VkDescriptorSetLayout set_layout = make_set_layout(d, 3);
  const VkPipelineLayout layout = make_layout(d, set_layout);
  const double start = now();
  const VkPipeline pipeline = make_pipeline(d, layout, read_bytes(files[0]));
  const double made = now() - start;
  const VkDescriptorSet set = make_set(d, set_layout, buffers);
  Times best;
  for (int i = 0; i < 3; ++i) {
    const Times times = dispatch(d, pipeline, layout, set, std::uint32_t(count / k_group));
    best = {std::min(best.wall, times.wall), std::min(best.processor, times.processor)};
  }
  std::ofstream out(files[2], std::ios::binary);
  out.write(static_cast<const char*>(buffers[2].bytes), std::streamsize(count * k_result_bytes));
  if (!out) {
    std::fprintf(stderr, "vkrun: cannot write %s\n", files[2]);
    std::exit(1);
  }
  std::printf("%.0f %.1f %.1f\n", made * 1e3, best.wall / double(count) * 1e9,
              best.processor / double(count) * 1e9);
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
  const Buffer polygons = make_buffer(d, read_bytes(argv[first]));
  for (int i = first + 1; i < argc; i += 3)
    run(d, polygons, argv + i);
  return 0;
}
