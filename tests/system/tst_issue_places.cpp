// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/postgres_server.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/issued_job.h"

#include <QtTest>

namespace {

const QString kGone = ".gone"; // as system/full_disk moves a folder away

/// A laboratory whose registry and certificates have folders of their own.
struct Laboratory
{
    IssuedJob job;
    QString database = {}; ///< of a PostgreSQL server, in the place of the registry's folder
    QString registryFolder() const { return job.path("registry"); }
    QString registry() const
    {
        return database.isEmpty() ? registryFolder() + "/registry.sqlite" : database;
    }
    QStringList withRegistry(const QStringList &command) const
    {
        return command + QStringList{"--registry", registry()};
    }
    QStringList issue() const
    {
        return withRegistry({"issue", job.path("job.dyncal"), "-o", job.output(), "--unsigned"});
    }
    QJsonArray numbers() const
    {
        return QJsonDocument::fromJson(runDyncal(withRegistry({"registry", "list", "--json"})).out)
            .array();
    }
    QByteArray trail() const
    {
        return runDyncal(withRegistry({"registry", "trail", "--json"})).out;
    }
    /// Or not made yet.
    bool isRegistryWhole() const
    {
        return (database.isEmpty() && !QFile::exists(registry()))
            || runDyncal({"verify", registry()}).exitCode == 0 || numbers().isEmpty();
    }
    QStringList placesOf(const QString &folder) const
    {
        return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
};

/// The folder that was moved away is brought back, in the place of what was made of its name
/// meanwhile; false where it was not moved.
bool broughtBack(const QString &folder)
{
    if (!QFile::exists(folder + kGone))
        return false;
    QDir(folder).removeRecursively();
    return QDir().rename(folder + kGone, folder);
}

Answer runBroken(const QStringList &command, const QString &kind, int from)
{
    return runDyncal(command,
        {"SOURCE_DATE_EPOCH=1767225600", "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0",
            "LD_PRELOAD=" + qEnvironmentVariable("DYNCAL_FULL_DISK"), "DYNCAL_FULL_KIND=" + kind,
            "DYNCAL_FULL_FROM=" + QString::number(from)});
}

} // namespace

/// A disk that turns read-only, and folders that vanish, at the k-th write of issuing, withdrawing
/// and changing the registry (system/full_disk), for k up to the last: one sentence each time, and
/// what was there is whole.
class TestIssuePlaces : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    QString recording() const { return m_recordings.filePath("shot.h5"); }

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(recording(), 7)); }

    void readOnly_whileIssuing();
    void vanished_whileIssuing_data();
    void vanished_whileIssuing();
    void stoppedServer_isNamed_andIssuedOnceItIsBack();
    void registryThatFails_keepsItsState_data();
    void registryThatFails_keepsItsState();
};

void TestIssuePlaces::readOnly_whileIssuing()
{
    const Laboratory lab;
    QVERIFY(lab.job.begin(recording()));
    int failed = 0;
    const int step = dyncal::trials::count(29, 1);
    for (int from = 0;; from += step) {
        const Answer answer = runBroken(lab.issue(), "read-only", from);
        const QByteArray about = QByteArray::number(from) + ": " + answer.err;
        if (answer.exitCode == 0)
            break;
        ++failed;
        QVERIFY2(answer.exitCode == 4 || answer.exitCode == 5, about);
        QVERIFY2(answer.complaints().size() == 1, about);
        QVERIFY2(lab.isRegistryWhole(), about);
    }
    qInfo("%d writes were refused one after the other", failed);
    QVERIFY(failed > 0);
    QCOMPARE(runDyncal(lab.issue()).exitCode, 0);
    QCOMPARE(lab.numbers().size(), 1);
    QCOMPARE(lab.placesOf(lab.job.output()), QStringList{"1"});
    QCOMPARE(runDyncal(lab.withRegistry({"verify", lab.job.output(), lab.registry()})).exitCode, 1);
}

void TestIssuePlaces::vanished_whileIssuing_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("onAServer");
    QTest::newRow("certificates") << "certificates" << false;
    QTest::newRow("registry") << "registry" << false;
    QTest::newRow("certificates, PostgreSQL") << "certificates" << true;
}

