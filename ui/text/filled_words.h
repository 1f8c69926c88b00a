// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <QString>

#include <functional>

namespace dyncal {

/// The sentence as core wrote it, in full, with its text and those of the sentences below as
/// `translate` has them: for documents, whose language is not the window's.
QString filledWords(
    const Message &message, const std::function<QString(const char *text)> &translate);

} // namespace dyncal
