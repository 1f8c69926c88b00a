// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/shock_tables.h"

#include "core/base/constants.h"
#include "core/shock/step_monte_carlo.h"
#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <cmath>

namespace dyncal {

namespace {

struct ShockTables
{
    Q_DECLARE_TR_FUNCTIONS(ShockTables)
};

const QString kNone = QStringLiteral("–");

QString shotName(Index shot)
{
    return ShockTables::tr("Shot %1").arg(shot);
}

QString percent(double share, int digits)
{
    return shownNumber(100.0 * share, digits) + QStringLiteral(" %");
}

QString withU(double value, const std::optional<double> &u, const QString &unit, int digits)
{
    if (!u)
        return shownQuantity(value, unit, digits);
    return shownWithStandardU(value, *u, unit, digits);
}

std::optional<double> uOf(const ShockConditions &shot, StepResult result)
{
    return shot.uncertainty ? shot.uncertainty->u(result) : std::nullopt;
}

/// Rows of one quantity over all shots.
class Rows
{
public:
    explicit Rows(const ShockConditionsSet &shock)
        : m_shock(shock)
    {
    }

    template <typename Value>
    void add(const QString &name, Value value)
    {
        QStringList row{name};
        for (const ShockConditions &shot : m_shock.shots)
            row << value(shot);
        m_rows.push_back(row);
    }

    /// A row of the gas states, where they are known.
    template <typename Value>
    void state(const QString &name, const QString &unit, int digits, Value value)
    {
        numbers(name, unit, digits, [&](const ShockConditions &shot) {
            return shot.states ? std::optional<double>(value(*shot.states)) : std::nullopt;
        });
    }

    /// Numbers of one unit, where they are known.
    template <typename Value>
    void numbers(const QString &name, const QString &unit, int digits, Value value)
    {
        std::vector<std::optional<double>> values;
        values.reserve(m_shock.shots.size());
        for (const ShockConditions &shot : m_shock.shots)
            values.push_back(value(shot));
        m_rows.push_back(QStringList{name} + shownColumn(values, unit, digits));
    }

