// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/awaited_bytes.h"

#include <stop_token>
#include <string>
#include <vector>

namespace dyncal {

/// A command line as program and arguments, without a shell: words are divided by blanks, '...' and
/// "..." keep blanks, and nothing else has a meaning. Fails (Usage) where it is empty, a quote is
/// open or a byte is 0.
Result<std::vector<std::string>> wordsOfCommand(const std::string &command);

/// A seal by somebody else's service, "hash out, CMS in" (docs/signatures.md): the command gets the
/// SHA-256 of what is to be signed, 64 hexadecimal digits and a line break, on its standard input,
/// and writes a detached CMS (DER) over it to its standard output. The content stays here. Fails
/// (FileUnreadable) where it cannot be started, ends with another exit code than 0, answers
/// nothing, too late or too much; (DataBlocked) where the answer is no signature over this hash;
/// (Cancelled) on request, and the command is ended then.
Result<std::string> sealedBy(const std::string &command, const std::string &sha256,
    const std::stop_token &stop, const AnswerLimits &limits = {});

} // namespace dyncal
