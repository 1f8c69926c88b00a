// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_sensitivity.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

namespace dyncal {
namespace {

bool isNotNegative(double u)
{
    return u >= 0.0 && std::isfinite(u);
}

constexpr double kBetween = 2.0; ///< times the bend that rows show: it may be larger between them
constexpr double kFinestUncertainty = 1e-12; ///< of the value: less is rounding error

bool isKnownU(double u, double value)
{
    return u > kFinestUncertainty * std::abs(value);
}

bool hasPhase(const ReferencePoint &row)
{
    return std::isfinite(row.phase_rad);
}

/// Straight lines between the rows would cross the jump of a wrapped phase.
bool isWrapped(const ReferencePoint &row, const ReferencePoint &before)
{
    return std::abs(row.phase_rad - before.phase_rad) > std::numbers::pi;
}

/// What is wrong with a row; null if nothing is. `before` is the one below it.
const char *faultOf(const ReferencePoint &row, const ReferencePoint &before, bool needsPhase)
{
    if (!(row.frequency_Hz > before.frequency_Hz) || !std::isfinite(row.frequency_Hz))
        return DYNCAL_TEXT("core", "a frequency above that of the row before, and above 0");
    if (!(row.magnitude > 0.0) || !std::isfinite(row.magnitude))
        return DYNCAL_TEXT("core", "a magnitude above 0");
    if (!isNotNegative(row.u_magnitude))
        return DYNCAL_TEXT("core", "an uncertainty of the magnitude that is not negative");
    if (hasPhase(row) != needsPhase || (needsPhase && !isNotNegative(row.u_phase_rad)))
        return DYNCAL_TEXT("core", "a phase with its uncertainty in all rows, or in none");
    if (isWrapped(row, before))
        return DYNCAL_TEXT("core",
            "a phase within half a turn of that of the row before: take the jumps of whole turns out");
    return row.dof > 0.0 ? nullptr : DYNCAL_TEXT("core", "degrees of freedom above 0");
}

std::complex<double> secondOrder(const ReferenceModel &model, double frequency_Hz)
{
    const double r = frequency_Hz / model.f0_Hz;
    return model.sensitivity / std::complex<double>(1.0 - r * r, 2.0 * model.zeta * r);
}

/// Change of log S by one standard uncertainty of one parameter, by the central difference over a
/// hundredth of it.
std::complex<double> logChange(
    const ReferenceModel &model, double ReferenceModel::*parameter, double u, double frequency_Hz)
{
    constexpr double kShare = 0.01;
    ReferenceModel up = model;
    ReferenceModel down = model;
    up.*parameter += kShare * u;
    down.*parameter -= kShare * u;
    return std::log(secondOrder(up, frequency_Hz) / secondOrder(down, frequency_Hz))
        / (2.0 * kShare);
}

ReferencePoint ofModel(const ReferenceModel &model, double frequency_Hz)
{
    using M = ReferenceModel;
    const std::complex<double> S = secondOrder(model, frequency_Hz);
    double along = 0.0;
    double across = 0.0;
    for (const auto &[parameter, u] : {std::pair(&M::sensitivity, model.u_sensitivity),
             std::pair(&M::f0_Hz, model.u_f0_Hz), std::pair(&M::zeta, model.u_zeta)}) {
        const std::complex<double> change = logChange(model, parameter, u, frequency_Hz);
        along += change.real() * change.real();
        across += change.imag() * change.imag();
    }
    return {
        frequency_Hz, std::abs(S), std::abs(S) * std::sqrt(along), std::arg(S), std::sqrt(across)};
}

} // namespace

Result<ReferenceSensitivity> ReferenceSensitivity::fromTable(std::vector<ReferencePoint> rows)
{
    if (rows.empty())
        return fail(ErrorKind::Usage, {DYNCAL_TEXT("core", "The table has no rows."), {}});
    ReferencePoint before;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (const char *needed = faultOf(rows[i], before, hasPhase(rows.front())))
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core", "Row %1 of the table, at %2 Hz, needs %3."),
                    {std::to_string(i + 1), numberText(rows[i].frequency_Hz, 6), needed}});
        before = rows[i];
    }
    ReferenceSensitivity result;
    result.m_rows = std::move(rows);
    return result;
}

Result<ReferenceSensitivity> ReferenceSensitivity::fromModel(const ReferenceModel &model)
{
    const std::array positive{model.sensitivity, model.f0_Hz, model.zeta};
    const std::array uncertain{model.u_sensitivity, model.u_f0_Hz, model.u_zeta};
    const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!std::ranges::all_of(positive, isPositive)
        || !std::ranges::all_of(uncertain, isNotNegative))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "comparison.model needs sensitivity, f0_hz and zeta above 0, and no uncertainty below 0."),
                {}});
    ReferenceSensitivity result;
    result.m_model = model;
    return result;
}

