// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/moist_air.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"

#include <array>
#include <cmath>

namespace dyncal {
namespace {

/// Coefficients a0..a15 of Cramer's equation 15, for the speed of sound (table III) and the ratio
/// of heat capacities.
using Coefficients = std::array<double, 16>;
constexpr Coefficients kSoundSpeed{331.5024, 0.603055, -0.000528, 51.471935, 0.1495874, -0.000782,
    -1.82e-7, 3.73e-8, -2.93e-10, -85.20931, -0.228525, 5.91e-5, -2.835149, -2.15e-13, 29.179762,
    0.000486};
constexpr Coefficients kGamma{1.400822, -1.75e-5, -1.73e-7, -0.0873629, -0.0001665, -3.26e-6,
    2.047e-8, -1.26e-10, 5.939e-14, -0.1199717, -0.0008693, 1.979e-6, -0.01104, -3.478e-16,
    0.0450616, 1.82e-6};

double cramer(const Coefficients &a, double t, double xw, double p, double xc)
{
    const double t2 = t * t;
    return a[0] + a[1] * t + a[2] * t2 + (a[3] + a[4] * t + a[5] * t2) * xw
        + (a[6] + a[7] * t + a[8] * t2) * p + (a[9] + a[10] * t + a[11] * t2) * xc + a[12] * xw * xw
        + a[13] * p * p + a[14] * xc * xc + a[15] * xw * p * xc;
}

struct Limit
{
    const char *name;
    const char *unit;
    double value;
    double lowest;
    double highest;
};

Result<void> checkLimits(const std::array<Limit, 5> &limits)
{
    for (const Limit &limit : limits) {
        if (limit.value >= limit.lowest && limit.value <= limit.highest)
            continue;
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "Moist air (Cramer): the %1 is %2 %5, and the formula holds from %3 to %4 %5; choose the gas 'air' or another value."),
                {limit.name, numberText(limit.value, 6), numberText(limit.lowest),
                    numberText(limit.highest), limit.unit}},
            "SHK-009");
    }
    return {};
}

} // namespace

double waterFraction(double pressure_Pa, double temperature_K, double relativeHumidity)
{
    const double t = temperature_K - kCelsiusZero_K;
    const double enhancement = 1.00062 + 3.14e-8 * pressure_Pa + 5.6e-7 * t * t;
    const double saturation_Pa = std::exp(1.2378847e-5 * temperature_K * temperature_K
        - 1.9121316e-2 * temperature_K + 33.93711047 - 6343.1645 / temperature_K);
    return relativeHumidity * enhancement * saturation_Pa / pressure_Pa;
}

Result<MoistAir> moistAir(
    double pressure_Pa, double temperature_K, double relativeHumidity, double carbonDioxide)
{
    const double xw = waterFraction(pressure_Pa, temperature_K, relativeHumidity);
    const double t = temperature_K - kCelsiusZero_K;
    constexpr double kEdge = 1e-9; // in doubles 303.15 - 273.15 is a little above 30
    const std::array<Limit, 5> limits{{{"temperature", "degC", t, -kEdge, 30.0 + kEdge},
        {"pressure", "Pa", pressure_Pa, 75e3, 102e3},
        {"relative humidity", "", relativeHumidity, 0.0, 1.0},
        {"mole fraction of water", "", xw, 0.0, 0.06},
        {"mole fraction of carbon dioxide", "", carbonDioxide, 0.0, 0.01}}};
    if (auto checked = checkLimits(limits); !checked)
        return tl::unexpected(checked.error());
    return MoistAir{cramer(kSoundSpeed, t, xw, pressure_Pa, carbonDioxide),
        cramer(kGamma, t, xw, pressure_Pa, carbonDioxide), xw};
}

} // namespace dyncal
