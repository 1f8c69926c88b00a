// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_assessing.h"

#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/model/early_samples.h"
#include "core/realization/model/homogeneity.h"
#include "core/realization/model/model_description.h"
#include "core/realization/model/model_findings.h"
#include "core/realization/model/nuisance_results.h"
#include "core/realization/model/second_order_beside.h"
#include "core/realization/model/unstated_front.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/second_order/second_order_fit.h"

namespace dyncal {
namespace {

/// Compares the model with the same poles refined with the nuisance modes left in the response.
std::optional<NuisanceEffect> effectOfNuisance(const ModelInput &input, const SensorModel &model,
    const std::vector<Pole> &assessed, const JobControl &control)
{
    const ModelInput plain = withModesLeftIn(input);
    ModelDraft draft = linearDraft(
        plain, discretePoles(model.draft.realizedPoles_rad_s, sampleInterval_s(plain)));
    refineDraft(plain, draft, control);
    if (!draft.refinement)
        return std::nullopt;
    SensorModel before;
    describeModel(plain, draft, std::nullopt, before);
    addUncertainties(draft, before.poles);
    return NuisanceEffect{
        effectSide(input, before, before.poles), effectSide(input, model, assessed)};
}

/// Flags again, as some flags need the uncertainties, which were not known before.
void flagAgain(const SensorModel &model, std::vector<Pole> &poles)
{
    for (Pole &pole : poles)
        std::erase_if(pole.flags, [](const std::string &flag) {
            return flag != kBelowNoiseFlag && flag != kShotsDisagreeFlag && flag != kTubeModeFlag;
        });
    flagPoles(model.zeros, poles);
}

} // namespace

Result<ModelAssessment> assessModel(const ModelInput &input, const SensorModel &fitted,
    const RealizationSettings &settings, const JobControl &control)
{
    ModelAssessment assessment;
    assessment.poles = fitted.poles;
    addUncertainties(fitted.draft, assessment.poles);
    assessment.secondOrder = fitted.secondOrder;
    compareShots(input, fitted, assessment, control);
    flagAgain(fitted, assessment.poles);
    if (fitted.refined && hasNuisance(input))
        assessment.nuisanceEffect = effectOfNuisance(input, fitted, assessment.poles, control);
    if (settings.refine && !assessment.secondOrder)
        assessment.secondOrder = fitSecondOrderBeside(input, fitted, control);
    const Findings front = judgeUnstatedFront(input, fitted, assessment.poles, control);
    const Findings early
        = front.empty() ? judgeEarlySamples(input, fitted, assessment.poles, control) : front;
    // A cancelled fit must not look like "nothing found".
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    assessment.findings = judgeShots(assessment);
    assessment.findings.insert(assessment.findings.end(), early.begin(), early.end());
    if (assessment.secondOrder) {
        const Findings found = judgeSecondOrder(*assessment.secondOrder, fitted.fit_percent);
        assessment.findings.insert(assessment.findings.end(), found.begin(), found.end());
    }
    return assessment;
}

} // namespace dyncal
