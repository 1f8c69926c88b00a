// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_import.h"

#include "core/capture/channel.h"
#include "core/project/recipe_limits.h"

namespace dyncal {
namespace {

constexpr Index kMostColumns = 100000;
constexpr Index kMostRows = 1000000000;
constexpr Index kLongestGap = 1000;
constexpr double kLeastExpansion = 1.0;
constexpr double kMostExpansion = 1e4; ///< no real filter compresses samples more
constexpr double kFastestRate_Hz = 1e12;
constexpr double kMostReadingFactor = 1e6;
constexpr double kLeastStepSigmas = 4.0; ///< below, noise alone would count as a step
constexpr double kMostStepSigmas = 1e6;

/// The words for a role; with "" for null where none need be given.
std::vector<std::string> roleWords(bool mayBeNull)
{
    std::vector<std::string> words;
    for (const ChannelRole r : {ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver,
             ChannelRole::Trigger, ChannelRole::Other})
        words.emplace_back(channelRoleName(r));
    words.insert(words.end(), {"velocity", "driver_static"}); // older words, as in captures
    if (mayBeNull)
        words.emplace_back("");
    return words;
}

std::vector<std::string> columnNames()
{
    return {"time", "dut", "driven_side", "driver", "trigger", "other"};
}

Codec<int> polarity()
{
    const Codec<Index> inner = whole(-1, 1);
    const auto read = [inner](const JsonAt &at) -> Result<int> {
        const Result<Index> value = inner.read(at);
        if (!value || *value == 0)
            return mismatch(at, "1 or -1");
        return static_cast<int>(*value);
    };
    return {"1 or -1", read, [](const int &value) { return Json(value); }};
}

/// A list whose absence is written as null.
template <typename T>
Codec<std::vector<T>> listOrNull(Codec<T> inner)
{
    const Codec<std::vector<T>> plain = list(std::move(inner));
    const auto read = [plain](const JsonAt &at) -> Result<std::vector<T>> {
        if (at.value.is_null())
            return std::vector<T>();
        return plain.read(at);
    };
    const auto write = [plain](const std::vector<T> &values) {
        return values.empty() ? Json(nullptr) : plain.write(values);
    };
    return {"null or " + plain.needs, read, write, plain.paths};
}

Codec<ExcludedShot> excludedShot()
{
    return object<ExcludedShot>({
        field("shot", &ExcludedShot::shot, whole(1, kMostShots), true),
        field("reason", &ExcludedShot::reason, nonEmptyText(), true),
    });
}

/// A text whose absence is written as null.
Codec<std::string> textOrNull()
{
    const Codec<std::optional<std::string>> plain = orNull(nonEmptyText());
    const auto read = [plain](const JsonAt &at) -> Result<std::string> {
        return plain.read(at).map(
            [](const std::optional<std::string> &text) { return text.value_or(""); });
    };
    return {plain.needs, read,
        [](const std::string &text) { return text.empty() ? Json(nullptr) : Json(text); }};
}

Codec<std::string> reference()
{
    return oneOf({"", "gauge", "absolute"});
}

Codec<std::optional<double>> rate()
{
    return orNull(number(0.0, kFastestRate_Hz, Bound::Exclusive));
}

Codec<std::map<std::string, Index>> columns()
{
    return dictionary(whole(0, kMostColumns), "\"time\" or a role", columnNames());
}

/// A channel as the recipe writes it: a role alone, or an object that may hold one.
struct NamedChannel
{
    std::string role; ///< "" = as the file says
    ChannelImport details;
    bool isObject = false;
};

Codec<NamedChannel> channelObject()
{
    // A detail is a member of a member, which field() does not reach.
    const auto detail = [](const char *key, auto ChannelImport::*member, auto codec) {
        return Field<NamedChannel>{key,
            [=](const JsonAt &at, NamedChannel &channel) -> Result<void> {
                auto value = codec.read(at);
                if (!value)
                    return tl::unexpected<Error>(value.error());
                channel.details.*member = std::move(*value);
                return {};
            },
            [=](const NamedChannel &channel) { return codec.write(channel.details.*member); }};
    };
    using D = ChannelImport;
    return object<NamedChannel>({
        field("role", &NamedChannel::role, oneOf(roleWords(true))),
        detail("unit", &D::unit, orNull(nonEmptyText())),
        detail("scale", &D::scale, orNull(positiveNumber())),
        detail("gain", &D::gain, orNull(positiveNumber())),
        detail("sensitivity", &D::sensitivity, orNull(positiveNumber())),
        detail("polarity", &D::polarity, orNull(polarity())),
        detail("reference", &D::reference, reference()),
    });
}

Codec<NamedChannel> namedChannel()
{
    const Codec<std::string> word = oneOf(roleWords(false));
    const Codec<NamedChannel> details = channelObject();
    const std::string needs = word.needs + " or an object";
    const auto read = [=](const JsonAt &at) -> Result<NamedChannel> {
        if (at.value.is_object())
            return details.read(at).map([](NamedChannel channel) {
                channel.isObject = true;
                return channel;
            });
        if (!at.value.is_string())
            return mismatch(at, needs);
        return word.read(at).map([](const std::string &text) {
            return NamedChannel{text, {}, false};
        });
    };
    const auto write = [=](const NamedChannel &channel) {
        return channel.isObject ? details.write(channel) : word.write(channel.role);
    };
    return {needs, read, write, details.paths};
}

/// One key for roles and details; two members share it.
template <typename S>
Field<S> channels()
{
    const auto codec = dictionary(namedChannel(), "a channel's name");
    return {"channels",
        [codec](const JsonAt &at, S &settings) -> Result<void> {
            const auto named = codec.read(at);
            if (!named)
                return tl::unexpected<Error>(named.error());
            for (const auto &[name, channel] : *named) {
                if (!channel.role.empty())
                    settings.channels[name] = channel.role;
                if (channel.isObject)
                    settings.channelDetails[name] = channel.details;
            }
            return {};
        },
        [codec](const S &settings) {
            std::map<std::string, NamedChannel> named;
            for (const auto &[name, role] : settings.channels)
                named[name].role = role;
            for (const auto &[name, details] : settings.channelDetails) {
                named[name].details = details;
                named[name].isObject = true;
            }
            return codec.write(named);
        },
        codec.paths};
}

/// The keys of import that a file may have for itself; null = as for all files.
Codec<FileImport> fileImport()
{
    using F = FileImport;
    Codec<FileImport> codec = object<F>({
        field("format", &F::format, orNull(nonEmptyText())),
        field("columns", &F::columns, columns()),
        channels<F>(),
        field("decimal", &F::decimal, oneOf({"", "auto", ".", ","})),
        field("separator", &F::separator, oneOf({"", "auto", ",", ";", "tab", "space", "|"})),
        field("sample_rate_hz", &F::sampleRate_Hz, rate()),
        field("sample_rate_reason", &F::sampleRateReason, textOrNull()),
        field("unit", &F::unit, orNull(nonEmptyText())),
        field("scale", &F::scale, orNull(positiveNumber())),
        field("polarity", &F::polarity, orNull(polarity())),
        field("reference", &F::reference, reference()),
        field("skip_rows", &F::skipRows, orNull(whole(0, kMostRows))),
        field("interpolate_invalid", &F::interpolateInvalid, orNull(whole(0, kLongestGap))),
        field("max_expansion", &F::maxExpansion, orNull(number(kLeastExpansion, kMostExpansion))),
    });
    codec.paths.clear(); // documented once, under import
    return codec;
}

} // namespace

Codec<ImportSettings> importCodec()
{
    using S = ImportSettings;
    return object<S>({
        field("format", &S::format, nonEmptyText()),
        field("columns", &S::columns, columns()),
        channels<S>(),
        field("decimal", &S::decimal, oneOf({"auto", ".", ","})),
        field("separator", &S::separator, oneOf({"auto", ",", ";", "tab", "space", "|"})),
        field("sample_rate_hz", &S::sampleRate_Hz, rate()),
        field("sample_rate_reason", &S::sampleRateReason, textOrNull()),
        field("unit", &S::unit, orNull(nonEmptyText())),
        field("scale", &S::scale, positiveNumber()),
        field("polarity", &S::polarity, polarity()),
        field("reference", &S::reference, reference()),
        field("skip_rows", &S::skipRows, orNull(whole(0, kMostRows))),
        field("interpolate_invalid", &S::interpolateInvalid, whole(0, kLongestGap)),
        field("max_expansion", &S::maxExpansion, number(kLeastExpansion, kMostExpansion)),
        field("channel_files", &S::channelFiles, oneOf({kJoinChannelFiles, "apart"})),
        field("levels", &S::levels, listOrNull(oneOf({"low", "medium", "high", ""}))),
        field("exclude", &S::exclude, list(excludedShot())),
        field("files", &S::files, dictionary(fileImport(), "a file's name")),
    });
}

Codec<CheckSettings> checksCodec()
{
    using S = CheckSettings;
    return object<S>({
        field("saturation_run", &S::saturationRun, whole(2, kMostRows)),
        field("flat_codes", &S::flatCodes, nonNegativeNumber()),
        field("min_codes", &S::leastCodes, nonNegativeNumber()),
        field("step_sigma", &S::stepSigmas, number(kLeastStepSigmas, kMostStepSigmas)),
        field("rate_mismatch_percent", &S::rateMismatch_percent, nonNegativeNumber()),
        field(
            "reading_factor", &S::readingFactor, number(1.0, kMostReadingFactor, Bound::Exclusive)),
    });
}

} // namespace dyncal
