// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/pole_json.h"

#include "core/results/results_context.h"

namespace dyncal {

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

} // namespace dyncal
