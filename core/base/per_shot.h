// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace dyncal {

/// A value that is typed once for all shots, or shot by shot (an entry for every shot of the set,
/// empty where that shot has none); nothing at all where neither is typed.
struct PerShot
{
    std::optional<double> common;
    std::vector<std::optional<double>> each;

    PerShot() = default;
    PerShot(double value)
        : common(value)
    {
    }
    explicit PerShot(std::vector<std::optional<double>> list)
        : each(std::move(list))
    {
    }

    /// Of shot `shot` (from 1).
    std::optional<double> of(Index shot) const
    {
        if (each.empty())
            return common;
        const auto at = static_cast<std::size_t>(shot - 1);
        return at < each.size() ? each[at] : std::nullopt;
    }

    bool isTyped() const
    {
        return common.has_value()
            || std::any_of(each.begin(), each.end(), [](const auto &v) { return v.has_value(); });
    }

    /// The same with another value for one shot of `shots`; a single shot has a common value.
    PerShot with(Index shot, Index shots, const std::optional<double> &value) const
    {
        PerShot changed;
        if (shots <= 1) {
            changed.common = value;
            return changed;
        }
        changed.each = each;
        if (each.empty())
            changed.each.assign(static_cast<std::size_t>(shots), common);
        changed.each.resize(static_cast<std::size_t>(shots));
        changed.each.at(static_cast<std::size_t>(shot - 1)) = value;
        return changed.isTyped() ? changed : PerShot();
    }

    bool operator==(const PerShot &) const = default;
};

} // namespace dyncal
