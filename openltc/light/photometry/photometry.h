// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Photometric files of either format.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/photometry/ies.h"

#include <string>
#include <string_view>

namespace openltc::light {

/// Whether the name's extension is that of a photometric file: .ies or .ldt, in any case.
bool is_photometric_name(const std::string& path);

/// A photometric file: EULUMDAT where the name ends in .ldt, else LM-63. See parse_ies and
/// parse_ldt. Refuses also what is no regular file (a folder, a pipe, a device), what cannot be
/// read, and more than 16 MiB.
Result<IesProfile> read_photometry(const std::string& path);

/// The same from the file's text, of the format that `name` tells; it stands in for the path in
/// messages.
Result<IesProfile> parse_photometry(std::string_view text, const std::string& name);

/// The profile as the text of an LM-63-2002 file of its own photometric type, which parse_ies reads
/// as the same intensities to ten digits: the least that its symmetry needs, all factors 1, lengths
/// in metres.
std::string to_lm63(const IesProfile& profile);

} // namespace openltc::light
