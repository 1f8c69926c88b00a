// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_glance.h"

#include "core/capture/check_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace dyncal {

namespace {

constexpr Index kStretches = 100;
constexpr Index kSamplesRead = 2000; ///< of a stretch, from its beginning

struct Stretch
{
    double mean = std::numeric_limits<double>::quiet_NaN();
    double difference2 = std::numeric_limits<double>::quiet_NaN(); ///< mean square, by neighbours
    SampleExtremes extremes;
};

Stretch stretchOf(std::span<const double> values)
{
    Stretch stretch;
    double sum = 0.0;
    double squares = 0.0;
    Index count = 0;
    Index pairs = 0;
    double before = std::numeric_limits<double>::quiet_NaN();
    for (const double value : values) {
        if (!std::isfinite(value)) {
            stretch.extremes.invalid = true;
            before = value;
            continue;
        }
        stretch.extremes.min = stretch.extremes.any ? std::min(stretch.extremes.min, value) : value;
        stretch.extremes.max = stretch.extremes.any ? std::max(stretch.extremes.max, value) : value;
        stretch.extremes.any = true;
        sum += value;
        ++count;
        if (std::isfinite(before)) {
            squares += (value - before) * (value - before);
            ++pairs;
        }
        before = value;
    }
    if (count > 0)
        stretch.mean = sum / static_cast<double>(count);
    if (pairs > 0)
        stretch.difference2 = squares / static_cast<double>(pairs);
    return stretch;
}

/// The quiet half of the stretches says what the noise is: the others may ring.
double noiseOf(const std::vector<Stretch> &stretches)
{
    std::vector<double> squares;
    squares.reserve(stretches.size());
    for (const Stretch &stretch : stretches)
        if (std::isfinite(stretch.difference2))
            squares.push_back(stretch.difference2);
    if (squares.empty())
        return 0.0;
    const auto quiet = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 4);
    std::nth_element(squares.begin(), quiet, squares.end());
    return std::sqrt(0.5 * *quiet);
}

/// From one stretch to the next but one: the stretch between them holds the step itself.
double changeAt(const std::vector<Stretch> &stretches, std::size_t i)
{
    return i + 2 < stretches.size() ? stretches[i + 2].mean - stretches[i].mean : 0.0;
}

/// The first of the changes that come near the largest: a sensor in the side wall sees the shock
/// before its reflection, which is the larger step.
std::size_t firstStep(const std::vector<Stretch> &stretches, double largest)
{
    constexpr double kNear = 0.25;
    const auto towards = [&](std::size_t i) { return changeAt(stretches, i) / largest; };
    std::size_t i = 0;
    while (i + 1 < stretches.size() && !(towards(i) >= kNear))
        ++i;
    while (i + 1 < stretches.size() && towards(i + 1) > towards(i))
        ++i;
    return i;
}

ChannelGlance glanceOf(const std::vector<Stretch> &stretches)
{
    ChannelGlance glance;
    glance.noise = noiseOf(stretches);
    glance.trace.reserve(stretches.size());
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const Stretch &stretch = stretches[i];
        glance.trace.push_back(stretch.extremes);
        if (!stretch.extremes.any)
            continue;
        lowest = std::min(lowest, stretch.extremes.min);
        highest = std::max(highest, stretch.extremes.max);
        const double change = changeAt(stretches, i);
        if (std::abs(change) > std::abs(glance.step))
            glance.step = change;
    }
    if (glance.step == 0.0)
        return glance;
    glance.stepAt = static_cast<Index>(firstStep(stretches, glance.step)) + 1;
    glance.swing = (highest - lowest) / std::abs(glance.step);
    return glance;
}

/// `stretch(i)` gives the samples of one stretch.
template <typename Samples>
ChannelGlance glanceOfStretches(Index size, Samples samplesOf)
{
    const Index count = std::min(kStretches, size);
    std::vector<Stretch> stretches;
    stretches.reserve(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) {
        const Index begin = i * size / count;
        stretches.push_back(stretchOf(samplesOf(begin, (i + 1) * size / count)));
    }
    return glanceOf(stretches);
}

/// Between two stretches that differ by the whole step at once, or in several parts of the same
/// sign: then the change is slow.
bool isSlow(const ChannelGlance &glance)
{
    constexpr double kSlowSwing = 3.0; ///< the whole way over what two stretches take
    return glance.swing > kSlowSwing;
}

} // namespace

bool ChannelGlance::steps() const
{
    return std::abs(step) > CheckSettings{}.stepSigmas * noise && step != 0.0;
}

ChannelGlance glanceAt(std::span<const double> values)
{
    return glanceOfStretches(std::ssize(values), [&](Index begin, Index end) {
        return values.subspan(
            static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    });
}

ChannelGlance glanceAt(const RawSamples &samples)
{
    std::vector<double> block;
    return glanceOfStretches(samples.size(), [&](Index begin, Index end) {
        block.clear();
        samples.visitBlocks(begin, std::min(end, begin + kSamplesRead),
            [&](auto values, Index) { block.insert(block.end(), values.begin(), values.end()); });
        return std::span<const double>(block);
    });
}

ChannelGlance glanceAt(const Channel &channel)
{
    ChannelGlance glance = glanceAt(channel.samples);
    if (glance.trace.empty())
        return glance;
    const SampleExtremes &at = glance.trace[static_cast<std::size_t>(glance.stepAt)];
    const double middle = 0.5 * (at.min + at.max);
    const auto change = [&](double counts) {
        return physicalValue(channel, middle + 0.5 * counts)
            - physicalValue(channel, middle - 0.5 * counts);
    };
    glance.noise = std::abs(change(glance.noise));
    glance.step = change(glance.step);
    for (SampleExtremes &stretch : glance.trace) {
        const double one = physicalValue(channel, stretch.min);
        const double other = physicalValue(channel, stretch.max);
        stretch.min = std::min(one, other);
        stretch.max = std::max(one, other);
    }
    return glance;
}

std::vector<ChannelRole> proposedRoles(const std::vector<ChannelGlance> &channels)
{
    std::vector<ChannelRole> roles(channels.size(), ChannelRole::Other);
    const bool anyRises = std::ranges::any_of(
        channels, [](const ChannelGlance &one) { return one.steps() && one.step > 0.0; });
    std::optional<std::size_t> dut;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const ChannelGlance &glance = channels[i];
        if (!glance.steps())
            continue;
        if (glance.step < 0.0 && (anyRises || isSlow(glance))) {
            roles[i] = ChannelRole::Driver;
            continue;
        }
        const bool later = dut && glance.stepAt > channels[*dut].stepAt;
        const bool ringsMore
            = dut && glance.stepAt == channels[*dut].stepAt && glance.swing > channels[*dut].swing;
        if (!dut || later || ringsMore)
            dut = i;
    }
    if (!dut)
        return roles;
    roles[*dut] = ChannelRole::Dut;
    std::optional<std::size_t> side;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const bool candidate = i != *dut && channels[i].steps() && roles[i] == ChannelRole::Other
            && channels[i].stepAt < channels[*dut].stepAt;
        if (candidate && (!side || channels[i].stepAt > channels[*side].stepAt))
            side = i;
    }
    if (side)
        roles[*side] = ChannelRole::DrivenSide;
    return roles;
}

} // namespace dyncal
