// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/batch_watch.h"

#include <QString>

namespace dyncal {

/// What a sensor of a batch is shown as: a state of its files, or that it is being computed.
enum class ShownState { Failed, Blocked, Cautions, Running, Missing, Done };
inline constexpr ShownState kShownStates[]{ShownState::Failed, ShownState::Blocked,
    ShownState::Cautions, ShownState::Running, ShownState::Missing, ShownState::Done};

ShownState shownState(const SensorNow &sensor);
QString stateWord(ShownState state);
/// With a shape before it: never colour alone.
QString stateText(ShownState state);

/// "7 sensors: 5 done, 1 with cautions, ..., 1 running"; what is running is not counted as missing
/// or failed.
QString batchTallyText(const BatchMoment &moment);

/// "value ± U" of a key result, with the digits of U; the value alone without one, "" without a
/// result.
QString keyResultText(const SensorOutcome &record, const char *quantity);

/// "■ CAP-003, shot 2"; with the number of further findings that somebody must see.
QString worstFindingText(const SensorOutcome &record);

/// Why there are no results, in the window's language.
QString reasonText(const SensorOutcome &record);

/// Everything the record says, for a tool tip: reason, key results with k, ids of findings.
QString recordText(const SensorNow &sensor);

} // namespace dyncal
