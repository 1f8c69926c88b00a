// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "ui/shell/files/file_actions.h"

#include <QTemporaryDir>
#include <QtTest>

#include <random>

using namespace dyncal;
using testing::writeBytes;

namespace {

constexpr unsigned int kSeed = 12;
constexpr int kSteps = 25;

using Bytes = std::optional<QByteArray>; ///< of a file; none: it is not there

Bytes bytesIfThere(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? Bytes(file.readAll()) : std::nullopt;
}

PipelineOutcome noResults(const std::shared_ptr<const CaptureSet> &, const Recipe &, ResultCache &,
    StageId, const JobControl &)
{
    return {};
}

/// What one window has of the File menu, and what its operator knows of the project on disk.
struct OneWindow
{
    QTemporaryDir folder;
    Preferences preferences{folder.filePath("settings.ini")};
    Prompts prompts;
    Session session{&noResults};
    QWidget widget;
    FileActions files{session, [] { return Result<std::string>("2026-01-31T12:00:00Z"); }, prompts,
        preferences, &widget};
    Bytes known; ///< of its project: as it was opened or saved here

    OneWindow() { prompts.setScripted(); }

    void edit(const QString &words)
    {
        Recipe next = session.recipe();
        next.certificate.fields["customer"] = words.toStdString();
        session.apply(next, "edit");
    }

    QString words() const
    {
        const auto &fields = session.recipe().certificate.fields;
        const auto found = fields.find("customer");
        return found != fields.end() ? QString::fromStdString(found->second) : QString();
    }

    bool open(const QString &path)
    {
        files.openProjectFile(path);
        const bool done = QTest::qWaitFor([&] { return !files.isBusy(); }, 20000);
        if (done && files.projectPath() == path)
            known = bytesIfThere(path);
        return done;
    }
};

/// Two windows and other programs on a handful of files, step by step at random. After every step
/// each file is as it was, or was replaced by somebody who knew what was there.
class Interleaving
{
public:
    explicit Interleaving(unsigned int seed)
        : m_random(seed)
    {
        for (const char *name : {"a.dyncal", "b.dyncal", "c.dyncal"})
            m_paths << m_folder.filePath(name);
    }

    /// Empty, or what was lost.
    QString run()
    {
        for (int step = 0; step < kSteps && m_problem.isEmpty(); ++step)
            act();
        return m_problem;
    }

    int asked() const
    {
        return m_windows[0].prompts.changedProjectsAsked()
            + m_windows[1].prompts.changedProjectsAsked();
    }
    int saves() const { return m_saves; }

private:
    int upTo(int count) { return static_cast<int>(m_random() % static_cast<unsigned int>(count)); }
    QString anyPath() { return m_paths[upTo(static_cast<int>(m_paths.size()))]; }

    void act()
    {
        OneWindow &window = m_windows[static_cast<std::size_t>(upTo(2))];
        const QString path = anyPath();
        switch (upTo(9)) {
        case 0:
            if (QFile::exists(path) && !window.open(path))
                m_problem = "opening did not end";
            return;
        case 1:
        case 2:
            window.edit(QString("words %1").arg(++m_edits));
            return;
        case 3:
        case 4:
        case 5:
            save(window, false);
            return;
        case 6:
            save(window, true);
            return;
        case 7:
            QFile::remove(path);
            return;
        default:
            if (QFile::exists(path)) // another program
                QVERIFY(writeBytes(path, bytesIfThere(path)->replace("words", "WORDS")));
        }
    }

