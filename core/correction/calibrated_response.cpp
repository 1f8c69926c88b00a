// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/calibrated_response.h"

#include "core/correction/results_model.h"
#include "core/correction/results_rows.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Json = nlohmann::json;

Result<void> checkKind(const Json &root)
{
    const std::string unit = textAt(valueAt(root, "response"), "unit");
    if (!unit.ends_with("/Pa") || !std::isfinite(numberAt(valueAt(root, "sensitivity"), "value")))
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The response of these results has the unit \"%1\" and not one per Pa, so it gives no pressure; calibrate with a known pressure step (response.reference)."),
                {unit}});
    const std::string treatment = textAt(valueAt(root, "input"), "treatment");
    if (treatment == "step-deflated" || treatment == "differenced")
        return {};
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "These results were made with input.treatment \"%1\", whose model is not the sensor's response to pressure; calibrate with \"step-deflated\"."),
            {treatment}});
}

std::vector<std::string> cautionsOf(const Json &findings)
{
    std::vector<std::string> ids;
    for (std::size_t i = 0; findings.is_array() && i < findings.size(); ++i)
        if (textAt(findings[i], "severity") == "caution")
            ids.push_back(textAt(findings[i], "id"));
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

KnownResponse withKnots(const MeasuredRows &rows, double sensitivity)
{
    KnownResponse response;
    response.knot_Hz.resize(rows.frequency_Hz.size() + 1);
    response.knot_Hz << 0.0, rows.frequency_Hz;
    response.atKnots.resize(response.knot_Hz.size());
    response.atKnots << std::complex<double>(sensitivity), rows.S;
    return response;
}

void append(std::vector<ResponseError> &errors, const std::vector<ResponseError> &more)
{
    errors.insert(errors.end(), more.begin(), more.end());
}

/// Rows, shape and the errors of both.
Result<KnownResponse> knownResponse(const Json &root, double fLow_Hz)
{
    const Json &model = valueAt(root, "model");
    const double sensitivity = numberAt(valueAt(root, "sensitivity"), "value");
    const Result<MeasuredRows> rows = measuredRows(valueAt(root, "response"));
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    KnownResponse response = withKnots(*rows, sensitivity);
    const Result<PoleShape> shape = shapeOf(model, fLow_Hz);
    if (!shape)
        return tl::unexpected<Error>(shape.error());
    response.shape = *shape;
    const auto ofRows = rowErrors(valueAt(root, "budget"), *rows, sensitivity);
    const auto ofPoles = poleErrors(model, *shape, response.knot_Hz.size());
    if (!ofRows || !ofPoles)
        return tl::unexpected<Error>(ofRows ? ofPoles.error() : ofRows.error());
    response.u_alone = uOfKnotsAlone(*ofRows, response.knot_Hz.size());
    append(response.errors, *ofRows);
    append(response.errors, *ofPoles);
    response.validTo_Hz = std::max(rows->frequency_Hz.tail(1)[0], 0.5 / numberAt(model, "dt_s"));
    response.unit = textAt(valueAt(root, "response"), "unit");
    return response;
}

} // namespace

Result<CalibratedResponse> calibratedResponse(const std::string &text, const std::string &name)
{
    const Result<Json> root = parseResults(text, name);
    if (!root)
        return tl::unexpected<Error>(root.error());
    const double fLow_Hz = numberAt(valueAt(*root, "response"), "f_low_hz");
    return checkKind(*root)
        .and_then([&] { return knownResponse(*root, fLow_Hz); })
        .map([&](KnownResponse response) {
            return CalibratedResponse{std::move(response), fLow_Hz,
                cautionsOf(valueAt(*root, "findings")), textAt(*root, "created_utc")};
        });
}

} // namespace dyncal
