// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/uncertainty_settings.h"
#include "ui/text/typed_quantity.h"

#include <QString>

namespace dyncal {

/// Whether entries of this quantity are of rows of S(f), from one frequency to another.
bool isOverFrequency(const CapabilityEntry &entry);

/// What its U is typed in: percent of the value, degrees, or the unit of the quantity.
ShownUnit capabilityUnit(const CapabilityEntry &entry, const QString &unitOfSensitivity);

/// What the entry is the least U of, in words.
QString capabilityName(const std::string &of);

/// "Magnitude of S(f): 2 %, from 1 kHz to 10 kHz".
QString capabilityText(const CapabilityEntry &entry, const QString &unitOfSensitivity);

} // namespace dyncal
