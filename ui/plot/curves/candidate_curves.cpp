// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/candidate_curves.h"

#include "core/model_analysis/model_curves.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/curves/model_curves.h"

#include <array>
#include <cmath>
#include <functional>

namespace dyncal {

namespace {

QString nameOf(const OverlaidModel &candidate)
{
    return Plots::tr("Order %1").arg(candidate.model->order);
}

void overlaySeries(PlotContent &content, const ModelInput &input,
    const std::vector<OverlaidModel> &candidates, std::size_t series,
    Eigen::VectorXd SeriesFit::*values)
{
    for (const OverlaidModel &candidate : candidates) {
        if (candidate.model->diverges || series >= candidate.model->series.size()
            || series >= input.series.size())
            continue;
        const Eigen::VectorXd &y = candidate.model->series[series].*values;
        content.curves.push_back({nameOf(candidate), candidate.role, CurveStyle::Line,
            timeAxis(input.series[series].first_s, 1.0 / input.sampleRate_Hz, y.size()),
            toVector(y), true});
    }
}

void overlayResponses(PlotContent &content, const std::vector<OverlaidModel> &candidates,
    Eigen::VectorXd ResponseCurve::*values, double scale)
{
    for (const OverlaidModel &candidate : candidates) {
        if (!candidate.response || candidate.response->modelCurve.frequency_Hz.size() == 0)
            continue;
        const ResponseCurve &curve = candidate.response->modelCurve;
        content.curves.push_back({nameOf(candidate), candidate.role, CurveStyle::Line,
            toVector(curve.frequency_Hz), toVector(scale * (curve.*values)), true});
    }
}

} // namespace

CurveRole candidateRole(std::size_t k)
{
    constexpr std::array<CurveRole, kMostOverlaid> kRoles{
        CurveRole::Candidate1, CurveRole::Candidate2, CurveRole::Candidate3, CurveRole::Candidate4};
    return kRoles[k % kMostOverlaid];
}

void overlaySimulations(PlotContent &content, const ModelInput &input,
    const std::vector<OverlaidModel> &candidates, std::optional<std::size_t> series)
{
    overlaySeries(content, input, candidates, series.value_or(0), &SeriesFit::simulated);
}

void overlayErrors(PlotContent &content, const ModelInput &input,
    const std::vector<OverlaidModel> &candidates, std::optional<std::size_t> series)
{
    overlaySeries(content, input, candidates, series.value_or(0), &SeriesFit::error);
}

void overlayMagnitudes(PlotContent &content, const std::vector<OverlaidModel> &candidates)
{
    overlayResponses(content, candidates, &ResponseCurve::magnitude, 1.0);
}

void overlayPhases(PlotContent &content, const std::vector<OverlaidModel> &candidates)
{
    overlayResponses(content, candidates, &ResponseCurve::phase_rad, 180.0 / M_PI);
}

void overlayPoles(PlotContent &content, const std::vector<OverlaidModel> &candidates)
{
    for (const OverlaidModel &candidate : candidates) {
        PlotCurve curve{nameOf(candidate), candidate.role, CurveStyle::Markers, {}, {}, true};
        for (const Pole &pole : candidate.model->poles) {
            if (std::abs(pole.z) > kFarthestInMap)
                continue;
            curve.x.push_back(pole.z.real());
            curve.y.push_back(pole.z.imag());
        }
        if (!curve.x.empty())
            content.curves.push_back(std::move(curve));
    }
}

} // namespace dyncal
