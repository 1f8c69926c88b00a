// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/record_response.h"
#include "core/model_analysis/response_source.h"
#include "core/reference/reference_records.h"

#include <vector>

namespace dyncal {

/// S(f) = S_ref(f) Y_dut(f) / Y_ref(f), mean over the shots: comparison with a reference transducer
/// that the same step reached (docs/method/comparison.md). Neither the onset nor the front nor the
/// pressure matters, for both records have them.
class TransducerResponse : public ResponseSource
{
public:
    /// `duts` as for RecordResponse, scaled to physical values; every one has a record of the
    /// reference of its shot. `reference` must outlive this.
    TransducerResponse(
        const std::vector<RecordOfShot> &duts, double span_s, const ReferenceRecords &reference);

    /// Not calibrated, magnitude NaN, where the reference was not calibrated; phase NaN where its
    /// phase was not.
    ResponsePoint at(double frequency_Hz) const override;

private:
    ShotPoint ratioOf(std::size_t shot, double length_s, double frequency_Hz) const;

    const ReferenceRecords &m_reference;
    double m_u_delay_s = 0.0;
    std::size_t m_shots;
    RecordResponse m_dut;
    RecordResponse m_ref;
};

/// u of the delay between the two where nobody stated one: anything within +-0.5 us, a front that
/// is tilted by half a degree over 30 mm between them.
double uDelay_s(const ReferenceRecords &reference);

} // namespace dyncal
