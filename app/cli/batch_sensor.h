// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "app/base/child_jobs.h"
#include "core/base/kept_message.h"
#include "core/batch/batch_plan.h"

#include <string>

namespace dyncal {

/// What came of a sensor in its process.
struct SensorAnswer
{
    enum How {
        Computed,
        Kept, ///< it was complete
        Busy, ///< another program computes it now
        Stopped, ///< on request
        Failed,
    };
    How how = Failed;
    KeptMessage said = {}; ///< Failed: the reason; else what is to be said besides
};

/// Brings one sensor up to the plan, in a process of its own and on one thread: keeps what is
/// complete and of the planned inputs, sets damaged results aside, calibrates.
ChildAnswer computeSensor(const PlannedSensor &sensor, const std::string &planFolder);

/// What computeSensor() answered; Failed if it is nothing of the sort.
SensorAnswer parseAnswer(const std::string &answer);

} // namespace dyncal
