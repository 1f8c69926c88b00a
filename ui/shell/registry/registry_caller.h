// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/program/program_call.h"

#include <QHash>
#include <QObject>
#include <QPointer>

#include <functional>

namespace dyncal {

class Preferences;

/// The address of a registry without the password of its server: passwords are not kept.
QString withoutPassword(const QString &address);

/// Commands of the program on the registry of the laboratory, one object for all that the window
/// of the registry shows. Nothing of a registry is read or changed but by these commands, so the
/// window and scripts do the same, and a server that does not answer holds nothing up.
class RegistryCaller : public QObject
{
    Q_OBJECT

public:
    using Then = std::function<void(const ProgramAnswer &)>;

    /// Begins with the registry that was used last.
    RegistryCaller(Preferences &preferences, QObject *parent);

    void setProgram(const QString &program) { m_program = program; }
    /// File or postgresql://...; empty: the registry of this user.
    const QString &address() const { return m_address; }
    /// Another registry from now on, remembered without its server's password; false if it is the
    /// same one.
    bool useAddress(const QString &typed);

    /// Runs `arguments` with the registry added, and with a secret where there is one (`--pin-fd 0`
    /// reads it); `then` follows where it came to its end, else failed().
    ProgramCall *call(QStringList arguments, const Then &then, SecretPipe secret = {});
    /// The same to show something: an answer that `reader` still waits for is given up, as it would
    /// be of an earlier moment, or of another registry. Where some of it could not be read, that
    /// is said and the rest shown.
    void read(const QObject &reader, const QStringList &arguments, const Then &then);
    bool isBusy() const { return m_running > 0; }

signals:
    void busyChanged();
    void failed(const QString &sentence);

private:
    void finish(ProgramCall *call, const ProgramAnswer &answer, const Then &then);
    bool isRead(ProgramCall *call) const { return m_reads.key(call) != nullptr; }

    Preferences &m_preferences;
    QString m_program;
    QString m_address;
    int m_running = 0;
    QHash<const QObject *, QPointer<ProgramCall>> m_reads; ///< the last one of each reader
};

} // namespace dyncal
