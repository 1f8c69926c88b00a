// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_rules.h"

#include "core/base/number_text.h"
#include "core/capture/channel_units.h"
#include "core/capture/gap_filling.h"
#include "core/capture/sensor_card.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace dyncal {
namespace {

constexpr double kPercent = 0.01;
constexpr double kSameRate = 1e-9; ///< rounding of a rate that was written as an interval

bool isRate(double rate_Hz)
{
    return rate_Hz > 0.0 && std::isfinite(rate_Hz);
}

tl::unexpected<Error> missingRate(const Channel &channel, Index shot)
{
    return fail(ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "Shot %1, channel '%2': the file states no sample rate and has no time column; give import.sample_rate_hz in the recipe."),
            {std::to_string(shot), channel.name}},
        "CAP-003", shot);
}

/// A rate written as an interval may be off by its rounding.
bool isCredible(double rate_Hz)
{
    return rate_Hz >= kLowestRate_Hz * (1.0 - kSameRate)
        && rate_Hz <= kHighestRate_Hz * (1.0 + kSameRate);
}

tl::unexpected<Error> incredibleRate(const Channel &channel, Index shot, double rate_Hz, bool typed)
{
    const char *ofFile = DYNCAL_TEXT("core",
        "Shot %1, channel '%2': the file gives a sample rate of %3 (an interval of %4), and recordings have %5 to %6. Correct the times or the rate in the file, or give import.sample_rate_hz and import.sample_rate_reason.");
    const char *ofRecipe = DYNCAL_TEXT("core",
        "Shot %1, channel '%2': import.sample_rate_hz is %3 (an interval of %4), and recordings have %5 to %6. Correct the key.");
    const double interval_s = 1.0 / std::max(rate_Hz, std::numeric_limits<double>::min());
    return fail(ErrorKind::DataBlocked,
        Message{typed ? ofRecipe : ofFile,
            {std::to_string(shot), channel.name, numberText(rate_Hz, 6) + " Hz",
                numberText(interval_s, 6) + " s", numberWithUnit(kLowestRate_Hz, "Hz"),
                numberWithUnit(kHighestRate_Hz, "Hz")}},
        "CAP-003", shot);
}

tl::unexpected<Error> contradictedRate(const Channel &channel, Index shot, double typed_Hz)
{
    return fail(ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "Shot %1, channel '%2': the file states %3 but import.sample_rate_hz is %4. Leave the key out, or say in import.sample_rate_reason why the file is wrong."),
            {std::to_string(shot), channel.name, numberWithUnit(channel.sampleRate_Hz, "Hz", 6),
                numberWithUnit(typed_Hz, "Hz", 6)}},
        "CAP-003", shot);
}

Finding replacedRate(double stated_Hz, double typed_Hz, const std::string &reason, bool contradicts)
{
    const std::string typed = numberWithUnit(typed_Hz, "Hz", 6);
    const std::string stated = numberWithUnit(stated_Hz, "Hz", 6);
    if (!contradicts)
        return {.id = "CAP-025",
            .severity = Severity::Info,
            .message = {DYNCAL_TEXT("core",
                            "The recipe's sample rate of %1 replaces the %2 that the files state."),
                {typed, stated}},
            .value = typed_Hz,
            .limit = stated_Hz};
    return {.id = "CAP-025",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The recipe's sample rate of %1 replaces the %2 that the files state; reason: %3."),
            {typed, stated, reason}},
        .value = typed_Hz,
        .limit = stated_Hz};
}

/// The recipe's settings for this channel; for the DUT, completed by those for the DUT.
ChannelImport detailsOf(const Channel &channel, const ImportSettings &settings)
{
    const auto found = settings.channelDetails.find(channel.name);
    ChannelImport details
        = found != settings.channelDetails.end() ? found->second : ChannelImport();
    if (channel.role != ChannelRole::Dut)
        return details;
    if (!details.unit)
        details.unit = settings.unit;
    details.scale = details.scale.value_or(settings.scale);
    details.polarity = details.polarity.value_or(settings.polarity);
    if (details.reference.empty())
        details.reference = settings.reference;
    return details;
}

PressureReference referenceFromName(const std::string &name)
{
    return name == "gauge" ? PressureReference::Gauge : PressureReference::Absolute;
}

/// A file that states no unit may have it in the channel's name; a scale of the recipe is taken for
/// the conversion.
void takeUnitOfName(Channel &channel, double scale, Findings &findings)
{
    const std::optional<std::string> unit = unitInName(channel.name);
    if (!channel.unit.empty() || !unit || scale != 1.0)
        return;
    channel.unit = *unit;
    addOnce(findings,
        {.id = "CAP-033",
            .severity = Severity::Info,
            .channel = channel.name,
            .message
            = {DYNCAL_TEXT("core",
                   "Channel '%1': the file states no unit, so its numbers are read as %2, as the name ends. Give the channel's unit if they are something else."),
                {channel.name, *unit}}});
}

void convertToSi(Channel &channel)
{
    const auto si = siUnitOf(channel.unit);
    if (!si || si->unit == channel.unit)
        return;
    channel.recordedUnit = channel.unit;
    channel.userScale *= si->factor;
    channel.unit = si->unit;
}

