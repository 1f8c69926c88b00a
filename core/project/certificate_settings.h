// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <map>
#include <string>
#include <vector>

namespace dyncal {

/// A caution that the operator accepts, with the reason.
struct Acknowledgement
{
    std::string finding;
    Index shot = 0;
    std::string reason;
    bool operator==(const Acknowledgement &) const = default;
};

/// Recipe section "certificate": what is printed but not computed. Keys of `fields` are in
/// docs/recipe.md ("laboratory", "laboratory_address", "customer", "sensor_serial", ...).
struct CertificateSettings
{
    std::string templateName = "accredited";
    std::vector<std::string> languages{"en"};
    std::map<std::string, std::string> fields;
    bool operator==(const CertificateSettings &) const = default;
};

} // namespace dyncal
