// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>

#include <csignal>
#include <memory>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dyncal::testing {

/// A PostgreSQL server of the test's own on the loopback, in a folder that goes with it. It does
/// not run as root, so root runs it as the user of the package.
class PostgresServer
{
public:
    PostgresServer()
    {
        if (m_programs.isEmpty())
            return;
        if (::geteuid() == 0)
            call("chown", {"postgres", m_folder.path()}, false);
        m_port = freePort();
        if (call(m_programs + "/initdb",
                {"-D", data(), "-A", "trust", "-U", "dyncal", "--no-sync", "-E", "UTF8"}, true))
            start();
    }
    ~PostgresServer() { stop(); }
    PostgresServer(const PostgresServer &) = delete;
    PostgresServer &operator=(const PostgresServer &) = delete;

    static bool isInstalled() { return !folderOfPrograms().isEmpty(); }

    /// Whether one may be run here: root must be able to become the package's user, which a
    /// container may forbid. Says so where not; the tests then hold SQLite alone.
    static bool isPermitted()
    {
        if (::geteuid() != 0 || call("/bin/true", {}, true))
            return true;
        qWarning("No program can be run as the user postgres here: PostgreSQL is not tested.");
        return false;
    }

    QString address() const
    {
        return QString("postgresql://dyncal@127.0.0.1:%1/postgres").arg(m_port);
    }

    /// An empty database on it; its address.
    QString database(const QString &name)
    {
        const QString statement = "CREATE DATABASE " + name;
        call("psql",
            {"-h", "127.0.0.1", "-p", QString::number(m_port), "-U", "dyncal", "-d", "postgres",
                "-c", statement},
            false);
        return QString("postgresql://dyncal@127.0.0.1:%1/%2").arg(m_port).arg(name);
    }

    bool start()
    {
        m_server = std::make_unique<QProcess>();
        m_server->setStandardErrorFile(QProcess::nullDevice());
        const auto [program, arguments] = asUser(m_programs + "/postgres",
            {"-D", data(), "-p", QString::number(m_port), "-k", m_folder.path(), "-c",
                "listen_addresses=127.0.0.1"});
        m_server->start(program, arguments);
        if (!m_server->waitForStarted())
            return false;
        QElapsedTimer waited;
        for (waited.start(); waited.elapsed() < 30000; QThread::msleep(50))
            if (call(m_programs + "/pg_isready", {"-h", "127.0.0.1", "-p", QString::number(m_port)},
                    false))
                return true;
        return false;
    }

    /// At once, without waiting for those who are connected.
    void stop()
    {
        if (!m_server)
            return;
        call(m_programs + "/pg_ctl", {"-D", data(), "-m", "immediate", "-w", "stop"}, true);
        m_server->waitForFinished(10000);
        m_server.reset();
    }

    bool isRunning() const { return m_server && m_server->state() == QProcess::Running; }

private:
    static QString folderOfPrograms()
    {
        const QDir versions("/usr/lib/postgresql");
        for (const QString &version : versions.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            if (QFileInfo::exists(versions.filePath(version + "/bin/initdb")))
                return versions.filePath(version + "/bin");
        return {};
    }
    static int freePort()
    {
        const int server = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof place;
        const bool isBound = ::bind(server, reinterpret_cast<sockaddr *>(&place), size) == 0
            && ::getsockname(server, reinterpret_cast<sockaddr *>(&place), &size) == 0;
        ::close(server);
        return isBound ? ntohs(place.sin_port) : 0;
    }
    QString data() const { return m_folder.filePath("data"); }
    static std::pair<QString, QStringList> asUser(const QString &program, QStringList arguments)
    {
        if (::geteuid() != 0)
            return {program, arguments};
        arguments = QStringList{"-u", "postgres", "--", program} + arguments;
        return {"runuser", arguments};
    }
    static bool call(const QString &program, const QStringList &arguments, bool isUsers)
    {
        const auto [name, all]
            = isUsers ? asUser(program, arguments) : std::pair(program, arguments);
        QProcess process;
        process.setWorkingDirectory("/");
        process.start(name, all);
        return process.waitForFinished(60000) && process.exitCode() == 0;
    }

    QTemporaryDir m_folder;
    QString m_programs = folderOfPrograms();
    int m_port = 0;
    std::unique_ptr<QProcess> m_server;
};

/// Ends a test that needs a server where none can be run.
#define DYNCAL_NEEDS_POSTGRES()                                                                    \
    do {                                                                                           \
        if (!dyncal::testing::PostgresServer::isInstalled())                                       \
            QSKIP(                                                                                 \
                "PostgreSQL is not installed (package postgresql), so no server can be started");  \
        if (!dyncal::testing::PostgresServer::isPermitted())                                       \
            return;                                                                                \
    } while (false)

} // namespace dyncal::testing
