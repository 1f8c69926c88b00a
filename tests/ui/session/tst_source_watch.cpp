// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/recording_files.h"
#include "ui/session/source_watch.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kSeen_ms = 2000; ///< so soon a change is known
constexpr int kNothing_ms = 2500;

} // namespace

/// Files of recordings are looked at while they are open.
class TestSourceWatch : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    int m_calls = 0;
    std::unique_ptr<SourceWatch> m_watch;

    SourceWatch::Captures recording(const QString &name) const
    {
        const QString path = m_folder.filePath(name);
        test::writeFile(path, "0.5\n");
        CaptureSet set;
        set.inputs.push_back(stampedInput(path.toStdString(), "text"));
        set.shots.resize(1);
        return std::make_shared<const CaptureSet>(std::move(set));
    }

private slots:
    void init()
    {
        m_calls = 0;
        m_watch = std::make_unique<SourceWatch>(this, [this] { ++m_calls; });
    }
    void cleanup() { m_watch.reset(); }

    void nothingChanges_nothingIsSaid()
    {
        m_watch->watch(recording("a"));
        QTest::qWait(kNothing_ms);
        QCOMPARE(m_calls, 0);
        QVERIFY(m_watch->changes().empty());
    }

    void change_isSeenAndSaidOnce()
    {
        m_watch->watch(recording("a"));
        QVERIFY(QFile::resize(m_folder.filePath("a"), 1));
        QTRY_COMPARE_WITH_TIMEOUT(m_calls, 1, kSeen_ms);
        QCOMPARE(m_watch->changes().size(), 1U);
        QTest::qWait(kNothing_ms);
        QCOMPARE(m_calls, 1);
    }

    void laterChange_isSeenToo()
    {
        m_watch->watch(recording("a"));
        QTest::qWait(kNothing_ms);
        QVERIFY(QFile::remove(m_folder.filePath("a")));
        QTRY_COMPARE_WITH_TIMEOUT(m_calls, 1, kSeen_ms);
        QVERIFY(m_watch->changes().front().isMissing);
        test::writeFile(m_folder.filePath("a"), "0.25\n"); // back, and another
        QTRY_COMPARE_WITH_TIMEOUT(m_calls, 2, kSeen_ms);
        QVERIFY(!m_watch->changes().front().isMissing);
    }

    void otherRecordings_beginWithNothing()
    {
        m_watch->watch(recording("a"));
        QVERIFY(QFile::remove(m_folder.filePath("a")));
        QTRY_COMPARE_WITH_TIMEOUT(m_calls, 1, kSeen_ms);
        m_watch->watch(recording("b"));
        QCOMPARE(m_calls, 2);
        QVERIFY(m_watch->changes().empty());
        QTest::qWait(kNothing_ms);
        QVERIFY(m_watch->changes().empty());
    }

    void noFiles_endTheWatch()
    {
        m_watch->watch(recording("a"));
        m_watch->watch(std::make_shared<const CaptureSet>());
        QVERIFY(QFile::remove(m_folder.filePath("a")));
        QTest::qWait(kNothing_ms);
        QCOMPARE(m_calls, 0);
    }
};

DYNCAL_TEST(TestSourceWatch)
#include "tst_source_watch.moc"
