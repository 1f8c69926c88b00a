// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_assessment.h"

#include "core/realization/exponentials/pole_rates.h"
#include "core/realization/model/homogeneity.h"
#include "core/realization/model/model_description.h"
#include "core/realization/model/model_findings.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/model/nuisance_results.h"
#include "core/realization/model/second_order_beside.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/second_order/second_order_fit.h"
#include "core/signal/spectrum_analysis.h"

namespace dyncal {
namespace {

/// The same poles refined with the nuisance modes left in the response, beside the model.
std::optional<NuisanceEffect> effectOfNuisance(
    const ModelInput &input, const SensorModel &model, const JobControl &control)
{
    const ModelInput plain = withModesLeftIn(input);
    ModelDraft draft
        = linearDraft(plain, discretePoles(model.draft.realised_rad_s, sampleInterval_s(plain)));
    refineDraft(plain, draft, control);
    if (!draft.refinement)
        return std::nullopt;
    SensorModel before;
    describeModel(plain, draft, std::nullopt, before);
    addUncertainties(draft, before.poles);
    return NuisanceEffect{effectSide(input, before), effectSide(input, model)};
}

/// Flags in their order; those that need the uncertainties were not known before.
void flagAgain(SensorModel &model)
{
    for (Pole &pole : model.poles)
        std::erase_if(pole.flags, [](const std::string &flag) {
            return flag != kBelowNoiseFlag && flag != kShotsDisagreeFlag && flag != kTubeModeFlag;
        });
    flagPoles(model);
}

void addFindings(const Findings &findings, SensorModel &model)
{
    model.findings.insert(model.findings.end(), findings.begin(), findings.end());
}

} // namespace

Result<SensorModel> assessModel(const ModelInput &input, const SensorModel &fitted,
    const RealizationSettings &settings, const JobControl &control)
{
    SensorModel model = fitted;
    addUncertainties(model.draft, model.poles);
    compareShots(input, model.draft, model, control);
    flagAgain(model);
    if (model.refined && hasNuisance(input))
        model.nuisanceEffect = effectOfNuisance(input, model, control);
    if (settings.refine)
        fitSecondOrderBeside(input, model.draft, model, control);
    // What a cancelled fit leaves out must not pass for "nothing found".
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    addFindings(judgeShots(model), model);
    if (model.secondOrder)
        addFindings(judgeSecondOrder(*model.secondOrder, model.fit_percent), model);
    model.isAssessed = true;
    return model;
}

Result<SensorModel> realizeModel(const ModelInput &input, const HankelDecomposition &decomposition,
    Index order, const RealizationSettings &settings, const SpectrumResult &spectrum,
    const JobControl &control)
{
    const Result<SensorModel> fitted
        = fitModel(input, decomposition, order, settings, spectrum, control);
    return fitted ? assessModel(input, *fitted, settings, control) : fitted;
}

} // namespace dyncal
