// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/dyncal_process.h"

#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTest>

#include <csignal>
#include <cstdint>
#include <utility>

/// The built program with its window, without a display, and a user of its own: everything it keeps
/// lies in `home`. window_driver.cpp operates it ($DYNCAL_WINDOW_DRIVER).
class WindowProcess
{
public:
    /// `addressSpace`: bytes that it may have, 0 = no limit. `extra`: further environment variables
    /// ("NAME=value").
    WindowProcess(const QString &home, const QStringList &files, std::uint64_t addressSpace = 0,
        const QStringList &extra = {})
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "SOURCE_DATE_EPOCH"})
            environment.remove(QLatin1String(name));
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("HOME", home);
        environment.insert("XDG_DATA_HOME", home + "/data");
        environment.insert("XDG_CONFIG_HOME", home + "/config");
        environment.insert("QT_PLUGIN_PATH", qEnvironmentVariable("DYNCAL_WINDOW_DRIVER"));
        environment.insert("QT_QPA_GENERIC_PLUGINS", "dyncal_window_driver");
        for (const QString &variable : extra)
            environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
        m_process.setProcessEnvironment(environment);
        limitAddressSpace(m_process, addressSpace);
        m_process.start(qEnvironmentVariable("DYNCAL_BINARY"), files);
    }
    ~WindowProcess() { stop(SIGKILL); }
    WindowProcess(const WindowProcess &) = delete;
    WindowProcess &operator=(const WindowProcess &) = delete;

    /// Gives a command and waits for its answer; "" if none comes.
    QString ask(const QString &command)
    {
        constexpr int kPatience_ms = 20000;
        m_process.write(command.toUtf8() + '\n');
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(kPatience_ms))
                return {};
        return QString::fromUtf8(m_process.readLine()).chopped(1);
    }

    /// Gives a command and goes on at once: the answer stays unread.
    void tell(const QString &command)
    {
        constexpr int kPatience_ms = 20000;
        m_process.write(command.toUtf8() + '\n');
        m_process.waitForBytesWritten(kPatience_ms);
    }

    /// Asks until the answer holds these words.
    bool waitFor(const QString &command, const QString &words)
    {
        constexpr int kTries = 300;
        for (int i = 0; i < kTries && m_process.state() != QProcess::NotRunning; ++i) {
            m_last = ask(command);
            if (m_last.contains(words))
                return true;
            QTest::qWait(100);
        }
        return false;
    }
    QByteArray last() const { return m_last.toUtf8() + '|' + errors(); }
    bool isRunning() { return m_process.state() != QProcess::NotRunning; }
    /// Its exit code (-1: ended by a signal) and what it wrote to stderr.
    std::pair<int, QByteArray> end()
    {
        const bool normal = m_process.exitStatus() == QProcess::NormalExit;
        return {normal ? m_process.exitCode() : -1, errors()};
    }

    /// Ends it by a signal, SIGKILL: at once, with no chance to tidy up.
    void stop(int signal)
    {
        constexpr int kPatience_ms = 20000;
        if (m_process.state() == QProcess::NotRunning)
            return;
        ::kill(static_cast<pid_t>(m_process.processId()), signal);
        m_process.waitForFinished(kPatience_ms);
    }
    /// -1 while it runs and after a signal.
    int exitCode() const
    {
        return m_process.state() == QProcess::NotRunning
                && m_process.exitStatus() == QProcess::NormalExit
            ? m_process.exitCode()
            : -1;
    }
    /// Whether it has ended by itself, without complaint.
    bool hasEndedWell()
    {
        constexpr int kPatience_ms = 20000;
        if (m_process.state() != QProcess::NotRunning)
            m_process.waitForFinished(kPatience_ms);
        return m_process.state() == QProcess::NotRunning
            && m_process.exitStatus() == QProcess::NormalExit && m_process.exitCode() == 0;
    }

private:
    QByteArray errors() const { return const_cast<QProcess &>(m_process).readAllStandardError(); }

    QProcess m_process;
    QString m_last;
};
