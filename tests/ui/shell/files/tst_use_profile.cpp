// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A laboratory's profile put over the work at hand.

#include "tests/support/test_program.h"
#include "ui/shell/files/file_actions.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

PipelineOutcome nothing(const std::shared_ptr<const CaptureSet> &, const Recipe &, ResultCache &,
    StageId, const JobControl &)
{
    return {};
}

} // namespace

class TestUseProfile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    Preferences m_preferences{m_folder.filePath("settings.ini")};
    Prompts m_prompts;
    Session m_session{&nothing};
    QWidget m_widget;
    FileActions m_files{m_session, [] { return Result<std::string>("2026-01-31T12:00:00Z"); },
        m_prompts, m_preferences, &m_widget};

    void use(const char *profile)
    {
        QFile file(m_folder.filePath("lab.json"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(profile) > 0);
        file.close();
        m_prompts.setNextFile(file.fileName());
        m_files.useProfile();
    }

private slots:
    void initTestCase() { m_prompts.setScripted(); }

    void withoutRecordings_nothingIsAsked()
    {
        m_files.useProfile();
        QVERIFY(m_prompts.shownProblems().last().contains("open recordings"));
    }

    void profile_isOneStepThatCanBeUndone()
    {
        CaptureSet set;
        set.shots.resize(3);
        ProjectState state;
        state.captures = std::make_shared<const CaptureSet>(std::move(set));
        m_session.reset(state);
        QSignalSpy said(&m_files, &FileActions::idle);
        use(R"({"schema": "dyncal-profile/1", "name": "Tube 2", "version": "7",
                "shock": {"driven_length_m": 0.97}})");
        QCOMPARE(m_session.recipe().shock.drivenLength_m, std::optional(0.97));
        QCOMPARE(m_session.recipe().profile->version, "7");
        QCOMPARE(m_session.undoStack().count(), 1);
        QVERIFY(said.last().first().toString().contains("Tube 2"));
        m_session.undoStack().undo();
        QVERIFY(!m_session.recipe().profile && !m_session.recipe().shock.drivenLength_m);
    }

    void badProfile_changesNothing()
    {
        const Recipe before = m_session.recipe();
        use(R"({"schema": "dyncal-profile/1", "name": "Tube 2"})");
        QVERIFY(m_prompts.shownProblems().last().contains("version"));
        m_files.useProfile(); // nothing chosen
        QVERIFY(m_session.recipe() == before);
    }
};

DYNCAL_TEST(TestUseProfile)
#include "tst_use_profile.moc"
