// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/chain_findings.h"

#include "core/base/number_text.h"
#include "core/uncertainty/quantity_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace dyncal {
namespace {

constexpr int kDigitsOfU = 2;
constexpr const char *kUnknownFront = "front_unknown";

/// A value whose U the two propagations give differently.
struct DifferentU
{
    Message name;
    std::string byTrials;
    std::string byGum;
    double ratio = 1.0; ///< of the first to the second
};

/// Both as words, and the value that differs most, for either direction.
struct DifferentUs
{
    Index count = 0;
    std::optional<DifferentU> worst;

    void add(DifferentU one)
    {
        const auto size = [](const DifferentU &u) { return std::abs(std::log(u.ratio)); };
        ++count;
        if (!worst || size(one) > size(*worst))
            worst = std::move(one);
    }
};

struct Differences
{
    DifferentUs tooSmall; ///< by the law of propagation
    DifferentUs ofFront; ///< the same, where it is a front that nobody stated that makes U
    DifferentUs tooLarge;
    Index compared = 0;

    /// `scale`, `unit`: what U is told in.
    void compare(const Message &name, double scale, const char *unit, const DrawnQuantity &drawn,
        const GumValidation &gum)
    {
        ++compared;
        const int size = sizeOfGum(gum, drawn);
        if (size == 0)
            return;
        const auto words = [&](double U) { return numberText(scale * U, kDigitsOfU) + " " + unit; };
        DifferentUs &list = size > 0 ? tooLarge : gum.largest == kUnknownFront ? ofFront : tooSmall;
        list.add(
            {name, words(drawn.expanded), words(gum.expanded()), drawn.expanded / gum.expanded()});
    }
};

Message atFrequency(const char *of, double frequency_Hz)
{
    return {DYNCAL_TEXT("core", "%M1 at %1"), {numberWithUnit(frequency_Hz, "Hz", 4)},
        {valueWords(of)}};
}

void compareRows(const std::vector<DrawnRow> &rows, Differences &differences)
{
    constexpr double kDegrees = 360.0 / kTwoPi;
    for (const DrawnRow &row : rows) {
        if (row.withMagnitude)
            differences.compare(atFrequency("magnitude", row.frequency_Hz),
                100.0 / std::abs(0.5 * (row.gumMagnitude.low + row.gumMagnitude.high)), "%",
                row.magnitude, row.gumMagnitude);
        if (row.withPhase)
            differences.compare(atFrequency("phase_rad", row.frequency_Hz), kDegrees, "\xC2\xB0",
                row.phase, row.gumPhase);
    }
}

Finding differentFinding(
    const DifferentUs &values, Index compared, Severity severity, const char *text)
{
    return {.id = "UNC-003",
        .severity = severity,
        .message = {text,
            {values.worst->byTrials, values.worst->byGum, std::to_string(values.count),
                std::to_string(compared)},
            {values.worst->name}},
        .value = 100.0 * (values.worst->ratio - 1.0),
        .limit = 100.0 * kExpandedDiffers};
}

Finding tooSmallFinding(const DifferentUs &values, Index compared)
{
    return differentFinding(values, compared, Severity::Caution,
        DYNCAL_TEXT("core",
            "%M1: Monte Carlo gives U = %1, the law of propagation only %2: use Monte Carlo. The law gives too little for %3 of %4 values and rows; their intervals by Monte Carlo are in monte_carlo of results.json."));
}

Finding ofFrontFinding(const DifferentUs &values, Index compared)
{
    Finding finding = differentFinding(values, compared, Severity::Info,
        DYNCAL_TEXT("core",
            "%M1: Monte Carlo gives U = %1, the law of propagation only %2, for a front of any duration up to 100 ns; it is so for %3 of %4 values and rows. Nobody has stated how long the front lasts: state shock.front_duration_s, or take these intervals from monte_carlo of results.json."));
    finding.causes = {FindingCause::Front};
    return finding;
}

Finding tooLargeFinding(const DifferentUs &values, Index compared)
{
    return differentFinding(values, compared, Severity::Info,
        DYNCAL_TEXT("core",
            "%M1: Monte Carlo gives U = %1, the law of propagation %2. The law gives more than is needed for %3 of %4 values and rows: what is stated is safe, Monte Carlo would state less."));
}

/// How far apart both are, whichever way: by spread, or by place in units of the spread.
double distanceOf(const RefittedValue &value)
{
    const double distance = std::max(
        std::abs(std::log(value.u_refits / value.u_draws)), std::abs(value.shift / value.u_draws));
    return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}

Finding failedRefits(const RefitCheck &check)
{
    return {.id = "UNC-006",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1 of %2 records made as the model gives them, with the noise of the shots, could not be fitted again: the values of the model may be far more uncertain than is stated. Choose a lower order, or record with less noise."),
            {std::to_string(check.failed), std::to_string(check.refits)}},
        .value = static_cast<double>(check.failed),
        .limit = 0.0};
}

Finding disagreeingRefits(const RefitCheck &check, const RefittedValue &worst)
{
    const double ratio = worst.u_refits / worst.u_draws;
    return {.id = "UNC-006",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%M1: %1 refits of simulated records are %2 times as uncertain as the model's covariance has it, and %3 of that u apart: the stated uncertainties of the model's values do not hold. Choose a lower order, or record with less noise."),
            {std::to_string(check.refits), numberText(ratio, kDigitsOfU),
                numberText(worst.shift / worst.u_draws, kDigitsOfU)},
            {valueWords(worst.of)}},
        .value = ratio,
        .limit = 1.0};
}

} // namespace

Findings judgeRefits(const RefitCheck &check)
{
    if (check.refits == 0 || check.agrees())
        return {};
    if (check.failed > 0)
        return {failedRefits(check)};
    const RefittedValue *worst = nullptr;
    for (const RefittedValue &one : check.values)
        if (!one.agrees && (!worst || distanceOf(one) > distanceOf(*worst)))
            worst = &one;
    return worst ? Findings{disagreeingRefits(check, *worst)} : Findings{};
}

Findings judgeChain(const std::vector<DrawnValue> &values, const std::vector<DrawnRow> &rows,
    const std::vector<DrawnRow> &rowsAtMarks)
{
    Differences differences;
    for (const DrawnValue &one : values)
        differences.compare(
            valueWords(one.of), 100.0 / std::abs(one.value), "%", one.drawn, one.gum);
    compareRows(rows, differences);
    compareRows(rowsAtMarks, differences);
    Findings findings;
    const auto tell = [&](const DifferentUs &list, auto make) {
        if (list.count > 0)
            findings.push_back(make(list, differences.compared));
    };
    tell(differences.tooSmall, tooSmallFinding);
    tell(differences.ofFront, ofFrontFinding);
    tell(differences.tooLarge, tooLargeFinding);
    return findings;
}

} // namespace dyncal
