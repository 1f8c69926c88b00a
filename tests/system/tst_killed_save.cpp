// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/short_capture.h"
#include "tests/system/window_process.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

using Clock = std::chrono::steady_clock;

namespace {

constexpr unsigned kSeed = 20260302;
constexpr const char *kCustomers[] = {"First", "Second"};
/// Of a difference between a project and its checksums, and of a project that has none.
constexpr const char *kChanged = "changed after the program saved it";
constexpr const char *kUnsealed = "has no checksum";

} // namespace

/// The program is killed while it saves a project: the file is the old one or the new one, whole.
class TestKilledSave : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::chrono::microseconds m_usual{}; ///< that a save takes which nobody disturbs
    QByteArray m_whole[2]; ///< the project with each customer, as undisturbed saves write it

    /// The job of a project: kept results hold the time of the save, and checksums are of them too.
    static QJsonObject job(const QByteArray &project)
    {
        QJsonObject content = QJsonDocument::fromJson(project).object();
        for (const char *key : {"kept_results", "sha256", "sha256_of"})
            content.remove(key);
        return content;
    }

    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString project() const { return path("work/job.dyncal"); }
    /// But the file that says who has the project open, which a killed window leaves to the next.
    QStringList filesThere() const
    {
        QStringList files
            = QDir(path("work")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
        files.removeOne(".job.dyncal.held");
        return files;
    }

    /// Which of the two projects the file is; -1: neither.
    int whichIsThere() const
    {
        const QJsonObject there = job(bytesOf(project()));
        return there == job(m_whole[0]) ? 0 : there == job(m_whole[1]) ? 1 : -1;
    }

    /// A user who never ran the program: nothing is left to be recovered.
    QString freshHome() const
    {
        QDir(path("home")).removeRecursively();
        QDir().mkpath(path("home"));
        return path("home");
    }

    /// Until it may be saved: the recordings are sealed and computed from.
    static void waitForData(WindowProcess &window)
    {
        QVERIFY2(window.waitFor("list findingsPanel", "note"), window.last());
    }

    static void edit(WindowProcess &window, const char *customer)
    {
        QCOMPARE(window.ask("key Alt+0"), QString("done"));
        QCOMPARE(window.ask(QString("type field_customer %1").arg(customer)), QString("done"));
        QVERIFY2(window.waitFor("title", "modified"), window.last());
    }

    void save(WindowProcess &window)
    {
        const Clock::time_point begin = Clock::now();
        QCOMPARE(window.ask("key Ctrl+S"), QString("done"));
        // The first one takes longer than those that follow it.
        m_usual = std::max(
            m_usual, std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin));
        QVERIFY(!window.ask("title").contains("modified"));
    }

    /// Changes the customer, tells the window to save and kills it at a moment after that.
    void killedSave(const char *customer, std::chrono::microseconds moment) const
    {
        WindowProcess window(freshHome(), {project()});
        waitForData(window);
        edit(window, customer);
        const Clock::time_point begin = Clock::now();
        window.tell("key Ctrl+S");
        std::this_thread::sleep_until(begin + moment);
        window.stop(SIGKILL);
    }

    /// What the program says of the project.
    QByteArray said() const
    {
        return runDyncal({"export", project(), "-o", path("model"), "--format", "json"}).err;
    }

    /// The program itself finds it unchanged since it was saved.
    void checkSaved(const char *customer) const
    {
        const QJsonValue recipe = fileJson(project())["recipe"];
        QCOMPARE(recipe["certificate"]["fields"]["customer"].toString(), QString(customer));
        const QByteArray words = said();
        QVERIFY2(!words.contains(kChanged) && !words.contains(kUnsealed), words.constData());
    }

private slots:
    void initTestCase()
    {
        QVERIFY(QDir().mkpath(path("work")));
        QVERIFY(simulateShortCapture(path("work/a.h5"), 1));
        const QJsonObject info = runDyncal({"info", path("work/a.h5"), "--json"}).json();
        const QJsonObject capture{
            {"path", "a.h5"}, {"sha256", info["files"][0]["sha256"]}, {"shots", QJsonArray{1}}};
        const QJsonObject byHand{{"format", "dyncal-project"}, {"version", 2},
            {"recipe", QJsonObject{{"schema", "dyncal-recipe/1"}}},
            {"captures", QJsonArray{capture}}};
        QVERIFY(writeBytes(project(), QJsonDocument(byHand).toJson()));
    }

    /// First of all: what whole projects are, and how long it takes to write one.
    void undisturbed_isWhole()
    {
        WindowProcess window(freshHome(), {project()});
        waitForData(window);
        for (int which = 0; which < 2 && !QTest::currentTestFailed(); ++which) {
            edit(window, kCustomers[which]);
            save(window);
            m_whole[which] = bytesOf(project());
            checkSaved(kCustomers[which]);
        }
        QVERIFY(job(m_whole[0]) != job(m_whole[1]));
        // A project that is not whole would have been told.
        QVERIFY(writeBytes(project(), QByteArray(m_whole[0]).replace("First", "Third")));
        QVERIFY(said().contains(kChanged));
        QVERIFY(writeBytes(project(), m_whole[0]));
    }

    void killedAtRandomMoments_isTheOldOrTheNewWhole()
    {
        QVERIFY2(whichIsThere() >= 0, "undisturbed_isWhole must come before");
        const int kills = dyncal::trials::count(4, 100);
        std::mt19937 random(kSeed);
        std::uniform_int_distribution<std::int64_t> moment_us(0, 2 * m_usual.count());
        int behind = 0, within = 0;
        for (int i = 0; i < kills; ++i) {
            const int old = whichIsThere();
            const QStringList before = filesThere();
            const std::chrono::microseconds moment(moment_us(random));
            killedSave(kCustomers[1 - old], moment);
            if (QTest::currentTestFailed())
                return;
            const int now = whichIsThere();
            QVERIFY2(now >= 0,
                qPrintable(QString("kill %1 after %2 us: %3")
                               .arg(i)
                               .arg(moment.count())
                               .arg(bytesOf(project()))));
            checkSaved(kCustomers[now]);
            behind += now == old ? 0 : 1;
            within += filesThere() == before || filesThere().size() == 2 ? 0 : 1;
        }
        WindowProcess window(freshHome(), {project()});
        waitForData(window);
        const int last = 1 - whichIsThere();
        edit(window, kCustomers[last]);
        save(window);
        QCOMPARE(whichIsThere(), last);
        QCOMPARE(filesThere(), QStringList({"a.h5", "job.dyncal"}));
        qInfo("a save takes %lld us; %d kills: %d behind the exchange, %d left something to clear",
            static_cast<long long>(m_usual.count()), kills, behind, within);
    }
};

DYNCAL_TEST(TestKilledSave)
#include "tst_killed_save.moc"
