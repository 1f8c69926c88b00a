// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <optional>
#include <string>

class QPDFObjectHandle;

namespace dyncal {

/// What the streams of one file may unpack to, together.
class UnpackingBudget
{
public:
    explicit UnpackingBudget(std::size_t bytes)
        : m_left(bytes)
    {
    }

    /// Bytes of a stream that has no filter, or one of deflate without predictor: a chain of
    /// filters may take for ever to unpack to nothing. Empty where it has others, is damaged, or
    /// would exceed what is left.
    std::optional<std::string> unpack(QPDFObjectHandle &stream);

private:
    std::size_t m_left;
};

/// MD5, 16 bytes, which /CheckSum of an embedded file is by ISO 32000-1, 7.11.4: against damage,
/// not against forgers.
std::string md5Of(const std::string &bytes);

} // namespace dyncal
