// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <QString>

#include <functional>

namespace dyncal {

/// The sentence as core wrote it, in full unless `length` says otherwise, with its text and those
/// of the sentences below as `translate` has them: for documents, whose language is not the
/// window's. With the decimal mark
/// ',' numbers have it: in a place %L1 every number, its digits in groups of three behind narrow
/// no-break spaces where more than four stand together; in a place %1 of a sentence what is wholly
/// numbers and units (inDecimalMark()). What stands in %V1, or is the whole text "%1", is foreign
/// and stays.
QString filledWords(const Message &message,
    const std::function<QString(const char *text)> &translate, QChar decimalMark,
    ArgumentText length = ArgumentText::Full);

/// Whether the place of an argument (from 0) in `text` says that it is foreign: %V1.
bool isVerbatimPlace(const char *text, std::size_t argument);

} // namespace dyncal
