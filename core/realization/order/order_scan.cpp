// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order/order_scan.h"

#include "core/base/constants.h"
#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/exponentials/shared_fit.h"
#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/pole_classes.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/order/cross_shot.h"
#include "core/realization/order/order_spread.h"
#include "core/realization/order/order_words.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/refinement/series_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr Index kHighestOrder = 60;
constexpr double kMostWork = 4e9; ///< samples x order^3 over all orders: about a second

using Poles = std::vector<std::complex<double>>;

Index highestOrder(const ModelInput &input, const HankelDecomposition &decomposition)
{
    const double affordable = std::cbrt(kMostWork / static_cast<double>(input.samples));
    return std::clamp<Index>(static_cast<Index>(affordable), 1,
        std::min({kHighestOrder, largestOrder(decomposition), input.samples / 2}));
}

OrderPole describePole(std::complex<double> z, Index order, double dt_s)
{
    const std::complex<double> s = continuousPole(z, dt_s);
    OrderPole pole;
    pole.order = order;
    pole.frequency_Hz = std::abs(s) / (2.0 * std::numbers::pi);
    pole.dampingRatio = -s.real() / std::abs(s);
    if (std::abs(z) > 1.0 + kUnstableMargin)
        pole.stability = PoleStability::Unstable;
    return pole;
}

bool sameWithin(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance * std::abs(b);
}

/// Compared with all poles of the order before: the best match counts.
PoleStability stabilityOf(const OrderPole &pole, const std::vector<OrderPole> &before,
    const RealizationSettings &settings)
{
    PoleStability best = PoleStability::New;
    for (const OrderPole &other : before) {
        if (!sameWithin(pole.frequency_Hz, other.frequency_Hz, settings.stableFrequency))
            continue;
        if (sameWithin(pole.dampingRatio, other.dampingRatio, settings.stableDamping))
            return PoleStability::FrequencyAndDamping;
        best = PoleStability::Frequency;
    }
    return best;
}

/// Result of one order: its oscillating poles, and FIT (NaN where it diverges).
struct OneOrder
{
    std::vector<OrderPole> poles;
    double fit_percent = kUnknown;
    bool diverges = false;
    Index unstable = 0;
    Index nyquist = 0;
};

class OrderScan
{
public:
    OrderScan(const ModelInput &input, const HankelDecomposition &decomposition)
        : m_input(input)
        , m_decomposition(decomposition)
        , m_records(input.samples, static_cast<Index>(input.series.size()))
    {
        for (Index r = 0; r < m_records.cols(); ++r) {
            m_records.col(r) = input.series[static_cast<std::size_t>(r)].y;
            m_spread += spreadSquares(m_records.col(r));
        }
    }

    OneOrder order(Index n) const
    {
        OneOrder result;
        const Poles poles = fittedPoles(n, result);
        const auto fits = fitSharedPoles(m_records, poles, isStepTreatment(m_input.treatment));
        if (!result.diverges)
            result.fit_percent = fitPercent(errorSquares(fits, n), m_spread);
        describe(n, poles, fits, result.poles);
        std::stable_sort(result.poles.begin(), result.poles.end(),
            [](const OrderPole &a, const OrderPole &b) { return a.frequency_Hz < b.frequency_Hz; });
        return result;
    }

