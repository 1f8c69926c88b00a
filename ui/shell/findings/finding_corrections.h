// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/capture_set.h"
#include "core/project/recipe.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace dyncal {

/// One way to settle a finding: an edit of the recipe, as one step of undo. Nothing on disk
/// changes.
struct OfferedCorrection
{
    QString label; ///< of the button: "Invert polarity"
    QString step; ///< of undo: "Invert the DUT's polarity"
    QString question; ///< asks for a reason, which the certificate prints; empty = none needed
    /// Changes the import section; `reason` is what the question was answered with.
    std::function<void(ImportSettings &settings, const std::string &reason)> apply;
    QString importPath; ///< not empty: shows the import settings of this file instead
    std::optional<Correction> ofFinding; ///< or the change that the finding itself proposes
};

/// The ways there are, the best first; none for most findings. `set` are the recordings on show,
/// with the import section applied; `all` the findings that there are beside this one.
std::vector<OfferedCorrection> correctionsOf(
    const Finding &finding, const CaptureSet &set, const Findings &all = {});

} // namespace dyncal
