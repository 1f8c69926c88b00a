// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/program/program_call.h"

#include <QObject>

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

    /// Runs `arguments` with the registry added; `then` follows where it came to its end, else
    /// failed().
    void call(QStringList arguments, const Then &then);
    bool isBusy() const { return m_running > 0; }

signals:
    void busyChanged();
    void failed(const QString &sentence);

private:
    void finish(ProgramCall *call, const ProgramAnswer &answer, const Then &then);

    Preferences &m_preferences;
    QString m_program;
    QString m_address;
    int m_running = 0;
};

} // namespace dyncal
