// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/chain_settings.h"

namespace dyncal {
namespace {

std::string hashOf(const ChainSettings &s)
{
    return s.loaded ? s.loaded->sha256 : std::string();
}

} // namespace

bool ChainSettings::operator==(const ChainSettings &other) const
{
    return source == other.source && sha256 == other.sha256 && quantityId == other.quantityId
        && certificate == other.certificate && hashOf(*this) == hashOf(other);
}

} // namespace dyncal
