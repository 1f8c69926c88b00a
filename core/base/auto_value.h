// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>

namespace dyncal {

/// A setting that is either a value or "auto" (the program's documented rule decides).
template <typename T>
struct Auto
{
    std::optional<T> value; ///< empty = auto

    Auto() = default;
    Auto(T v)
        : value(std::move(v))
    {
    }

    bool isAuto() const { return !value.has_value(); }
    bool operator==(const Auto &) const = default;
};

} // namespace dyncal
