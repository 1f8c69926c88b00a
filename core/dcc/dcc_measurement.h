// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

namespace dyncal {

/// dcc:usedMethods: the calibration, the evaluation of uncertainty, Monte Carlo where it was used,
/// and the versions of the methods.
XmlElement dccMethods(const DccSource &source);
XmlElement dccUsedSoftware(const DccSource &source);
/// dcc:measuringEquipments: reference transducer, chain and the references of the budget with their
/// certificates. Empty name where none is stated.
XmlElement dccEquipment(const DccSource &source);
/// dcc:influenceConditions: what the air in the laboratory was, or that it was not recorded.
XmlElement dccConditions(const DccSource &source);

} // namespace dyncal
