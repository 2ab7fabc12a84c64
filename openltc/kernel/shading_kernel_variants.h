// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The compiled kernels, one namespace each; private to render/.

#pragma once

#include "openltc/kernel/shading_kernel.h"

namespace openltc::kernel {

namespace scalar {
Kernel kernel();
}
namespace sse4 {
Kernel kernel();
}
namespace avx2 {
Kernel kernel();
}
namespace avx512 {
Kernel kernel();
}
namespace neon {
Kernel kernel();
}

} // namespace openltc::kernel
