// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   shader_statistics [--device NAME] SHADER.spv...
//
// Lets a Vulkan driver compile compute shaders, and prints what it tells of the result
// (VK_KHR_pipeline_executable_properties): the name of the device, then a line of JSON for each
// shader. Nothing runs, so the device may be Mesa's driver for AMD without any: cost.py says how.
// A shader has storage buffers in bindings 0 to 2 of set 0, textures with samplers in 3 to 6. Of
// several devices it takes the first whose name contains NAME.
//
// Exit code 77: there is no such device, or its driver tells nothing.

#include "tests/parity/vulkan_program.h"

#include <cstdio>
#include <cstring>

namespace {

using namespace openltc::testing;

template <class Function> Function function_of(const Device& d, const char* name) {
  return reinterpret_cast<Function>(vkGetDeviceProcAddr(d.device, name));
}

double number_of(const VkPipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
    return double(statistic.value.b32);
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
    return double(statistic.value.i64);
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
    return statistic.value.f64;
  default:
    return double(statistic.value.u64);
  }
}

void print_statistics(const Device& d, VkPipeline pipeline) {
  const auto properties_of = function_of<PFN_vkGetPipelineExecutablePropertiesKHR>(
      d, "vkGetPipelineExecutablePropertiesKHR");
  const auto statistics_of = function_of<PFN_vkGetPipelineExecutableStatisticsKHR>(
      d, "vkGetPipelineExecutableStatisticsKHR");
  VkPipelineInfoKHR whole{};
  whole.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR;
  whole.pipeline = pipeline;
  std::uint32_t count = 1;
  VkPipelineExecutablePropertiesKHR properties{};
  properties.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
  check(properties_of(d.device, &whole, &count, &properties),
        "vkGetPipelineExecutablePropertiesKHR");

  VkPipelineExecutableInfoKHR first{};
  first.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
  first.pipeline = pipeline;
  check(statistics_of(d.device, &first, &count, nullptr), "vkGetPipelineExecutableStatisticsKHR");
  VkPipelineExecutableStatisticKHR none{};
  none.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
  std::vector<VkPipelineExecutableStatisticKHR> statistics(count, none);
  check(statistics_of(d.device, &first, &count, statistics.data()),
        "vkGetPipelineExecutableStatisticsKHR");
  std::printf("{\"lanes\": %u", properties.subgroupSize);
  for (const auto& statistic : statistics)
    std::printf(", \"%s\": %.17g", statistic.name, number_of(statistic));
  std::printf("}\n");
}

} // namespace

int main(int argc, char** argv) {
  const bool named = argc > 2 && std::strcmp(argv[1], "--device") == 0;
  const int first = named ? 3 : 1;
  if (argc <= first) {
    std::fprintf(stderr, "usage: shader_statistics [--device NAME] SHADER.spv...\n");
    return 2;
  }
  VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR told{};
  told.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
  told.pipelineExecutableInfo = VK_TRUE;
  const Device d = open_device(named ? argv[2] : "",
                               VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME, &told);
  std::printf("%s\n", d.name.c_str());
  const VkPipelineLayout layout = make_layout(d, make_set_layout(d, 3, 4));
  for (int i = first; i < argc; ++i)
    print_statistics(d, make_pipeline(d, layout, read_bytes(argv[i]),
                                      VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR));
  return 0;
}
