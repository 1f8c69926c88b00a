// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model_findings.h"

#include "core/base/number_text.h"
#include "core/realization/order_evidence.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kPairRatio = 1.05;
constexpr double kGoodShare = 0.8; ///< of the attainable FIT
constexpr double kOverFit_points = 2.0;
constexpr double kNoiseLimit_percent = 10.0; ///< below, FIT says nothing
constexpr double kSameFrequency = 0.02;
constexpr double kCancelling = 1e-3;
constexpr double kClearGap = 3.0;
constexpr double kOtherShots_points = 15.0;
constexpr std::size_t kMostNamed = 4; ///< poles in one sentence
constexpr double kMissingFast = 0.1; ///< of the plateau, at the onset

Finding about(const char *id, Severity severity, Message message, std::optional<double> value = {},
    std::optional<double> limit = {})
{
    return {id, severity, 0, {}, {}, std::move(message), value, limit};
}

void judgeOrder(const SensorModel &model, const HankelDecomposition &decomposition, Findings &out)
{
    const Index n = model.order;
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    const double floor = decomposition.noiseFloor_p95;
    if (splitsPair(decomposition, n)) {
        out.push_back(about("ORD-001", Severity::Caution,
            {DYNCAL_TEXT("core",
                 "Order %1 splits an oscillating pair (singular values %1 and %2 are %3 and %4). "
                 "Order %2 keeps it."),
                {std::to_string(n), std::to_string(n + 1), numberText(sigma[n - 1], 4),
                    numberText(sigma[n], 4)}},
            sigma[n - 1] / sigma[n], kPairRatio));
        out.back().mend = Mend{{DYNCAL_TEXT("core", "Use order %1"), {std::to_string(n + 1)}},
            "realization.order", std::to_string(n + 1)};
    }
    if (n <= sigma.size() && floor > 0.0 && sigma[n - 1] < floor) {
        const Index above = (sigma.array() > floor).count();
        out.push_back(about("ORD-003", Severity::Caution,
            {DYNCAL_TEXT("core", "States above %1 lie at the noise level."),
                {std::to_string(above)}},
            static_cast<double>(n), static_cast<double>(above)));
    }
}

void judgePoles(const SensorModel &model, Findings &out)
{
    for (const Pole &pole : model.poles) {
        if (pole.z.imag() < 0.0)
            continue; // its conjugate has been spoken of
        const std::string magnitude = numberText(std::abs(pole.z), 7);
        switch (pole.poleClass) {
        case PoleClass::Unstable:
            out.push_back(about("MOD-001", Severity::Block,
                {DYNCAL_TEXT("core",
                     "The model of order %1 is unstable: a pole of magnitude %2 at %3. It is not "
                     "reportable; choose another order."),
                    {std::to_string(model.order), magnitude,
                        numberWithUnit(pole.frequency_Hz, "Hz", 4)}},
                std::abs(pole.z), 1.0));
            break;
        case PoleClass::Nyquist:
            out.push_back(about("MOD-002", Severity::Caution,
                {DYNCAL_TEXT("core",
                     "A pole lies at z = %1: dynamics at the Nyquist frequency come from sampling, "
                     "not from the sensor."),
                    {numberText(pole.z.real(), 4)}},
                pole.z.real()));
            break;
        case PoleClass::Step:
            out.push_back(about("MOD-003", Severity::Info,
                {DYNCAL_TEXT("core", "The pole at z = %1 is the step itself."),
                    {numberText(pole.z.real(), 9)}}));
            break;
        case PoleClass::Sensor:
        case PoleClass::Other:
            break;
        }
    }
}

bool isCancelled(const Pole &pole, const std::vector<std::complex<double>> &zeros)
{
    return std::any_of(zeros.begin(), zeros.end(),
        [&](const auto &zero) { return std::abs(zero - pole.z) < kCancelling; });
}

/// A pair counts once: "2 (1.2 MHz, 3.4 MHz)".
void judgeCancelling(const SensorModel &model, Findings &out)
{
    std::vector<std::string> named;
    for (const Pole &pole : model.poles) {
        if (pole.z.imag() >= 0.0 && isCancelled(pole, model.zeros))
            named.push_back(numberWithUnit(pole.frequency_Hz, "Hz", 4));
    }
    if (named.empty())
        return;
    const std::string count = std::to_string(named.size());
    std::string list;
    for (std::size_t i = 0; i < std::min(named.size(), kMostNamed); ++i)
        list += (i > 0 ? ", " : "") + named[i];
    out.push_back(about("MOD-005", Severity::Info,
        {DYNCAL_TEXT("core", "Poles nearly cancelled by zeros: %1 (%2). A lower order may do."),
            {count, named.size() > kMostNamed ? list + ", \xE2\x80\xA6" : list}},
        static_cast<double>(named.size())));
}

void judgeFit(const SensorModel &model, Findings &out)
{
    const double attainable = model.fitAttainable_percent;
    if (model.diverges || !(attainable > kNoiseLimit_percent))
        return;
    const std::vector<std::string> words{
        numberText(std::round(model.fit_percent * 10.0) / 10.0, 4), numberText(attainable, 3)};
    if (model.fit_percent < kGoodShare * attainable) {
        out.push_back(about("MOD-004", Severity::Caution,
            {DYNCAL_TEXT("core",
                 "FIT is %1 % of an attainable %2 %: the model misses part of the response."),
                words},
            model.fit_percent, kGoodShare * attainable));
    } else if (model.fit_percent > attainable + kOverFit_points) {
        out.push_back(about("MOD-008", Severity::Caution,
            {DYNCAL_TEXT("core",
                 "FIT %1 % is above the %2 % that the noise allows: order %3 also fits noise."),
                {words[0], words[1], std::to_string(model.order)}},
            model.fit_percent, attainable));
    }
}

