// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/pole_json.h"

#include "core/realization/model/pole_classes.h"
#include "core/results/results_context.h"

#include <cmath>

namespace dyncal {
namespace {

bool isSameNumber(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool isSamePlace(const Pole &a, const Pole &b)
{
    return isSameNumber(a.z.real(), b.z.real()) && isSameNumber(a.z.imag(), b.z.imag());
}

} // namespace

JsonRecord::Json poleJson(const Pole &pole)
{
    const char *noFrequency = "The pole has no counterpart in continuous time.";
    JsonRecord record;
    record.number("re", pole.z.real(), "Not determined.");
    record.number("im", pole.z.imag(), "Not determined.");
    record.set("class", poleClassName(pole.poleClass));
    record.set("flags", pole.flags);
    record.number("frequency_hz", pole.frequency_Hz, noFrequency);
    record.number("u_frequency_hz", pole.u_frequency_Hz, kNoUncertainty);
    record.number("damping_ratio", pole.dampingRatio, noFrequency);
    record.number("u_damping_ratio", pole.u_dampingRatio, kNoUncertainty);
    record.number("coverage_factor", pole.coverageFactor, kNoUncertainty);
    record.number("amplitude", pole.amplitude, "The amplitude could not be fitted.");
    return record.take();
}

std::vector<std::size_t> listedPoles(const std::vector<Pole> &poles)
{
    std::vector<Pole> sorted = poles;
    sortPoles(sorted);
    std::vector<std::size_t> positions;
    std::vector<bool> isTaken(poles.size(), false);
    for (const Pole &pole : sorted)
        for (std::size_t i = 0; i < poles.size(); ++i)
            if (!isTaken[i] && isSamePlace(poles[i], pole)) {
                isTaken[i] = true;
                positions.push_back(i);
                break;
            }
    return positions;
}

JsonRecord::Json statedPoleJson(const Pole &pole, const PoleUncertainty &stated)
{
    JsonRecord record;
    record.number("u_complete_frequency_hz", stated.u_frequency_Hz, kNoUncertainty);
    record.number("k_frequency", stated.kFrequency, kNoUncertainty);
    record.number("u_complete_damping_ratio", stated.u_dampingRatio, kNoUncertainty);
    record.number("k_damping_ratio", stated.kDamping, kNoUncertainty);
    record.number("u_amplitude", stated.u_amplitude, kNoUncertainty);
    record.number("k_amplitude", stated.kAmplitude, kNoUncertainty);
    JsonRecord::Json json = poleJson(pole);
    json.update(record.take());
    return json;
}

} // namespace dyncal
