// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/gas_names.h"

#include "core/shock/gas_model.h"

namespace dyncal {
namespace {

std::vector<std::pair<std::string, GasSettings>> makeGases()
{
    std::vector<std::pair<std::string, GasSettings>> gases;
    for (const NamedGas &gas : knownGases())
        gases.emplace_back(gas.name, GasSettings{gas.gamma, gas.molarMass_kg_mol, gas.name});
    gases.emplace_back("humid-air", GasSettings{1.402, 0.028966, "humid-air"});
    return gases;
}

} // namespace

const std::vector<std::pair<std::string, GasSettings>> &namedGases()
{
    static const std::vector<std::pair<std::string, GasSettings>> gases = makeGases();
    return gases;
}

} // namespace dyncal
