// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/terminal_text.h"

#include "core/base/foreign_text.h"

#include <ostream>

namespace dyncal {

TerminalText::TerminalText(std::ostream &stream)
    : m_stream(stream)
    , m_target(stream.rdbuf(this))
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
    const auto size = static_cast<std::streamsize>(shown.size());
    return m_target->sputn(shown.data(), size) == size;
}

} // namespace dyncal
