// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_ticker.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kMaxDecimals = 12;
constexpr int kMostLabelledDecades = 9;

/// Ticks mantissa * 10^k inside the range.
QVector<double> decadeTicks(
    const QCPRange &range, const std::vector<double> &mantissas, int decadeStep)
{
    QVector<double> ticks;
    const int first = static_cast<int>(std::floor(std::log10(range.lower)));
    const int last = static_cast<int>(std::ceil(std::log10(range.upper)));
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % decadeStep != 0)
            continue;
        for (const double mantissa : mantissas)
            ticks.append(mantissa * std::pow(10.0, exponent));
    }
    return ticks;
}

Index countInside(const QVector<double> &ticks, const QCPRange &range)
{
    return std::count_if(
        ticks.begin(), ticks.end(), [&range](double tick) { return range.contains(tick); });
}

/// Fewest decimals that write multiples of `step` exactly: 0.25 needs two.
int decimalsOf(double step)
{
    double scaled = std::abs(step);
    for (int decimals = 0; decimals < kMaxDecimals; ++decimals, scaled *= 10.0)
        if (scaled >= 1.0 && std::abs(scaled - std::round(scaled)) < 1e-6 * scaled)
            return decimals;
    return kMaxDecimals;
}

constexpr int kMoreTicks = 4;

/// Inside: one on the edge may be left out for a rounding.
double multiplesIn(const QCPRange &range, double step)
{
    const double edge = 1e-6 * range.size();
    return std::floor((range.upper - edge) / step) - std::ceil((range.lower + edge) / step) + 1.0;
}

} // namespace

PrefixTicker::PrefixTicker(const PlotAxis &axis)
    : m_axis(axis)
{
    setTickCount(5);
}

double PrefixTicker::getTickStep(const QCPRange &range)
{
    double step = QCPAxisTicker::getTickStep(range);
    if (m_axis.integers)
        return std::max(1.0, std::round(step));
    // One number alone says nothing of the scale.
    const int wanted = tickCount();
    for (int count = wanted + 1; count <= wanted + kMoreTicks && multiplesIn(range, step) < 2.0;
         ++count) {
        setTickCount(count);
        step = QCPAxisTicker::getTickStep(range);
    }
    setTickCount(wanted);
    return step;
}

int PrefixTicker::getSubTickCount(double tickStep)
{
    if (m_axis.integers)
        return tickStep <= 10.0 ? static_cast<int>(tickStep) - 1 : 0;
    return QCPAxisTicker::getSubTickCount(tickStep);
}

QVector<double> PrefixTicker::createTickVector(double tickStep, const QCPRange &range)
{
    m_prefix = axisPrefix(range.lower, range.upper, m_axis.unit);
    return QCPAxisTicker::createTickVector(tickStep, range);
}

QVector<QString> PrefixTicker::createLabelVector(
    const QVector<double> &ticks, const QLocale &, QChar, int)
{
    QVector<QString> labels;
    labels.reserve(ticks.size());
    const double step = ticks.size() > 1 ? (ticks[1] - ticks[0]) / m_prefix.factor : 1.0;
    const int decimals = decimalsOf(step);
    for (const double tick : ticks) {
        const double value = tick / m_prefix.factor;
        // No "-0.0" for a tick that is zero but for rounding.
        labels.append(plotNumber(std::abs(value) < 1e-9 * step ? 0.0 : value, 'f', decimals));
    }
    return labels;
}

DecadeTicker::DecadeTicker(const PlotAxis &axis)
    : m_axis(axis)
{
}

QVector<double> DecadeTicker::createTickVector(double tickStep, const QCPRange &range)
{
    m_range = range;
    m_prefix = decadePrefix(range.lower, range.upper, m_axis.unit);
    m_decadesOnly = false;
    if (!(range.lower > 0.0))
        return {};
    const double decades = std::log10(range.upper / range.lower);
    if (decades > 2.5) {
        m_decadesOnly = true;
        int step = 1 + static_cast<int>(decades) / kMostLabelledDecades;
        while (step < decades && countInside(decadeTicks(range, {1.0}, step), range) > m_mostTicks)
            ++step;
        return decadeTicks(range, {1.0}, step);
    }
    QVector<double> ticks = decadeTicks(range, {1.0, 2.0, 5.0}, 1);
    if (const auto count = countInside(ticks, range); count >= 3) {
        const QVector<double> whole = decadeTicks(range, {1.0}, 1);
        return count > m_mostTicks && countInside(whole, range) > 0 ? whole : ticks;
    }
    return QCPAxisTicker::createTickVector(tickStep, range);
}

QVector<double> DecadeTicker::createSubTickVector(int, const QVector<double> &)
{
    if (!(m_range.lower > 0.0))
        return {};
    const std::vector<double> between{2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
    const double decades = std::log10(m_range.upper / m_range.lower);
    return decadeTicks(
        m_range, decades > kMostLabelledDecades ? std::vector<double>{1.0} : between, 1);
}

QString DecadeTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    constexpr int kMostZeros = 4; // "10000", "0.0001"
    const double value = tick / m_prefix.factor;
    const int exponent = static_cast<int>(std::lround(std::log10(value)));
    const bool isLong = std::abs(exponent) > kMostZeros;
    if (m_decadesOnly && (isLong || !takesPrefix(m_axis.unit)))
        return exponent == 0 ? QStringLiteral("1") : powerOfTen(exponent);
    return plotNumber(value, 'g', 6);
}

} // namespace dyncal
