// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <iosfwd>
#include <streambuf>
#include <string>

namespace dyncal {

/// While it lives, nothing that goes to one of the standard streams acts on a terminal: control
/// characters and bytes that are not UTF-8 are made visible instead (core/base/foreign_text.h).
/// This is the last safeguard; only the code that prints knows what must stay on one line.
class TerminalText : private std::streambuf
{
public:
    /// For std::cout or std::cerr. If nobody reads the output, a write waits until `isStopped`
    /// (without one: for ever) says that the program is to end; then the stream fails.
    TerminalText(std::ostream &stream, bool (*isStopped)());
    ~TerminalText() override;
    TerminalText(const TerminalText &) = delete;
    TerminalText &operator=(const TerminalText &) = delete;

private:
    int_type overflow(int_type byte) override;
    int sync() override;
    bool pass();
    bool isWritable() const;

    std::ostream &m_stream;
    std::streambuf *m_target;
    int m_descriptor;
    bool (*m_isStopped)();
    std::string m_line;
};

} // namespace dyncal
