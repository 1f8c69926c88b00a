// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever lies in and around the folders that the window exports to, it changes nothing that is
// not its own. The same for the command line: tests/system/tst_nothing_foreign.cpp.

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/own_files.h"
#include "tests/system/random_layout.h"
#include "tests/system/short_capture.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/quick_pipeline.h"

#include <QFileInfo>
#include <QtTest>

using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

constexpr unsigned kSeed = 20260301;
constexpr int kPatience_ms = 120'000;
const std::vector<std::string> kFolders{"out", "out", "out", "out/sub", "rec", "."};
/// Names that an operator may give to a certificate: free, taken, an input, a listed file.
const std::vector<std::string> kCertificates{"new.pdf", "out/certificate.pdf",
    "out/certificate.pdf", "out/results.json", "out/written.json", "out/csv/a.csv", "out/model",
    "out/notes.txt", "rec/certificate.pdf", "rec/shot1.h5", "rec/model.mat",
    "out/results.json.part"};

QString text(const fs::path &path)
{
    return QString::fromStdString(path.string());
}

/// Where a path leads, but for its last name: that is what is replaced.
fs::path placeOf(const fs::path &path)
{
    return fs::weakly_canonical(path.parent_path()) / path.filename();
}

/// A window that keeps unsaved work in a folder of its own; one after the other it opens the
/// recordings of all layouts.
struct Bench : dyncal::test::WindowBench
{
    Bench()
        : WindowBench(dyncal::test::quickPipeline())
    {
        window->show();
        window->keepWork(folder.filePath("recovery"), {std::chrono::milliseconds(20)});
    }

    dyncal::FileActions &files() const { return window->files(); }
    bool waitIdle() const
    {
        return QTest::qWaitFor([this] { return !files().isBusy(); }, kPatience_ms);
    }
    bool holds(const fs::path &recording) const
    {
        const auto &inputs = window->session().state().captures->inputs;
        std::error_code error;
        return inputs.size() == 1 && fs::equivalent(inputs[0].path, recording, error);
    }

    /// A new job, changed so that it is auto-saved while results are written.
    bool open(const fs::path &recording)
    {
        prompts.dropAnswers();
        prompts.setNextFile(text(recording));
        prompts.setNextAnswer(dyncal::Answer::Discard); // the changes of the job before
        files().openCaptures();
        if (!waitIdle() || !holds(recording))
            return false;
        dyncal::Recipe next = window->session().recipe();
        next.certificate.fields["customer"] = recording.string();
        window->session().apply(next, "customer");
        return QTest::qWaitFor([this] { return window->session().isUpToDate(); }, kPatience_ms);
    }
};

/// The exports of one layout, each held against what was there before it.
class Trial
{
public:
    Trial(Bench &bench, const std::string &capture, unsigned seed)
        : m_bench(bench)
        , m_root(fs::canonical(m_place.file("")))
        , m_layout(m_root, capture, seed)
    {
    }

    /// Empty, or what went wrong.
    QString run()
    {
        if (!m_bench.open(m_layout.recording()))
            return "not opened: " + m_bench.prompts.shownProblems().join('\n');
        const std::string folder = m_layout.pick(kFolders);
        const bool isWritten = exportResults(folder);
        const Snapshot first = snapshotOf(m_root);
        const bool isWrittenAgain = exportResults(folder); // over its own
        if (isWrittenAgain != isWritten || snapshotOf(m_root) != first)
            complain("the second export is not as the first");
        exportCertificate();
        exportResults(m_layout.pick(kFolders));
        return m_problem;
    }

    int refused() const { return m_refused; }
    int written() const { return m_written; }
    int certificates() const { return m_certificates; } ///< of those

private:
    bool exportResults(const std::string &folder)
    {
        const std::set<std::string> own = ownFiles(m_root, {"out", "out/sub", "rec", "."});
        const bool isWritten = exportTo(m_root / folder, own, &dyncal::FileActions::exportResults);
        if (isWritten && !fs::exists(m_root / folder / "results.json"))
            complain("no results in " + text(folder));
        return isWritten;
    }

