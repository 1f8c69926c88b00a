// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_measurement.h"

#include "core/project/recipe_limits.h"

namespace dyncal {
namespace {

constexpr Index kMostSamples = 1000000000;

Codec<ExcludedStretch> excludedStretch()
{
    using S = ExcludedStretch;
    return object<S>({
        field("shot", DYNCAL_TEXT("RecipeLabel", "shot of the stretch"), &S::shot,
            whole(1, kMostShots), true),
        field("from_s", DYNCAL_TEXT("RecipeLabel", "begin of the stretch"), &S::from_s, anyNumber(),
            true),
        field("to_s", DYNCAL_TEXT("RecipeLabel", "end of the stretch"), &S::to_s, positiveNumber(),
            true),
        field("reason", DYNCAL_TEXT("RecipeLabel", "reason for leaving the stretch out"),
            &S::reason, nonEmptyText(), true),
    });
}

/// "auto" (nothing in the list), one time, or one time per shot.
Codec<std::vector<double>> start()
{
    const std::string needs = "\"auto\", a time in seconds or a list of one time per shot";
    const Codec<std::vector<double>> times = list(anyNumber(), 1);
    const auto read = [=](const JsonAt &at) -> Result<std::vector<double>> {
        if (at.value == "auto")
            return std::vector<double>();
        if (at.value.is_number())
            return std::vector<double>{at.value.get<double>()};
        if (!at.value.is_array())
            return mismatch(at, needs);
        return times.read(at);
    };
    const auto write = [times](const std::vector<double> &values) {
        if (values.empty())
            return Json("auto");
        return values.size() == 1 ? Json(values.front()) : times.write(values);
    };
    return {needs, read, write};
}

/// null = nothing is subtracted; two members share the key.
Field<WindowSettings> baseline()
{
    const auto codec = valueOr(Json(nullptr), orAuto(interval()));
    return {"baseline_s", DYNCAL_TEXT("RecipeLabel", "baseline"),
        [codec](const JsonAt &at, WindowSettings &window) -> Result<void> {
            const Result<std::optional<Auto<Interval>>> value = codec.read(at);
            if (!value)
                return tl::unexpected<Error>(value.error());
            window.subtractBaseline = value->has_value();
            window.baseline_s = value->value_or(Auto<Interval>());
            return {};
        },
        [codec](const WindowSettings &window) {
            return codec.write(
                window.subtractBaseline ? std::optional(window.baseline_s) : std::nullopt);
        }};
}

/// "plateau", a time after the start, or a list of one per shot; three members share the key.
Field<WindowSettings> windowEnd()
{
    Codec<std::optional<Auto<double>>> common = valueOr(Json("plateau"), orAuto(positiveNumber()));
    common.needs += ", or a list with one of the last two per shot";
    const Codec<std::vector<Auto<double>>> own = list(orAuto(positiveNumber()), 1);
    return {"end_s", DYNCAL_TEXT("RecipeLabel", "end of the window"),
        [=](const JsonAt &at, WindowSettings &window) -> Result<void> {
            window.end_s = {};
            window.ownEnds_s.clear();
            window.endAtPlateau = false;
            if (at.value.is_array()) {
                Result<std::vector<Auto<double>>> values = own.read(at);
                if (!values)
                    return tl::unexpected<Error>(values.error());
                window.ownEnds_s = std::move(*values);
                return {};
            }
            const Result<std::optional<Auto<double>>> value = common.read(at);
            if (!value)
                return mismatch(at, common.needs);
            window.endAtPlateau = !value->has_value();
            window.end_s = value->value_or(Auto<double>());
            return {};
        },
        [=](const WindowSettings &window) {
            if (!window.endAtPlateau && !window.ownEnds_s.empty())
                return own.write(window.ownEnds_s);
            return common.write(window.endAtPlateau ? std::nullopt : std::optional(window.end_s));
        }};
}

/// "auto" = search, "none", or the operator's own list; two members share the key.
Field<SpectrumSettings> resonance()
{
    const auto frequencies = list(positiveNumber());
    const std::string needs = "\"auto\", \"none\" or a list of frequencies in hertz";
    return {"resonance", DYNCAL_TEXT("RecipeLabel", "resonance"),
        [=](const JsonAt &at, SpectrumSettings &spectrum) -> Result<void> {
            const bool isWord = at.value == "auto" || at.value == "none";
            if (!isWord && !at.value.is_array())
                return mismatch(at, needs);
            spectrum.searchResonance = at.value == "auto";
            spectrum.resonances_Hz.clear();
            if (isWord)
                return {};
            Result<std::vector<double>> values = frequencies.read(at);
            if (!values)
                return tl::unexpected<Error>(values.error());
            spectrum.resonances_Hz = std::move(*values);
            return {};
        },
        [frequencies](const SpectrumSettings &spectrum) {
            if (spectrum.searchResonance)
                return Json("auto");
            return spectrum.resonances_Hz.empty() ? Json("none")
                                                  : frequencies.write(spectrum.resonances_Hz);
        }};
}

Codec<WindowSettings> windowCodec()
{
    using S = WindowSettings;
    return object<S>({
        field("start", DYNCAL_TEXT("RecipeLabel", "start"), &S::start_s, start()),
        baseline(),
        windowEnd(),
        field("settle_s", DYNCAL_TEXT("RecipeLabel", "settle band"), &S::settle_s,
            orAuto(interval())),
        field("exclude_stretches", DYNCAL_TEXT("RecipeLabel", "stretches left out of the fit"),
            &S::excludeStretches, list(excludedStretch())),
    });
}

Codec<SpectrumSettings> spectrumCodec()
{
    using S = SpectrumSettings;
    return object<S>({
        field("taper", DYNCAL_TEXT("RecipeLabel", "window function"), &S::taper,
            choice<Taper>({{"rectangular", Taper::Rectangular}, {"hann", Taper::Hann}})),
        field("method", DYNCAL_TEXT("RecipeLabel", "estimator"), &S::method,
            choice<SpectrumMethod>(
                {{"periodogram", SpectrumMethod::Periodogram}, {"welch", SpectrumMethod::Welch}})),
        field("segment", DYNCAL_TEXT("RecipeLabel", "segment length"), &S::segment,
            orNull(whole(8, kMostSamples))),
        field("detrend", DYNCAL_TEXT("RecipeLabel", "trend taken off"), &S::detrend,
            choice<Detrend>(
                {{"none", Detrend::None}, {"mean", Detrend::Mean}, {"linear", Detrend::Linear}})),
        field("resonance_band_hz", DYNCAL_TEXT("RecipeLabel", "band of the search"),
            &S::resonanceBand_Hz, orNull(interval())),
        resonance(),
    });
}

} // namespace

std::vector<Field<Recipe>> measurementSections()
{
    return {
        field("window", DYNCAL_TEXT("RecipeLabel", "window"), &Recipe::window, windowCodec()),
        field("remap", DYNCAL_TEXT("RecipeLabel", "remap to 0..1"), &Recipe::remap, boolean()),
        field(
            "spectrum", DYNCAL_TEXT("RecipeLabel", "spectrum"), &Recipe::spectrum, spectrumCodec()),
    };
}

} // namespace dyncal
