// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <QString>

namespace dyncal {

/// The sentence in the language of the program, places filled in.
QString translated(const Message &message, ArgumentText shown = ArgumentText::Brief);

} // namespace dyncal