    void save(OneWindow &window, bool underName)
    {
        const auto answer = static_cast<ChangedProject>(upTo(3));
        const bool dialogFirst = underName || window.files.projectPath().isEmpty();
        const QString named = anyPath();
        const QString own = window.files.projectPath();
        window.prompts.setNextFile(named);
        window.prompts.setNextChangedProject(answer);
        std::map<QString, Bytes> before;
        for (const QString &path : m_paths)
            before[path] = bytesIfThere(path);
        const int asked = window.prompts.changedProjectsAsked();
        const bool saved = underName ? window.files.saveAs() : window.files.save();
        m_saves += saved ? 1 : 0;
        const bool wasAsked = window.prompts.changedProjectsAsked() > asked;
        for (const QString &path : m_paths) {
            if (bytesIfThere(path) == before[path])
                continue;
            const bool isOwn = path == own;
            const bool knew = isOwn && before[path] == window.known;
            const bool said = wasAsked && answer == ChangedProject::Replace;
            const bool chosen
                = path == named && !isOwn && (dialogFirst || answer == ChangedProject::OtherName);
            if (!saved || path != window.files.projectPath() || !(knew || said || chosen))
                m_problem = QString("%1 was replaced unasked").arg(path);
        }
        if (wasAsked && answer == ChangedProject::Cancel && saved)
            m_problem = "saved although the operator said no";
        if (saved)
            window.known = bytesIfThere(window.files.projectPath());
        if (saved && !window.known->contains(window.words().toUtf8()))
            m_problem = "the file is not what was saved";
        if (saved == window.files.isModified() && saved)
            m_problem = "saved, and still modified";
        forget(window.prompts);
    }

    /// Answers that nobody asked for must not serve the next question.
    static void forget(Prompts &prompts) { prompts.dropAnswers(); }

    QTemporaryDir m_folder;
    QStringList m_paths;
    std::mt19937 m_random;
    std::array<OneWindow, 2> m_windows;
    int m_edits = 0;
    int m_saves = 0;
    QString m_problem;
};

} // namespace

/// Two windows, or other programs, on one project.
class TestTwoWindows : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(name); }

    /// A project that both windows have open, changed in both, saved in the second.
    void makeConflict(const QString &path, OneWindow &first, OneWindow &second) const
    {
        first.edit("the first");
        first.prompts.setNextFile(path);
        QVERIFY(first.files.saveAs());
        QVERIFY(second.open(path));
        first.edit("changed in the first");
        second.edit("changed in the second");
        QVERIFY(second.files.save());
        QCOMPARE(second.prompts.changedProjectsAsked(), 0);
    }