void TestIssuePlaces::vanished_whileIssuing()
{
    QFETCH(QString, name);
    QFETCH(bool, onAServer);
    if (onAServer)
        DYNCAL_NEEDS_POSTGRES();
    std::optional<dyncal::testing::PostgresServer> server;
    if (onAServer)
        QVERIFY(server.emplace().isRunning());
    int failed = 0;
    const int step = dyncal::trials::count(29, 1);
    for (int from = 0;; from += step) {
        // Of its own: a folder that vanished late has a whole certificate.
        const Laboratory lab{
            {}, server ? server->database("at" + QString::number(from)) : QString()};
        QVERIFY(lab.job.begin(recording()));
        QVERIFY(QDir().mkpath(lab.job.output()) && QDir().mkpath(lab.registryFolder()));
        const Answer answer = runBroken(lab.issue(), "vanished:" + lab.job.path(name), from);
        const QByteArray about = QByteArray::number(from) + ": " + answer.err;
        if (!broughtBack(lab.job.path(name)))
            break;
        if (answer.exitCode != 0) {
            ++failed;
            QVERIFY2(answer.exitCode >= 3 && answer.exitCode <= 5, about);
            QVERIFY2(answer.complaints().size() == 1, about);
        }
        QVERIFY2(lab.isRegistryWhole(), about);
        const Answer again = runDyncal(lab.issue());
        // What was written after the folder had gone stands in no folder any more.
        const bool isIssuedElsewhere = again.err.contains("was issued as certificate 1");
        QVERIFY2(
            again.exitCode == 0 || (answer.exitCode == 0 && isIssuedElsewhere), about + again.err);
        if (again.exitCode == 0) {
            QVERIFY2(lab.numbers().size() == 1, about);
            QVERIFY2(lab.placesOf(lab.job.output()) == QStringList{"1"}, about);
        }
    }
    qInfo("%d of the moments ended in a refusal", failed);
    QVERIFY(failed > 0);
}

/// Nothing is written of a certificate that has no number yet.
void TestIssuePlaces::stoppedServer_isNamed_andIssuedOnceItIsBack()
{
    DYNCAL_NEEDS_POSTGRES();
    dyncal::testing::PostgresServer server;
    QVERIFY(server.isRunning());
    const Laboratory lab{{}, server.database("stopped")};
    QVERIFY(lab.job.begin(recording()));
    server.stop();
    const Answer refused = runDyncal(lab.issue());
    QVERIFY2(refused.exitCode >= 3 && refused.exitCode <= 5, refused.err);
    QVERIFY2(refused.complaints().size() == 1 && refused.err.contains("127.0.0.1"), refused.err);
    QVERIFY(!QFile::exists(lab.job.output() + "/1"));
    QVERIFY(server.start());
    QCOMPARE(runDyncal(lab.issue()).exitCode, 0);
    QCOMPARE(lab.placesOf(lab.job.output()), QStringList{"1"});
    QVERIFY(lab.isRegistryWhole() && lab.numbers().size() == 1);
}

void TestIssuePlaces::registryThatFails_keepsItsState_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::addColumn<bool>("vanishes");
    const QStringList withdraw{"withdraw", "1", "--reason", "reference damaged"};
    const QStringList import{"registry", "import", "customer", "cards.csv", "--reason", "new list"};
    QTest::newRow("withdraw, read-only") << withdraw << false;
    QTest::newRow("withdraw, vanished") << withdraw << true;
    QTest::newRow("import, read-only") << import << false;
    QTest::newRow("import, vanished") << import << true;
}

/// Either the command failed and nothing changed, or it is done and its entry is in the trail.
void TestIssuePlaces::registryThatFails_keepsItsState()
{
    QFETCH(QStringList, command);
    QFETCH(bool, vanishes);
    const Laboratory lab;
    QVERIFY(lab.job.begin(recording()));
    QVERIFY(QDir().mkpath(lab.registryFolder()));
    QCOMPARE(runDyncal(lab.issue()).exitCode, 0);
    QVERIFY(
        writeBytes(lab.job.path("cards.csv"), "name,customer_address\nCustomer Ltd,9 Street\n"));
    command.replaceInStrings("cards.csv", lab.job.path("cards.csv"));
    const QByteArray numbers = QJsonDocument(lab.numbers()).toJson();
    const QByteArray trail = lab.trail();
    const QString kind = vanishes ? "vanished:" + lab.registryFolder() : QString("read-only");
    int failed = 0;
    const int step = dyncal::trials::count(4, 1);
    for (int from = 0;; from += step) {
        const Answer answer = runBroken(lab.withRegistry(command), kind, from);
        const QByteArray about = QByteArray::number(from) + ": " + answer.err;
        if (vanishes)
            broughtBack(lab.registryFolder());
        QVERIFY2(lab.isRegistryWhole(), about);
        if (answer.exitCode == 0)
            break;
        ++failed;
        QVERIFY2(answer.exitCode >= 3 && answer.exitCode <= 5, about);
        QVERIFY2(answer.complaints().size() == 1, about);
        QVERIFY2(QJsonDocument(lab.numbers()).toJson() == numbers, about);
        QVERIFY2(lab.trail() == trail, about);
    }
    qInfo("%d writes were refused one after the other", failed);
    QVERIFY(failed > 0);
    QVERIFY(lab.trail() != trail);
    QVERIFY(lab.placesOf(lab.registryFolder()) == QStringList{"registry.sqlite"});
}

DYNCAL_TEST(TestIssuePlaces)
#include "tst_issue_places.moc"
