// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "ui/shell/files/file_actions.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kPatience_ms = 60'000;

/// A calibration that came to its end, of a recording that is not what it was.
PipelineOutcome blocked(const std::shared_ptr<const CaptureSet> &, const Recipe &, ResultCache &,
    StageId, const JobControl &)
{
    PipelineOutcome outcome{example::calibration(), {}, {}};
    auto response = std::make_shared<ResponseResult>(*outcome.results.response);
    response->findings.push_back(
        {.id = "CAP-015", .severity = Severity::Block, .message = {"The recording changed.", {}}});
    outcome.results.response = response;
    return outcome;
}

} // namespace

/// What the window exports of results that something blocks.
class TestBlockedExport : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    Preferences m_preferences{m_folder.filePath("settings.ini")};
    Prompts m_prompts;
    Session m_session{&blocked};
    QWidget m_widget;
    FileActions m_files{m_session, [] { return Result<std::string>("2026-01-31T12:00:00Z"); },
        m_prompts, m_preferences, &m_widget};

    QString made(const char *name) const
    {
        QDir(m_folder.path()).mkdir(name);
        return m_folder.filePath(name);
    }

private slots:
    void initTestCase()
    {
        m_prompts.setScripted();
        CaptureSet set;
        set.shots.resize(3);
        ProjectState state;
        state.captures = std::make_shared<const CaptureSet>(std::move(set));
        m_session.reset(state);
        QTRY_VERIFY_WITH_TIMEOUT(m_session.isUpToDate() && !m_session.isComputing(), kPatience_ms);
        QVERIFY(m_session.results().model);
    }

    void results_areJsonAndRecipeAlone()
    {
        const QString folder = made("results");
        QString told;
        const QObject here; // ends the connection with the words
        connect(&m_files, &FileActions::idle, &here, [&](const QString &words) { told = words; });
        m_prompts.setNextFile(folder);
        m_files.exportResults();
        QTRY_VERIFY_WITH_TIMEOUT(!m_files.isBusy(), kPatience_ms);
        QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
            QStringList({"recipe.json", "results.json", "written.json"}));
        QVERIFY2(told.contains("because of what blocks"), qPrintable(told));
        QCOMPARE(m_prompts.shownProblems(), QStringList());
    }

    void certificateAndModel_areRefusedWithTheReason()
    {
        const QString folder = made("refused");
        m_prompts.setNextFile(folder + "/c.pdf");
        m_files.exportCertificate();
        m_prompts.dropAnswers();
        m_prompts.setNextFile(folder);
        m_files.exportModel();
        QCOMPARE(m_prompts.shownProblems(),
            QStringList({"The recording changed.", "The recording changed."}));
        QVERIFY(!m_files.isBusy());
        QVERIFY(QDir(folder).isEmpty());
    }
};

DYNCAL_TEST(TestBlockedExport)
#include "tst_blocked_export.moc"