private slots:
    void laterSave_asksAndKeepsTheOther()
    {
        OneWindow first;
        OneWindow second;
        makeConflict(path("cancel.dyncal"), first, second);
        const Bytes saved = bytesIfThere(path("cancel.dyncal"));
        first.prompts.setNextChangedProject(ChangedProject::Cancel);
        QVERIFY(!first.files.save());
        QCOMPARE(first.prompts.changedProjectsAsked(), 1);
        QVERIFY(first.files.isModified());
        QVERIFY(bytesIfThere(path("cancel.dyncal")) == saved);
        QVERIFY(first.prompts.shownProblems().isEmpty());
    }

    void laterSave_underAnotherName_keepsBoth()
    {
        OneWindow first;
        OneWindow second;
        makeConflict(path("both.dyncal"), first, second);
        const Bytes saved = bytesIfThere(path("both.dyncal"));
        first.prompts.setNextChangedProject(ChangedProject::OtherName);
        first.prompts.setNextFile(path("other.dyncal"));
        QVERIFY(first.files.save());
        QVERIFY(bytesIfThere(path("both.dyncal")) == saved);
        QVERIFY(bytesIfThere(path("other.dyncal"))->contains("changed in the first"));
        QCOMPARE(first.files.projectPath(), path("other.dyncal"));
    }

    void laterSave_replacesWhenToldTo()
    {
        OneWindow first;
        OneWindow second;
        makeConflict(path("replace.dyncal"), first, second);
        first.prompts.setNextChangedProject(ChangedProject::Replace);
        QVERIFY(first.files.save());
        QVERIFY(bytesIfThere(path("replace.dyncal"))->contains("changed in the first"));
        first.edit("once more"); // its own now
        QVERIFY(first.files.save());
        QCOMPARE(first.prompts.changedProjectsAsked(), 1);
        second.edit("again in the second");
        QVERIFY(!second.files.save());
        QCOMPARE(second.prompts.changedProjectsAsked(), 1);
    }

    void saveAs_overItsOwnChangedFile_asksToo()
    {
        OneWindow first;
        OneWindow second;
        makeConflict(path("own.dyncal"), first, second);
        first.prompts.setNextFile(path("own.dyncal"));
        QVERIFY(!first.files.saveAs());
        QCOMPARE(first.prompts.changedProjectsAsked(), 1);
        QVERIFY(bytesIfThere(path("own.dyncal"))->contains("changed in the second"));
    }

    void removedProject_isSaid()
    {
        OneWindow window;
        window.edit("x");
        window.prompts.setNextFile(path("gone.dyncal"));
        QVERIFY(window.files.saveAs());
        QVERIFY(QFile::remove(path("gone.dyncal")));
        window.edit("y");
        QVERIFY(!window.files.save());
        QCOMPARE(window.prompts.changedProjectsAsked(), 1);
        window.prompts.setNextChangedProject(ChangedProject::Replace);
        QVERIFY(window.files.save());
        QVERIFY(bytesIfThere(path("gone.dyncal"))->contains("y"));
    }

    void touchedProject_isTheSame()
    {
        OneWindow window;
        window.edit("x");
        window.prompts.setNextFile(path("touched.dyncal"));
        QVERIFY(window.files.saveAs());
        QVERIFY(writeBytes(path("touched.dyncal"), *bytesIfThere(path("touched.dyncal"))));
        window.edit("y");
        QVERIFY(window.files.save());
        QCOMPARE(window.prompts.changedProjectsAsked(), 0);
    }

    void restoredWork_isHeldAgainstTheProjectItWasMadeOf()
    {
        const QString project = path("restored.dyncal");
        const QString file = path("work-1.dyncal");
        OneWindow window;
        window.edit("saved");
        window.prompts.setNextFile(project);
        QVERIFY(window.files.saveAs());
        ProjectState state = window.session.state();
        state.recipe.certificate.fields["customer"] = "not saved";
        QVERIFY(writeRecoveryFile(file, state, project,
            QDateTime::fromString("2026-01-31T12:00:00Z", Qt::ISODate),
            window.files.projectHash()));
        const auto restoreInto = [&](OneWindow &other) {
            other.files.restoreWork(*readRecoveryFile(file));
            return QTest::qWaitFor([&] { return !other.files.isBusy(); }, 20000)
                && other.files.projectPath() == project && other.files.isModified();
        };
        OneWindow soon;
        QVERIFY(restoreInto(soon));
        QVERIFY(soon.files.save());
        QCOMPARE(soon.prompts.changedProjectsAsked(), 0);
        OneWindow late; // by now the project is another one
        QVERIFY(restoreInto(late));
        late.edit("and something else");
        QVERIFY(!late.files.save());
        QCOMPARE(late.prompts.changedProjectsAsked(), 1);
    }

    void interleavings_neverOverwriteUnasked()
    {
        const int count = trials::count(100, 2000);
        int asked = 0;
        int saves = 0;
        for (int trial = 0; trial < count; ++trial) {
            Interleaving interleaving(kSeed + static_cast<unsigned int>(trial));
            const QString problem = interleaving.run();
            QVERIFY2(
                problem.isEmpty(), qPrintable(QString("trial %1: %2").arg(trial).arg(problem)));
            asked += interleaving.asked();
            saves += interleaving.saves();
        }
        qInfo(
            "%d interleavings of %d steps: %d saves, asked %d times", count, kSteps, saves, asked);
        QVERIFY(asked > count / 2 && saves > count);
    }
};

DYNCAL_TEST(TestTwoWindows)
#include "tst_two_windows.moc"
