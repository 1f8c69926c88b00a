// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/delay_difference.h"

#include "core/base/contradiction.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr double kModel_rad = 0.02; ///< that no model's phase is nearer than, where noise is small
constexpr std::size_t kLeastRows = 3;

struct PhaseRow
{
    double omega = 0.0; ///< rad/s
    double difference_rad = 0.0;
    double weight = 0.0; ///< 1 / u^2 of what is the row's own
    double u_all_s = 0.0; ///< of both phases, as a delay
};

std::vector<PhaseRow> phaseRows(const UncertainResponse &answer)
{
    const ResponseResult &r = answer.response;
    std::vector<PhaseRow> rows;
    for (Index i = 0; i < r.phase_rad.size(); ++i) {
        const double difference = r.phase_rad[i] - r.modelPhase_rad[i];
        const double u
            = std::hypot(answer.report.rows.u_phase_rad[i], answer.report.rows.u_modelPhase_rad[i]);
        if (!std::isfinite(difference + u) || !(r.frequency_Hz[i] <= 0.5 * r.modelLimit_Hz))
            continue;
        const double omega = kTwoPi * r.frequency_Hz[i];
        const double own = std::hypot(r.u_noiseMagnitude[i] / r.magnitude[i], kModel_rad);
        rows.push_back({omega, difference, 1.0 / (own * own), u / omega});
    }
    std::ranges::sort(rows, {}, &PhaseRow::omega);
    return rows;
}

} // namespace

std::optional<DelayDifference> delayDifference(const UncertainResponse &byTransducer)
{
    const std::vector<PhaseRow> rows = phaseRows(byTransducer);
    if (rows.size() < kLeastRows)
        return std::nullopt;
    DelayDifference found;
    double sum = 0.0, weights = 0.0, squares = 0.0;
    double u_common_s = std::numeric_limits<double>::infinity();
    for (const PhaseRow &row : rows) {
        const double expected = row.omega * found.delay_s;
        const double difference = expected + std::remainder(row.difference_rad - expected, kTwoPi);
        sum += row.weight * row.omega * difference;
        weights += row.weight * row.omega * row.omega;
        squares += row.weight * difference * difference;
        found.delay_s = sum / weights;
        u_common_s = std::min(u_common_s, row.u_all_s);
    }
    const double left = std::max(0.0, squares - sum * found.delay_s);
    const double scatter = std::max(1.0, left / static_cast<double>(rows.size() - 1));
    found.u_s = std::hypot(u_common_s, std::sqrt(scatter / weights));
    return found;
}

Findings judgeDelay(const DelayDifference &difference, double stated_s)
{
    const double ratio = std::abs(difference.delay_s) / difference.u_s;
    if (!(ratio > kContradiction))
        return {};
    return {{.id = "CMP-005",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The phase against the reference transducer differs from that of the sensor's own model as by a delay of %1 (U = %2, k = 2): the step seems to reach the transducer %3 after the sensor, and comparison.delay_s states %4. Check its sign and value, and the phases of the transducer."),
            {numberWithUnit(difference.delay_s, "s", 3),
                numberWithUnit(2.0 * difference.u_s, "s", 2),
                numberWithUnit(stated_s + difference.delay_s, "s", 3),
                numberWithUnit(stated_s, "s", 3)}},
        .value = ratio,
        .limit = kContradiction,
        .causes = {FindingCause::Reference}}};
}

} // namespace dyncal
