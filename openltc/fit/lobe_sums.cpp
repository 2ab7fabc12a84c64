// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/lobe_sums.h"

#include "openltc/base/processor.h"

namespace openltc::fit {

LobeSums lobe_sums_baseline();
#ifdef OPENLTC_LOBE_SUMS_AVX2
LobeSums lobe_sums_avx2();
LobeSums lobe_sums_avx512();
#endif

std::vector<LobeSums> all_lobe_sums() {
  std::vector<LobeSums> variants = {lobe_sums_baseline()};
#ifdef OPENLTC_LOBE_SUMS_AVX2
  if (has_avx2()) variants.push_back(lobe_sums_avx2());
  if (has_avx512()) variants.push_back(lobe_sums_avx512());
#endif
  return variants;
}

LobeSums lobe_sums() {
  static const LobeSums best = all_lobe_sums().back();
  return best;
}

} // namespace openltc::fit
