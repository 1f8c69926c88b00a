// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/component_analysis.h"

#include "core/base/number_text.h"
#include "core/decomposition/principal_components.h"
#include "core/decomposition/residual_analysis.h"
#include "core/decomposition/residual_findings.h"
#include "core/signal/resampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace dyncal {
namespace {

constexpr double kLeastExplained_percent = 95.0;
constexpr Index kLeastSamples = 8; ///< of a reduced response: what a spectrum needs
constexpr double kNegligible = 1e-12; ///< of the responses: smaller residuals are rounding

double lowestRate_Hz(const std::vector<WindowedResponse> &responses)
{
    double lowest_Hz = std::numeric_limits<double>::infinity();
    for (const WindowedResponse &response : responses)
        lowest_Hz = std::min(lowest_Hz, response.sampleRate_Hz);
    return lowest_Hz;
}

/// The response from its start on, reduced by `factor`. If the record begins with the start, its
/// first value is repeated before it.
Eigen::VectorXd reduced(const WindowedResponse &response, double factor)
{
    if (factor == 1.0)
        return response.window();
    const AntiAliasFilter filter = designAntiAliasFilter(factor, response.sampleRate_Hz);
    const Index half = filter.halfLength();
    const Index missing = std::max<Index>(half - response.lead, 0);
    const Index size = response.values.size();
    Eigen::VectorXd padded(missing + size);
    padded.head(missing).setConstant(response.values[0]);
    padded.tail(size) = response.values;
    const Index first = missing + response.lead;
    const Index inWindow
        = static_cast<Index>(std::floor(static_cast<double>(response.length - 1) / factor)) + 1;
    return decimate(
        padded, filter, first, std::min(outputCount(filter, first, padded.size() - 1), inWindow));
}

Error tooShort(const WindowedResponse &response, double factor)
{
    return {ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "Shot %1 has %2 samples in its window, too few to be reduced %3 times to the rate of the other shots; set window.end_s or exclude a shot."),
            {std::to_string(response.shot), std::to_string(response.length),
                numberText(factor, 6)}},
        "CAP-004", response.shot};
}

/// All responses as columns at the lowest rate, cut to the length of the shortest.
std::optional<Error> unify(const std::vector<WindowedResponse> &responses, ComponentResult &result)
{
    result.sampleRate_Hz = lowestRate_Hz(responses);
    std::vector<Eigen::VectorXd> columns;
    Index rows = std::numeric_limits<Index>::max();
    for (const WindowedResponse &response : responses) {
        // The lowest rate is the target, so there always is a factor.
        const double factor
            = reductionFactor(response.sampleRate_Hz, result.sampleRate_Hz).value_or(1.0);
        columns.push_back(reduced(response, factor));
        if (columns.back().size() < kLeastSamples)
            return tooShort(response, factor);
        rows = std::min(rows, columns.back().size());
        result.shots.push_back(response.shot);
    }
    result.responses.resize(rows, static_cast<Index>(columns.size()));
    for (Index i = 0; i < result.responses.cols(); ++i)
        result.responses.col(i) = columns[static_cast<std::size_t>(i)].head(rows);
    return std::nullopt;
}

/// PCA-001, with the shot that the first component describes worst.
std::optional<Finding> poorFirstComponent(const ComponentResult &result)
{
    const double explained_percent = result.principal->explainedCumulative_percent[0];
    if (explained_percent >= kLeastExplained_percent)
        return std::nullopt;
    const Eigen::MatrixXd rest = result.responses - reconstruct(*result.principal, 1);
    const Eigen::VectorXd energy = rest.colwise().squaredNorm();
    Index worst = 0;
    energy.maxCoeff(&worst);
    const Index shot = result.shots[static_cast<std::size_t>(worst)];
    return Finding{.id = "PCA-001",
        .severity = Severity::Caution,
        .shot = shot,
        .message
        = {DYNCAL_TEXT("core",
               "The first principal component explains %1 % (limit %2 %). Shot %3 carries %4 % of the remainder."),
            {numberText(explained_percent, 3), numberText(kLeastExplained_percent, 3),
                std::to_string(shot),
                numberText(std::round(100.0 * energy[worst] / energy.sum()), 4)}},
        .value = explained_percent,
        .limit = kLeastExplained_percent};
}

/// Components, reconstructions and residuals of two and more shots.
std::optional<Error> decompose(const ComponentSettings &settings, const SpectrumSettings &spectrum,
    const JobControl &control, ComponentResult &result)
{
    result.principal = computePrincipalComponents(result.responses, settings.centre);
    result.reconstructions = reconstruct(*result.principal, result.kept);
    result.average = result.reconstructions.rowwise().mean();
    if (!settings.centre) {
        if (auto finding = poorFirstComponent(result))
            result.findings.push_back(std::move(*finding));
    }
    const Eigen::MatrixXd residuals = result.responses - result.reconstructions;
    for (Index i = 0; i < residuals.cols(); ++i) {
        if (control.stopRequested())
            return Error{
                ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}}, {}, 0};
        auto analysis = analyseResidual(residuals.col(i), result.sampleRate_Hz, settings, spectrum);
        if (!analysis) {
            analysis.error().shot = result.shots[static_cast<std::size_t>(i)];
            return analysis.error();
        }
        result.residuals.push_back(std::move(*analysis));
        control.report(static_cast<double>(i + 1) / static_cast<double>(residuals.cols()));
    }
    // Residuals that are only rounding are not judged.
    if (residuals.norm() > kNegligible * result.responses.norm()) {
        const Findings findings = residualFindings(result, spectrum);
        result.findings.insert(result.findings.end(), findings.begin(), findings.end());
    }
    return std::nullopt;
}

} // namespace

Result<ComponentResult> analyseComponents(const std::vector<WindowedResponse> &responses,
    const ComponentSettings &settings, const SpectrumSettings &spectrum, const JobControl &control)
{
    if (responses.empty())
        return fail(ErrorKind::Usage, {DYNCAL_TEXT("core", "No shot is included."), {}});
    const bool lawful = settings.components >= 1 && settings.residualLags >= 1
        && settings.residualConfidence > 0.0 && settings.residualConfidence < 1.0;
    if (!lawful)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The settings of the principal components make no sense: components %1 and residual lags %2 must be at least 1, the confidence %3 between 0 and 1."),
                {std::to_string(settings.components), std::to_string(settings.residualLags),
                    numberText(settings.residualConfidence)}});
    ComponentResult result;
    if (auto error = unify(responses, result))
        return tl::unexpected(*error);
    result.kept = std::min(settings.components, result.responses.cols());
    if (responses.size() == 1) {
        result.reconstructions = result.responses;
        result.average = result.responses.col(0);
    } else if (auto error = decompose(settings, spectrum, control, result)) {
        return tl::unexpected(*error);
    }
    return result;
}

} // namespace dyncal
