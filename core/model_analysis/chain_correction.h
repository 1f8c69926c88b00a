// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/model_analysis/response_source.h"
#include "core/reference/reference_sensitivity.h"

#include <memory>

namespace dyncal {

/// S(f) of another source without the response of amplifier and converter: S(f)/H(f), H relative to
/// the gain at low frequency (docs/method/response.md). Nothing where H is not stated; no phase
/// where H has none.
class ChainCorrected : public ResponseSource
{
public:
    /// `chain` must outlive this. `u_delay_s` joins the u of the phase's zero of time.
    ChainCorrected(std::unique_ptr<ResponseSource> source, const ReferenceSensitivity &chain,
        double u_delay_s = 0.0);

    ResponsePoint at(double frequency_Hz) const override;

private:
    std::unique_ptr<ResponseSource> m_source;
    const ReferenceSensitivity &m_chain;
    double m_u_delay_s;
};

/// What the chain's delay may do to the onset of a step, which is found in records that have it:
/// a model takes any part of it for a later onset, so anything between nothing and the largest
/// delay -arg H/w from `from_Hz` to `to_Hz`, a rectangle. 0 where the table has no phase.
double uOnsetBehind(const ReferenceSensitivity &chain, double from_Hz, double to_Hz);

/// The same division of what the model says: not a number where the chain's response is not stated.
void divideModel(const ReferenceSensitivity &chain, ResponseResult &result);

} // namespace dyncal
