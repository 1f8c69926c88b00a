// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/sensor_model.h"

#include "core/base/number_text.h"
#include "core/realization/exponential_sum.h"
#include "core/realization/model_findings.h"
#include "core/realization/onset.h"
#include "core/realization/pole_classes.h"
#include "core/realization/pole_refinement.h"
#include "core/realization/realized_poles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace dyncal {
namespace {

constexpr Index kLargestRefined = 12; ///< beyond, spurious poles make the fit ill-posed

/// Poles and, per series, the response they give, while the model is being built.
struct Draft
{
    std::vector<std::complex<double>> rates_rad_s; ///< without the step pole
    std::vector<ExponentialSum> series; ///< at time 0 = detected start
    std::optional<Refinement> refinement;
};

bool isThesis(const ModelInput &input)
{
    return input.treatment == ResponseTreatment::StepAsImpulse;
}

double sampleInterval_s(const ModelInput &input)
{
    return 1.0 / input.sampleRate_Hz;
}

std::complex<double> rateOf(std::complex<double> z, double dt_s)
{
    // A pole at 0 is a pure delay: infinitely fast, kept finite so that it can be listed.
    constexpr double kTiny = 1e-300;
    return std::log(std::abs(z) > kTiny ? z : std::complex<double>(kTiny)) / dt_s;
}

/// Pairs stay together: both have the same |s|, the upper half comes first.
void sortByFrequency(std::vector<std::complex<double>> &rates)
{
    std::stable_sort(rates.begin(), rates.end(), [](const auto &a, const auto &b) {
        const double left = std::abs(a);
        const double right = std::abs(b);
        return left != right ? left < right : a.imag() > b.imag();
    });
}

/// s of a negative real z lies on the Nyquist line; its sampled form has no partner there.
std::vector<std::complex<double>> discrete(
    const std::vector<std::complex<double>> &rates, double dt_s)
{
    std::vector<std::complex<double>> poles;
    for (const std::complex<double> &s : rates) {
        const std::complex<double> z = std::exp(s * dt_s);
        const bool onNyquistLine = std::abs(std::abs(s.imag()) * dt_s - std::numbers::pi) < 1e-12;
        poles.push_back(onNyquistLine ? std::complex<double>(z.real()) : z);
    }
    return poles;
}

/// Amplitudes by least squares at the model rate, brought back to time 0 and freed of the filter.
Draft linearDraft(const ModelInput &input, std::vector<std::complex<double>> rates)
{
    Draft draft;
    draft.rates_rad_s = std::move(rates);
    const auto poles = discrete(draft.rates_rad_s, sampleInterval_s(input));
    for (const ModelSeries &series : input.series) {
        const AmplitudeFit fit = fitAmplitudes(series.y, poles, isStepTreatment(input.treatment));
        ExponentialSum sum;
        sum.constant = fit.constant;
        sum.rates_rad_s = Eigen::Map<const Eigen::VectorXcd>(
            draft.rates_rad_s.data(), static_cast<Index>(draft.rates_rad_s.size()));
        sum.amplitudes = fit.amplitudes;
        for (Index i = 0; i < sum.amplitudes.size(); ++i) {
            const std::complex<double> s = sum.rates_rad_s[i];
            sum.amplitudes[i] *= std::exp(-s * series.first_s) / series.filter.gain(s);
        }
        draft.series.push_back(std::move(sum));
    }
    return draft;
}

bool canRefine(const ModelInput &input, const std::vector<std::complex<double>> &poles)
{
    return !isThesis(input) && !poles.empty() && static_cast<Index>(poles.size()) <= kLargestRefined
        && std::all_of(poles.begin(), poles.end(), [](const std::complex<double> &z) {
               return std::abs(z) < 1.0 && !(z.imag() == 0.0 && z.real() <= 0.0);
           });
}

/// Refinement on the records at their own rate from the start on: no filter, nothing lost.
void refine(const ModelInput &input, Draft &draft, const JobControl &control)
{
    std::vector<RefinementRecord> records;
    for (const ModelSeries &series : input.series) {
        constexpr double kNoiseFree = 1e-9; // of the record's range: keeps weights finite
        const double range = series.fullRate.maxCoeff() - series.fullRate.minCoeff();
        const double noise = std::max(series.fullRateNoiseSd, kNoiseFree * range);
        records.push_back({series.fullRate, series.fullRate_Hz, 1.0 / noise});
    }
    draft.refinement
        = refinePoles(records, draft.rates_rad_s, isStepTreatment(input.treatment), control);
    if (!draft.refinement)
        return;
    draft.rates_rad_s = draft.refinement->rates_rad_s;
    draft.series = draft.refinement->records;
}

/// Whether the part of pole i stands out of the noise of any series: its energy over the input
/// against what one fitted pair takes up of white noise, with a margin of 10 dB.
std::vector<bool> standingOut(const ModelInput &input, const Draft &draft)
{
    constexpr double kMargin = 20.0;
    constexpr double kRounding = 1e-20;
    std::vector<bool> result(draft.rates_rad_s.size(), false);
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        const ModelSeries &series = input.series[r];
        const double noise
            = std::max(series.noiseSd * series.noiseSd, kRounding * series.y.squaredNorm());
        for (std::size_t i = 0; i < result.size(); ++i) {
            const Index at = static_cast<Index>(i);
            const std::complex<double> s = draft.rates_rad_s[i];
            const double first = std::norm(draft.series[r].amplitudes[at] * series.filter.gain(s)
                * std::exp(s * series.first_s));
            const double decay = std::norm(std::exp(s * sampleInterval_s(input)));
            const double samples = static_cast<double>(series.y.size());
            const double sum = std::abs(1.0 - decay) > 1e-12
                ? (1.0 - std::pow(decay, samples)) / (1.0 - decay)
                : samples;
            if (2.0 * first * sum > kMargin * noise)
                result[i] = true;
        }
    }
    return result;
}

