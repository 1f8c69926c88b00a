// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// Why a stage produced no result. The kinds map one to one to the exit codes of the command line.
enum class ErrorKind {
    FileUnreadable, ///< a file cannot be read, or is none of ours (exit 3)
    Usage, ///< the caller asked for something that does not exist (exit 4)
    DataBlocked, ///< the data do not allow a trustworthy result (exit 2)
    Cancelled, ///< stopped on request; nobody needs to be told
    Internal, ///< a bug or a lack of memory (exit 5)
};

/// A stage could not produce a result. The sentence says what, where, found, needed, what to do.
struct Error
{
    ErrorKind kind = ErrorKind::Internal;
    Message message;
    std::string findingId; ///< id of the catalogue entry this error stands for, or empty
    Index shot = 0; ///< number of the shot concerned, from 1; 0 = none in particular
    std::vector<Error> further = {}; ///< other reasons of the same stage: all are told at once
};

/// Several reasons as one error: the first, with the others behind it. `errors` is not empty.
Error asOneError(std::vector<Error> errors);

template <typename T>
using Result = tl::expected<T, Error>;

/// Short form for `return fail(ErrorKind::Usage, {DYNCAL_TEXT("..."), {...}});`
inline tl::unexpected<Error> fail(
    ErrorKind kind, Message message, std::string findingId = {}, Index shot = 0)
{
    return tl::unexpected<Error>(Error{kind, std::move(message), std::move(findingId), shot});
}

} // namespace dyncal
