// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/kernel/shading_kernel.h"

#include "openltc/base/processor.h"
#include "openltc/kernel/shading_kernel_variants.h"

#include <string_view>

namespace openltc::kernel {

Kernel kernel_by_name(const char* name) {
  const std::string_view wanted(name);
  const bool any = wanted == "auto";
#if defined(__x86_64__)
  if ((any || wanted == "avx512") && has_avx512()) return avx512::kernel();
  if ((any || wanted == "avx2") && has_avx2()) return avx2::kernel();
  if ((any || wanted == "sse4") && has_sse4()) return sse4::kernel();
#elif defined(__aarch64__)
  if (any || wanted == "neon") return neon::kernel();
#endif
  if (any || wanted == "scalar") return scalar::kernel();
  return {};
}

Kernel best_kernel() { return kernel_by_name("auto"); }

} // namespace openltc::kernel
