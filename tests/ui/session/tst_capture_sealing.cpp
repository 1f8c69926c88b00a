// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "tests/support/test_program.h"
#include "ui/session/capture_sealing.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

/// By itself; what the session makes of it is in tst_session_sealing.
class TestCaptureSealing : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void opened_becomesSealed_andIsRemembered();
    void started_anotherMeanwhile_deliversTheOther();
    void cancelled_deliversNothing_andMayBeStartedAgain();
    void changedFile_isAnError();
    void forget_knowsTheOpenedOnly();

private:
    CaptureSealing::Captures opened() const
    {
        CaptureSet set;
        set.inputs.push_back(stampedInput(m_path.toStdString(), "test"));
        Channel &channel = set.shots.emplace_back().channels.emplace_back();
        channel.name = "dut";
        channel.samples = RawSamples(std::vector<std::int16_t>{1, 2, 3});
        return std::make_shared<const CaptureSet>(std::move(set));
    }

    QTemporaryDir m_folder;
    QString m_path;
    QObject m_receiver;
    std::unique_ptr<CaptureSealing> m_sealing;
    QVector<CaptureSealing::Captures> m_of; ///< delivered
    QVector<CaptureSealing::Captures> m_sealed;
    std::optional<Error> m_error;
};

void TestCaptureSealing::init()
{
    m_path = m_folder.filePath("recording.bin");
    QFile file(m_path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("three samples");
    m_of.clear();
    m_sealed.clear();
    m_error.reset();
    m_sealing = std::make_unique<CaptureSealing>(
        &m_receiver,
        [this](const CaptureSealing::Captures &of, const Result<CaptureSealing::Captures> &sealed) {
            m_of << of;
            if (sealed)
                m_sealed << *sealed;
            else
                m_error = sealed.error();
        },
        ProgressSink());
}

void TestCaptureSealing::opened_becomesSealed_andIsRemembered()
{
    const auto captures = opened();
    QVERIFY(!isSealed(*captures));
    QCOMPARE(m_sealing->latest(captures), captures);
    m_sealing->start(captures);
    QVERIFY(m_sealing->isSealing(captures));
    QVERIFY(!m_sealing->isSealing(opened()));
    QTRY_COMPARE(m_sealed.size(), 1);
    QCOMPARE(m_of.front(), captures);
    QVERIFY(isSealed(*m_sealed.front()));
    QCOMPARE(m_sealing->latest(captures), m_sealed.front());
    QVERIFY(!m_sealing->isSealing(captures));
}

void TestCaptureSealing::started_anotherMeanwhile_deliversTheOther()
{
    const auto first = opened();
    const auto second = opened();
    m_sealing->start(first);
    m_sealing->start(second);
    QVERIFY(!m_sealing->isSealing(first));
    QTRY_COMPARE(m_of.size(), 1);
    QTest::qWait(30);
    QCOMPARE(m_of, QVector<CaptureSealing::Captures>{second});
    QCOMPARE(m_sealing->latest(first), first);
}

void TestCaptureSealing::cancelled_deliversNothing_andMayBeStartedAgain()
{
    const auto captures = opened();
    m_sealing->start(captures);
    m_sealing->cancel();
    QVERIFY(!m_sealing->isSealing(captures));
    QTest::qWait(60);
    QVERIFY(m_of.isEmpty());
    QCOMPARE(m_sealing->latest(captures), captures);
    m_sealing->start(captures);
    QTRY_COMPARE(m_sealed.size(), 1);
}

void TestCaptureSealing::changedFile_isAnError()
{
    const auto captures = opened();
    QVERIFY(QFile(m_path).resize(3));
    m_sealing->start(captures);
    QTRY_VERIFY(m_error);
    QCOMPARE(m_error->findingId, std::string("CAP-015"));
    QCOMPARE(m_sealing->latest(captures), captures);
}

void TestCaptureSealing::forget_knowsTheOpenedOnly()
{
    const auto captures = opened();
    m_sealing->start(captures);
    QTRY_COMPARE(m_sealed.size(), 1);
    m_sealing->forget();
    QCOMPARE(m_sealing->latest(captures), captures);
}

DYNCAL_TEST(TestCaptureSealing)
#include "tst_capture_sealing.moc"
