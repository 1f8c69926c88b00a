// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/binary_record.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace dyncal {

double intendedInterval(double stored)
{
    const auto single = static_cast<float>(stored);
    if (!std::isfinite(single) || static_cast<double>(single) != stored)
        return stored;
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), single).ptr;
    double decimal = stored;
    std::from_chars(digits.data(), end, decimal);
    return decimal;
}

double sampleRateOf(double interval_s, const std::string &path, const std::string &channel,
    Index shot, Findings &findings)
{
    const double rate = 1.0 / interval_s;
    if (interval_s > 0.0 && std::isfinite(interval_s) && std::isfinite(rate))
        return rate;
    findings.push_back({.id = "CAP-016",
        .severity = Severity::Caution,
        .shot = shot,
        .channel = channel,
        .message
        = {DYNCAL_TEXT("core",
               "%1 states a sampling interval of %2 s for channel %3, which cannot be; state the sample rate in the recipe's import section if it is known."),
            {path, numberText(interval_s, 6), channel}},
        .value = interval_s});
    return 0.0;
}

void labelShots(CaptureSet &set, const std::string &path)
{
    const std::string stem = std::filesystem::path(path).stem().string();
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        Shot &shot = set.shots[i];
        shot.label = stem;
        if (set.shots.size() > 1)
            shot.label.append(", segment ").append(std::to_string(i + 1));
    }
}

std::string freeChannelName(const Shot &shot, const std::string &name)
{
    const auto isTaken = [&](const std::string &candidate) {
        return std::any_of(shot.channels.begin(), shot.channels.end(),
            [&](const Channel &channel) { return channel.name == candidate; });
    };
    std::string candidate = name;
    for (int k = 2; isTaken(candidate); ++k)
        candidate = name + " (" + std::to_string(k) + ")";
    return candidate;
}

Finding leftOut(const std::string &path, const std::string &name, const std::string &kind)
{
    return {.id = "CAP-026",
        .severity = Severity::Info,
        .channel = name,
        .message
        = {DYNCAL_TEXT("core", "%1: \"%2\" was left out, because it is no sampled signal (%3)."),
            {path, name, kind}}};
}

tl::unexpected<Error> endsInHeader(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 ends before its first sample, so it is likely an incomplete copy; copy it again."),
            {path}},
        "CAP-018");
}

tl::unexpected<Error> endsInSamples(
    const std::string &path, const std::string &channel, Index found, Index declared)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 ends after %3 of the %4 samples of channel %2 that its header declares, so it is likely an incomplete copy; copy it again."),
            {path, channel, std::to_string(found), std::to_string(declared)}},
        "CAP-018");
}

tl::unexpected<Error> impossibleField(
    const std::string &path, const std::string &field, const std::string &value)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 is damaged: its header states %2 as %3, which cannot be; copy the file again."),
            {path, field, value}},
        "CAP-018");
}

tl::unexpected<Error> unsupportedKind(const std::string &path, const std::string &kind)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 is a recording of kind %2, which this version does not read; save it as CSV."),
            {path, kind}},
        "CAP-001");
}

tl::unexpected<Error> noSignal(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 holds nothing that is a sampled signal; save the recorded channel itself."),
            {path}},
        "CAP-001");
}

} // namespace dyncal
