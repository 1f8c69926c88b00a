// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "tests/support/test_program.h"
#include "ui/session/session.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>

using namespace dyncal;

/// Recordings that are only opened are shown at once, and hashed before anything is computed.
class TestSessionSealing : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void opened_isSealedBeforeItIsComputed();
    void opened_changedFile_isAnErrorAndNothingIsComputed();
    void recipe_changedMeanwhile_isComputedOnce();
    void undo_toStepsMadeMeanwhile_keepsTheHashes();
    void otherJob_meanwhile_dropsTheFirst();

private:
    CaptureSet opened() const
    {
        CaptureSet set;
        set.inputs.push_back(stampedInput(m_path.toStdString(), "test"));
        Shot &shot = set.shots.emplace_back();
        Channel &channel = shot.channels.emplace_back();
        channel.name = "dut";
        channel.samples = RawSamples(std::vector<std::int16_t>{1, 2, 3});
        return set;
    }
    ProjectState openedState() const { return {std::make_shared<const CaptureSet>(opened()), {}}; }
    Session::Pipeline pipeline()
    {
        return [this](const std::shared_ptr<const CaptureSet> &captures, const Recipe &,
                   ResultCache &, StageId, const JobControl &) {
            const bool hashed = !captures->inputs.front().sha256.empty()
                && !captures->shots.front().channels.front().sha256.empty();
            ++(hashed ? m_sealedRuns : m_openRuns);
            return PipelineOutcome{};
        };
    }

    QTemporaryDir m_folder;
    QString m_path;
    std::atomic<int> m_sealedRuns = 0;
    std::atomic<int> m_openRuns = 0;
};

void TestSessionSealing::init()
{
    m_sealedRuns = m_openRuns = 0;
    m_path = m_folder.filePath("recording.bin");
    QFile file(m_path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("three samples");
}

void TestSessionSealing::opened_isSealedBeforeItIsComputed()
{
    Session session(pipeline());
    const QSignalSpy captures(&session, &Session::capturesChanged);
    session.reset(openedState());
    QVERIFY(!session.isSealed());
    QCOMPARE(captures.count(), 1); // to be shown now
    QVERIFY(session.isComputing());
    QTRY_VERIFY(session.isUpToDate());
    QVERIFY(session.isSealed());
    QCOMPARE(captures.count(), 2);
    QVERIFY(!session.state().captures->inputs.front().sha256.empty());
    QVERIFY(m_sealedRuns > 0);
    QCOMPARE(m_openRuns.load(), 0);
    QVERIFY(session.undoStack().isClean());
}

void TestSessionSealing::opened_changedFile_isAnErrorAndNothingIsComputed()
{
    Session session(pipeline());
    const QSignalSpy failures(&session, &Session::failed);
    const ProjectState state = openedState();
    QVERIFY(QFile(m_path).resize(3));
    session.reset(state);
    QTRY_COMPARE(failures.count(), 1);
    QCOMPARE(session.error()->findingId, std::string("CAP-015"));
    QVERIFY(!session.isComputing());
    QCOMPARE(m_sealedRuns + m_openRuns, 0);
}

void TestSessionSealing::recipe_changedMeanwhile_isComputedOnce()
{
    Session session(pipeline());
    session.reset(openedState());
    Recipe recipe = session.recipe();
    recipe.import.scale = 2.0;
    session.apply(recipe, "scale");
    QTRY_VERIFY(session.isUpToDate());
    QVERIFY(session.isSealed());
    QCOMPARE(session.recipe().import.scale, 2.0);
    QCOMPARE(m_openRuns.load(), 0);
}

void TestSessionSealing::undo_toStepsMadeMeanwhile_keepsTheHashes()
{
    Session session(pipeline());
    session.reset(openedState());
    Recipe recipe = session.recipe();
    recipe.import.scale = 2.0;
    session.apply(recipe, "scale"); // knows the recordings as opened only
    QTRY_VERIFY(session.isUpToDate());
    const auto sealed = session.state().captures;
    session.undoStack().undo();
    QCOMPARE(session.recipe().import.scale, 1.0);
    QVERIFY(session.isSealed());
    QCOMPARE(session.state().captures, sealed);
    session.undoStack().redo();
    QCOMPARE(session.state().captures, sealed);
    QTRY_VERIFY(session.isUpToDate());
}

void TestSessionSealing::otherJob_meanwhile_dropsTheFirst()
{
    Session session(pipeline());
    session.reset(openedState());
    QTest::qWait(20);
    session.reset({});
    QTest::qWait(100);
    QVERIFY(!session.state().hasShots());
    QVERIFY(!session.isComputing());
    session.reset(openedState());
    QTRY_VERIFY(session.isUpToDate());
    QVERIFY(session.isSealed());
}

DYNCAL_TEST(TestSessionSealing)
#include "tst_session_sealing.moc"
