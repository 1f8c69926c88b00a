// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/source_check.h"
#include "tests/support/test_program.h"

#include "core/capture/capture_seal.h"
#include "tests/core/capture/capture_test_support.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

/// What is said of files that are not as they were when they were opened.
class TestSourceCheck : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    CaptureSet m_set; ///< one shot of a.txt, two of b.txt

    QString file(const QString &name) const { return m_folder->filePath(name); }

    void expectOne(bool isMissing, const QString &name, Index shot)
    {
        const std::vector<ChangedSource> changed = changedSources(m_set);
        QCOMPARE(changed.size(), 1U);
        QCOMPARE(changed[0].isMissing, isMissing);
        QCOMPARE(changed[0].finding.id, std::string("CAP-015"));
        QCOMPARE(changed[0].finding.severity, Severity::Block);
        QCOMPARE(changed[0].finding.shot, shot);
        QVERIFY(english(changed[0].finding.message).starts_with(file(name).toStdString() + " "));
        const Result<void> same = checkSources(m_set);
        QVERIFY(!same && same.error().findingId == "CAP-015");
        QCOMPARE(english(same.error().message), english(changed[0].finding.message));
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_set = {};
        for (const char *name : {"a.txt", "b.txt"})
            m_set.inputs.push_back(stampedInput(write(file(name), "0.5\n0.25\n"), "text"));
        m_set.inputs.push_back({"the example", "the example", "", "simulated"}); // no stamp
        m_set.shots.resize(3);
        m_set.shots[1].input = m_set.shots[2].input = 1;
    }

    void untouched_isAsItWas()
    {
        QVERIFY(changedSources(m_set).empty());
        QVERIFY(checkSources(m_set));
    }

    void cut_isChanged()
    {
        QVERIFY(QFile::resize(file("a.txt"), 3));
        expectOne(false, "a.txt", 1);
    }

    void otherBytesOfTheSameSize_areChanged()
    {
        QFile other(file("b.txt"));
        QVERIFY(other.open(QIODevice::ReadWrite) && other.write("9") == 1);
        other.close();
        expectOne(false, "b.txt", 0); // which of its two shots is not known
    }

    void timePutBack_isChangedAllTheSame()
    {
        QFile other(file("a.txt"));
        QVERIFY(other.open(QIODevice::ReadWrite));
        const QDateTime before = other.fileTime(QFileDevice::FileModificationTime);
        QVERIFY(other.write("9") == 1 && other.flush());
        QVERIFY(other.setFileTime(before, QFileDevice::FileModificationTime));
        other.close();
        expectOne(false, "a.txt", 1);
    }

    void otherFileInItsPlace_isChanged()
    {
        write(file("new.txt"), "0.5\n0.25\n"); // the same bytes: only reading tells
        QVERIFY(QFile::remove(file("a.txt")) && QFile::rename(file("new.txt"), file("a.txt")));
        expectOne(false, "a.txt", 1);
    }

    void removed_isMissing()
    {
        QVERIFY(QFile::remove(file("a.txt")));
        expectOne(true, "a.txt", 1);
    }

    void folderGone_allAreMissing()
    {
        m_folder.reset();
        const std::vector<ChangedSource> changed = changedSources(m_set);
        QCOMPARE(changed.size(), 2U);
        QVERIFY(changed[0].isMissing && changed[1].isMissing);
    }

    void joinedChannels_countForTheirShot()
    {
        m_set.shots[0].channels.resize(1);
        m_set.shots[0].channels[0].input = 1; // the second channel of the shot is in b.txt
        m_set.shots.resize(1);
        QVERIFY(QFile::remove(file("b.txt")));
        expectOne(true, "b.txt", 1);
    }

    void relocated_takesWhatIsMissingFromTheFolder_andExpectsItsHash()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("moved"));
        m_set.inputs[1].sha256 = "b's";
        for (const char *name : {"a.txt", "b.txt"})
            QVERIFY(QFile::copy(file(name), file("moved/") + name));
        QVERIFY(QFile::remove(file("b.txt")));
        const CaptureSet set = relocated(m_set, file("moved").toStdString());
        QCOMPARE(set.inputs[0], m_set.inputs[0]);
        QCOMPARE(set.inputs[1].path, file("moved/b.txt").toStdString());
        QCOMPARE(set.inputs[1].expectedSha256, std::optional<std::string>("b's"));
        QCOMPARE(set.inputs[2], m_set.inputs[2]);
    }

    void relocated_nowhere_changesNothing()
    {
        QVERIFY(QFile::remove(file("b.txt")));
        for (const QString &folder : {QString(), m_folder->path(), file("no such")})
            QCOMPARE(relocated(m_set, folder.toStdString()).inputs, m_set.inputs);
    }

    void relocated_keepsWhatAProjectExpects()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("moved"));
        QVERIFY(QFile::rename(file("a.txt"), file("moved/a.txt")));
        m_set.inputs[0].sha256 = "now";
        m_set.inputs[0].expectedSha256 = "of the project";
        const CaptureSet set = relocated(m_set, file("moved").toStdString());
        QCOMPARE(set.inputs[0].expectedSha256, std::optional<std::string>("of the project"));
    }
};

DYNCAL_TEST(TestSourceCheck)
#include "tst_source_check.moc"
