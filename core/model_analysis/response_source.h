// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <limits>

namespace dyncal {

/// S at one frequency, mean over the shots, as the records have it.
struct ResponsePoint
{
    double magnitude = 0.0; ///< NaN where it is not known
    double phase_rad = 0.0; ///< in -pi .. pi
    double u_magnitude = 0.0; ///< from the noise
    double u_phase_rad = 0.0; ///< from the noise and the zero of time
    double dof = std::numeric_limits<double>::infinity(); ///< of u, for it rests on a record
    double boundEnd = 0.0; ///< of the error by the end of the records
    double boundAlias = 0.0; ///< of that by sampling, if nothing is stronger above half the rate
    double length_s = 0.0; ///< used behind the detected start, of a shot at most its window
    double u_front = 0.0; ///< of the magnitude, from that of the front's duration
    double u_reference = 0.0; ///< of the magnitude, from a reference transducer's sensitivity
    double u_referencePhase_rad = 0.0;
    double dofReference = std::numeric_limits<double>::infinity();

    double u_chain = 0.0; ///< of the magnitude, from that of the chain's response
    double u_chainPhase_rad = 0.0;
    double dofChain = std::numeric_limits<double>::infinity();

    bool isCalibrated = true; ///< false where a reference transducer was not
    bool isChainKnown = true; ///< false where the chain's response is not stated

    double bound() const { return boundEnd + boundAlias; }
};

/// Where the values of S(f) come from: the pressure step, or a reference transducer.
class ResponseSource
{
public:
    virtual ~ResponseSource() = default;

    /// 0 < frequency_Hz <= 0.4 of every shot's rate.
    virtual ResponsePoint at(double frequency_Hz) const = 0;
};

} // namespace dyncal
