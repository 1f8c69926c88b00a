// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/row_uncertainty.h"

#include "core/model_analysis/model_response.h"
#include "core/uncertainty/front_effect.h"

#include <cmath>
#include <complex>
#include <utility>

namespace dyncal {
namespace {

constexpr double kCoverageOfRows = 0.95;

/// What the error of a heat drift that was divided out may leave: h/(1 + jw tau) of the step for
/// each h, the same direction in every shot. 0 without one.
double ofDrift_relative(const ResponseResult &response, double frequency_Hz)
{
    if (response.drift.kind != DriftKind::Heat || response.drift.shots.empty())
        return 0.0;
    double sum = 0.0;
    for (const ShotDrift &drift : response.drift.shots) {
        const double u_share = drift.u / std::abs(std::expm1(-drift.at_s / drift.tau_s));
        sum += u_share / std::hypot(1.0, kTwoPi * frequency_Hz * drift.tau_s);
    }
    const double u = sum / static_cast<double>(response.drift.shots.size());
    return std::isfinite(u) ? u : 0.0;
}

UncertaintyLine rowLine(const char *quantity, double contribution,
    Distribution distribution = Distribution::Normal,
    double dof = std::numeric_limits<double>::infinity())
{
    UncertaintyLine line = directLine(quantity, contribution, dof, distribution);
    line.value = 0.0;
    return line;
}

/// What a certificate's degrees of freedom take off those of a row.
double inverseDof(double u, double dof, double u_row)
{
    return std::pow(u / u_row, 4) / dof;
}

/// Of the noise alone; ResponseResult has that of all of u_magnitude, of which only those of the
/// noise, of a reference and of the chain are finite.
double dofOfNoise(const ResponseResult &response, Index row)
{
    const double u = response.u_magnitude[row];
    const double share = response.u_noiseMagnitude[row] / u;
    if (!response.isByTransducer && !response.isWithoutChain)
        return response.dof[row] * std::pow(share, 4);
    double others = 0.0;
    if (response.isByTransducer)
        others = inverseDof(response.u_referenceMagnitude[row], response.dofReference[row], u);
    if (response.isWithoutChain)
        others += inverseDof(
            response.u_chain_relative[row] * response.magnitude[row], response.dofChain[row], u);
    return std::pow(share, 4) / std::max(0.0, 1.0 / response.dof[row] - others);
}

UncertaintyLine rowNoise(const ResponseResult &response, Index row, double u)
{
    return with(
        OverShots::Own, rowLine("noise", u, Distribution::Normal, dofOfNoise(response, row)));
}

bool isStated(const ResponseResult &response, Index row)
{
    return std::isfinite(response.magnitude[row]);
}

/// Half width of each of the bounds as u.
double ofBound(const Eigen::VectorXd &bound, Index row)
{
    return bound[row] / std::sqrt(3.0);
}

std::vector<UncertaintyLine> ownLines(const ResponseResult &response, Index row)
{
    const double f_Hz = response.frequency_Hz[row];
    const double S = response.magnitude[row];
    std::vector<UncertaintyLine> lines{rowNoise(response, row, response.u_noiseMagnitude[row]),
        rowLine("end_of_record", ofBound(response.boundEnd, row), Distribution::Rectangular),
        rowLine("aliasing", ofBound(response.boundAlias, row), Distribution::Rectangular),
        rowLine("drift", S * ofDrift_relative(response, f_Hz))};
    if (response.isByTransducer)
        lines.push_back(rowLine("reference_sensitivity", response.u_referenceMagnitude[row],
            Distribution::Normal, response.dofReference[row]));
    else if (isFrontStated(response.front))
        lines.push_back(rowLine("front_duration_s", response.u_frontMagnitude[row]));
    else
        lines.push_back(scaled({frontLine(f_Hz)}, S).front());
    if (response.isWithoutChain)
        lines.push_back(rowLine(kChainResponse, S * response.u_chain_relative[row],
            Distribution::Normal, response.dofChain[row]));
    return lines;
}

std::vector<UncertaintyLine> magnitudeLines(
    const ResponseResult &response, const std::vector<UncertaintyLine> &common, Index row)
{
    std::vector<UncertaintyLine> lines = scaled(common, response.magnitude[row]);
    const std::vector<UncertaintyLine> own = ownLines(response, row);
    lines.insert(lines.end(), own.begin(), own.end());
    return lines;
}

std::vector<UncertaintyLine> phaseLines(const ResponseResult &response, Index row)
{
    const double S = response.magnitude[row];
    const double noise = response.u_noiseMagnitude[row] / S;
    const double withOnset = response.u_noisePhase_rad[row];
    const double onset = std::sqrt(std::max(0.0, withOnset * withOnset - noise * noise));
    const char *timing = response.isByTransducer ? "delay_of_reference" : "onset_s";
    const double u_timing = std::isfinite(withOnset) ? onset : kUnknown;
    std::vector<UncertaintyLine> lines{rowNoise(response, row, noise),
        response.isByTransducer ? rowLine(timing, u_timing)
                                : with(OverShots::Own, rowLine(timing, u_timing)),
        rowLine("end_of_record", ofBound(response.boundEnd, row) / S, Distribution::Rectangular),
        rowLine("aliasing", ofBound(response.boundAlias, row) / S, Distribution::Rectangular),
        rowLine("drift", ofDrift_relative(response, response.frequency_Hz[row]))};
    if (response.isByTransducer)
        lines.push_back(rowLine("reference_phase", response.u_referencePhase_rad[row],
            Distribution::Normal, response.dofReference[row]));
    if (response.isWithoutChain)
        lines.push_back(rowLine("chain_phase", response.u_chainPhase_rad[row], Distribution::Normal,
            response.dofChain[row]));
    return lines;
}

/// Row k of everything that is NaN until it is known.
void prepare(Index count, RowUncertainty &rows)
{
    for (auto *values : {&rows.u_magnitude, &rows.k_magnitude, &rows.dof_magnitude,
             &rows.u_phase_rad, &rows.k_phase, &rows.dof_phase, &rows.u_modelMagnitude,
             &rows.u_modelPhase_rad, &rows.e_n})
        values->setConstant(count, kUnknown);
    rows.covarianceReIm.setConstant(count, 3, kUnknown);
}

/// Of real and imaginary part, without what all rows share, and without a CMC.
Eigen::RowVector3d ownCovariance(const ResponseResult &response, Index row)
{
    const double c = std::cos(response.phase_rad[row]);
    const double s = std::sin(response.phase_rad[row]);
    const double along = std::pow(combined(ownLines(response, row)).u, 2);
    const double across
        = std::pow(response.magnitude[row] * combined(phaseLines(response, row)).u, 2);
    return {
        c * c * along + s * s * across, s * c * (along - across), s * s * along + c * c * across};
}

void combineRow(const ResponseResult &response, Index row, RowUncertainty &rows)
{
    if (rows.isComplete()) {
        const ReportedValue all = magnitudeOfRow(response, rows, row);
        rows.u_magnitude[row] = *all.u;
        rows.dof_magnitude[row] = all.dof;
        rows.k_magnitude[row] = all.k;
    }
    const ReportedValue phase = phaseOfRow(response, rows, row);
    if (!phase.u)
        return;
    rows.u_phase_rad[row] = *phase.u;
    rows.dof_phase[row] = phase.dof;
    rows.k_phase[row] = phase.k;
    rows.covarianceReIm.row(row) = ownCovariance(response, row);
}

/// From one model's response over its level to the other's, relative, as a complex logarithm.
std::complex<double> changeOf(const SensorModel &to, const SensorModel &from,
    ResponseTreatment treatment, double frequency_Hz)
{
    return std::log(modelResponse(to, treatment, frequency_Hz) / to.level() * from.level()
        / modelResponse(from, treatment, frequency_Hz));
}

/// The model's response is divided by the chain's too.
void addChain(const ResponseResult &response, Index row, RowUncertainty &rows)
{
    rows.u_modelMagnitude[row] = std::hypot(
        rows.u_modelMagnitude[row], response.modelMagnitude[row] * response.u_chain_relative[row]);
    rows.u_modelPhase_rad[row]
        = std::hypot(rows.u_modelPhase_rad[row], response.u_chainPhase_rad[row]);
}

/// Relative change of the model's response, as u of its magnitude and, in quadrature, of its phase.
void addModel(const ResponseResult &response, const FrontVariation &front,
    const std::vector<ModelVariation> &variations, ResponseTreatment treatment, Index row,
    RowUncertainty &rows)
{
    const double f_Hz = response.frequency_Hz[row];
    double along = 0.0;
    double across = 0.0;
    for (const ModelVariation &one : variations) {
        const std::complex<double> change
            = changeOf(one.up, one.down, treatment, f_Hz) / (2.0 * kVariation);
        along += std::norm(change.real());
        across += std::norm(change.imag());
    }
    const double own = response.modelMagnitude[row] * std::sqrt(along);
    const std::complex<double> ofFront
        = changeOf(front.longer, front.shorter, treatment, f_Hz) / front.range.divisor;
    rows.u_modelMagnitude[row] = rows.isComplete()
        ? std::hypot(own,
            response.modelMagnitude[row]
                * std::hypot(ofFront.real(), rows.u_commonOfModel_relative))
        : kUnknown;
    rows.u_modelPhase_rad[row] = std::hypot(std::sqrt(across), ofFront.imag());
    if (response.isWithoutChain)
        addChain(response, row, rows);
    if (!isStated(response, row))
        return;
    // Both come from the same noise, and of it the model takes the least: the difference has the
    // variance of the measured value less that of the model (J. A. Hausman, Econometrica 46 (1978)
    // 1251). The bounds are the measured value's alone.
    const double noise
        = std::sqrt(std::abs(std::pow(response.u_noiseMagnitude[row], 2) - own * own));
    // A reference's sensitivity is the measured row's own.
    const double u = std::hypot(std::hypot(noise, response.u_referenceMagnitude[row]),
        ofBound(response.boundEnd, row), ofBound(response.boundAlias, row));
    rows.e_n[row] = (response.magnitude[row] - response.modelMagnitude[row])
        / (coverageFactor(std::numeric_limits<double>::infinity(), kCoverageOfRows) * u);
}

/// Of the CMC; 0 where none is stated.
double leastOf(const Eigen::VectorXd &least, Index row)
{
    return row < least.size() ? least[row] : 0.0;
}

} // namespace

ReportedValue magnitudeOfRow(const ResponseResult &response, const RowUncertainty &rows, Index row)
{
    const double S = response.magnitude[row];
    ReportedValue reported{"magnitude", S, response.unit == "1" ? "" : response.unit,
        magnitudeLines(response, rows.common, row)};
    reported.leastExpanded = leastOf(rows.leastExpanded_relative, row) * S;
    combineLines(reported);
    return reported;
}

ReportedValue phaseOfRow(const ResponseResult &response, const RowUncertainty &rows, Index row)
{
    ReportedValue reported{"phase_rad", response.phase_rad[row], "rad", phaseLines(response, row)};
    if (!std::isfinite(combined(reported.lines).u))
        return reported;
    reported.leastExpanded = leastOf(rows.leastExpandedPhase_rad, row);
    combineLines(reported);
    return reported;
}

RowUncertainty rowUncertainty(const ResponseResult &response,
    const std::optional<CommonLines> &common, const SensorModel &model,
    const std::vector<ModelVariation> &variations, ResponseTreatment treatment)
{
    RowUncertainty rows;
    const Index count = response.frequency_Hz.size();
    prepare(count, rows);
    if (common) {
        rows.common = common->ofRows;
        rows.u_common_relative = combined(rows.common).u;
        rows.u_commonOfModel_relative = combined(common->ofModel).u;
    }
    const FrontVariation front = frontVariation(model, response.front);
    for (Index row = 0; row < count; ++row) {
        if (row < response.magnitude.size() && isStated(response, row))
            combineRow(response, row, rows);
        if (!variations.empty() && row < response.modelMagnitude.size()
            && response.magnitude.size() == count)
            addModel(response, front, variations, treatment, row, rows);
    }
    return rows;
}

} // namespace dyncal
