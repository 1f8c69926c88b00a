// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/shock/shock_relations.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

enum class ResonanceKind {
    Body, ///< the tube's wall, lengthwise (eq 5.1)
    Cavity, ///< the gas of the whole tube before the burst (eq 5.2)
    CavityShocked, ///< the gas of the driven section behind the reflected shock
    CavityMixed, ///< the whole tube at the plateau's end: a5 and a3
    Transverse, ///< across the tube, in region 5: mode (m, n)
};

/// "tube-body", "cavity", "cavity-shocked", "cavity-mixed", "transverse".
const char *resonanceKindName(ResonanceKind kind);

/// A frequency at which the tube, not the sensor, may ring.
struct TubeResonance
{
    ResonanceKind kind = ResonanceKind::Body;
    int order = 1; ///< lengthwise modes; 0 for transverse ones
    int m = 0; ///< nodal diameters
    int n = 0; ///< nodal circles not counting the wall
    double frequency_Hz = 0.0;
    bool followsGas = true; ///< moves with the shot's sound speed
    std::string label() const; ///< "transverse (1,0)", "cavity 2"
};

/// Lengths and diameter, where known.
struct TubeDimensions
{
    std::optional<double> wholeLength_m;
    std::optional<double> drivenLength_m;
    std::optional<double> driverLength_m;
    std::optional<double> innerDiameter_m;
    double wallSoundSpeed_m_s = 5130.0;
};

/// Candidates of one shot, by frequency: three lengthwise modes of each kind and the
/// transverseZeros(). `driver` is region 4.
std::vector<TubeResonance> tubeResonances(const ShockStates &states,
    const std::optional<GasState> &driver, const Gas &driverGas, const TubeDimensions &dimensions);

/// Zero of J_m'(x), the derivative of the Bessel function, for transverse mode (m, n). There is no
/// (0,0).
struct BesselZero
{
    int m;
    int n;
    double zero;
};
const std::vector<BesselZero> &transverseZeros();

/// Frequency of one peak in one shot.
struct PeakOfShot
{
    double soundSpeed_m_s = 0.0; ///< a5 of that shot
    double frequency_Hz = 0.0;
    double u_frequency_Hz = 0.0;
};

/// Slope of ln f on ln a5: 1 for a mode of the gas, 0 for sensor and mount.
struct SoundSpeedTest
{
    double slope = 0.0;
    double u_slope = 0.0;
    bool followsGas = false; ///< agrees with 1 and excludes 0 within 2 u
    bool excludesGas = false; ///< agrees with 0 and excludes 1 within 2 u
};

/// Weighted regression; u from the stated u of the frequencies, or from their scatter where that is
/// larger. Empty on fewer than two shots, or sound speeds all the same.
std::optional<SoundSpeedTest> testSoundSpeed(const std::vector<PeakOfShot> &peaks);

/// Frequency at which the average of a swept diaphragm, |2 J1(x)/x| with x = pi f d/W, falls to
/// 1/sqrt(2): 0.514 W/d.
double sideWallLimit_Hz(double diameter_m, double velocity_m_s);

} // namespace dyncal
