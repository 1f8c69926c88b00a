// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/pipeline/calibration_kind.h"

#include <vector>

namespace dyncal {

/// The words of a certificate that follow from the kind of its calibration. Internal to
/// core/certificate.
Message certificateTitle(CalibrationKind kind);

/// What is determined: the measurand, with the wall that the sensor was in.
Message measurandSentence(CalibrationKind kind, const std::string &dutPosition);

/// Where the pressure step comes from; none of a free decay.
std::vector<Message> stepSentences(CalibrationKind kind);

/// What the uncertainties of the section "Results" contain, and what has none.
Message uncertaintyNote(CalibrationKind kind);

/// Below the table of the shots.
Message shotsNote(CalibrationKind kind);

} // namespace dyncal
