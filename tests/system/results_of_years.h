// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

#include <QByteArray>

/// A year's calibration: what it differs in from an issued one.
struct Year
{
    int year = 0;
    double factor = 1.0; ///< of the sensitivity
    const char *serial = "17";
};

/// As a calibration of another year with other recordings would have left it.
inline QByteArray resultsOf(const QByteArray &issued, const Year &made)
{
    nlohmann::json root = nlohmann::json::parse(issued.toStdString());
    const std::string year = std::to_string(made.year);
    nlohmann::json &fields = root["recipe"]["certificate"]["fields"];
    fields["date_performed"] = year + "-03-01";
    fields["sensor_serial"] = made.serial;
    root["created_utc"] = year + "-03-02T08:00:00Z";
    root["inputs"][0]["sha256"] = std::string(60, 'a') + year;
    root["sensitivity"]["value"] = made.factor * root["sensitivity"]["value"].get<double>();
    return QByteArray::fromStdString(dyncal::jsonText(root));
}
