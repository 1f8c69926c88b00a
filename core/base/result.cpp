// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/result.h"

#include <iterator>
#include <utility>

namespace dyncal {

Error asOneError(std::vector<Error> errors)
{
    Error first = std::move(errors.front());
    for (std::size_t i = 1; i < errors.size(); ++i) {
        std::vector<Error> behind = std::move(errors[i].further);
        errors[i].further.clear();
        first.further.push_back(std::move(errors[i]));
        first.further.insert(first.further.end(), std::make_move_iterator(behind.begin()),
            std::make_move_iterator(behind.end()));
    }
    return first;
}

} // namespace dyncal
