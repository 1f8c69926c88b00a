// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_figures.h"

#include "ui/plot/component_curves.h"
#include "ui/plot/model_curves.h"
#include "ui/plot/realization_curves.h"
#include "ui/plot/signal_curves.h"

#include <algorithm>

namespace dyncal {

namespace {

void addComponents(const CalibrationResults &results, std::vector<ReportFigure> &figures)
{
    const ComponentResult &components = *results.components;
    const WindowResult &window = *results.window;
    if (components.principal)
        figures.push_back({"explained", explainedCurves(components)});
    figures.push_back({"reconstruction", reconstructionCurves(components, window)});
    figures.push_back({"residuals", residualCurves(components, window)});
    figures.push_back({"residual-autocovariance", autocovarianceCurves(components, window)});
    figures.push_back({"residual-spectrum", residualSpectrumCurves(components, window)});
    figures.push_back({"average", averageCurves(components, window)});
}

void addModel(const CalibrationResults &results, std::vector<ReportFigure> &figures)
{
    const SensorModel &model = *results.model;
    figures.push_back({"model-data", simulationCurves(*results.input, model, *results.window)});
    figures.push_back({"model-error", errorCurves(*results.input, model, *results.window)});
    figures.push_back({"pole-zero", poleZeroCurves(model)});
    figures.push_back({"step", stepCurves(model, results.input->treatment)});
}

} // namespace

std::vector<ReportFigure> reportFigures(const CalibrationResults &results)
{
    std::vector<ReportFigure> figures;
    if (results.captures)
        for (const auto &[role, id] : {std::pair{ChannelRole::Dut, "raw-dut"},
                 std::pair{ChannelRole::DrivenSide, "raw-driven-side"},
                 std::pair{ChannelRole::Driver, "raw-driver"}}) {
            PlotContent content = rawCurves(results.captures->set, role);
            if (!content.curves.empty())
                figures.push_back({id, std::move(content)});
        }
    if (!results.window)
        return figures;
    figures.push_back({"responses", windowCurves(*results.window)});
    figures.push_back({"responses-start", startCurves(*results.window)});
    if (results.spectrum)
        figures.push_back({"spectrum", spectrumCurves(*results.spectrum, *results.window)});
    if (results.components)
        addComponents(results, figures);
    if (!results.input)
        return figures;
    figures.push_back({"model-input", modelInputCurves(*results.input, *results.window)});
    if (results.decomposition) {
        const DecompositionResult &decomposition = *results.decomposition;
        figures.push_back({"singular-values",
            singularValueCurves(
                decomposition.hankel, decomposition.suggestion, results.input->treatment)});
        figures.push_back({"bic", bicCurves(decomposition.suggestion)});
    }
    if (results.model)
        addModel(results, figures);
    if (results.response) {
        figures.push_back({"magnitude", bodeMagnitudeCurves(*results.response)});
        figures.push_back({"phase", bodePhaseCurves(*results.response)});
    }
    return figures;
}

const PlotContent *findFigure(const std::vector<ReportFigure> &figures, const std::string &id)
{
    const auto found = std::find_if(figures.begin(), figures.end(),
        [&id](const ReportFigure &figure) { return figure.id == id; });
    return found == figures.end() ? nullptr : &found->content;
}

} // namespace dyncal
