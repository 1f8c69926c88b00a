// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/comparison_settings.h"

#include <tuple>

namespace dyncal {
namespace {

auto keysOf(const ComparisonSettings &s)
{
    return std::tie(s.enabled, s.channel, s.source, s.sha256, s.quantityId, s.certificate, s.due,
        s.model, s.unit, s.delay_s, s.u_delay_s, s.correlationWithStep);
}

std::string contentOf(const ComparisonSettings &s)
{
    return s.loaded ? s.loaded->sha256 : std::string();
}

} // namespace

bool ComparisonSettings::operator==(const ComparisonSettings &other) const
{
    return keysOf(*this) == keysOf(other) && contentOf(*this) == contentOf(other);
}

} // namespace dyncal
