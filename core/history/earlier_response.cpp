// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/earlier_response.h"

#include "core/dcc_reading/d_si_unit.h"
#include "core/history/control_chart.h"
#include "core/history/dcc_calibration.h"
#include "core/history/followed_value.h"
#include "core/results/results_reading.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

Result<EarlierResponse> earlierResponse(const EarlierCalibration &calibration)
{
    EarlierResponse response{.file = calibration.file,
        .serial = calibration.serial,
        .time = calibration.time,
        .unit = textAt(valueAt(calibration.results, "response"), "unit"),
        .certificate = calibration.dcc.number,
        .notAssigned = calibration.notAssigned};
    for (double f_Hz : numbersAt(valueAt(calibration.results, "response"), "frequency_hz")) {
        const FollowedValue row
            = followedValue(calibration.results, {FollowedKind::Magnitude, f_Hz, f_Hz});
        if (std::isfinite(row.value))
            response.rows.push_back({f_Hz, row.value, row.U()});
    }
    if (response.rows.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "%1 states no magnitude of a frequency response, so there is nothing to lay over; choose the results of a run that has one."),
                {calibration.file}, calibration.notAssigned});
    return response;
}

Result<EarlierResponse> readEarlierResponse(const std::string &path)
{
    if (isXmlFile(path))
        return readEarlierDcc(path).and_then(earlierResponse);
    Result<EarlierResults> read = readEarlierResults(path);
    if (!read)
        return tl::unexpected<Error>(read.error());
    return earlierCalibration(std::move(*read)).and_then(earlierResponse);
}

bool toUnit(EarlierResponse &response, const std::string &unit)
{
    const std::optional<double> ratio
        = response.unit == unit ? std::optional(1.0) : unitRatio(response.unit, unit);
    if (!ratio)
        return false;
    for (ResponseRow &row : response.rows) {
        row.magnitude *= *ratio;
        row.U *= *ratio;
    }
    response.unit = unit;
    return true;
}

ResponseAgreement agreementOf(
    const std::vector<ResponseRow> &present, const std::vector<ResponseRow> &earlier)
{
    ResponseAgreement agreement;
    for (const ResponseRow &row : present) {
        const auto other = std::ranges::find_if(earlier, [&](const ResponseRow &one) {
            return std::abs(one.frequency_Hz - row.frequency_Hz) <= kSameRow * row.frequency_Hz;
        });
        const double En = other == earlier.end()
            ? kUnknown
            : normalisedError(row.magnitude, row.U, other->magnitude, other->U);
        if (!std::isfinite(En))
            continue;
        ++agreement.compared;
        agreement.agreeing += std::abs(En) <= 1.0 ? 1 : 0;
        if (!(std::abs(agreement.largestEn) >= std::abs(En))) {
            agreement.largestEn = En;
            agreement.at_Hz = row.frequency_Hz;
        }
    }
    return agreement;
}

} // namespace dyncal
