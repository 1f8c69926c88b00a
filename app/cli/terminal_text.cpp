// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/terminal_text.h"

#include "core/base/foreign_text.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <string_view>

namespace dyncal {

TerminalText::TerminalText(std::ostream &stream, bool (*isStopped)())
    : m_stream(stream)
    , m_target(stream.rdbuf(this))
    , m_descriptor(&stream == &std::cout ? STDOUT_FILENO : STDERR_FILENO)
    , m_isStopped(isStopped)
{
}

TerminalText::~TerminalText()
{
    pass();
    m_stream.rdbuf(m_target);
}

TerminalText::int_type TerminalText::overflow(int_type byte)
{
    if (traits_type::eq_int_type(byte, traits_type::eof()))
        return traits_type::not_eof(byte);
    m_line += traits_type::to_char_type(byte);
    if (m_line.back() == '\n' && !pass())
        return traits_type::eof();
    return byte;
}

int TerminalText::sync()
{
    return pass() && m_target->pubsync() == 0 ? 0 : -1;
}

bool TerminalText::pass()
{
    const std::string shown = presentable(m_line, LineBreaks::Keep);
    m_line.clear();
    constexpr std::size_t kAtOnce = 4096; // a writable pipe takes this much without waiting
    for (std::string_view rest = shown; !rest.empty();) {
        if (!isWritable())
            return false;
        const ssize_t written = ::write(m_descriptor, rest.data(), std::min(rest.size(), kAtOnce));
        if (written < 0 && errno != EINTR && errno != EAGAIN)
            return false;
        rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return true;
}

/// A write into a full pipe would not return before somebody reads.
bool TerminalText::isWritable() const
{
    constexpr int kLook_ms = 50;
    for (;;) {
        pollfd wait{m_descriptor, POLLOUT, 0};
        if (::poll(&wait, 1, kLook_ms) > 0)
            return true; // or an error, which the write will report
        if (m_isStopped != nullptr && m_isStopped())
            return false;
    }
}

} // namespace dyncal
