// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/registry_caller.h"

#include <QCoreApplication>

namespace dyncal {

RegistryCaller::RegistryCaller(QObject *parent)
    : QObject(parent)
    , m_program(QCoreApplication::applicationFilePath())
{
}

void RegistryCaller::call(QStringList arguments, const Then &then)
{
    if (!m_address.isEmpty())
        arguments << QStringLiteral("--registry") << m_address;
    auto *call = new ProgramCall(m_program, this);
    connect(call, &ProgramCall::ended, this,
        [this, call, then](const ProgramAnswer &answer) { finish(call, answer, then); });
    ++m_running;
    emit busyChanged();
    call->start(arguments);
}

void RegistryCaller::finish(ProgramCall *call, const ProgramAnswer &answer, const Then &then)
{
    call->deleteLater();
    --m_running;
    emit busyChanged();
    if (const QString problem = problemOf(answer); !problem.isEmpty())
        emit failed(problem);
    else if (!answer.isStopped)
        then(answer);
}

void RegistryCaller::stop()
{
    for (ProgramCall *call : findChildren<ProgramCall *>())
        call->stop();
}

} // namespace dyncal