/// Only what the sensor does takes part in the search for the onset.
ExponentialSum sensorPart(const ExponentialSum &sum, const std::vector<bool> &isSensor)
{
    ExponentialSum part;
    part.constant = sum.constant;
    const Index kept = std::count(isSensor.begin(), isSensor.end(), true);
    part.rates_rad_s.resize(kept);
    part.amplitudes.resize(kept);
    Index at = 0;
    for (std::size_t i = 0; i < isSensor.size(); ++i) {
        if (isSensor[i]) {
            part.rates_rad_s[at] = sum.rates_rad_s[static_cast<Index>(i)];
            part.amplitudes[at++] = sum.amplitudes[static_cast<Index>(i)];
        }
    }
    return part;
}

/// Search range for the onset: six tenths of the period (or time constant) of the fastest part.
double onsetSearch_s(const ExponentialSum &part)
{
    const double fastest = part.rates_rad_s.cwiseAbs().maxCoeff();
    return 0.6 * 2.0 * std::numbers::pi / fastest;
}

struct Onset
{
    double time_s = 0.0;
    double u_s = kUnknown;
};

Onset locateOnset(const Draft &draft, std::size_t series, const std::vector<bool> &isSensor)
{
    const ExponentialSum part = sensorPart(draft.series[series], isSensor);
    if (part.rates_rad_s.size() == 0)
        return {};
    const double search_s = onsetSearch_s(part);
    const auto found = findOnset_s(part, search_s);
    if (!found)
        return {};
    Onset onset{*found, kUnknown};
    if (!draft.refinement)
        return onset;

    const Index record = static_cast<Index>(series);
    const Eigen::MatrixXd covariance = recordCovariance(*draft.refinement, record);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(covariance.rows());
    for (Index i = 0; i < gradient.size(); ++i) {
        const double step = 0.1 * std::sqrt(std::max(0.0, covariance(i, i)));
        if (!(step > 0.0))
            continue;
        const auto above = findOnset_s(
            sensorPart(perturbed(*draft.refinement, record, i, step), isSensor), search_s);
        const auto below = findOnset_s(
            sensorPart(perturbed(*draft.refinement, record, i, -step), isSensor), search_s);
        if (!above || !below)
            return onset;
        gradient[i] = (*above - *below) / (2.0 * step);
    }
    onset.u_s = std::sqrt(std::max(0.0, gradient.dot(covariance * gradient)));
    return onset;
}