    QVector<QStringList> take() { return std::move(m_rows); }

private:
    const ShockConditionsSet &m_shock;
    QVector<QStringList> m_rows;
};

QString stepText(const ShockConditions &shot)
{
    if (!shot.step_Pa)
        return ShockTables::tr("not determined");
    if (shot.stepTyped)
        return ShockTables::tr("%1 (typed)").arg(shownQuantity(*shot.step_Pa, "Pa", 5));
    return withU(*shot.step_Pa, uOf(shot, StepResult::Step), "Pa", 5);
}

QString gradientText(const ShockConditions &shot)
{
    if (!shot.states || !shot.velocityFit || !shot.velocityFit->gradient_per_s)
        return kNone;
    const double scale = 1.0 / shot.states->velocity_m_s;
    const double percent = 100.0 * scale;
    const ShownResult gradient = shownResult(percent * *shot.velocityFit->gradient_per_s,
        percent * shot.velocityFit->u_gradient_per_s.value_or(0.0), {});
    const auto perMetre
        = [](const QString &number) { return ShockTables::tr("%1 %/m").arg(number); };
    const QString text = shot.velocityFit->u_gradient_per_s
        ? shownWithStandardU({perMetre(gradient.value), perMetre(gradient.u)})
        : perMetre(gradient.value);
    return shot.velocityFit->attenuated ? text : ShockTables::tr("%1 (not applied)").arg(text);
}

void addStates(Rows &rows)
{
    using States = const ShockStates &;
    rows.state(ShockTables::tr("p1"), "Pa", 5, [](States s) { return s.driven.pressure_Pa; });
    rows.state(ShockTables::tr("p2"), "Pa", 5, [](States s) { return s.shocked.pressure_Pa; });
    rows.state(ShockTables::tr("p5"), "Pa", 5, [](States s) { return s.reflected.pressure_Pa; });
    using Number = std::optional<double>;
    rows.numbers(ShockTables::tr("p4 (eq. 3.10)"), "Pa", 4, [](const ShockConditions &shot) {
        return shot.driver ? Number(shot.driver->pressure_Pa) : Number();
    });
    rows.state(ShockTables::tr("T1"), "K", 5, [](States s) { return s.driven.temperature_K; });
    rows.state(ShockTables::tr("T2"), "K", 5, [](States s) { return s.shocked.temperature_K; });
    rows.state(ShockTables::tr("T5"), "K", 5, [](States s) { return s.reflected.temperature_K; });
    rows.numbers(ShockTables::tr("T4"), "K", 5, [](const ShockConditions &shot) {
        return shot.driver ? Number(shot.driver->temperature_K) : Number();
    });
    rows.state(ShockTables::tr("Density ρ5"), "kg/m³", 4,
        [](States s) { return s.reflected.density_kg_m3; });
    rows.state(ShockTables::tr("Sound speed a1"), "m/s", 5,
        [](States s) { return s.driven.soundSpeed_m_s; });
    rows.state(ShockTables::tr("Sound speed a5"), "m/s", 5,
        [](States s) { return s.reflected.soundSpeed_m_s; });
    rows.state(ShockTables::tr("Gas velocity u2"), "m/s", 4,
        [](States s) { return s.shocked.velocity_m_s; });
    rows.state(ShockTables::tr("Reflected shock"), "m/s", 4,
        [](States s) { return s.reflectedVelocity_m_s; });
}

QString verdict(const SoundSpeedTest &test)
{
    if (test.followsGas)
        return ShockTables::tr("follows the gas: a mode of the tube");
    return test.excludesGas ? ShockTables::tr("stays: not a mode of the gas")
                            : ShockTables::tr("undecided");
}

} // namespace

ShownTable stateTable(const ShockConditionsSet &shock)
{
    ShownTable table{{ShockTables::tr("Quantity")}, {}};
    for (const ShockConditions &shot : shock.shots)
        table.headers << shotName(shot.shot);
    Rows rows(shock);
    rows.add(ShockTables::tr("Pressure step"), stepText);
    rows.state(ShockTables::tr("Velocity W"), "m/s", 6,
        [](const ShockStates &s) { return s.velocity_m_s; });
    rows.state(ShockTables::tr("Mach number"), {}, 5, [](const ShockStates &s) { return s.mach; });
    rows.add(ShockTables::tr("W along the tube"), gradientText);
    addStates(rows);
    rows.numbers(ShockTables::tr("Plateau lasts"), "s", 4,
        [](const ShockConditions &shot) { return shot.plateau_s; });
    rows.numbers(ShockTables::tr("Lowest frequency"), "Hz", 3, [](const ShockConditions &shot) {
        const bool known = shot.plateau_s && *shot.plateau_s > 0.0;
        return known ? std::optional(1.0 / *shot.plateau_s) : std::nullopt;
    });
    rows.numbers(ShockTables::tr("Arrival at the side"), "s", 5,
        [](const ShockConditions &shot) { return shot.arrival_s; });
    table.rows = rows.take();
    return table;
}

ShownTable measuredTable(const ShockConditionsSet &shock)
{
    ShownTable table{
        {ShockTables::tr("Shot"), ShockTables::tr("Pressure"), ShockTables::tr("Channel"),
            ShockTables::tr("Measured, absolute"), ShockTables::tr("Predicted"),
            ShockTables::tr("Deviation"), ShockTables::tr("Reads")},
        {}};
    std::vector<std::optional<double>> pressures_Pa;
    std::vector<std::optional<double>> deviations_percent;
    for (const ShockConditions &shot : shock.shots) {
        for (const MeasuredPressure &m : shot.measured) {
            table.rows.push_back({shotName(shot.shot), shownText(m.region), shownText(m.channel),
                m.wasGauge ? ShockTables::tr("gauge") : ShockTables::tr("absolute")});
            pressures_Pa.insert(pressures_Pa.end(), {m.measured_Pa, m.predicted_Pa});
            deviations_percent.push_back(100.0 * m.deviation());
        }
    }
    // Measured and predicted side by side, in one unit.
    const QStringList pressures = shownColumn(pressures_Pa, "Pa", 4);
    const QStringList deviations = shownColumn(deviations_percent, "%", 3);
    for (qsizetype row = 0; row < table.rows.size(); ++row) {
        QStringList &cells = table.rows[row];
        const QString reads = cells.takeLast();
        cells << pressures[2 * row] << pressures[2 * row + 1] << deviations[row] << reads;
    }
    return table;
}

ShownTable arrivalTable(const ShockConditionsSet &shock)
{
    ShownTable table{{ShockTables::tr("Shot"), ShockTables::tr("Place"),
                         ShockTables::tr("To the end wall"), ShockTables::tr("u (place)"),
                         ShockTables::tr("Arrival"), ShockTables::tr("u (arrival)"),
                         ShockTables::tr("u (delay)"), ShockTables::tr("Seen – fitted")},
        {}};
    std::vector<Estimate> places_m;
    std::vector<Estimate> arrivals_s;
    std::vector<std::optional<double>> delays_s;
    std::vector<std::optional<double>> residuals_s;
    const auto known = [](double u) { return u > 0.0 ? std::optional(u) : std::nullopt; };
    for (const ShockConditions &shot : shock.shots) {
        for (std::size_t i = 0; i < shot.sightings.size(); ++i) {
            const Sighting &s = shot.sightings[i];
            // Two places fix the velocity exactly: the residuals are then only rounding.
            const bool fitted = shot.velocityFit && shot.velocityFit->dof > 0
                && shot.velocityFit->residual.size() == std::ssize(shot.sightings);
            table.rows.push_back({shotName(shot.shot), shownText(s.channel)});
            places_m.push_back({s.distance_m, s.u_distance_m});
            arrivals_s.push_back({s.time_s, s.u_time_s});
            delays_s.push_back(known(s.u_delay_s));
            residuals_s.push_back(fitted
                    ? std::optional(shot.velocityFit->residual[static_cast<Index>(i)])
                    : std::nullopt);
        }
    }
    const std::vector<ShownResult> places = shownColumn(places_m, "m");
    const std::vector<ShownResult> arrivals = shownColumn(arrivals_s, "s");
    const QStringList delays = shownColumn(delays_s, "s", 2);
    const QStringList residuals = shownColumn(residuals_s, "s", 2);
    for (qsizetype row = 0; row < table.rows.size(); ++row) {
        const auto at = static_cast<std::size_t>(row);
        table.rows[row] << places[at].value << places[at].u << arrivals[at].value << arrivals[at].u
                        << delays[row] << residuals[row];
    }
    return table;
}

ShownTable uncertaintyTable(const ShockConditionsSet &shock, const StepMonteCarloSet *drawn)
{
    ShownTable table{
        {ShockTables::tr("Shot"), ShockTables::tr("Quantity"), ShockTables::tr("Value"),
            ShockTables::tr("u (propagation)"), ShockTables::tr("Relative"),
            ShockTables::tr("u (Monte Carlo)"), ShockTables::tr("Interval (Monte Carlo)")},
        {}};
    const std::pair<QString, QString> results[] = {{ShockTables::tr("Velocity W"), "m/s"},
        {ShockTables::tr("Mach number"), QString()}, {ShockTables::tr("p2"), "Pa"},
        {ShockTables::tr("p5"), "Pa"}, {ShockTables::tr("Pressure step"), "Pa"}};
    for (const ShockConditions &shot : shock.shots) {
        const ShotMonteCarlo *mc = drawn != nullptr ? drawn->ofShot(shot.shot) : nullptr;
        for (Index r = 0; shot.uncertainty && r < kStepResults; ++r) {
            const auto &[name, unit] = results[r];
            const double value = shot.uncertainty->budget.value[r];
            const auto u = shot.uncertainty->u(static_cast<StepResult>(r));
            const ShownResult shown = shownResult(value, u.value_or(kUnknown), unit);
            QStringList row{shotName(shot.shot), name, shown.value, shown.u,
                u ? percent(*u / value, 3) : kNone};
            if (mc != nullptr && mc->outcome) {
                const MonteCarloResult &result = mc->outcome->result;
                // To the place of its own u, like the value beside it.
                const auto shownDrawn
                    = shownColumn(std::vector<Estimate>{{value, result.u[r]},
                                      {result.low[r], result.u[r]}, {result.high[r], result.u[r]}},
                        unit);
                row << shownDrawn[0].u
                    << ShockTables::tr("%1 to %2").arg(shownDrawn[1].value, shownDrawn[2].value);
            } else {
                row << kNone << kNone;
            }
            table.rows.push_back(row);
        }
    }
    return table;
}

ShownTable followedPeakTable(const ShockConditionsSet &shock)
{
    ShownTable table{{ShockTables::tr("Peak"), ShockTables::tr("Slope of ln f on ln a5"),
                         ShockTables::tr("u (slope)"), ShockTables::tr("Verdict"),
                         ShockTables::tr("Nearest tube mode (computed)")},
        {}};
    for (const FollowedPeak &peak : shock.followedPeaks) {
        std::vector<double> frequencies_Hz;
        frequencies_Hz.reserve(peak.peaks.size());
        for (const PeakOfShot &p : peak.peaks)
            frequencies_Hz.push_back(p.frequency_Hz);
        const QStringList frequencies = shownColumn(frequencies_Hz, "Hz", 4);
        const ShownResult slope = shownResult(peak.test.slope, peak.test.u_slope, {});
        table.rows.push_back({frequencies.join(QStringLiteral(" / ")), slope.value, slope.u,
            verdict(peak.test), peak.candidate.empty() ? kNone : shownText(peak.candidate)});
    }
    return table;
}

} // namespace dyncal
