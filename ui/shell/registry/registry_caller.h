// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/program/program_call.h"

#include <QObject>

#include <functional>

namespace dyncal {

/// Commands of the program on the registry of the laboratory, one object for all that the window
/// of the registry shows. Nothing of a registry is read or changed but by these commands, so the
/// window and scripts do the same, and a server that does not answer holds nothing up.
class RegistryCaller : public QObject
{
    Q_OBJECT

public:
    using Then = std::function<void(const ProgramAnswer &)>;

    explicit RegistryCaller(QObject *parent);

    void setProgram(const QString &program) { m_program = program; }
    /// File or postgresql://...; empty: the registry of this user.
    void setAddress(const QString &address) { m_address = address; }
    const QString &address() const { return m_address; }

    /// Runs `arguments` with the registry added; `then` follows where it came to its end, else
    /// failed().
    void call(QStringList arguments, const Then &then);
    bool isBusy() const { return m_running > 0; }
    void stop(); ///< all that runs

signals:
    void busyChanged();
    void failed(const QString &sentence);

private:
    void finish(ProgramCall *call, const ProgramAnswer &answer, const Then &then);

    QString m_program;
    QString m_address;
    int m_running = 0;
};

} // namespace dyncal
