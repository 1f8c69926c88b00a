// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/transducer_comparison.h"

#include "core/base/number_text.h"
#include "core/model_analysis/response_rows.h"
#include "core/uncertainty/front_effect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// Common lines that are not the DUT's own chain, which cancels.
double uCommonAlone(const UncertaintyReport &report)
{
    std::vector<UncertaintyLine> alone;
    std::ranges::copy_if(
        report.rows.common, std::back_inserter(alone), [&](const UncertaintyLine &line) {
            return std::ranges::find(
                       report.chain.ofSensitivity, line.quantity, &UncertaintyLine::quantity)
                == report.chain.ofSensitivity.end();
        });
    return combined(alone).u;
}

/// Of one pair of rows, relative to the mean of both.
struct RowDifference
{
    double relative = kUnknown;
    double u_noise = 0.0; ///< and bounds: differs from row to row
    double u_common = 0.0; ///< much the same in neighbouring rows
};

RowDifference differenceOf(const UncertainResponse &byTransducer, Index a,
    const UncertainResponse &byStep, Index b, double correlation)
{
    const ResponseResult &t = byTransducer.response, &s = byStep.response;
    const double S = 0.5 * (t.magnitude[a] + s.magnitude[b]);
    const double step = uCommonAlone(byStep.report);
    const double reference
        = std::hypot(t.u_referenceMagnitude[a] / t.magnitude[a], uCommonAlone(byTransducer.report));
    const double front = s.u_frontMagnitude[b] / s.magnitude[b];
    const double unknownFront
        = isFrontStated(s.front) ? 0.0 : frontLine(s.frequency_Hz[b]).contribution;
    RowDifference result;
    result.relative = (s.magnitude[b] - t.magnitude[a]) / S;
    // The DUT's noise and bounds are in both; the ratio's hold them and the reference's.
    result.u_noise = std::hypot(t.u_noiseMagnitude[a],
                         std::hypot(t.boundEnd[a], t.boundAlias[a]) / std::sqrt(3.0))
        / S;
    result.u_common = std::hypot(
        std::sqrt(step * step + reference * reference - 2.0 * correlation * step * reference),
        front, unknownFront);
    return result;
}

ReportedValue statedAt(const UncertainResponse &of, std::optional<Index> row)
{
    ReportedValue value{"magnitude", kUnknown, ""};
    if (!row || !std::isfinite(of.response.magnitude[*row]))
        return value;
    if (of.report.rows.isComplete())
        return magnitudeOfRow(of.response, of.report.rows, *row);
    value.value = of.response.magnitude[*row];
    return value;
}

/// Up to where the model stays within 10 %.
double flatUpTo_Hz(const ResponseResult &response)
{
    return response.characteristics.within10percent_Hz.value_or(
        std::numeric_limits<double>::infinity());
}

/// Mean of the rows of the flat part; of their common parts the largest.
void average(const std::vector<RowDifference> &rows, StepAgainstTransducer &result)
{
    const double n = static_cast<double>(rows.size());
    double sum = 0.0, noise2 = 0.0, common = 0.0;
    for (const RowDifference &row : rows) {
        sum += row.relative;
        noise2 += row.u_noise * row.u_noise;
        common = std::max(common, row.u_common);
    }
    result.difference_relative = sum / n;
    result.u_relative = std::hypot(std::sqrt(noise2) / n, common);
}

} // namespace

std::optional<StepAgainstTransducer> compareWithStep(
    const UncertainResponse &byTransducer, const UncertainResponse &byStep, double correlation)
{
    const ResponseResult &response = byTransducer.response;
    if (!byTransducer.report.rows.isComplete() || !byStep.report.rows.isComplete()
        || response.unit != byStep.response.unit)
        return std::nullopt;
    StepAgainstTransducer result;
    result.e_n.setConstant(response.frequency_Hz.size(), kUnknown);
    std::vector<RowDifference> flat;
    std::vector<RowDifference> all;
    for (Index row = 0; row < response.magnitude.size(); ++row) {
        const std::optional<Index> other
            = measuredRowAt(byStep.response, response.frequency_Hz[row]);
        if (!other || !std::isfinite(response.magnitude[row]))
            continue;
        all.push_back(differenceOf(byTransducer, row, byStep, *other, correlation));
        const RowDifference &last = all.back();
        result.e_n[row] = last.relative / (2.0 * std::hypot(last.u_noise, last.u_common));
        if (response.frequency_Hz[row] <= flatUpTo_Hz(byStep.response))
            flat.push_back(last);
    }
    if (all.empty())
        return std::nullopt;
    average(flat.empty() ? all : flat, result);
    return result;
}

std::vector<ComparedRow> comparedRows(const ComparisonResult &comparison)
{
    std::vector<ComparedRow> rows;
    if (!comparison.byTransducer || !comparison.byStep)
        return rows;
    const UncertainResponse &t = *comparison.byTransducer, &s = *comparison.byStep;
    const bool isAlike = t.response.unit == s.response.unit;
    for (Index row = 0; row < t.response.magnitude.size(); ++row) {
        const double f_Hz = t.response.frequency_Hz[row];
        rows.push_back({f_Hz, statedAt(t, row),
            statedAt(s, isAlike ? measuredRowAt(s.response, f_Hz) : std::nullopt),
            comparison.againstStep ? comparison.againstStep->e_n[row] : kUnknown});
    }
    return rows;
}

Findings judgeAgainstStep(const StepAgainstTransducer &comparison)
{
    const double e_n = std::abs(comparison.meanE_n());
    if (!(e_n > 1.0))
        return {};
    return {{.id = "CMP-001",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The sensitivity against the computed pressure step differs by %1 % from that against the reference transducer, more than both uncertainties allow (U = %2 %, k = 2). Check the transducer's certificate, unit and chain, and gas, temperature and distances of the step."),
            {numberText(100.0 * comparison.difference_relative, 2),
                numberText(200.0 * comparison.u_relative, 2)}},
        .value = e_n,
        .limit = 1.0,
        .causes = {FindingCause::Reference, FindingCause::Gas, FindingCause::Scale,
            FindingCause::Distance, FindingCause::Attenuation, FindingCause::Temperature}}};
}

} // namespace dyncal
