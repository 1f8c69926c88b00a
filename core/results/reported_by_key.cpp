// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/reported_by_key.h"

#include "core/results/pole_json.h"

namespace dyncal {
namespace {

using ByKey = std::vector<std::pair<std::string, const ReportedValue *>>;

/// In the order of the summary's levels and of the shots.
void addSensitivities(const UncertaintyReport &report, ByKey &all)
{
    if (report.sensitivity)
        all.emplace_back("sensitivity", &*report.sensitivity);
    for (std::size_t i = 0; i < report.perLevel.size(); ++i)
        all.emplace_back("sensitivity.per_level" + placeOf(i), &report.perLevel[i]);
    for (std::size_t i = 0; i < report.ofShots.size(); ++i)
        all.emplace_back("shots" + placeOf(i) + ".sensitivity", &report.ofShots[i]);
}

/// In the order of the poles of results.json.
void addAmplitudes(const CalibrationResults &results, ByKey &all)
{
    const std::vector<ReportedValue> &amplitudes = results.uncertainty->amplitudes;
    if (!results.model)
        return;
    const std::vector<Pole> &poles = polesOf(*results.model, results.assessment.get());
    std::size_t listed = 0;
    for (const std::size_t i : listedPoles(poles)) {
        if (i < amplitudes.size() && !(poles[i].z.imag() < 0.0))
            all.emplace_back("model.poles" + placeOf(listed) + ".amplitude", &amplitudes[i]);
        ++listed;
    }
}

} // namespace

std::string placeOf(std::size_t i)
{
    return "[" + std::to_string(i) + "]";
}

ByKey reportedByKey(const CalibrationResults &results)
{
    ByKey all;
    if (!results.uncertainty)
        return all;
    addSensitivities(*results.uncertainty, all);
    for (const ReportedValue &value : results.uncertainty->ofModel)
        all.emplace_back(value.of, &value);
    addAmplitudes(results, all);
    return all;
}

} // namespace dyncal
