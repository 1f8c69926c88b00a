// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_figures.h"

#include "ui/plot/curves/comparison_curves.h"
#include "ui/plot/curves/component_curves.h"
#include "ui/plot/curves/model_curves.h"
#include "ui/plot/curves/realization_curves.h"
#include "ui/plot/curves/signal_curves.h"

#include <algorithm>

namespace dyncal {

namespace {

/// The makers in the order of the method; each holds the results, whose parts are shared.
class Makers
{
public:
    explicit Makers(const CalibrationResults &results)
        : m_results(results)
    {
    }

    template <typename Make>
    void add(const char *id, Make make)
    {
        m_makers.push_back([results = m_results, id, make] {
            return ReportFigure{id, make(results)};
        });
    }
    void addRaw(const char *id, ChannelRole role)
    {
        m_makers.push_back([set = m_results.captures, id, role]() -> std::optional<ReportFigure> {
            PlotContent content = rawCurves(set->set, role);
            if (content.curves.empty())
                return std::nullopt;
            return ReportFigure{id, std::move(content)};
        });
    }
    std::vector<FigureMaker> take() { return std::move(m_makers); }

private:
    CalibrationResults m_results;
    std::vector<FigureMaker> m_makers;
};

using R = const CalibrationResults &;

void addComponents(R results, Makers &makers)
{
    if (results.components->principal)
        makers.add("explained", [](R r) { return explainedCurves(*r.components); });
    makers.add(
        "reconstruction", [](R r) { return reconstructionCurves(*r.components, *r.window); });
    makers.add("residuals", [](R r) { return residualCurves(*r.components, *r.window); });
    makers.add("residual-autocovariance",
        [](R r) { return autocovarianceCurves(*r.components, *r.window); });
    makers.add(
        "residual-spectrum", [](R r) { return residualSpectrumCurves(*r.components, *r.window); });
    makers.add("average", [](R r) { return averageCurves(*r.components, *r.window); });
}

void addDecomposition(Makers &makers)
{
    makers.add("singular-values", [](R r) {
        return singularValueCurves(
            r.decomposition->hankel, r.decomposition->suggestion, r.input->treatment);
    });
    makers.add("bic", [](R r) { return bicCurves(r.decomposition->suggestion); });
}

void addModel(Makers &makers)
{
    makers.add("model-data", [](R r) { return simulationCurves(*r.input, *r.model, *r.window); });
    makers.add("model-error", [](R r) { return errorCurves(*r.input, *r.model, *r.window); });
    makers.add("pole-zero", [](R r) { return poleZeroCurves(*r.model); });
    makers.add(
        "step", [](R r) { return stepCurves(*r.model, r.input->treatment, r.response.get()); });
}

} // namespace

std::vector<FigureMaker> figureMakers(const CalibrationResults &results)
{
    Makers makers(results);
    if (results.captures) {
        makers.addRaw("raw-dut", ChannelRole::Dut);
        makers.addRaw("raw-driven-side", ChannelRole::DrivenSide);
        makers.addRaw("raw-driver", ChannelRole::Driver);
    }
    if (!results.window)
        return makers.take();
    makers.add("responses", [](R r) { return windowCurves(*r.window); });
    makers.add("responses-start", [](R r) { return startCurves(*r.window); });
    if (results.spectrum)
        makers.add("spectrum", [](R r) { return spectrumCurves(*r.spectrum, *r.window); });
    if (results.components)
        addComponents(results, makers);
    if (!results.input)
        return makers.take();
    makers.add("model-input", [](R r) { return modelInputCurves(*r.input, *r.window); });
    if (results.decomposition)
        addDecomposition(makers);
    if (results.model)
        addModel(makers);
    if (results.response) {
        makers.add("magnitude", [](R r) { return bodeMagnitudeCurves(*r.response); });
        makers.add("phase", [](R r) { return bodePhaseCurves(*r.response); });
    }
    if (results.comparison && results.comparison->againstStep)
        makers.add("comparison", [](R r) { return comparedDeviationCurves(*r.comparison); });
    return makers.take();
}

const PlotContent *findFigure(const std::vector<ReportFigure> &figures, const std::string &id)
{
    const auto found = std::find_if(figures.begin(), figures.end(),
        [&id](const ReportFigure &figure) { return figure.id == id; });
    return found == figures.end() ? nullptr : &found->content;
}

} // namespace dyncal
