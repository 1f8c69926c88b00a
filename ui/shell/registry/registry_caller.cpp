// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/registry_caller.h"

#include "ui/shell/preferences/preferences.h"

#include <QCoreApplication>
#include <QUrl>

namespace dyncal {

QString withoutPassword(const QString &address)
{
    if (!address.contains(QLatin1String("://")))
        return address;
    QUrl url(address);
    url.setPassword({});
    return url.toString();
}

RegistryCaller::RegistryCaller(Preferences &preferences, QObject *parent)
    : QObject(parent)
    , m_preferences(preferences)
    , m_program(QCoreApplication::applicationFilePath())
    , m_address(preferences.issuing(Preferences::Issuing::Registry))
{
}

bool RegistryCaller::useAddress(const QString &typed)
{
    const QString address = typed.trimmed();
    if (address == m_address)
        return false;
    m_address = address;
    m_preferences.setIssuing(Preferences::Issuing::Registry, withoutPassword(address));
    return true;
}

ProgramCall *RegistryCaller::call(QStringList arguments, const Then &then, SecretPipe secret)
{
    if (!m_address.isEmpty())
        arguments << QStringLiteral("--registry") << m_address;
    auto *call = new ProgramCall(m_program, this);
    connect(call, &ProgramCall::ended, this,
        [this, call, then](const ProgramAnswer &answer) { finish(call, answer, then); });
    ++m_running;
    emit busyChanged();
    call->start(arguments, std::move(secret));
    return call;
}

void RegistryCaller::read(const QObject &reader, const QStringList &arguments, const Then &then)
{
    if (ProgramCall *before = m_reads.value(&reader))
        before->stop();
    m_reads[&reader] = call(arguments, then);
}

void RegistryCaller::finish(ProgramCall *call, const ProgramAnswer &answer, const Then &then)
{
    call->deleteLater();
    --m_running;
    emit busyChanged();
    const QString problem = problemOf(answer);
    if (!problem.isEmpty())
        emit failed(problem);
    const bool isPartlyRead = isRead(call) && !answer.isCrash && !answer.out.isEmpty();
    if (!answer.isStopped && (problem.isEmpty() || isPartlyRead))
        then(answer);
}

} // namespace dyncal
