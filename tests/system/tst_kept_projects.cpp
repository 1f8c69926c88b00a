// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"

#include <QTest>

namespace {

QString keptFolder()
{
    return qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/data";
}

/// A copy of everything that a version left, with the recording beside it.
struct KeptVersion
{
    QTemporaryDir folder;
    QString path(const QString &name) const { return folder.filePath(name); }

    explicit KeptVersion(const QString &version)
    {
        const QString kept = keptFolder() + "/kept_projects/" + version;
        for (QDirIterator entry(kept, QDir::Files, QDirIterator::Subdirectories);
             entry.hasNext();) {
            const QString file = entry.next();
            const QString target = path(QDir(kept).relativeFilePath(file));
            QDir().mkpath(QFileInfo(target).path());
            if (!QFile::copy(file, target))
                qFatal("cannot copy %s", qPrintable(file));
        }
        QFile::copy(keptFolder() + "/kept_runs/recording.h5", path("recording.h5"));
    }

    int projectVersion() const { return fileJson(path("job.dyncal"))["version"].toInt(); }
    QByteArray warning() const
    {
        return "as version " + QByteArray::number(projectVersion()) + "; saving it writes version ";
    }
    Answer verify(const QStringList &files) const
    {
        return runDyncal(QStringList{"verify", "--json"} + files);
    }
};

QJsonObject firstOf(const Answer &answer)
{
    return QJsonDocument::fromJson(answer.out).array().first().toObject();
}

} // namespace

/// Projects, certificates and registries that earlier versions left, by the program of today.
class TestKeptProjects : public QObject
{
    Q_OBJECT

private slots:
    void project_isVerified_data() { addVersions(); }
    void project_isVerified();
    void certificate_isVerified_data() { addVersions(); }
    void certificate_isVerified();
    void certificate_isComputedAgain_data() { addVersions(); }
    void certificate_isComputedAgain();
    void registry_isVerifiedAndGoesOn_data() { addVersions(); }
    void registry_isVerifiedAndGoesOn();

private:
    static void addVersions()
    {
        QTest::addColumn<QString>("version");
        const QStringList versions
            = QDir(keptFolder() + "/kept_projects").entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        QVERIFY(versions.size() >= 2);
        for (const QString &version : versions)
            QTest::newRow(qPrintable(version)) << version;
    }
};

void TestKeptProjects::project_isVerified()
{
    QFETCH(QString, version);
    const KeptVersion kept(version);
    const Answer answer = kept.verify({kept.path("job.dyncal")});
    const bool isOlder = kept.projectVersion() < kCurrentProjectVersion;
    QVERIFY2(answer.exitCode == (isOlder ? 1 : 0), answer.out + answer.err);
    QCOMPARE(answer.out.contains(kept.warning()), isOlder);
}

void TestKeptProjects::certificate_isVerified()
{
    QFETCH(QString, version);
    const KeptVersion kept(version);
    const Answer answer = kept.verify({kept.path("certificates"), "--registry",
        kept.path("registry.sqlite"), "--recordings", kept.folder.path()});
    QVERIFY2(answer.exitCode == 1, answer.out + answer.err);
    const QJsonObject row = firstOf(answer);
    QCOMPARE(row["status"].toString(), QString("unsigned"));
    QCOMPARE(row["state"].toString(), QString("issued"));
    QVERIFY2(row["first_difference"].isNull(), answer.out);
    QVERIFY2(row["remarks"].toArray().isEmpty(), answer.out);
}

/// Nothing that was issued differs by more than its U.
void TestKeptProjects::certificate_isComputedAgain()
{
    QFETCH(QString, version);
    const KeptVersion kept(version);
    const Answer answer = runDyncal(
        {"recheck", kept.path("certificates"), "--recordings", kept.folder.path(), "--json"});
    QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
    QVERIFY(QDir(kept.path("certificates/1")).exists("project.dyncal"));
}

/// An amendment of the kept certificate, from the kept project: the warning comes before anything
/// is written, and the registry, migrated if need be, is whole.
void TestKeptProjects::registry_isVerifiedAndGoesOn()
{
    QFETCH(QString, version);
    const KeptVersion kept(version);
    const QString registry = kept.path("registry.sqlite");
    QCOMPARE(kept.verify({registry}).exitCode, 0);
    const QByteArray before = bytesOf(kept.path("job.dyncal"));
    const QStringList issue{"issue", kept.path("job.dyncal"), "-o", kept.path("certificates"),
        "--registry", registry, "--unsigned"};
    const Answer again = runDyncal(issue);
    QVERIFY2(again.exitCode == 0, again.err); // issued then: answered
    const bool isOlder = kept.projectVersion() < kCurrentProjectVersion;
    QCOMPARE(again.err.contains(kept.warning()), isOlder);
    QCOMPARE(again.complaints().size(), isOlder ? 1 : 0);
    const Answer amended = runDyncal(issue + QStringList{"--amends", "1", "--reason", "kept"});
    QVERIFY2(amended.exitCode == 0, amended.err);
    QCOMPARE(fileJson(kept.path("certificates/2/project.dyncal"))["version"].toInt(),
        kCurrentProjectVersion);
    QCOMPARE(bytesOf(kept.path("job.dyncal")), before);
    const Answer all = kept.verify({kept.path("certificates"), registry, "--registry", registry});
    QVERIFY2(all.exitCode == 1, all.out + all.err);
}

DYNCAL_TEST(TestKeptProjects)
#include "tst_kept_projects.moc"