    /// Under a name that may be taken: the dialog has asked whether to replace it. A recording of
    /// the job is replaced all the same by nothing.
    void exportCertificate()
    {
        fs::path target = m_root / m_layout.pick(kCertificates);
        if (m_layout.number(0, 5) == 0)
            target = m_layout.recording();
        fs::path given = target;
        if (QFileInfo(text(target)).suffix().isEmpty())
            target += ".pdf";
        std::set<std::string> own;
        if (placeOf(target) != placeOf(m_layout.recording()))
            own.insert(placeOf(target).lexically_relative(m_root).string());
        if (!exportTo(given, own, &dyncal::FileActions::exportCertificate))
            return;
        m_certificates += 1;
        if (!contentOf(target.string()).starts_with("%PDF"))
            complain("no certificate in " + text(target));
    }

    /// Whether something was written.
    bool exportTo(const fs::path &answer, const std::set<std::string> &own,
        void (dyncal::FileActions::*call)())
    {
        m_answer = text(answer);
        const Snapshot before = snapshotOf(m_root);
        const qsizetype problems = m_bench.prompts.shownProblems().size();
        m_bench.prompts.setNextFile(m_answer);
        (m_bench.files().*call)();
        if (!m_bench.waitIdle())
            complain("no end");
        const bool isRefused = m_bench.prompts.shownProblems().size() > problems;
        (isRefused ? m_refused : m_written) += 1;
        const Snapshot now = snapshotOf(m_root);
        if (const std::string harmed = firstHarmed(before, now, own); !harmed.empty())
            complain(text(harmed) + " was harmed");
        if (isRefused && now != before)
            complain("refused, and something changed");
        return !isRefused;
    }

    /// The first thing that went wrong is told.
    void complain(const QString &what)
    {
        if (m_problem.isEmpty())
            m_problem = what + "; export to " + m_answer + '\n'
                + m_bench.prompts.shownProblems().value(m_bench.prompts.shownProblems().size() - 1);
    }

    Bench &m_bench;
    ScratchFolder m_place;
    fs::path m_root;
    RandomLayout m_layout;
    QString m_answer; ///< of the dialog, last
    QString m_problem;
    int m_refused = 0;
    int m_written = 0;
    int m_certificates = 0;
};

} // namespace

class TestExportLayouts : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_captures;
    std::string m_capture = m_captures.file("c.h5");
    std::unique_ptr<Bench> m_bench;

private slots:
    void initTestCase()
    {
        if (!QFile::exists(qEnvironmentVariable("DYNCAL_BINARY")))
            QSKIP("the program is not built: there is nothing to simulate a recording with");
        QVERIFY(simulateShortCapture(text(m_capture), 1));
        m_bench = std::make_unique<Bench>();
    }

    void randomLayouts_noForeignByteChanges()
    {
        const int layouts = dyncal::trials::count(8, 200);
        int refused = 0, written = 0, certificates = 0;
        for (int i = 0; i < layouts; ++i) {
            Trial trial(*m_bench, m_capture, kSeed + static_cast<unsigned>(i));
            const QString problem = trial.run();
            QVERIFY2(problem.isEmpty(), qPrintable(QString("layout %1: %2").arg(i).arg(problem)));
            refused += trial.refused();
            written += trial.written();
            certificates += trial.certificates();
        }
        qInfo("%d layouts: %d exports refused, %d written, %d of them certificates", layouts,
            refused, written, certificates);
        QVERIFY(refused > 0 && certificates > 0 && written > certificates);
    }

    /// Under its own name and every other that it has, though the dialog was answered "replace".
    void recordingOfTheJob_isNeverReplaced()
    {
        const ScratchFolder place;
        const fs::path recording = place.file("a.h5");
        fs::copy_file(m_capture, recording);
        fs::create_hard_link(recording, place.file("second.dyncal"));
        fs::create_symlink(recording, place.file("link.pdf"));
        QVERIFY(m_bench->open(recording));
        const Snapshot before = snapshotOf(place.file(""));
        for (const char *name : {"a.h5", "second.dyncal", "link.pdf"}) {
            const qsizetype problems = m_bench->prompts.shownProblems().size();
            m_bench->prompts.setNextFiles({text(place.file(name))});
            m_bench->files().exportCertificate();
            QVERIFY(m_bench->waitIdle());
            m_bench->prompts.setNextFiles({text(place.file(name))});
            QVERIFY(!m_bench->files().saveAs());
            const QStringList said = m_bench->prompts.shownProblems().mid(problems);
            QCOMPARE(said.size(), 2);
            QCOMPARE(said.filter("is not replaced").size(), 2);
            QVERIFY(snapshotOf(place.file("")) == before);
        }
    }
};

DYNCAL_TEST(TestExportLayouts)
#include "tst_export_layouts.moc"
