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

/// The words for a role; with "" for null where none need be given.
std::vector<std::string> roleWords(bool mayBeNull)
{
    std::vector<std::string> words;
    for (const ChannelRole r : {ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver,
             ChannelRole::Trigger, ChannelRole::Reference, ChannelRole::Other})
        words.emplace_back(channelRoleName(r));
    words.insert(words.end(), {"velocity", "driver_static"}); // older words, as in captures
    if (mayBeNull)
        words.emplace_back("");
    return words;
}

std::vector<RecipeKey> columnNames()
{
    return {
        {"time", DYNCAL_TEXT("RecipeLabel", "column of the times")},
        {"dut", DYNCAL_TEXT("RecipeLabel", "column of the DUT")},
        {"driven_side", DYNCAL_TEXT("RecipeLabel", "column of the driven-side sensor")},
        {"driver", DYNCAL_TEXT("RecipeLabel", "column of the driver pressure")},
        {"trigger", DYNCAL_TEXT("RecipeLabel", "column of the trigger")},
        {"other", DYNCAL_TEXT("RecipeLabel", "column of another channel")},
    };
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
    return {"null or " + plain.needs, read, write, plain.keys};
}

Codec<ExcludedShot> excludedShot()
{
    return object<ExcludedShot>({
        field("shot", DYNCAL_TEXT("RecipeLabel", "excluded shot"), &ExcludedShot::shot,
            whole(1, kMostShots), true),
        field("reason", DYNCAL_TEXT("RecipeLabel", "reason for the exclusion"),
            &ExcludedShot::reason, nonEmptyText(), true),
    });
}

Codec<ShotImport> shotImport()
{
    return object<ShotImport>({
        field("shot", DYNCAL_TEXT("RecipeLabel", "shot with roles of its own"), &ShotImport::shot,
            whole(1, kMostShots), true),
        field("channels", DYNCAL_TEXT("RecipeLabel", "channel roles of one shot"),
            &ShotImport::channels, dictionary(oneOf(roleWords(false)), "a channel's name"), true),
    });
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
    const auto detail = [](const char *key, const char *label, auto ChannelImport::*member,
                            auto codec) {
        return Field<NamedChannel>{key, label,
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
        field("role", DYNCAL_TEXT("RecipeLabel", "role of the channel"), &NamedChannel::role,
            oneOf(roleWords(true))),
        detail("unit", DYNCAL_TEXT("RecipeLabel", "unit of the channel"), &D::unit,
            orNull(nonEmptyText())),
        detail("scale", DYNCAL_TEXT("RecipeLabel", "factor on the channel"), &D::scale,
            orNull(positiveNumber())),
        detail("gain", DYNCAL_TEXT("RecipeLabel", "gain of the channel"), &D::gain,
            orNull(positiveNumber())),
        detail("sensitivity", DYNCAL_TEXT("RecipeLabel", "sensitivity of the channel"),
            &D::sensitivity, orNull(positiveNumber())),
        detail("polarity", DYNCAL_TEXT("RecipeLabel", "inverted polarity of the channel"),
            &D::polarity, orNull(polarity())),
        detail("reference", DYNCAL_TEXT("RecipeLabel", "gauge or absolute pressure of the channel"),
            &D::reference, reference()),
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
    return {needs, read, write, details.keys};
}

/// One key for roles and details; two members share it.
template <typename S>
Field<S> channels()
{
    const auto codec = dictionary(namedChannel(), "a channel's name");
    return {"channels", DYNCAL_TEXT("RecipeLabel", "channel roles"),
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
        codec.keys};
}

/// The keys of import that a file may have for itself; null = as for all files.
Codec<FileImport> fileImport()
{
    using F = FileImport;
    Codec<FileImport> codec = object<F>({
        field("format", &F::format, orNull(nonEmptyText())),
        field("columns", &F::columns, columns()),
        field("columns_are", &F::columnsAre, oneOf({"", kColumnsAreChannels, kColumnsAreShots})),
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
    codec.keys.clear(); // documented once, under import
    return codec;
}

Codec<ImportSettings> importCodec()
{
    using S = ImportSettings;
    return object<S>({
        field("format", DYNCAL_TEXT("RecipeLabel", "file format"), &S::format, nonEmptyText()),
        field("columns", DYNCAL_TEXT("RecipeLabel", "columns of the text file"), &S::columns,
            columns()),
        field("columns_are", DYNCAL_TEXT("RecipeLabel", "what the columns are"), &S::columnsAre,
            oneOf({kColumnsAreChannels, kColumnsAreShots})),
        channels<S>(),
        field("decimal", DYNCAL_TEXT("RecipeLabel", "decimal mark"), &S::decimal,
            oneOf({"auto", ".", ","})),
        field("separator", DYNCAL_TEXT("RecipeLabel", "separator"), &S::separator,
            oneOf({"auto", ",", ";", "tab", "space", "|"})),
        field(
            "sample_rate_hz", DYNCAL_TEXT("RecipeLabel", "sample rate"), &S::sampleRate_Hz, rate()),
        field("sample_rate_reason", DYNCAL_TEXT("RecipeLabel", "why the rate in the file is wrong"),
            &S::sampleRateReason, textOrNull()),
        field("unit", DYNCAL_TEXT("RecipeLabel", "unit of the DUT"), &S::unit,
            orNull(nonEmptyText())),
        field(
            "scale", DYNCAL_TEXT("RecipeLabel", "factor on the DUT"), &S::scale, positiveNumber()),
        field(
            "polarity", DYNCAL_TEXT("RecipeLabel", "inverted polarity"), &S::polarity, polarity()),
        field("reference", DYNCAL_TEXT("RecipeLabel", "gauge or absolute pressure"), &S::reference,
            reference()),
        field("skip_rows", DYNCAL_TEXT("RecipeLabel", "rows before the data"), &S::skipRows,
            orNull(whole(0, kMostRows))),
        field("interpolate_invalid", DYNCAL_TEXT("RecipeLabel", "longest gap to be filled"),
            &S::interpolateInvalid, whole(0, kLongestGap)),
        field("max_expansion", DYNCAL_TEXT("RecipeLabel", "memory that a file may take"),
            &S::maxExpansion, number(kLeastExpansion, kMostExpansion)),
        field("channel_files", DYNCAL_TEXT("RecipeLabel", "files joined as channels"),
            &S::channelFiles, oneOf({kJoinChannelFiles, "apart"})),
        field("levels", DYNCAL_TEXT("RecipeLabel", "levels of the shots"), &S::levels,
            listOrNull(oneOf({"low", "medium", "high", ""}))),
        field("exclude", DYNCAL_TEXT("RecipeLabel", "excluded shots"), &S::exclude,
            list(excludedShot())),
        field("shots", DYNCAL_TEXT("RecipeLabel", "settings of single shots"), &S::shots,
            list(shotImport())),
        field("files", DYNCAL_TEXT("RecipeLabel", "import settings of single files"), &S::files,
            dictionary(fileImport(), "a file's name")),
    });
}

} // namespace

std::vector<Field<Recipe>> importSections()
{
    return {
        field("import", DYNCAL_TEXT("RecipeLabel", "import settings"), &Recipe::import,
            importCodec()),
    };
}

} // namespace dyncal
