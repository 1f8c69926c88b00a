// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/stage_status.h"

#include <QIcon>

namespace dyncal {

/// Signs of the tool bar.
enum class ToolSign { OpenCaptures, OpenProject, Save, Export, Undo, Redo, Back, Forward, Compute };

/// Drawn as lines in the palette's colour of text at the moment of painting, sharp at every size.
QIcon toolIcon(ToolSign sign);

/// A shape for each status, in a colour of its own: they differ in grey print too.
QIcon statusIcon(StageStatus status);

} // namespace dyncal
