// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/base/propagation.h"
#include "core/base/result.h"
#include "core/shock/gas_model.h"
#include "core/shock/shock_settings.h"
#include "core/shock/shock_velocity.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// The input that stands for the range of the attenuation (shock.attenuation_per_m).
inline constexpr const char *kAttenuation = "attenuation_per_m";

/// An uncertainty that the operator states (recipe section "uncertainty", key "budget").
struct StatedUncertainty
{
    std::string
        quantity; ///< "p1_pa", "t1_k", "gamma", "molar_mass_kg_mol", "relative_humidity", ...
    double u = 0.0;
    Distribution distribution = Distribution::Normal;
    std::optional<double> dof;
    Correlations correlated = {}; ///< with other stated ones
};

// Where nothing is stated: to compare with other ways (Unstated::IsAssumed); docs/method/checks.md.
inline constexpr double kAssumedRelative_p1 = 0.005;
inline constexpr double kAssumed_u_T1_K = 1.0;
inline constexpr double kAssumed_u_distance_m = 0.001;
inline constexpr double kAssumedRelativeVelocity = 0.002;
inline constexpr double kAssumedRelativeStep = 0.005; ///< of a typed step
inline constexpr double kAssumedRelativeRise = 0.02; ///< of a typed p2, of p2 - p1
inline constexpr double kAssumedRelativeDriver = 0.1; ///< of p4: losses, opening of the diaphragm

/// Everything that the step of one shot follows from.
struct StepMeasurement
{
    GasSettings gas; ///< driven
    SectionState state; ///< p1, T1 and what humid air needs
    VelocityEstimate velocity; ///< as used: typed, of counters, or of the arrivals
    std::vector<CounterReading> counters; ///< where the velocity comes from them
    bool atEndWall = true;
    double u_p1_Pa = 0.0; ///< as recorded; not above 0 = not stated
    double u_T1_K = 0.0;
    double u_relativeHumidity = 0.0; ///< where the budget states none
    Distribution humidityDistribution = Distribution::Normal;
    /// What the arrivals give where the velocity used is typed or of counters.
    std::optional<VelocityEstimate> recorded = std::nullopt;
    std::optional<double> typedStep_Pa = std::nullopt; ///< used in place of the computed one
    /// Of a velocity that is typed or follows from a pressure, where nothing is stated.
    double uAssumedVelocity_relative = kAssumedRelativeVelocity;

    /// The estimate made of arrivals, used or not; null where there is none.
    const VelocityEstimate *arrivals() const;
};

/// Values of all inputs of one shot's step.
struct StepPoint
{
    SectionState state;
    double gammaShift = 0.0;
    double molarMassShift_kg_mol = 0.0;
    double velocityShift_m_s = 0.0; ///< of the velocity used
    double stepFactor = 1.0;
    Eigen::VectorXd distance_m; ///< of the arrivals' sightings
    Eigen::VectorXd time_s;
    Eigen::VectorXd delay_s; ///< beyond what is taken off already
    std::vector<CounterReading> counters;
    double attenuation_per_m = 0.0; ///< as observed beforehand
};

/// What serves where an input has no stated uncertainty.
enum class Unstated {
    IsMissing, ///< nothing: the uncertainty of the result is not known
    IsAssumed, ///< kAssumed...: to compare with other ways, not to state a result
};

/// The inputs of a shot's step with their uncertainties, each with the function that puts its value
/// into a StepPoint. `m` and `stated` must outlive it.
class StepInputs
{
public:
    StepInputs(const StepMeasurement &m, const std::vector<StatedUncertainty> &stated,
        Unstated unstated = Unstated::IsMissing);

    const std::vector<UncertainInput> &inputs() const { return m_inputs; }
    const std::optional<Message> &velocityMissing() const { return m_velocityMissing; }
    const std::optional<Message> &stateMissing() const { return m_stateMissing; }
    const std::optional<Message> &stepMissing() const { return m_stepMissing; }

    /// `x`: a value for each of inputs(); what follows them is not looked at.
    StepPoint at(const Eigen::VectorXd &x) const;

private:
    using Setter = std::function<void(StepPoint &, double)>;

    StepPoint start() const;
    const StatedUncertainty *find(const std::string &quantity) const;
    double otherwise(double assumed) const; ///< what serves where nothing is stated
    void add(UncertainInput input, Setter setter);
    bool addKnown(const std::string &name, const std::string &quantity, double value, double known,
        Distribution distribution, bool common, Setter setter);
    void addVelocity();
    void addTypedVelocity(double velocity_m_s);
    void addFit(const VelocityEstimate &estimate, bool ofCounters);
    void addSightings(const std::vector<Sighting> &sightings);
    void addCounters();
    void need(bool known, const char *what, const char *quantity);
    void addState();
    void addHumidity();
    void addGas();
    void addStep();

    const StepMeasurement &m_measurement;
    const std::vector<StatedUncertainty> &m_stated;
    Unstated m_unstated;
    std::vector<UncertainInput> m_inputs;
    std::vector<Setter> m_setters;
    std::optional<Message> m_velocityMissing;
    std::optional<Message> m_stateMissing;
    std::optional<Message> m_stepMissing;
};

/// The velocity used at that point, m/s.
double velocityAt(const StepMeasurement &m, const StepPoint &point);

/// What the arrivals give at that point (used or not); there must be arrivals().
RefittedWay recordedWayAt(const StepMeasurement &m, const StepPoint &point);

/// The driven gas at that point. Fails as gasModel().
Result<GasModel> gasAt(const StepMeasurement &m, const StepPoint &point);

/// All states at that point with another velocity. Fails as shockStatesOf().
Result<ShockStates> statesAt(const StepMeasurement &m, const StepPoint &point, double velocity_m_s);

/// p5 - p1 or p2 - p1 of the DUT's place.
double computedStep_Pa(const StepMeasurement &m, const ShockStates &states);

/// The step used: typed or computed, times the point's factor.
double stepAt(const StepMeasurement &m, const StepPoint &point, const ShockStates &states);

/// u of a step that is typed without any velocity; the other results have none. Empty where no
/// `step_relative` is stated.
std::optional<GumBudget> budgetOfTypedStep(
    double step_Pa, const std::vector<StatedUncertainty> &stated, Index results, Index ofStep);

} // namespace dyncal
