// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/matlab/mat_time.h"

#include "core/base/ascii_text.h"
#include "core/base/number_text.h"
#include "core/capture/formats/bytes/time_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr Index kRowsToTellTime = 8; ///< so many uniform steps are no accident

constexpr auto kRateNames = std::to_array<std::string_view>({"fs", "f_s", "fs_hz", "sample_rate",
    "samplerate", "sample_rate_hz", "sampling_rate", "samplingrate", "sample_frequency",
    "samplefrequency", "sampling_frequency", "samplingfrequency"});
constexpr auto kIntervalNames = std::to_array<std::string_view>({"dt", "ts", "dt_s", "delta_t",
    "deltat", "tinterval", "sample_interval", "sampleinterval", "sampling_interval"});
constexpr auto kStartNames = std::to_array<std::string_view>({"t0", "t0_s", "tstart", "t_start"});
constexpr auto kTimeNames = std::to_array<std::string_view>({"time", "times", "zeit", "tid"});

struct TimeUnit
{
    std::string_view suffix;
    double seconds;
};
constexpr std::array kUnits{
    TimeUnit{"_s", 1.0}, TimeUnit{"_ms", 1e-3}, TimeUnit{"_us", 1e-6}, TimeUnit{"_ns", 1e-9}};

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N> &names, const std::string &name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Seconds per unit of a time vector: 0 where its name does not say; empty if it is no such name.
std::optional<double> unitByName(const std::string &name)
{
    const auto isTime = [](const std::string &word) {
        return word == "t" || isOneOf(kTimeNames, lowerCase(word)); // T is a temperature
    };
    if (isTime(name))
        return 0.0;
    for (const TimeUnit &unit : kUnits) {
        const std::string lower = lowerCase(name);
        if (lower.ends_with(unit.suffix)
            && isTime(name.substr(0, name.size() - unit.suffix.size())))
            return unit.seconds;
    }
    return {};
}

/// So near that reading the whole column is worth it.
bool near(double meanStep, double firstStep)
{
    constexpr double kFactor = 0.1; // coarse: single precision far from zero
    return std::abs(meanStep - firstStep) <= kFactor * meanStep;
}

std::string rateText(double rate_Hz)
{
    return numberWithUnit(rate_Hz, "Hz", 7);
}

} // namespace

MatTime::MatTime(std::string path, std::optional<double> stated_Hz)
    : m_path(std::move(path))
    , m_operator_Hz(stated_Hz)
{
}

void MatTime::addScalar(const std::string &name, double value)
{
    const std::string lower = lowerCase(name);
    if (!std::isfinite(value))
        return;
    if (isOneOf(kStartNames, lower))
        m_start_s = value;
    if (value > 0.0 && std::isfinite(1.0 / value)) {
        if (isOneOf(kRateNames, lower)) {
            m_rate_Hz = value;
            m_scalars.push_back({name, value, value, false});
        }
        if (isOneOf(kIntervalNames, lower)) {
            m_interval_s = value;
            m_scalars.push_back({name, value, 1.0 / value, true});
        }
    }
}

bool MatTime::isTimeName(const std::string &name) const
{
    return unitByName(name).has_value();
}

void MatTime::addVector(const std::string &name, const RawSamples &times)
{
    const double unit_s = unitByName(name).value_or(0.0);
    m_axes.push_back({name, times.size(), uniformAxis(times), unit_s, unit_s == 0.0});
}

std::optional<TimeAxis> MatTime::uniformAxis(const RawSamples &times)
{
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(times.size()));
    const bool whole = times.visitBlocks(0, times.size(), [&](auto block, Index) {
        for (const auto value : block)
            values.push_back(static_cast<double>(value));
    });
    if (!whole || values.size() < 2)
        return {};
    const double largest = std::max(std::abs(values.front()), std::abs(values.back()));
    const double resolution = largest
        * (times.type() == SampleType::Float32 ? double(std::numeric_limits<float>::epsilon())
                                               : std::numeric_limits<double>::epsilon());
    const TimeAxis axis = timeAxisOf(values, resolution);
    const bool usable = !axis.irregular && axis.step > 0.0 && std::isfinite(axis.first)
        && std::isfinite(1.0 / axis.step);
    return usable ? std::optional(axis) : std::nullopt;
}

std::optional<Index> MatTime::columnOf(const std::vector<RawSamples> &columns) const
{
    for (const std::size_t c : {std::size_t{0}, columns.size() - 1}) {
        const RawSamples &column = columns[c];
        if (column.size() < kRowsToTellTime)
            continue;
        const double step = column.at(1) - column.at(0);
        const double span = column.at(column.size() - 1) - column.at(0);
        if (!(step > 0.0) || !near(span / static_cast<double>(column.size() - 1), step))
            continue;
        const std::optional<TimeAxis> axis = uniformAxis(column);
        const bool counter = axis && axis->step == 1.0 && axis->first == std::floor(axis->first);
        if (axis && !counter)
            return static_cast<Index>(c);
    }
    return {};
}

std::optional<double> MatTime::stated() const
{
    if (m_operator_Hz)
        return m_operator_Hz;
    if (m_rate_Hz)
        return m_rate_Hz;
    return m_interval_s ? std::optional(1.0 / *m_interval_s) : std::nullopt;
}

Finding MatTime::contradiction(const std::string &name, double step) const
{
    return {.id = "CAP-003",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: the sample rate is stated as %2, but %3 steps by %4, which fits it in no unit of time, so the rate is unknown. Which one is right? State it in the recipe's import section."),
            {m_path, rateText(*stated()), name, numberText(step, 7)}},
        .value = step,
        .limit = stated()};
}

