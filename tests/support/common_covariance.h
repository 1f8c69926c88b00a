// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/propagation.h"

#include <algorithm>

namespace dyncal::testing {

/// Covariance of one result between two shots: the lines common to both, matched by name.
inline double commonCovariance(const GumBudget &a, const GumBudget &b, Index result)
{
    double covariance = 0.0;
    for (const BudgetLine &line : a.lines) {
        const auto same = std::find_if(b.lines.begin(), b.lines.end(),
            [&](const BudgetLine &other) { return other.input.quantity == line.input.quantity; });
        if (line.input.common && same != b.lines.end())
            covariance += line.contribution[result] * same->contribution[result];
    }
    return covariance;
}

} // namespace dyncal::testing
