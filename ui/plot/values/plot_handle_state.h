// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"

#include <QString>

namespace dyncal {

/// A band over x or (`isLine`) a vertical line, as set by the page.
struct HandleState
{
    QString id;
    QString label;
    bool isLine = false;
    Interval x; ///< of a line: begin == end
    bool movable = true;
    bool snapToIntegers = false;
    bool hatched = false; ///< marks what takes no part

    bool operator==(const HandleState &) const = default;
};

} // namespace dyncal
