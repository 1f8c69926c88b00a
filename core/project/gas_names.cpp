// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/gas_names.h"

namespace dyncal {

const std::vector<std::pair<std::string, GasSettings>> &namedGases()
{
    static const std::vector<std::pair<std::string, GasSettings>> gases{
        {"air", GasSettings{1.402, 0.028966}},
        {"n2", GasSettings{7.0 / 5.0, 0.028014}},
        {"he", GasSettings{5.0 / 3.0, 0.0040026}},
        {"ar", GasSettings{5.0 / 3.0, 0.039948}},
    };
    return gases;
}

} // namespace dyncal
