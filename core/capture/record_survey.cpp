// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/record_survey.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace dyncal {
namespace {

/// So few samples that a stretch stays in the cache for its second pass.
constexpr std::size_t kStretch = 4096;

/// Longest run of the extreme value in one direction, while the extreme itself may still move.
template <typename T>
class ExtremeRun
{
public:
    explicit ExtremeRun(bool top)
        : m_top(top)
    {
    }

    /// `extreme` is that of `values`. Most stretches do not reach the record's extreme and need no
    /// search.
    void see(std::span<const T> values, Index first, T extreme)
    {
        const bool beyond = m_top ? extreme > m_level : extreme < m_level;
        if (!m_any || beyond) {
            m_any = true;
            m_level = extreme;
            m_longest = {};
            m_current = 0;
        }
        if (extreme != m_level) {
            m_current = 0;
            return;
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            m_current = values[i] == m_level ? m_current + 1 : 0;
            if (m_current > m_longest.count)
                m_longest = {first + static_cast<Index>(i) - m_current + 1, m_current};
        }
    }

    /// A stretch without a single valid sample.
    void interrupt() { m_current = 0; }

    double level() const { return m_any ? static_cast<double>(m_level) : 0.0; }
    const EqualRun &longest() const { return m_longest; }

private:
    bool m_top;
    bool m_any = false;
    T m_level{};
    EqualRun m_longest;
    Index m_current = 0;
};

/// Standard deviation, from sums that stay exact for up to 16 bits.
template <typename T>
class Spread
{
public:
    void see(std::span<const T> values)
    {
        if constexpr (sizeof(T) <= 2) {
            std::int64_t sum = 0;
            std::int64_t squares = 0;
            for (const std::int32_t value : values) {
                sum += value;
                squares += static_cast<std::int64_t>(value) * value;
            }
            add(static_cast<double>(sum), static_cast<double>(squares));
        } else {
            double sum = 0.0;
            double squares = 0.0;
            for (const T value : values) {
                sum += static_cast<double>(value);
                squares += static_cast<double>(value) * static_cast<double>(value);
            }
            add(sum, squares);
        }
        m_count += static_cast<double>(values.size());
    }

    double sd() const
    {
        const double mean = m_sum / m_count;
        return m_count > 0.0 ? std::sqrt(std::max(m_squares / m_count - mean * mean, 0.0)) : 0.0;
    }

private:
    void add(double sum, double squares)
    {
        m_sum += sum;
        m_squares += squares;
    }

    double m_sum = 0.0;
    double m_squares = 0.0;
    double m_count = 0.0;
};

template <typename T>
class Surveyor
{
public:
    void see(std::span<const T> block, Index first)
    {
        for (std::size_t at = 0; at < block.size(); at += kStretch) {
            const auto stretch = block.subspan(at, std::min(kStretch, block.size() - at));
            if constexpr (std::is_floating_point_v<T>)
                seeFloating(stretch, first + static_cast<Index>(at));
            else
                seeInteger(stretch, first + static_cast<Index>(at));
        }
    }

    RecordSurvey result() const
    {
        RecordSurvey survey = m_invalid;
        survey.highest = m_top.level();
        survey.lowest = m_bottom.level();
        survey.top = m_top.longest();
        survey.bottom = m_bottom.longest();
        survey.sd = m_spread.sd();
        return survey;
    }

private:
    void seeInteger(std::span<const T> values, Index first)
    {
        T low = values[0];
        T high = values[0];
        for (const T value : values) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
        m_top.see(values, first, high);
        m_bottom.see(values, first, low);
        m_spread.see(values);
    }

    void seeFloating(std::span<const T> values, Index first)
    {
        constexpr T kLargest = std::numeric_limits<T>::max();
        T low = std::numeric_limits<T>::infinity();
        T high = -low;
        Index invalid = 0;
        for (const T value : values) {
            const bool valid = std::abs(value) <= kLargest; // false for NaN too
            invalid += valid ? 0 : 1;
            low = valid && value < low ? value : low;
            high = valid && value > high ? value : high;
        }
        if (invalid > 0)
            noteInvalid(values, first, invalid);
        if (invalid == std::ssize(values)) {
            m_top.interrupt();
            m_bottom.interrupt();
            return;
        }
        m_top.see(values, first, high);
        m_bottom.see(values, first, low);
    }

    void noteInvalid(std::span<const T> values, Index first, Index invalid)
    {
        m_invalid.invalid += invalid;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::isfinite(values[i]))
                continue;
            m_invalid.lastInvalid = first + static_cast<Index>(i);
            if (m_invalid.firstInvalid < 0)
                m_invalid.firstInvalid = m_invalid.lastInvalid;
        }
    }

    RecordSurvey m_invalid;
    ExtremeRun<T> m_top{true};
    ExtremeRun<T> m_bottom{false};
    Spread<std::conditional_t<std::is_floating_point_v<T>, std::int32_t, T>> m_spread;
};

template <typename T>
RecordSurvey surveyAs(const RawSamples &samples)
{
    Surveyor<T> surveyor;
    const bool readable = samples.visitBlocks(0, samples.size(), [&](auto values, Index first) {
        if constexpr (std::is_same_v<decltype(values), std::span<const T>>)
            surveyor.see(values, first);
    });
    RecordSurvey survey = surveyor.result();
    survey.size = samples.size();
    survey.readable = readable;
    return survey;
}

} // namespace

RecordSurvey surveyRecord(const RawSamples &samples)
{
    switch (samples.type()) {
    case SampleType::Int16:
        return surveyAs<std::int16_t>(samples);
    case SampleType::Int32:
        return surveyAs<std::int32_t>(samples);
    case SampleType::Float32:
        return surveyAs<float>(samples);
    case SampleType::Float64:
        return surveyAs<double>(samples);
    case SampleType::Int8:
        return surveyAs<std::int8_t>(samples);
    case SampleType::UInt8:
        return surveyAs<std::uint8_t>(samples);
    case SampleType::UInt16:
        return surveyAs<std::uint16_t>(samples);
    }
    return {};
}

} // namespace dyncal