/// 100 (1 - ||error|| / ||y - mean||).
double fitPercent(double errorSquares, double spreadSquares)
{
    return spreadSquares > 0.0 ? 100.0 * (1.0 - std::sqrt(errorSquares / spreadSquares)) : 0.0;
}

double spreadSquares(const Eigen::VectorXd &y)
{
    return (y.array() - y.mean()).square().sum();
}

Eigen::VectorXd simulate(const ModelSeries &series, const ExponentialSum &sum, double dt_s)
{
    Eigen::VectorXd y = Eigen::VectorXd::Constant(series.y.size(), sum.constant);
    for (Index i = 0; i < sum.rates_rad_s.size(); ++i) {
        const std::complex<double> s = sum.rates_rad_s[i];
        const std::complex<double> first
            = sum.amplitudes[i] * series.filter.gain(s) * std::exp(s * series.first_s);
        for (Index k = 0; k < y.size(); ++k)
            y[k] += (first * std::exp(s * (static_cast<double>(k) * dt_s))).real();
    }
    return y;
}

SeriesFit describeSeries(const ModelInput &input, const Draft &draft, std::size_t r,
    const std::vector<bool> &isSensor, const SensorModel &model)
{
    const ModelSeries &series = input.series[r];
    const ExponentialSum &sum = draft.series[r];
    SeriesFit fit;
    fit.shot = series.shot;
    fit.plateauGain = sum.constant;
    if (draft.refinement && draft.refinement->withConstant) {
        const Eigen::MatrixXd covariance
            = recordCovariance(*draft.refinement, static_cast<Index>(r));
        fit.u_plateauGain = std::sqrt(covariance(covariance.rows() - 1, covariance.rows() - 1));
    }
    if (isStepTreatment(input.treatment)) {
        const Onset onset = locateOnset(draft, r, isSensor);
        fit.onset_s = onset.time_s;
        fit.u_onset_s = onset.u_s;
    }
    fit.amplitudes = sum.amplitudes.array() * (sum.rates_rad_s.array() * fit.onset_s).exp();
    fit.simulated = isThesis(input)
        ? Eigen::VectorXd(
            impulseResponse(model.stateSpace, series.y.size() + 1).tail(series.y.size()))
        : simulate(series, sum, sampleInterval_s(input));
    fit.error = series.y - fit.simulated;
    fit.fit_percent = fitPercent(fit.error.squaredNorm(), spreadSquares(series.y));
    fit.fitAttainable_percent
        = fitPercent(series.noiseSd * series.noiseSd * static_cast<double>(series.y.size()),
            spreadSquares(series.y));
    return fit;
}

void poolFits(const ModelInput &input, SensorModel &model)
{
    double error = 0.0;
    double noise = 0.0;
    double spread = 0.0;
    double weights = 0.0;
    Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(model.series.front().amplitudes.size());
    const bool isStep = isStepTreatment(input.treatment);
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const SeriesFit &fit = model.series[r];
        const ModelSeries &series = input.series[r];
        error += fit.error.squaredNorm();
        noise += series.noiseSd * series.noiseSd * static_cast<double>(series.y.size());
        spread += spreadSquares(series.y);
        // Each shot's own plateau is its unit: shots of different height share their shape.
        const double unit = isStep ? fit.plateauGain : 1.0;
        const double relativeNoise = series.noiseSd / unit;
        const double weight = relativeNoise != 0.0 ? 1.0 / (relativeNoise * relativeNoise) : 1.0;
        weights += weight;
        model.plateauGain += weight * fit.plateauGain;
        // Free decays start at an arbitrary phase: their sizes are pooled, the first one's phase
        // kept.
        const Eigen::ArrayXcd amplitudes = fit.amplitudes.array();
        if (isStep)
            shape.array() += weight * amplitudes / unit;
        else
            shape.array() += weight * amplitudes.abs()
                * (model.series.front().amplitudes.array().arg() * std::complex<double>(0.0, 1.0))
                      .exp();
    }
    model.plateauGain /= weights;
    model.amplitudes = shape / weights * (isStep ? model.plateauGain : 1.0);
    model.fit_percent = fitPercent(error, spread);
    model.fitAttainable_percent = fitPercent(noise, spread);
}

