// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_nuisance.h"

#include "core/base/constants.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"

#include <cmath>

namespace dyncal {
namespace {

/// `part` of a plateau as percent; a free decay has none.
Message ofPlateau(double part, double plateau)
{
    if (plateau == 0.0 || !std::isfinite(part / plateau))
        return dash();
    return inNumbers(roundedText(100.0 * part / std::abs(plateau), kUnknown, "%"));
}

std::vector<Message> modeRow(const NuisanceMode &mode, const NuisanceOfShot &shot, bool hasPlateau)
{
    const Message kind = mode.isTube ? Message{DYNCAL_TEXT("core", "gas in the tube"), {}}
                                     : Message{DYNCAL_TEXT("core", "other"), {}};
    std::vector<Message> row{mode.label.empty() ? kind : verbatim(mode.label),
        inNumbers(std::to_string(shot.shot)),
        printedWithUncertainty(shot.term.frequency_Hz(), shot.u_frequency_Hz, "Hz"),
        printedWithUncertainty(shot.term.dampingRatio(), shot.u_dampingRatio, "")};
    if (hasPlateau)
        row.push_back(ofPlateau(shot.relativeAmplitude, 1.0));
    row.push_back(verbatim(mode.reason));
    return row;
}

CertificateTable modeTable(const SensorModel &model)
{
    CertificateTable table;
    table.id = "nuisance-modes";
    table.caption = {
        DYNCAL_TEXT("core", "Oscillations that are not the sensor's, left out of the model"), {}};
    table.columns
        = {{{DYNCAL_TEXT("core", "Mode"), {}}, false}, {{DYNCAL_TEXT("core", "Shot"), {}}, true},
            {{DYNCAL_TEXT("core", "Undamped frequency"), {}}, true},
            {{DYNCAL_TEXT("core", "Damping ratio"), {}}, true}};
    const bool hasPlateau = model.plateauGain != 0.0; // a free decay has none
    if (hasPlateau)
        table.columns.push_back({{DYNCAL_TEXT("core", "Size, of the plateau"), {}}, true});
    table.columns.push_back({{DYNCAL_TEXT("core", "Reason"), {}}, false});
    for (const NuisanceResult &mode : model.nuisance) {
        for (const NuisanceOfShot &shot : mode.perShot)
            table.rows.push_back(modeRow(mode.mode, shot, hasPlateau));
    }
    return table;
}

std::vector<Message> sideRow(
    Message name, const NuisanceEffect::Side &side, const std::string &gainUnit, bool hasPlateau)
{
    std::vector<Message> row{std::move(name),
        std::abs(side.fit_percent) < kMostPercent ? inNumbers(fixedText(side.fit_percent, 2) + " %")
                                                  : dash(),
        printedWithUncertainty(side.f0_Hz, side.u_f0_Hz, "Hz"),
        printedWithUncertainty(side.zeta, side.u_zeta, "")};
    if (!hasPlateau)
        return row;
    row.insert(row.begin() + 1, ofPlateau(side.residualRms, side.plateauGain));
    row.push_back(printed(side.plateauGain, gainUnit == "1" ? "" : gainUnit, dash()));
    return row;
}

CertificateTable effectTable(
    const NuisanceEffect &effect, const std::string &gainUnit, bool hasPlateau)
{
    CertificateTable table;
    table.id = "nuisance-effect";
    table.caption
        = {DYNCAL_TEXT("core", "What leaving them out has changed, at the same order"), {}};
    table.columns = {{{DYNCAL_TEXT("core", "Oscillations"), {}}, false},
        {{DYNCAL_TEXT("core", "Fit"), {}}, true},
        {{DYNCAL_TEXT("core", "Undamped frequency"), {}}, true},
        {{DYNCAL_TEXT("core", "Damping ratio"), {}}, true}};
    if (hasPlateau) {
        table.columns.insert(table.columns.begin() + 1,
            {{DYNCAL_TEXT("core", "Residual, rms of the plateau"), {}}, true});
        table.columns.push_back({{DYNCAL_TEXT("core", "Plateau gain"), {}}, true});
    }
    table.rows
        = {sideRow({DYNCAL_TEXT("core", "left in"), {}}, effect.before, gainUnit, hasPlateau),
            sideRow({DYNCAL_TEXT("core", "left out"), {}}, effect.after, gainUnit, hasPlateau)};
    return table;
}

} // namespace

void addNuisance(const SensorModel &model, const ModelAssessment *assessment,
    const std::string &gainUnit, CertificateSection &section)
{
    CertificateTable modes = modeTable(model);
    if (modes.rows.empty())
        return;
    section.tables.push_back(std::move(modes));
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "The oscillations above were fitted in each shot together with the sensor. Poles and all results are those of the sensor without them; the fit counts them."),
            {}});
    if (assessment && assessment->nuisanceEffect)
        section.tables.push_back(
            effectTable(*assessment->nuisanceEffect, gainUnit, model.plateauGain != 0.0));
}

void addLeftOut(const ModelInput &input, CertificateSection &section)
{
    if (input.leftOut.empty())
        return;
    CertificateTable table;
    table.id = "left-out";
    table.caption = {DYNCAL_TEXT("core", "Stretches of the records that were not fitted"), {}};
    table.columns
        = {{{DYNCAL_TEXT("core", "Shot"), {}}, true}, {{DYNCAL_TEXT("core", "From"), {}}, true},
            {{DYNCAL_TEXT("core", "To"), {}}, true}, {{DYNCAL_TEXT("core", "Reason"), {}}, false}};
    for (const ExcludedStretch &stretch : input.leftOut)
        table.rows.push_back({inNumbers(std::to_string(stretch.shot)), setting(stretch.from_s, "s"),
            setting(stretch.to_s, "s"), verbatim(stretch.reason)});
    section.tables.push_back(std::move(table));
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "Times behind the start of the response. These stretches take no part in the model, the fit and its uncertainties; in the response without a model they are filled by the model."),
            {}});
}

} // namespace dyncal
