// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/transducer_response.h"

#include "core/base/constants.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace dyncal {
namespace {

/// The reference's record of the same shot, its zero of time at that of the DUT.
RecordOfShot alongside(const RecordOfShot &dut, const ReferenceRecords &reference)
{
    const WindowedResponse &response = *reference.ofShot(dut.response->shot);
    // No longer than the DUT's, which an echo may have ended.
    const double window_s = static_cast<double>(dut.response->length) / dut.response->sampleRate_Hz;
    const auto samples = static_cast<Index>(std::llround(window_s * response.sampleRate_Hz));
    RecordOfShot shot{&response, {}};
    shot.record.values = response.values.head(response.lead + std::min(response.length, samples));
    shot.record.early = response.lead;
    shot.scale = response.valueScale;
    shot.onset_s = dut.response->start_s - response.start_s + reference.delay_s;
    return shot;
}

std::vector<RecordOfShot> recordsOf(
    const std::vector<RecordOfShot> &duts, const ReferenceRecords &reference)
{
    std::vector<RecordOfShot> records;
    records.reserve(duts.size());
    for (const RecordOfShot &dut : duts)
        records.push_back(alongside(dut, reference));
    return records;
}

/// The DUT's zero of time is its detected start: what it shares with the reference.
std::vector<RecordOfShot> fromStart(std::vector<RecordOfShot> duts)
{
    for (RecordOfShot &dut : duts)
        dut.onset_s = 0.0;
    return duts;
}

/// Of the sum of two independent relative variances, by Welch and Satterthwaite.
double dofOfSum(double a, double dofOf_a, double b, double dofOf_b)
{
    const double sum = a + b;
    return sum > 0.0 ? sum * sum / (a * a / dofOf_a + b * b / dofOf_b)
                     : std::numeric_limits<double>::infinity();
}

/// a/b with what noise and cuts do to it, to first order.
ShotPoint quotient(const ShotPoint &a, const ShotPoint &b)
{
    ShotPoint point;
    point.S = a.S / b.S;
    const double size2 = std::norm(point.S);
    const double ofA = a.variance / std::norm(a.S);
    const double ofB = b.variance / std::norm(b.S);
    point.variance = size2 * (ofA + ofB);
    point.dof = dofOfSum(ofA, a.dof, ofB, b.dof);
    point.changes = std::abs(point.S) * (a.changes / std::abs(a.S) - b.changes / std::abs(b.S));
    point.variancesOfChanges
        = size2 * (a.variancesOfChanges / std::norm(a.S) + b.variancesOfChanges / std::norm(b.S));
    return point;
}

} // namespace

double uDelay_s(const ReferenceRecords &reference)
{
    constexpr double kUnstated_s = 0.5e-6;
    return reference.u_delay_s.value_or(kUnstated_s / std::sqrt(3.0));
}

TransducerResponse::TransducerResponse(
    const std::vector<RecordOfShot> &duts, double span_s, const ReferenceRecords &reference)
    : m_reference(reference)
    , m_u_delay_s(uDelay_s(reference))
    , m_shots(duts.size())
    , m_dut(fromStart(duts), span_s)
    , m_ref(recordsOf(duts, reference), span_s)
{
}

ShotPoint TransducerResponse::ratioOf(std::size_t shot, double length_s, double frequency_Hz) const
{
    ShotPoint point = quotient(
        m_dut.pointOf(shot, length_s, frequency_Hz), m_ref.pointOf(shot, length_s, frequency_Hz));
    point.u_onset_s = m_u_delay_s;
    return point;
}

ResponsePoint TransducerResponse::at(double frequency_Hz) const
{
    const std::optional<ReferencePoint> S_ref = m_reference.sensitivity.at(frequency_Hz);
    if (!S_ref)
        return {.magnitude = kUnknown, .phase_rad = kUnknown, .isCalibrated = false};
    const ResponsePoint dut = m_dut.at(frequency_Hz), ref = m_ref.at(frequency_Hz);
    ResponsePoint point;
    point.length_s = std::max(dut.length_s, ref.length_s);
    std::vector<ShotPoint> shots;
    double variance = 0.0;
    for (std::size_t i = 0; i < m_shots; ++i) {
        shots.push_back(ratioOf(i, point.length_s, frequency_Hz));
        variance += shots.back().variance;
    }
    const double omega = kTwoPi * frequency_Hz;
    const double n = static_cast<double>(shots.size());
    point.magnitude = meanMagnitude(shots) * S_ref->magnitude;
    point.phase_rad = std::remainder(meanPhase_rad(shots, omega) + S_ref->phase_rad, kTwoPi);
    point.u_magnitude = std::sqrt(variance) / n * S_ref->magnitude;
    // The delay is the same in every shot.
    point.u_phase_rad = std::hypot(point.u_magnitude / point.magnitude, omega * m_u_delay_s);
    point.dof = dofOf(shots);
    point.boundEnd = boundOfEnd(shots) * S_ref->magnitude;
    point.boundAlias
        = point.magnitude * (dut.boundAlias / dut.magnitude + ref.boundAlias / ref.magnitude);
    point.u_reference = point.magnitude * S_ref->u_magnitude / S_ref->magnitude;
    point.u_referencePhase_rad = S_ref->u_phase_rad;
    point.dofReference = S_ref->dof;
    return point;
}

} // namespace dyncal