double listingFit(const StateSpaceModel &stateSpace, const Eigen::VectorXd &y)
{
    // Appendix D compares y(1) with dimpulse's first value, D = 0: one sample late.
    return fitPercent((y - impulseResponse(stateSpace, y.size())).squaredNorm(), spreadSquares(y));
}

bool runsAway(const SensorModel &model, const ModelInput &input)
{
    constexpr double kTooLarge = 10.0;
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const double data = input.series[r].y.cwiseAbs().maxCoeff();
        const Eigen::VectorXd &simulated = model.series[r].simulated;
        if (!simulated.allFinite() || simulated.cwiseAbs().maxCoeff() > kTooLarge * data)
            return true;
    }
    return std::any_of(model.poles.begin(), model.poles.end(), [&](const Pole &pole) {
        return pole.poleClass == PoleClass::Unstable
            && static_cast<double>(input.samples) * std::log(std::abs(pole.z))
            > std::log(kTooLarge);
    });
}

void addUncertainties(const Draft &draft, std::vector<Pole> &poles)
{
    if (!draft.refinement)
        return;
    const Eigen::MatrixXd &covariance = draft.refinement->covariance;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const std::complex<double> s = poles[i].s_rad_s;
        const double w = std::abs(s);
        const Index at = static_cast<Index>(i);
        if (isUpperOfPair(draft.rates_rad_s, i)) {
            const Eigen::Vector2d frequency(s.real() / w, s.imag() / w);
            const Eigen::Vector2d damping(
                -s.imag() * s.imag() / (w * w * w), s.real() * s.imag() / (w * w * w));
            const Eigen::Matrix2d block = covariance.block<2, 2>(at, at);
            poles[i].u_frequency_Hz
                = std::sqrt(frequency.dot(block * frequency)) / (2.0 * std::numbers::pi);
            poles[i].u_dampingRatio = std::sqrt(damping.dot(block * damping));
        } else if (s.imag() < 0.0) {
            poles[i].u_frequency_Hz = poles[i - 1].u_frequency_Hz;
            poles[i].u_dampingRatio = poles[i - 1].u_dampingRatio;
        } else {
            poles[i].u_frequency_Hz = std::sqrt(covariance(at, at)) / (2.0 * std::numbers::pi);
            poles[i].u_dampingRatio = 0.0; // a real pole has damping ratio 1 by definition
        }
    }
}

Pole makePole(std::complex<double> z, std::complex<double> s, PoleClass poleClass)
{
    Pole pole;
    pole.z = z;
    pole.s_rad_s = s;
    pole.poleClass = poleClass;
    pole.frequency_Hz = std::abs(s) / (2.0 * std::numbers::pi);
    pole.dampingRatio = std::abs(s) > 0.0 ? -s.real() / std::abs(s) : 0.0;
    return pole;
}

/// Sensor states first; in thesis mode the step's own pole joins them in the list.
std::vector<Pole> listPoles(const ModelInput &input, const Draft &draft,
    const std::vector<bool> &standsOut, std::optional<std::complex<double>> stepPole)
{
    const double dt_s = sampleInterval_s(input);
    const auto z = discrete(draft.rates_rad_s, dt_s);
    const std::vector<PoleClass> classes
        = classifyPoles(z, ResponseTreatment::StepDeflated, standsOut);
    std::vector<Pole> poles;
    for (std::size_t i = 0; i < z.size(); ++i) {
        poles.push_back(makePole(z[i], draft.rates_rad_s[i], classes[i]));
        if (!standsOut[i])
            poles.back().flags.push_back("below-noise");
    }
    addUncertainties(draft, poles);
    if (stepPole)
        poles.push_back(makePole(*stepPole, rateOf(*stepPole, dt_s), PoleClass::Step));
    return poles;
}

