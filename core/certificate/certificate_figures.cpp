// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_figures.h"

#include "core/pipeline/calibration_kind.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {
namespace {

using C = CalibrationResults;
using R = const C &;

/// A figure, its caption, and whether the results hold what it shows.
struct KnownFigure
{
    std::string_view id;
    const char *caption;
    bool (*isThere)(R);
};

template <auto part>
bool has(R r)
{
    return r.*part != nullptr;
}
/// One shot alone has none: its figures would be empty.
bool hasComponents(R r)
{
    return r.components && r.components->principal;
}
bool hasComparison(R r)
{
    return r.comparison && r.comparison->againstStep;
}

constexpr std::string_view kPoleZero = "pole-zero";

constexpr std::array<KnownFigure, 22> kKnownFigures{{
    {"raw-dut", DYNCAL_TEXT("core", "Recordings of the item calibrated"), has<&C::captures>},
    {"raw-driven-side",
        DYNCAL_TEXT("core", "Recordings of the sensors in the wall of the driven section"),
        has<&C::captures>},
    {"raw-driver", DYNCAL_TEXT("core", "Recordings of the sensor in the driver section"),
        has<&C::captures>},
    {"responses", DYNCAL_TEXT("core", "Responses of the item, aligned at their start"),
        has<&C::window>},
    {"responses-start", DYNCAL_TEXT("core", "First moments of the responses"), has<&C::window>},
    {"spectrum", DYNCAL_TEXT("core", "Power spectra of the responses"), has<&C::window>},
    {"explained", DYNCAL_TEXT("core", "Share explained by the first principal components"),
        hasComponents},
    {"reconstruction", DYNCAL_TEXT("core", "Responses reconstructed from the components kept"),
        hasComponents},
    {"residuals", DYNCAL_TEXT("core", "Residuals of the reconstruction"), hasComponents},
    {"residual-autocovariance",
        DYNCAL_TEXT("core", "Autocovariance of the residuals; dotted: white noise"), hasComponents},
    {"residual-spectrum", DYNCAL_TEXT("core", "Power spectra of the residuals"), hasComponents},
    {"average", DYNCAL_TEXT("core", "Average of the reconstructions"), hasComponents},
    {"model-input", DYNCAL_TEXT("core", "Input of the model"), has<&C::input>},
    {"singular-values", DYNCAL_TEXT("core", "Singular values of the Hankel matrix"),
        has<&C::decomposition>},
    {"bic", DYNCAL_TEXT("core", "Bayesian information criterion over the order"),
        has<&C::decomposition>},
    {"model-data", DYNCAL_TEXT("core", "Responses and model"), has<&C::model>},
    {"model-error", DYNCAL_TEXT("core", "Responses minus model"), has<&C::model>},
    {kPoleZero, "", has<&C::model>}, // poleZeroCaption()
    {"step", DYNCAL_TEXT("core", "Step response of the model"), has<&C::model>},
    {"magnitude", DYNCAL_TEXT("core", "Frequency response, magnitude"), has<&C::response>},
    {"phase", DYNCAL_TEXT("core", "Frequency response, phase"), has<&C::response>},
    {"comparison",
        DYNCAL_TEXT("core",
            "Magnitude against the reference transducer and against the pressure step, less the mean of both"),
        hasComparison},
}};

const KnownFigure *knownFigure(const std::string &id)
{
    const auto found = std::ranges::find(kKnownFigures, std::string_view(id), &KnownFigure::id);
    return found == kKnownFigures.end() ? nullptr : &*found;
}

/// What the map cannot show is said in its caption.
Message poleZeroCaption(const SensorModel &model)
{
    const std::vector<std::string> counts{std::to_string(model.poles.size()),
        std::to_string(model.zeros.size()), std::to_string(countBeyondMap(model))};
    return countBeyondMap(model) == 0
        ? Message{DYNCAL_TEXT(
                      "core", "Poles and zeros of the model in the z-plane; poles: %1, zeros: %2"),
            counts}
        : Message{
            DYNCAL_TEXT("core",
                "Poles and zeros of the model in the z-plane; poles: %1, zeros: %2; further out than shown: %3"),
            counts};
}

Message captionOf(const KnownFigure &figure, R results)
{
    if (figure.id == kPoleZero)
        return poleZeroCaption(*results.model);
    if (figure.id == "phase" && results.response->isByTransducer)
        return {
            DYNCAL_TEXT("core",
                "Frequency response, phase; measured: from the pressure at the reference transducer, model: from the item's own onset"),
            {}};
    return {figure.caption, {}};
}

/// A free decay has neither a frequency response nor a step.
bool isOfSteps(const std::string &figure)
{
    return figure == "magnitude" || figure == "phase" || figure == "step";
}

} // namespace

CertificateSection figuresSection(const CalibrationResults &results, const Recipe &recipe,
    const std::vector<std::string> &figures)
{
    CertificateSection section;
    section.id = "figures";
    section.title = {DYNCAL_TEXT("core", "Figures"), {}};
    const bool isDecay = calibrationKind(results, recipe) == CalibrationKind::FreeDecay;
    for (const std::string &id : figures) {
        const KnownFigure *figure = knownFigure(id);
        if (figure && figure->isThere(results) && !(isDecay && isOfSteps(id)))
            section.figures.push_back({id, captionOf(*figure, results)});
    }
    return section;
}

} // namespace dyncal
