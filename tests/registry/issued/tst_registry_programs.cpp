// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/registry_check.h"
#include "registry/issued/folder_check.h"
#include "tests/support/made_registry.h"
#include "tests/support/postgres_server.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <random>
#include <set>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// A runner (tests/registry_runner): issues and amends certificates of its own name.
std::unique_ptr<QProcess> startedRunner(
    const QString &registry, const std::string &output, const QString &name, int count)
{
    auto runner = std::make_unique<QProcess>();
    runner->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    runner->start(qEnvironmentVariable("DYNCAL_REGISTRY_RUNNER"),
        {registry, QString::fromStdString(output), name, QString::number(count)});
    return runner;
}

bool isDone(QProcess &runner)
{
    return runner.waitForFinished(600000) && runner.exitStatus() == QProcess::NormalExit
        && runner.exitCode() == 0;
}

/// Certificates and amendments of one runner.
Index numbersOf(int count)
{
    return count + count / 3;
}

/// Empty, or what is wrong: the registry is whole, its numbers are 1 to `expected`, each issued
/// with its folder, and nothing else lies there, hidden or not.
std::string faultOf(const std::string &address, const std::string &output, Index expected)
{
    CertificateRegister registry = openedRegister(address);
    const auto check = checkRegistry(registry);
    if (!check || check->firstDifference)
        return english(check ? *check->firstDifference : check.error().message);
    const auto all = registry.all();
    if (static_cast<Index>(all->size()) != expected)
        return std::to_string(all->size()) + " numbers";
    std::set<std::string> names;
    for (const CertificateRecord &record : *all) {
        const std::string place = issuedFolder(output, record.number);
        const auto folder = checkIssuedFolder(place, &registry);
        if (!folder || folder->firstDifference)
            return place + ": "
                + english(folder ? *folder->firstDifference : folder.error().message);
        names.insert(std::to_string(record.number));
    }
    for (const auto &entry : fs::directory_iterator(output))
        if (names.erase(entry.path().filename().string()) == 0)
            return "stray " + entry.path().string();
    return names.empty() ? std::string() : "folders are missing";
}

void issueByTwo(const QString &address, int count)
{
    const ScratchFolder folder;
    const std::string output = folder.file("certificates");
    const auto one = startedRunner(address, output, "one", count);
    const auto two = startedRunner(address, output, "two", count);
    QVERIFY(isDone(*one) && isDone(*two));
    const std::string fault = faultOf(address.toStdString(), output, 2 * numbersOf(count));
    QVERIFY2(fault.empty(), fault.c_str());
}

} // namespace

/// Programs that issue at once, are killed, or lose their server.
class TestRegistryPrograms : public QObject
{
    Q_OBJECT

private slots:
    void twoPrograms_haveConsecutiveNumbers()
    {
        const ScratchFolder folder;
        issueByTwo(QString::fromStdString(folder.file("registry.sqlite")), trials::count(20, 500));
    }

    void twoProgramsOnAServer_haveConsecutiveNumbers()
    {
        DYNCAL_NEEDS_POSTGRES();
        PostgresServer server;
        QVERIFY(server.isRunning());
        issueByTwo(server.database("two"), trials::count(20, 500));
    }

    /// Killed at any moment, again and again: each restart goes on, and at the end nothing is
    /// missing, twice, mixed or left over.
    void killedPrograms_loseNothing()
    {
        const ScratchFolder folder;
        const std::string output = folder.file("certificates");
        const QString address = QString::fromStdString(folder.file("registry.sqlite"));
        const int kills = trials::count(25, 250), count = trials::count(30, 150);
        std::mt19937_64 random(20261126);
        int killed = 0;
        for (int i = 0; i < kills; ++i) {
            const auto runner = startedRunner(address, output, "job", count);
            QVERIFY(runner->waitForStarted());
            QThread::usleep(random() % 120000);
            killed += runner->state() == QProcess::Running ? 1 : 0;
            runner->kill();
            runner->waitForFinished();
        }
        const auto last = startedRunner(address, output, "job", count);
        QVERIFY(isDone(*last));
        const std::string fault = faultOf(address.toStdString(), output, numbersOf(count));
        QVERIFY2(fault.empty(), fault.c_str());
        qInfo("%d kills of %d met a running program", killed, kills);
    }

    /// The server is stopped without notice and started again while two programs issue.
    void stoppedServer_losesNothing()
    {
        DYNCAL_NEEDS_POSTGRES();
        PostgresServer server;
        QVERIFY(server.isRunning());
        const ScratchFolder folder;
        const std::string output = folder.file("certificates");
        const QString address = server.database("stopped");
        const int count = trials::count(20, 300);
        const auto one = startedRunner(address, output, "one", count);
        const auto two = startedRunner(address, output, "two", count);
        for (int i = 0; i < trials::count(2, 10); ++i) {
            QThread::msleep(400);
            server.stop();
            QThread::msleep(200);
            QVERIFY(server.start());
        }
        QVERIFY(isDone(*one) && isDone(*two));
        const std::string fault = faultOf(address.toStdString(), output, 2 * numbersOf(count));
        QVERIFY2(fault.empty(), fault.c_str());
    }
};

DYNCAL_TEST(TestRegistryPrograms)
#include "tst_registry_programs.moc"
