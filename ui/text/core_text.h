// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <QString>

namespace dyncal {

/// The sentence in the language of the window, places filled in: numbers with its decimal mark,
/// keys of the recipe by the names of their fields.
QString translated(const Message &message);

/// The same for a document, in the language that is installed for it, numbers with the decimal mark
/// of the default locale (filledWords()): keys of the recipe as core wrote them, everything in
/// full.
QString printed(const Message &message);

} // namespace dyncal