void judgeAgainstSpectrum(const SensorModel &model, const SpectrumResult &spectrum, Findings &out)
{
    if (spectrum.resonances.empty() || model.diverges)
        return;
    const double seen_Hz = spectrum.resonances.front().frequency_Hz;
    double nearest_Hz = 0.0;
    for (const Pole &pole : model.poles) {
        if (pole.poleClass != PoleClass::Sensor || pole.z.imag() <= 0.0)
            continue;
        // The spectrum of a ringing peaks at the damped frequency, not at |s| / 2 pi.
        const double ringing_Hz = pole.frequency_Hz
            * std::sqrt(std::max(0.0, 1.0 - pole.dampingRatio * pole.dampingRatio));
        if (std::abs(ringing_Hz - seen_Hz) < std::abs(nearest_Hz - seen_Hz))
            nearest_Hz = ringing_Hz;
    }
    if (std::abs(nearest_Hz - seen_Hz) > kSameFrequency * seen_Hz) {
        out.push_back(about("MOD-006", Severity::Caution,
            {nearest_Hz > 0.0 ? DYNCAL_TEXT("core",
                 "The spectrum's resonance at %1 is not in the model, whose nearest lies at %2.")
                              : DYNCAL_TEXT("core",
                                  "The spectrum's resonance at %1 is not in the model, which has "
                                  "none."),
                {numberWithUnit(seen_Hz, "Hz", 4), numberWithUnit(nearest_Hz, "Hz", 4)}},
            nearest_Hz, seen_Hz));
    }
}

/// A sensor cannot jump: a model that starts far from 0 lacks its fastest part.
void judgeOnset(const SensorModel &model, const ModelInput &input, Findings &out)
{
    if (!isStepTreatment(input.treatment) || model.diverges || !(std::abs(model.plateauGain) > 0.0))
        return;
    const double atOnset
        = std::abs(model.plateauGain + model.amplitudes.sum().real()) / std::abs(model.plateauGain);
    if (atOnset > kMissingFast) {
        out.push_back(about("MOD-009", Severity::Caution,
            {DYNCAL_TEXT("core",
                 "The model starts at %1 % of the step instead of 0: a fast part of the response "
                 "is "
                 "missing; raise the model rate or the order."),
                {numberText(100.0 * atOnset, 3)}},
            atOnset, kMissingFast));
    }
}

} // namespace

bool splitsPair(const HankelDecomposition &decomposition, Index order)
{
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    return order >= 1 && order < sigma.size() && sigma[order] > 0.0
        && sigma[order] > decomposition.noiseFloor_p95
        && sigma[order - 1] / sigma[order] < kPairRatio;
}

Findings judgeGap(const HankelDecomposition &decomposition)
{
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    double widest = 0.0;
    for (Index n = 1; n < sigma.size() && sigma[n - 1] > decomposition.noiseFloor_p95; ++n)
        widest = std::max(widest, sigma[n - 1] / sigma[n]);
    if (sigma.size() < 2 || widest > kClearGap)
        return {};
    return {about("ORD-002", Severity::Info,
        {DYNCAL_TEXT("core",
             "No clear gap between the singular values: none above the noise is more than %1 times "
             "the next. Compare candidates."),
            {numberText(kClearGap, 2)}},
        widest, kClearGap)};
}

Findings judgeOtherShots(const SensorModel &model, const OrderEvidence &evidence)
{
    Findings findings;
    if (model.diverges || model.order > evidence.crossShotFit_percent.rows())
        return findings;
    for (std::size_t i = 0; i < evidence.crossShots.size(); ++i) {
        const Index shot = evidence.crossShots[i];
        const auto own = std::find_if(model.series.begin(), model.series.end(),
            [shot](const SeriesFit &fit) { return fit.shot == shot; });
        const double others = evidence.crossShotFit_percent(model.order - 1, static_cast<Index>(i));
        if (own == model.series.end() || !(own->fit_percent - others > kOtherShots_points))
            continue;
        findings.push_back(about("MOD-007", Severity::Caution,
            {DYNCAL_TEXT("core",
                 "Shot %1: FIT is %2 % with the model, but %3 % with the poles of the other shots "
                 "alone. The shots do not share their poles; the sensor may not be linear."),
                {std::to_string(shot), numberText(own->fit_percent, 3), numberText(others, 3)}},
            own->fit_percent - others, kOtherShots_points));
        findings.back().shot = shot;
    }
    return findings;
}

void flagPoles(SensorModel &model)
{
    for (Pole &pole : model.poles) {
        if (pole.poleClass == PoleClass::Step || pole.poleClass == PoleClass::Nyquist
            || pole.poleClass == PoleClass::Unstable)
            pole.flags.push_back(poleClassName(pole.poleClass));
        if (isCancelled(pole, model.zeros))
            pole.flags.push_back("near-cancelled");
        if (pole.poleClass != PoleClass::Step && pole.z.imag() == 0.0
            && pole.frequency_Hz <= pole.u_frequency_Hz)
            pole.flags.push_back("integrator");
    }
}

Findings judgeModel(const SensorModel &model, const ModelInput &input,
    const HankelDecomposition &decomposition, const SpectrumResult &spectrum)
{
    Findings findings;
    judgeOrder(model, decomposition, findings);
    judgePoles(model, findings);
    judgeCancelling(model, findings);
    judgeFit(model, findings);
    judgeAgainstSpectrum(model, spectrum, findings);
    judgeOnset(model, input, findings);
    return findings;
}

} // namespace dyncal