/// Half the width of the rectangle within which the value lies about the line from row above - 1 to
/// row `above`.
double ReferenceSensitivity::missedBetween(
    std::size_t above, double share, double ReferencePoint::*value) const
{
    const auto x = [&](std::size_t i) { return std::log(m_rows[i].frequency_Hz); };
    const auto slope = [&](std::size_t i) { // from the row before
        return (m_rows[i].*value - m_rows[i - 1].*value) / (x(i) - x(i - 1));
    };
    const double h = x(above) - x(above - 1);
    if (m_rows.size() == 2)
        return 2.0 * share * (1.0 - share) * std::abs(slope(above) * h);
    double bend = 0.0;
    for (const std::size_t i : {above - 1, above})
        if (i > 0 && i + 1 < m_rows.size())
            bend = std::max(bend, std::abs(slope(i + 1) - slope(i)) * 2.0 / (x(i + 1) - x(i - 1)));
    return kBetween * 0.5 * h * h * share * (1.0 - share) * bend;
}

std::optional<ReferencePoint> ReferenceSensitivity::at(double frequency_Hz) const
{
    if (m_model)
        return ofModel(*m_model, frequency_Hz);
    constexpr double kRounding = 1e-9; // of a frequency that is meant to be a row's
    if (!(frequency_Hz >= lowest_Hz() * (1.0 - kRounding))
        || !(frequency_Hz <= highest_Hz() * (1.0 + kRounding)))
        return std::nullopt;
    const auto above
        = std::ranges::lower_bound(m_rows, frequency_Hz, {}, &ReferencePoint::frequency_Hz);
    if (above == m_rows.begin())
        return m_rows.front();
    if (above == m_rows.end())
        return m_rows.back();
    const ReferencePoint &a = *(above - 1), &b = *above;
    const double share
        = std::log(frequency_Hz / a.frequency_Hz) / std::log(b.frequency_Hz / a.frequency_Hz);
    const auto between
        = [&](double ReferencePoint::*value) { return a.*value + share * (b.*value - a.*value); };
    using P = ReferencePoint;
    const auto row = static_cast<std::size_t>(above - m_rows.begin());
    const auto uOf = [&](double P::*value, double P::*u) {
        return std::hypot(between(u), missedBetween(row, share, value) / std::sqrt(3.0));
    };
    return ReferencePoint{frequency_Hz, between(&P::magnitude), uOf(&P::magnitude, &P::u_magnitude),
        between(&P::phase_rad), uOf(&P::phase_rad, &P::u_phase_rad), std::min(a.dof, b.dof)};
}

std::optional<double> ReferenceSensitivity::withoutU_Hz() const
{
    if (m_model)
        return isKnownU(m_model->u_sensitivity, m_model->sensitivity)
                && isKnownU(m_model->u_f0_Hz, m_model->f0_Hz)
                && isKnownU(m_model->u_zeta, m_model->zeta)
            ? std::nullopt
            : std::optional(0.0);
    const auto isWithout = [](const ReferencePoint &row) {
        return !isKnownU(row.u_magnitude, row.magnitude)
            || (hasPhase(row) && !isKnownU(row.u_phase_rad, 1.0));
    };
    const auto found = std::ranges::find_if(m_rows, isWithout);
    return found == m_rows.end() ? std::nullopt : std::optional(found->frequency_Hz);
}

ReferencePoint ReferenceSensitivity::lowest() const
{
    return m_model ? ofModel(*m_model, 0.0) : m_rows.front();
}

double ReferenceSensitivity::changeBelow() const
{
    if (m_model)
        return 0.0;
    const ReferencePoint &first = m_rows.front();
    const auto octave
        = [&](const ReferencePoint &row) { return row.frequency_Hz >= 2.0 * first.frequency_Hz; };
    const auto found = std::ranges::find_if(m_rows, octave);
    const ReferencePoint &second = found == m_rows.end() ? m_rows.back() : *found;
    const double ratio = second.frequency_Hz / first.frequency_Hz;
    return std::abs(second.magnitude - first.magnitude) / (ratio * ratio - 1.0); // 0/0 of one row
}

std::optional<ReferenceSensitivity::Gap> ReferenceSensitivity::widestGap(
    double from_Hz, double to_Hz) const
{
    std::optional<Gap> widest;
    for (std::size_t i = 1; i < m_rows.size(); ++i) {
        const Gap gap{m_rows[i - 1].frequency_Hz, m_rows[i].frequency_Hz};
        const bool isWithin = gap.from_Hz < to_Hz && gap.to_Hz > from_Hz;
        if (isWithin && (!widest || gap.to_Hz / gap.from_Hz > widest->to_Hz / widest->from_Hz))
            widest = gap;
    }
    return widest;
}

double ReferenceSensitivity::lowest_Hz() const
{
    return m_model ? 0.0 : m_rows.front().frequency_Hz;
}

double ReferenceSensitivity::highest_Hz() const
{
    return m_model ? std::numeric_limits<double>::infinity() : m_rows.back().frequency_Hz;
}

} // namespace dyncal
