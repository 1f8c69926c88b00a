// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {

// Names that reader and writer of the capture layout share (docs/method/captures.md).

constexpr const char *kCaptureFormatName = "dyncal-capture";
constexpr int kCaptureMajorVersion = 1;
constexpr int kCaptureMinorVersion = 0;
constexpr std::string_view kSensorFolder = "/setup/sensors/";

/// One attribute of /shots/NNN/environment.
struct EnvironmentEntry
{
    const char *name;
    double Environment::*value;
};

inline constexpr std::array<EnvironmentEntry, 9> kEnvironmentEntries{
    {{"p1_Pa", &Environment::p1_Pa}, {"u_p1_Pa", &Environment::u_p1_Pa},
        {"T1_K", &Environment::T1_K}, {"u_T1_K", &Environment::u_T1_K},
        {"p4_Pa", &Environment::p4_Pa}, {"T4_K", &Environment::T4_K},
        {"ambient_pressure_Pa", &Environment::ambientPressure_Pa},
        {"ambient_T_K", &Environment::ambientT_K},
        {"relative_humidity", &Environment::relativeHumidity}}};

/// Attributes of a shot that have a place of their own in Shot; all others are its notes.
inline bool isLayoutShotAttribute(std::string_view name)
{
    static constexpr std::array<std::string_view, 6> kNames{
        "label", "level", "valid", "reject_reason", "imported_from", "import_sha256"};
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

} // namespace dyncal