void describeAmplitudes(SensorModel &model)
{
    // model.amplitudes follow the sensor's poles, which are listed before the step's.
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        model.poles[static_cast<std::size_t>(i)].amplitude = std::abs(model.amplitudes[i]);
}

/// ZOH-equivalent G(z) = c0 + sum c_i (z - 1)/(z - p_i); of a free decay F(z) = sum c_i/(z - p_i).
StateSpaceModel describeStateSpace(const ModelInput &input, const SensorModel &model)
{
    std::vector<std::complex<double>> z;
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        z.push_back(model.poles[static_cast<std::size_t>(i)].z);
    Eigen::VectorXcd residues = model.amplitudes;
    double feedthrough = 0.0;
    if (isStepTreatment(input.treatment)) {
        for (Index i = 0; i < residues.size(); ++i)
            residues[i] *= z[static_cast<std::size_t>(i)] - 1.0;
        feedthrough = model.plateauGain + model.amplitudes.sum().real();
    }
    return modalStateSpace(z, residues, feedthrough, sampleInterval_s(input));
}

/// The pole of the step (thesis mode) is taken out of the list and handed back.
std::optional<std::complex<double>> takeStepPole(
    const ModelInput &input, std::vector<std::complex<double>> &poles)
{
    const std::vector<PoleClass> classes
        = classifyPoles(poles, input.treatment, std::vector<bool>(poles.size(), true));
    const auto step = std::find(classes.begin(), classes.end(), PoleClass::Step);
    if (step == classes.end())
        return std::nullopt;
    const auto at = poles.begin() + (step - classes.begin());
    const std::complex<double> pole = *at;
    poles.erase(at);
    return pole;
}

} // namespace

Result<SensorModel> realizeModel(const ModelInput &input, const HankelDecomposition &decomposition,
    Index order, const RealizationSettings &settings, const SpectrumResult &spectrum,
    const JobControl &control)
{
    const Index largest = largestOrder(decomposition);
    if (order < 1 || order > largest) {
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Model order %1 is not possible: the Hankel matrix of %2 rows serves orders 1 "
                    "to %3; choose one of them, or a longer model input."),
                {std::to_string(order), std::to_string(decomposition.rows),
                    std::to_string(largest)}});
    }
    const double dt_s = sampleInterval_s(input);
    std::vector<std::complex<double>> poles = realizedPoles(decomposition, order);
    const auto stepPole = takeStepPole(input, poles);
    std::vector<std::complex<double>> rates;
    for (const std::complex<double> &z : poles)
        rates.push_back(rateOf(z, dt_s));
    sortByFrequency(rates);

    Draft draft = linearDraft(input, rates);
    if (settings.refine && canRefine(input, poles))
        refine(input, draft, control);
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});

    SensorModel model;
    model.order = order;
    model.refined = draft.refinement.has_value();
    if (isThesis(input))
        model.stateSpace = thesisRealization(decomposition, order, dt_s);
    const std::vector<bool> standsOut = standingOut(input, draft);
    model.poles = listPoles(input, draft, standsOut, stepPole);
    for (std::size_t r = 0; r < input.series.size(); ++r)
        model.series.push_back(describeSeries(input, draft, r, standsOut, model));
    poolFits(input, model);
    describeAmplitudes(model);
    if (isThesis(input))
        model.fitListing_percent = listingFit(model.stateSpace, input.series.front().y);
    else
        model.stateSpace = describeStateSpace(input, model);
    model.zeros = transmissionZeros(model.stateSpace);
    model.diverges = runsAway(model, input);
    model.findings = judgeModel(model, input, decomposition, spectrum);
    return model;
}

} // namespace dyncal
