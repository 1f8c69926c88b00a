// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/dcc_calibration.h"

#include "core/base/calendar_date.h"
#include "core/dcc_reading/certified_sensor.h"
#include "core/xml/xml_file.h"

#include <cmath>
#include <fstream>

namespace dyncal {
namespace {

using Json = nlohmann::json;

Json numberOrNull(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

Json listOf(const std::vector<double> &values)
{
    Json list = Json::array();
    for (const double value : values)
        list.push_back(numberOrNull(value));
    return list;
}

Json responseJson(const CertifiedResponse &response)
{
    Json json{{"unit", response.magnitude.unit.symbol()},
        {"frequency_hz", listOf(response.frequency_Hz)},
        {"magnitude", listOf(response.magnitude.values)},
        {"u_magnitude", listOf(response.magnitude.u)},
        {"k_magnitude", listOf(response.magnitude.k)}, {"u_contains_step", true}};
    if (!response.phase_rad)
        return json;
    json["phase_rad"] = listOf(response.phase_rad->values);
    json["u_phase_rad"] = listOf(response.phase_rad->u);
    json["k_phase"] = listOf(response.phase_rad->k);
    return json;
}

Json valueJson(const CertifiedValue &value)
{
    return {{"value", value.value}, {"u", numberOrNull(value.u)}, {"k", numberOrNull(value.k)},
        {"unit", value.unit}};
}

Json resultsOf(const CertifiedSensor &sensor)
{
    Json results{{"characteristics", Json::array()}};
    if (sensor.response)
        results["response"] = responseJson(*sensor.response);
    if (sensor.sensitivity)
        results["sensitivity"] = valueJson(*sensor.sensitivity);
    const auto add = [&](const char *name, const std::optional<CertifiedValue> &value) {
        if (!value)
            return;
        Json json = valueJson(*value);
        json["quantity"] = name;
        results["characteristics"].push_back(std::move(json));
    };
    add("f0_hz", sensor.naturalFrequency);
    add("damping_ratio", sensor.dampingRatio);
    return results;
}

/// The last day of the calibration, else the day of the issue.
std::string dayOf(const DccContents &contents)
{
    for (const std::string &day : {contents.ended, contents.begun, contents.issued})
        if (isCalendarDate(day))
            return day;
    return {};
}

tl::unexpected<Error> noDay(const std::string &file)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 does not say when the calibration was: its certificate has no day (endPerformanceDate) such as 2026-01-31; ask its laboratory."),
            {file}});
}

} // namespace

bool isXmlFile(const std::string &path)
{
    std::ifstream stream(path, std::ios::binary);
    std::string begin(64, '\0');
    stream.read(begin.data(), std::ssize(begin));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    // Behind blanks, and the marks and zeros of Unicode's encodings.
    const std::size_t first
        = begin.find_first_not_of(std::string(" \t\r\n\xEF\xBB\xBF\xFF\xFE\0", 10));
    return first != begin.npos && begin[first] == '<';
}

Result<EarlierCalibration> earlierCalibrationOfDcc(
    const std::string &file, const std::string &bytes)
{
    const Result<DccContents> contents = readDcc(bytes);
    if (!contents)
        return tl::unexpected<Error>(contents.error());
    const std::string day = dayOf(*contents);
    const auto since1970 = daysSince1970(day);
    if (!since1970)
        return noDay(file);
    const CertifiedSensor sensor = certifiedSensor(*contents);
    EarlierCalibration calibration;
    calibration.file = file;
    calibration.serial = sensor.serial;
    calibration.time = day;
    calibration.day = *since1970;
    calibration.isDayOfCalibration = true;
    calibration.results = resultsOf(sensor);
    calibration.recordings = sensor.recordings;
    calibration.dcc = {contents->number, contents->laboratory, contents->version};
    calibration.whyNoSerial = english(sensor.whyNoSerial);
    calibration.notAssigned = sensor.leftOut;
    return calibration;
}

Result<EarlierCalibration> readEarlierDcc(const std::string &path)
{
    const Result<std::string> bytes = xmlFileBytes(path);
    if (!bytes)
        return tl::unexpected<Error>(bytes.error());
    return earlierCalibrationOfDcc(path, *bytes);
}

} // namespace dyncal