MatRate MatTime::rateByAxis(const Axis &axis, Findings &findings) const
{
    if (!axis.uniform) {
        findings.push_back({.id = "CAP-016",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: the times in %2 are not uniform (allowed is 1 % of a step, and half a step in all), so the sample rate is unknown; state it in the recipe's import section if it is known."),
                {m_path, axis.name}}});
        return {};
    }
    const double step = axis.uniform->step;
    if (const std::optional<double> rate_Hz = stated()) {
        for (const TimeUnit &unit : kUnits) {
            const bool possible = axis.unit_s == 0.0 || axis.unit_s == unit.seconds;
            if (possible && ratesAgree(*rate_Hz * step * unit.seconds, 1.0))
                return {*rate_Hz, axis.uniform->first * unit.seconds};
        }
        findings.push_back(contradiction(axis.name, step));
        return {};
    }
    if (axis.unit_s > 0.0)
        return {1.0 / (step * axis.unit_s), axis.uniform->first * axis.unit_s};
    if (axis.byConvention) {
        findings.push_back({.id = "CAP-016",
            .severity = Severity::Info,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: %2 has no unit and was taken as seconds, which makes the sample rate %3; state the rate in the recipe's import section if it is another."),
                {m_path, axis.name, rateText(1.0 / step)}},
            .value = step});
        return {1.0 / step, axis.uniform->first};
    }
    findings.push_back({.id = "CAP-016",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: %2 increases uniformly by %3 and was taken as the times, but its unit is said nowhere. State the sample rate in the recipe's import section: %4 if they are seconds, %5 if milliseconds, %6 if microseconds."),
            {m_path, axis.name, numberText(step, 7), rateText(1.0 / step),
                rateText(1.0 / (step * 1e-3)), rateText(1.0 / (step * 1e-6))}},
        .value = step});
    return {};
}

MatRate MatTime::rateByColumn(
    const std::string &name, Index column, const RawSamples &times, Findings &findings) const
{
    const std::string place = name + " " + std::to_string(column + 1);
    return rateByAxis({place, times.size(), uniformAxis(times), 0.0, false}, findings);
}

MatRate MatTime::rateOfLength(Index length, Findings &findings) const
{
    const auto axis = std::find_if(
        m_axes.begin(), m_axes.end(), [=](const Axis &one) { return one.length == length; });
    Findings news;
    MatRate rate;
    if (const auto twice = contradictingScalars(axis == m_axes.end()))
        news.push_back(*twice);
    else if (const auto other = axis != m_axes.end() ? contradictingAxes(*axis) : std::nullopt)
        news.push_back(*other);
    else
        rate = axis != m_axes.end() ? rateByAxis(*axis, news) : statedRate();
    for (Finding &finding : news) { // the same for every signal of this length
        if (std::find(findings.begin(), findings.end(), finding) == findings.end())
            findings.push_back(std::move(finding));
    }
    return rate;
}

/// Intervals only where no times decide: "Ts" may be anything beside them.
std::optional<Finding> MatTime::contradictingScalars(bool withIntervals) const
{
    const Scalar *first = nullptr;
    for (const Scalar &scalar : m_scalars) {
        if (m_operator_Hz || (scalar.isInterval && !withIntervals))
            continue;
        if (first == nullptr)
            first = &scalar;
        if (ratesAgree(scalar.rate_Hz, first->rate_Hz))
            continue;
        return Finding{.id = "CAP-003",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: %2 = %3 and %4 = %5 contradict each other (%6 and %7), so the sample rate is unknown; state it in the recipe's import section."),
                {m_path, first->name, numberText(first->value, 7), scalar.name,
                    numberText(scalar.value, 7), rateText(first->rate_Hz),
                    rateText(scalar.rate_Hz)}},
            .value = scalar.rate_Hz,
            .limit = first->rate_Hz};
    }
    return {};
}

/// Another vector of times of this length that steps by something else. Where one of the two has no
/// unit, any unit will do.
std::optional<Finding> MatTime::contradictingAxes(const Axis &axis) const
{
    for (const Axis &other : m_axes) {
        if (other.length != axis.length || !other.uniform || !axis.uniform || m_operator_Hz)
            continue;
        const double ratio = other.uniform->step / axis.uniform->step;
        const auto agrees
            = [&](double unit, double otherUnit) { return ratesAgree(ratio * otherUnit, unit); };
        const bool isFree = axis.unit_s == 0.0 && other.unit_s > 0.0;
        const bool isOtherFree = axis.unit_s > 0.0 && other.unit_s == 0.0;
        const auto agreesInSome = [&](const TimeUnit &unit) {
            return (isFree && agrees(unit.seconds, other.unit_s))
                || (isOtherFree && agrees(axis.unit_s, unit.seconds));
        };
        const bool agree = isFree || isOtherFree ? std::ranges::any_of(kUnits, agreesInSome)
            : axis.unit_s > 0.0                  ? agrees(axis.unit_s, other.unit_s)
                                                 : agrees(1.0, 1.0);
        if (agree)
            continue;
        return Finding{.id = "CAP-003",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: the times in %2 step by %3 and those in %4 by %5, which fits no sample rate in common, so it is unknown; state it in the recipe's import section."),
                {m_path, axis.name, numberText(axis.uniform->step, 7), other.name,
                    numberText(other.uniform->step, 7)}},
            .value = other.uniform->step,
            .limit = axis.uniform->step};
    }
    return {};
}

MatRate MatTime::statedRate() const
{
    return {stated().value_or(0.0), m_start_s};
}

} // namespace dyncal
