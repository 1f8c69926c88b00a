// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/reference/comparison_settings.h"
#include "core/reference/reference_dcc.h"

#include <memory>
#include <string>

namespace dyncal {

/// A file that states a response over frequency, as a section of the recipe names it.
struct CertifiedSource
{
    std::string section; ///< "comparison", "chain": for sentences
    std::string path; ///< as the recipe has it
    std::string sha256; ///< that it must have; "" = any
    std::string quantityId;
    std::string unit; ///< of the magnitudes, "1" of a ratio
    std::shared_ptr<const ReferenceSource> loaded; ///< null where it could not be read
    bool isRatio = false; ///< to its first row, of which 0 is then the uncertainty
};

/// What a file of a recipe's section states, as XML (DCC) or CSV. Fails (FileUnreadable) where it
/// was not read, (DataBlocked) where it has another hash, and (Usage) as readReferenceDcc() and
/// readReferenceCsv(), and on an uncertainty of 0, which counts as unknown, unless it is a ratio.
Result<CertifiedReference> readCertifiedSource(const CertifiedSource &source);

} // namespace dyncal