/// What a sensor gives, once it is in its SI unit: a unit with an unknown prefix or spelling is not
/// what the sensitivity is of.
bool isSensorUnit(const std::string &unit)
{
    static constexpr std::array<std::string_view, 6> kUnits{"V", "A", "C", "W", "1", ""};
    return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

/// A unit that says what was measured, and how large: not the counts, volts per division or letters
/// that only the recipe explains.
bool isKnownUnit(const std::string &unit)
{
    return siUnitOf(unit) || (isSensorUnit(unit) && unit != "1" && !unit.empty());
}

/// CAP-030: the recipe's unit in place of the file's; with a factor it may be meant as a
/// conversion.
void reportReplacedUnit(const Channel &channel, const ChannelImport &details, Findings &findings)
{
    const std::string &unit = *details.unit;
    const SiUnit recorded = siUnitOf(channel.unit).value_or(SiUnit{channel.unit});
    const SiUnit typed = siUnitOf(unit).value_or(SiUnit{unit});
    if (!isKnownUnit(channel.unit)
        || (recorded.unit == typed.unit && recorded.factor == typed.factor))
        return;
    const double factor = details.scale.value_or(1.0) / details.gain.value_or(1.0);
    Finding finding{.id = "CAP-030",
        .severity = factor == 1.0 ? Severity::Caution : Severity::Info,
        .channel = channel.name,
        .message = {factor == 1.0
                ? DYNCAL_TEXT("core",
                    "Channel '%1': the recipe reads the numbers as %2, the file states %3, and no scale converts them: leave out the unit, or give the scale that belongs to it.")
                : DYNCAL_TEXT("core",
                    "Channel '%1': the recipe reads the numbers as %2, with a factor of %4 in place of the file's %3."),
            {channel.name, unit, channel.unit, numberText(factor, 6)}},
        .causes = {FindingCause::Scale}};
    if (factor != 1.0)
        finding.causes.clear();
    addOnce(findings, std::move(finding));
}

Result<void> divideBySensitivity(Channel &channel, Index shot, double sensitivity)
{
    if (channel.unit == "Pa")
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Shot %1, channel '%2' is a pressure already (%3), so it cannot have a sensitivity; leave out the sensitivity or give its unit, e.g. V."),
                {std::to_string(shot), channel.name,
                    channel.recordedUnit.empty() ? channel.unit : channel.recordedUnit}});
    if (!isSensorUnit(channel.unit))
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Shot %1, channel '%2': the unit \"%3\" is not known, so it cannot be divided by a sensitivity per pascal; the units known are V, mV, uV, kV, A, C, W and 1. Give one of them as the channel's unit, with the scale that it needs."),
                {std::to_string(shot), channel.name, channel.unit}});
    channel.userScale /= sensitivity;
    channel.recordedUnit.clear();
    channel.unit = "Pa";
    channel.quantity = "pressure";
    return {};
}

void fillGapsOfDut(Channel &channel, Index shot, Index longest, Findings &findings)
{
    if (channel.role != ChannelRole::Dut)
        return;
    const Index filled = fillGaps(channel.samples, longest); // sha256 stays that of the recording
    if (filled > 0)
        findings.push_back({.id = "CAP-022",
            .severity = Severity::Caution,
            .shot = shot,
            .channel = channel.name,
            .message = {DYNCAL_TEXT("core", "Shot %1, %2: %3 invalid samples were interpolated."),
                {std::to_string(shot), channel.name, std::to_string(filled)}},
            .value = static_cast<double>(filled),
            .limit = static_cast<double>(longest)});
}

} // namespace

Result<void> setSampleRate(Channel &channel, Index shot, const ImportSettings &settings,
    const CheckSettings &checks, Findings &findings)
{
    const double stated_Hz = channel.sampleRate_Hz;
    const double rate_Hz = settings.sampleRate_Hz.value_or(stated_Hz);
    if (!isRate(rate_Hz))
        return missingRate(channel, shot);
    if (!isCredible(rate_Hz))
        return incredibleRate(channel, shot, rate_Hz, settings.sampleRate_Hz.has_value());
    const double difference = isRate(stated_Hz) ? std::abs(rate_Hz / stated_Hz - 1.0) : 0.0;
    const bool contradicts = difference > kPercent * checks.rateMismatch_percent;
    if (contradicts && settings.sampleRateReason.empty())
        return contradictedRate(channel, shot, rate_Hz);
    channel.sampleRate_Hz = rate_Hz;
    if (difference <= kSameRate)
        return {};
    addOnce(findings, replacedRate(stated_Hz, rate_Hz, settings.sampleRateReason, contradicts));
    return {};
}

Result<void> shapeChannel(Channel &channel, Index shot, const ImportSettings &settings,
    const Attributes &card, Findings &findings)
{
    const ChannelImport details = detailsOf(channel, settings);
    if (details.unit) {
        reportReplacedUnit(channel, details, findings);
        channel.unit = *details.unit;
    }
    const double scale = details.scale.value_or(1.0);
    takeUnitOfName(channel, scale, findings);
    channel.userScale *= scale / details.gain.value_or(1.0);
    channel.polarity *= details.polarity.value_or(1);
    if (!details.reference.empty())
        channel.reference = referenceFromName(details.reference);
    convertToSi(channel);
    if (details.sensitivity) {
        if (auto contradiction = typedAgainstCard(card, channel, *details.sensitivity))
            addOnce(findings, std::move(*contradiction));
        if (auto done = divideBySensitivity(channel, shot, *details.sensitivity); !done)
            return done;
    }
    fillGapsOfDut(channel, shot, settings.interpolateInvalid, findings);
    return {};
}

} // namespace dyncal
