// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order/order_findings.h"

#include "core/realization/refinement/series_simulation.h"

#include <algorithm>
#include <string>

namespace dyncal {
namespace {

constexpr double kOtherShots_points = 15.0;

} // namespace

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
        findings.push_back({.id = "MOD-007",
            .severity = Severity::Caution,
            .shot = shot,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1: FIT is %2 % with the model, but %3 % with the poles of the other shots alone. The shots do not share their poles: look at that shot; if nothing is wrong with it the sensor is not linear."),
                {std::to_string(shot), fitPercentText(own->fit_percent), fitPercentText(others)}},
            .value = own->fit_percent - others,
            .limit = kOtherShots_points});
    }
    return findings;
}

} // namespace dyncal
