// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/reference/comparison_settings.h"

#include <memory>
#include <string>

namespace dyncal {

/// Recipe section "chain": the response of amplifier and converter over frequency, relative to the
/// gain that the records are scaled with. It is divided out of S(f).
struct ChainSettings
{
    std::string source; ///< file, relative to the recipe; "" = none
    std::string sha256; ///< that it must have; "" = any
    std::string quantityId; ///< of the list in a certificate in XML
    std::string certificate; ///< its number, where the file states none

    /// What `source` holds; no key of the recipe: whoever reads a recipe reads the file too.
    std::shared_ptr<const ReferenceSource> loaded;

    bool operator==(const ChainSettings &other) const;
};

} // namespace dyncal
