// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/index.h"
#include "core/base/message.h"
#include "core/model_analysis/sensor_response.h"
#include "core/project/certificate_settings.h"

#include <optional>

namespace dyncal {

enum class ConformityVerdict { Conforms, DoesNotConform, NoStatement };

/// |S(f)| over the sensitivity at low frequency, less 1, all relative (0.01 = 1 %).
struct JudgedRow
{
    double frequency_Hz = kUnknown;
    double deviation = kUnknown;
    double u = kUnknown; ///< standard uncertainty of the deviation, complete
    double dof = kUnknown; ///< effective
    double k = kUnknown; ///< that U = k u is stated with
    double risk = kUnknown; ///< probability of lying beyond the limit
    bool isAccepted = false;

    double expanded() const { return k * u; }
};

struct ConformityResult
{
    ConformityVerdict verdict = ConformityVerdict::NoStatement;
    Message why = {}; ///< of NoStatement
    Index rows = 0; ///< judged
    std::optional<JudgedRow> worst; ///< nearest to the limit, or farthest beyond it, by the rule
};

/// Probability that a quantity known as `deviation` with standard uncertainty `u` > 0 and `dof`
/// degrees of freedom lies outside +-`limit`: P(T > (limit - d)/u) + P(T > (limit + d)/u), T
/// Student's (JCGM 106:2012, section 7). u = 0: 0 or 1.
double probabilityOutside(double deviation, double u, double dof, double limit);

/// Fills k, risk and isAccepted in: accepted by the simple rule if |d| <= limit, by the guard band
/// w = U if |d| <= limit - U (ILAC-G8:09/2019, 4.2), by the risk if it is at most
/// maxRisk_percent.
void judgeRow(const DecisionSettings &decision, JudgedRow &row);

/// Judges all rows of S(f) from from_Hz to to_Hz, those at the marked frequencies too. Each is the
/// ratio to the sensitivity at the onset (of a relative response to 1): what all rows share
/// cancels, and its u is of the row's own lines and of those of the sensitivity that the rows do
/// not share, which are the noise of the levels and, against a transducer, its calibration. No
/// statement where the claim leaves the band, a row is withheld or without u, or two rows are
/// farther apart than a third of an octave (a factor of 1.28: 1.6 to 1.25 kHz of ISO 266).
ConformityResult judgeConformity(const ResponseResult &response, const DecisionSettings &decision);

} // namespace dyncal
