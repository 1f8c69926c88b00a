// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/model_draws.h"

#include "core/base/input_draws.h"
#include "core/base/portable_random.h"
#include "core/realization/model/model_description.h"
#include "core/uncertainty/front_effect.h"
#include "core/uncertainty/model_shape.h"
#include "core/uncertainty/weak_modes.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

bool isOfScatter(const ModelAssessment &assessment)
{
    return assessment.homogeneity && !assessment.homogeneity->passed;
}

double dofOfModel(const ChainSubject &subject)
{
    return isOfScatter(subject.assessment) ? static_cast<double>(subject.model.series.size()) - 1.0
                                           : subject.model.draft.noise.dof;
}

/// How much wider than by noise alone a quantity scatters from shot to shot; 1 where not known.
double scatterOver(double assessed, double byNoise)
{
    const double ratio = assessed / byNoise;
    return std::isfinite(ratio) ? std::max(1.0, ratio) : 1.0;
}

/// The pole of f0 and damping with u of the noise alone.
Pole poleByNoise(const SensorModel &model, const MainPair &pair)
{
    std::vector<Pole> poles = model.poles;
    addUncertainties(model.draft, poles);
    return pair ? poles[pair->first] : Pole();
}

} // namespace

bool ModelDraws::canDraw(const ChainSubject &subject)
{
    return subject.model.draft.refinement && !subject.model.diverges
        && isStepTreatment(subject.input.treatment);
}

ModelDraws::ModelDraws(const ChainSubject &subject, const ChainInputs &inputs)
    : m_subject(subject)
    , m_inputs(inputs)
    , m_mover(subject.input, subject.model)
    , m_pair(mainPair(subject.model, subject.assessment))
    , m_directions(directionsOf(subject.model.draft.refinement->covariance))
    , m_dof(dofOfModel(subject))
    , m_fitted(characteristicValues(subject.model, m_pair, subject.input.treatment))
{
    const auto assessed = sensorResonance(&subject.model, &subject.assessment);
    if (!assessed || !isOfScatter(subject.assessment))
        return;
    const Pole byNoise = poleByNoise(subject.model, m_pair);
    const double frequency = scatterOver(assessed->u_frequency_Hz, byNoise.u_frequency_Hz);
    const double damping = scatterOver(assessed->u_dampingRatio, byNoise.u_dampingRatio);
    m_wider = std::max(frequency, damping);
    m_frequencyShare = frequency / m_wider;
    m_dampingShare = damping / m_wider;
}

Eigen::VectorXd ModelDraws::deltas(std::uint64_t seed, Index trial) const
{
    static const Index kStream = streamOf("model parameters");
    RandomStream stream(seed, trial, kStream);
    Eigen::VectorXd z(m_directions.cols());
    for (double &one : z)
        one = stream.nextNormal();
    return m_directions * z / std::sqrt(drawnVariance(stream, m_dof));
}

SensorModel ModelDraws::movedBy(const Eigen::VectorXd &deltas, double front_s, bool withWeak) const
{
    SensorModel moved
        = withFront(m_mover.moved(deltas), m_subject.response.front.duration_s, front_s);
    if (withWeak || !m_pair)
        return moved;
    return withoutWeakModes(moved, *m_pair).value_or(std::move(moved));
}

/// f0 and damping scatter each by as much as the shots show.
void ModelDraws::narrowPoles(CharacteristicValues &values) const
{
    if (m_wider == 1.0)
        return;
    values.f0_Hz = m_fitted.f0_Hz + m_frequencyShare * (values.f0_Hz - m_fitted.f0_Hz);
    values.zeta = m_fitted.zeta + m_dampingShare * (values.zeta - m_fitted.zeta);
    values.q = 0.5 / values.zeta;
}

void ModelDraws::addClock(double clock_relative, CharacteristicValues &values) const
{
    for (const Characteristic &one : kCharacteristics) {
        if (one.kind == CharacteristicKind::Frequency)
            values.*one.value *= 1.0 + clock_relative;
        if (one.kind == CharacteristicKind::Time)
            values.*one.value /= 1.0 + clock_relative;
    }
}

CharacteristicValues ModelDraws::valuesByNoise(std::uint64_t seed, Index trial) const
{
    return characteristicValues(
        m_mover.moved(deltas(seed, trial)), m_pair, m_subject.input.treatment);
}

CharacteristicValues ModelDraws::values(
    std::uint64_t seed, Index trial, const Eigen::VectorXd &probabilities) const
{
    const double front_s = std::max(0.0, m_inputs.front.value(probabilities));
    const bool withWeak = probabilities[m_inputs.weakMode] < 0.5;
    const SensorModel moved
        = withMounting(movedBy(m_wider * deltas(seed, trial), front_s, withWeak),
            m_inputs.mounting.value(probabilities));
    CharacteristicValues values = characteristicValues(moved, m_pair, m_subject.input.treatment);
    narrowPoles(values);
    addClock(m_inputs.clock.value(probabilities), values);
    return values;
}

} // namespace dyncal