    /// FIT that the true model would score; unknown if the noise is unknown.
    double attainable_percent() const
    {
        double noise = 0.0;
        for (const ModelSeries &series : m_input.series) {
            if (series.noise.size() == 0)
                return kUnknown;
            noise += series.noiseSd * series.noiseSd * static_cast<double>(series.y.size());
        }
        return fitPercent(noise, m_spread);
    }

private:
    /// All poles except the step's own (thesis mode); also counts unstable and Nyquist poles. Poles
    /// with which the order diverges are described here, without an amplitude, and left out.
    Poles fittedPoles(Index n, OneOrder &result) const
    {
        const Poles all = realizedPoles(m_decomposition, n);
        const auto classes
            = classifyPoles(all, m_input.treatment, std::vector<bool>(all.size(), true));
        Poles poles;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (classes[i] == PoleClass::Step)
                continue;
            result.unstable += classes[i] == PoleClass::Unstable;
            result.nyquist += classes[i] == PoleClass::Nyquist;
            if (!isRunaway(all[i], m_input.samples))
                poles.push_back(all[i]);
            else if (all[i].imag() > 0.0)
                result.poles.push_back(describePole(all[i], n, sampleInterval_s(m_input)));
            result.diverges = result.diverges || isRunaway(all[i], m_input.samples);
        }
        return poles;
    }

    double errorSquares(const std::vector<AmplitudeFit> &fits, Index order) const
    {
        if (isThesisMode(m_input)) {
            const StateSpaceModel model
                = thesisRealization(m_decomposition, order, sampleInterval_s(m_input));
            const Index samples = m_records.rows();
            return (m_records.col(0) - impulseResponse(model, samples + 1).tail(samples))
                .squaredNorm();
        }
        double sum = 0.0;
        for (Index r = 0; r < m_records.cols(); ++r)
            sum += (m_records.col(r) - fits[static_cast<std::size_t>(r)].fitted).squaredNorm();
        return sum;
    }

    void describe(Index order, const Poles &poles, const std::vector<AmplitudeFit> &fits,
        std::vector<OrderPole> &described) const
    {
        const double dt_s = sampleInterval_s(m_input);
        ModelDraft draft;
        for (const std::complex<double> &z : poles)
            draft.poles_rad_s.push_back(continuousPole(z, dt_s));
        for (std::size_t r = 0; r < fits.size(); ++r)
            draft.series.push_back(atStart(m_input.series[r], draft.poles_rad_s, fits[r]));
        const std::vector<bool> standsOut = standingOut(m_input, draft);
        for (std::size_t i = 0; i < poles.size(); ++i) {
            if (!isUpperOfPair(poles, i))
                continue;
            described.push_back(describePole(poles[i], order, dt_s));
            described.back().standsOut = standsOut[i];
            described.back().amplitude = relativeSize(fits, static_cast<Index>(i));
        }
    }

    double relativeSize(const std::vector<AmplitudeFit> &fits, Index pole) const
    {
        double sum = 0.0;
        for (std::size_t r = 0; r < fits.size(); ++r) {
            const double noise = m_input.series[r].noiseSd;
            sum += std::norm(fits[r].amplitudes[pole]) / (noise > 0.0 ? noise * noise : 1.0);
        }
        return std::sqrt(sum / static_cast<double>(fits.size()));
    }

    const ModelInput &m_input;
    const HankelDecomposition &m_decomposition;
    Eigen::MatrixXd m_records;
    double m_spread = 0.0;
};

/// The oscillating pole that holds most energy at an order; null if none does.
const OrderPole *mainPoleOf(const OrderEvidence &evidence, Index order)
{
    const auto energy = [](const OrderPole &pole) {
        return pole.amplitude * pole.amplitude / std::abs(pole.dampingRatio * pole.frequency_Hz);
    };
    const OrderPole *main = nullptr;
    for (const OrderPole &pole : evidence.poles) {
        if (pole.order == order && pole.standsOut && pole.stability != PoleStability::Unstable
            && (!main || energy(pole) > energy(*main)))
            main = &pole;
    }
    return main;
}

} // namespace

Result<OrderEvidence> gatherOrderEvidence(const ModelInput &input,
    const HankelDecomposition &decomposition, const OrderSuggestion &suggestion,
    const RealizationSettings &settings, const JobControl &control)
{
    const OrderScan scan(input, decomposition);
    OrderEvidence evidence;
    evidence.fit_percent.resize(highestOrder(input, decomposition));
    std::vector<OrderPole> before;
    for (Index n = 1; n <= evidence.fit_percent.size(); ++n) {
        OneOrder one = scan.order(n);
        evidence.fit_percent[n - 1] = one.fit_percent;
        evidence.unstable.push_back(one.unstable);
        evidence.nyquist.push_back(one.nyquist);
        for (OrderPole &pole : one.poles) {
            if (pole.stability != PoleStability::Unstable)
                pole.stability = stabilityOf(pole, before, settings);
        }
        evidence.poles.insert(evidence.poles.end(), one.poles.begin(), one.poles.end());
        before = std::move(one.poles);
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {});
    }
    CrossShot cross = leaveOneShotOut(input, settings, control);
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    evidence.crossShot_percent = std::move(cross.error_percent);
    evidence.crossShotFit_percent = std::move(cross.fit_percent);
    for (Index r = 0; r < evidence.crossShotFit_percent.cols(); ++r)
        evidence.crossShots.push_back(input.series[static_cast<std::size_t>(r)].shot);
    if (const OrderPole *main = mainPoleOf(evidence, suggestion.order))
        evidence.spread = spreadAround(evidence, suggestion.order, main->frequency_Hz);
    evidence.fitAttainable_percent = scan.attainable_percent();
    evidence.findings = judgeGap(decomposition);
    evidence.words = wordsFor(decomposition, suggestion, evidence);
    return evidence;
}

} // namespace dyncal
