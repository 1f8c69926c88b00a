// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/model_residual_curves.h"

#include "core/decomposition/component_result.h"
#include "core/decomposition/residual_analysis.h"
#include "ui/plot/curves/component_curves.h"
#include "ui/plot/curves/curve_building.h"

#include <cmath>
#include <complex>

namespace dyncal {

PlotContent modelResidualCurves(const ModelInput &input, const SensorModel &model,
    const WindowResult &window, const ComponentSettings &settings,
    std::optional<std::size_t> series)
{
    ComponentResult left;
    for (std::size_t i = 0; i < model.series.size() && i < input.series.size(); ++i) {
        if ((series && *series != i) || model.diverges)
            continue;
        auto analysis = analyseResidual(model.series[i].error, input.sampleRate_Hz, settings, {});
        if (!analysis)
            continue; // too short to say anything
        left.shots.push_back(input.series[i].shot);
        left.residuals.push_back(std::move(*analysis));
    }
    PlotContent content = autocovarianceCurves(left, window, std::nullopt);
    content.title = Plots::tr("Residual autocorrelation; dotted: white noise");
    content.yAxis.quantity = Plots::tr("Autocorrelation");
    content.summary
        = Plots::tr("Autocorrelation of data minus model with the bounds of white noise.");
    return content;
}

void addSecondOrder(PlotContent &magnitude, const SensorModel &model, const SecondOrderModel &fit,
    const ResponseResult &response)
{
    const Eigen::VectorXd &f_Hz = response.modelCurve.frequency_Hz;
    if (f_Hz.size() == 0 || model.plateauGain == 0.0)
        return;
    // The plateau of this sensor as a multiple of the model's, which is the response at f -> 0.
    double ratio = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < fit.shots.size() && i < model.series.size(); ++i) {
        if (model.series[i].plateauGain == 0.0)
            continue;
        ratio += fit.shots[i].plateauGain / model.series[i].plateauGain;
        ++count;
    }
    if (count == 0)
        return;
    const double atZero
        = response.sensitivity && response.unit != "1" ? *response.sensitivity : 1.0;
    const double plateau = atZero * ratio / static_cast<double>(count);
    PlotCurve curve{Plots::tr("2nd-order sensor"), CurveRole::Reference, CurveStyle::Line,
        toVector(f_Hz), {}, true};
    for (const double f : curve.x) {
        const double x = f / fit.f0_Hz;
        curve.y.push_back(
            plateau / std::abs(std::complex<double>(1.0 - x * x, 2.0 * fit.zeta * x)));
    }
    magnitude.curves.push_back(std::move(curve));
}

} // namespace dyncal
