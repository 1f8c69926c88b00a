// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/second_order_beside.h"

#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/refinement.h"
#include "core/realization/second_order/second_order_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kFitMargin_points = 2.0;

struct Start
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
};

/// From the main resonance, else from the two slowest real poles.
Start resonanceOf(const SensorModel &model)
{
    if (const Pole *main = mainPole(model.poles, model.series))
        return {main->frequency_Hz, main->dampingRatio};
    std::vector<double> real;
    for (const Pole &pole : model.poles) {
        if (pole.poleClass == PoleClass::Sensor && pole.s_rad_s.imag() == 0.0)
            real.push_back(std::abs(pole.s_rad_s.real()));
    }
    if (real.empty())
        return {};
    constexpr double kMuchFaster = 9.0; // if there is only one real pole
    std::sort(real.begin(), real.end());
    const double slow = real[0];
    const double fast = real.size() > 1 ? real[1] : kMuchFaster * slow;
    const double omega = std::sqrt(slow * fast);
    return {omega / (2.0 * std::numbers::pi), (slow + fast) / (2.0 * omega)};
}

} // namespace

std::optional<SecondOrderModel> fitSecondOrderBeside(
    const ModelInput &input, const SensorModel &model, const JobControl &control)
{
    if (!isStepTreatment(input.treatment) || isThesisMode(input) || model.diverges)
        return std::nullopt;
    const Start resonance = resonanceOf(model);
    SecondOrderStart start{resonance.f0_Hz, resonance.zeta, {}, {}};
    for (const SeriesFit &series : model.series) {
        start.plateau.push_back(series.plateauGain);
        start.onset_s.push_back(series.onset_s);
    }
    auto fit = fitSecondOrder(input, refinementRecords(input, model.draft), {start}, control);
    if (!fit)
        return std::nullopt;
    fit->sensor.describes = fit->sensor.fit_percent >= model.fit_percent - kFitMargin_points;
    return std::move(fit->sensor);
}

} // namespace dyncal
