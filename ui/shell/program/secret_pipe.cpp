// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/program/secret_pipe.h"

#include <QLineEdit>
#include <QStringEncoder>

#include <array>

#include <fcntl.h>
#include <string.h>
#include <unistd.h>

namespace dyncal {

namespace {

/// The bytes of a text that others may share: they are to be gone everywhere. A literal of the
/// program, which nobody typed, cannot be written to.
void overwrite(const QString &text)
{
    if (text.data_ptr().isMutable())
        ::explicit_bzero(const_cast<QChar *>(text.constData()),
            static_cast<std::size_t>(text.size()) * sizeof(QChar));
}

/// Writes UTF-8 of the text and a line break, and leaves no copy of them; false: not all.
bool writeLine(int descriptor, const QString &text)
{
    QStringEncoder encoder(QStringConverter::Utf8);
    QByteArray line(encoder.requiredSpace(text.size()) + 1, '\0');
    char *end = encoder.appendToBuffer(line.data(), text);
    *end++ = '\n';
    const ssize_t size = end - line.constData();
    const bool isWritten
        = ::write(descriptor, line.constData(), static_cast<std::size_t>(size)) == size;
    ::explicit_bzero(line.data(), static_cast<std::size_t>(line.size()));
    return isWritten;
}

} // namespace

SecretPipe::~SecretPipe()
{
    close();
}

SecretPipe &SecretPipe::operator=(SecretPipe &&other) noexcept
{
    close();
    m_readEnd = std::exchange(other.m_readEnd, kNone);
    return *this;
}

void SecretPipe::close()
{
    if (isGiven())
        ::close(std::exchange(m_readEnd, kNone));
}

SecretPipe SecretPipe::takenFrom(QLineEdit &field)
{
    SecretPipe pipe;
    std::array<int, 2> ends{kNone, kNone};
    if (field.text().isEmpty() || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
        wipe(field);
        return pipe;
    }
    pipe.m_readEnd = ends[0];
    const bool isWritten = writeLine(ends[1], field.text());
    ::close(ends[1]);
    wipe(field);
    return isWritten ? std::move(pipe) : SecretPipe();
}

void wipe(QLineEdit &field)
{
    overwrite(field.text()); // shares the field's own bytes
    field.setText({}); // which forgets what was typed, other than clear()
}

} // namespace dyncal
