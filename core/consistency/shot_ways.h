// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/propagation.h"
#include "core/base/result.h"
#include "core/consistency/shot_evidence.h"
#include "core/consistency/way_comparison.h"
#include "core/shock/step_inputs.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The inputs of all ways of one shot.
struct CheckPoint
{
    StepPoint step;
    Eigen::VectorXd back_s; ///< per reading: when the reflected shock passes
    Eigen::VectorXd gain; ///< per reading: factor of its pressures
    Eigen::VectorXd stepRatio; ///< per reading: factor of its ratio of steps
    double timeFactor = 1.0; ///< of all times of the records
    double velocityRatio = 1.0;
    double p4 = 1.0;
    double level = 1.0; ///< factor of the DUT's level
    double card = 1.0;
};

/// All ways to the quantities of one shot, over common inputs, so that errors which two ways share
/// cancel in their difference. `evidence` and `stated` must outlive it; it is not copied.
class ShotWays
{
public:
    ShotWays(const ShotEvidence &evidence, const std::vector<StatedUncertainty> &stated);
    ShotWays(const ShotWays &) = delete;
    ShotWays &operator=(const ShotWays &) = delete;

    const ShotEvidence &evidence() const { return m_evidence; }
    const std::vector<UncertainInput> &inputs() const { return m_inputs; }
    /// Those that can be compared first, then those that cannot, with the reason; without u.
    const std::vector<WayComparison> &made() const { return m_made; }
    const std::vector<WayComparison> &missing() const { return m_missing; }

    CheckPoint at(const Eigen::VectorXd &x) const;
    CheckPoint nominal() const;

    /// value_a, value_b of each of made(), one after the other. Fails where the gas or the states
    /// cannot be computed there; NaN where one way has no value.
    Result<Eigen::VectorXd> values(const CheckPoint &point) const;

private:
    struct Derived;
    using Values = std::function<std::pair<double, double>(const CheckPoint &, const Derived &)>;
    using Setter = std::function<void(CheckPoint &, double)>;

    void addInput(UncertainInput input, Setter setter);
    void addModel(const std::string &name, double uCommon, double uOwn, const Setter &times);
    void compare(WayComparison head, Values values);
    void cannot(WayComparison head, Message reason);
    void addInputs(const std::vector<StatedUncertainty> &stated);
    void addReadingInputs();
    void addWays();
    void addVelocity();
    void addArrivals();
    void addReading(Index i);
    void addStepRatio(Index i, const WayComparison &head);
    void addVelocityRatio(Index i, const WayComparison &head);
    void addPressures(Index i);
    void addDriver();
    void addStep();
    void addSensitivity();
    Derived derivedAt(CheckPoint &point) const;

    const ShotEvidence &m_evidence;
    std::unique_ptr<StepInputs> m_stepInputs; ///< null without a measurement
    std::vector<UncertainInput> m_inputs;
    std::vector<Setter> m_setters; ///< of the inputs behind those of the step
    std::vector<WayComparison> m_made;
    std::vector<WayComparison> m_missing;
    std::vector<Values> m_values;
    Index m_dut = -1; ///< reading of the DUT in the end wall
};

} // namespace dyncal
