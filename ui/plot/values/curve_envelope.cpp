// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/curve_envelope.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace dyncal {

namespace {

/// Samples that the caller owns.
class ViewedNumbers : public SampleSource
{
public:
    explicit ViewedNumbers(std::span<const double> numbers)
        : m_numbers(numbers)
    {
    }
    bool read(Index begin, Index count, std::byte *target) const override
    {
        std::memcpy(
            target, m_numbers.data() + begin, static_cast<std::size_t>(count) * sizeof(double));
        return true;
    }

private:
    std::span<const double> m_numbers;
};

} // namespace

CurveEnvelope::CurveEnvelope(std::span<const double> x, std::span<const double> y)
    : m_x(x)
    , m_y(y)
    , m_pyramid(*EnvelopePyramid::build(
          RawSamples(std::make_shared<ViewedNumbers>(y), SampleType::Float64, std::ssize(y))))
{
}

SampleExtremes CurveEnvelope::extremes(Index begin, Index end) const
{
    return stretches(std::array{begin, end}).front();
}

std::vector<SampleExtremes> CurveEnvelope::stretches(std::span<const Index> edges) const
{
    return *m_pyramid.stretches(edges); // numbers in memory can always be read
}

Index CurveEnvelope::firstFrom(double x) const
{
    return std::lower_bound(m_x.begin(), m_x.end(), x) - m_x.begin();
}

Index CurveEnvelope::firstBeyond(double x) const
{
    return std::upper_bound(m_x.begin(), m_x.end(), x) - m_x.begin();
}

DrawnPoints CurveEnvelope::samples(Index begin, Index end) const
{
    DrawnPoints drawn;
    drawn.x.assign(m_x.begin() + begin, m_x.begin() + end);
    drawn.y.assign(m_y.begin() + begin, m_y.begin() + end);
    return drawn;
}

} // namespace dyncal
