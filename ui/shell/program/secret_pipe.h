// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <utility>

class QLineEdit;

namespace dyncal {

/// A passphrase or PIN on its way from a field to a program: it lies in a pipe, from which it is
/// read once, and no longer in memory of the window. Moved, never copied.
class SecretPipe
{
public:
    /// Letters that a field may hold, so that the pipe takes it at once.
    static constexpr int kMostLetters = 1024;

    SecretPipe() = default; ///< none
    ~SecretPipe();
    SecretPipe(SecretPipe &&other) noexcept
        : m_readEnd(std::exchange(other.m_readEnd, kNone))
    {
    }
    SecretPipe &operator=(SecretPipe &&other) noexcept;

    /// Takes it, as UTF-8 and a line break, out of a field of at most kMostLetters, which is empty
    /// then and whose own text was overwritten. None where nothing was typed, or where the system
    /// gives no pipe.
    static SecretPipe takenFrom(QLineEdit &field);

    bool isGiven() const { return m_readEnd != kNone; }
    int readEnd() const { return m_readEnd; } ///< closed in programs that are started

private:
    static constexpr int kNone = -1;

    void close();

    int m_readEnd = kNone;
};

/// Empties a field and overwrites the text that it held.
void wipe(QLineEdit &field);

} // namespace dyncal
