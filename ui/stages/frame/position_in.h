// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <iterator>

namespace dyncal {

/// The row of `value` in a combo box that shows `list`; the first row if it is not in the list.
template <typename List, typename T>
int positionIn(const List &list, const T &value)
{
    const auto at = std::ranges::find(list, value);
    return at == std::end(list) ? 0 : static_cast<int>(at - std::begin(list));
}

} // namespace dyncal
