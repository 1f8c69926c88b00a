// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/hostile_files.h"
#include "tests/system/hostile_instruments.h"
#include "tests/system/hostile_judge.h"
#include "tests/system/window_process.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>

#include <filesystem>
#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::test;

namespace {

constexpr int kInternal = 5; ///< exit code of what is no fault of the files

/// All of `all` in the long form, `inSuite` of them, evenly spread, in the suite. Where each of
/// several functions begins with another one, `first`, they have different ones between them.
template <typename T>
std::vector<T> chosen(const std::vector<T> &all, int inSuite, int first = 0)
{
    const int size = static_cast<int>(all.size());
    const int count = trials::count(std::min(inSuite, size), size);
    std::vector<T> part;
    for (int i = 0; i < count; ++i)
        part.push_back(all[static_cast<std::size_t>((first + i * size / count) % size)]);
    return part;
}

} // namespace

/// Hostile text in files, recipes and arguments, as the built program shows it.
///
/// The long form is all texts x all outlets: folders of all formats with every verb, each of their
/// files with every verb, every call with an argument, recipes and projects, runs with their files;
/// and every row of numbers that are none. The suite has some texts for each of these: a folder
/// with two verbs of four, six of its files with one verb of three, an argument in one call of
/// seven, 7 rows of 43; between them every verb, file and call. The windows are the same in both.
class TestHostileText : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    std::vector<std::string> texts(int inSuite, int first) const
    {
        return chosen(hostileTexts(path("bait").toStdString()), inSuite, first);
    }

    /// Qt cannot, as it does not know names that are no UTF-8.
    void removeFiles() const { std::filesystem::remove_all(path("files").toStdString()); }

    QString makeFolder(const std::string &text) const
    {
        const QString folder = path("files");
        removeFiles();
        QDir().mkpath(folder);
        const QByteArray bytes = QByteArray::fromStdString(text);
        writeBytes(folder + "/a.csv", csv(bytes));
        writeBytes(folder + "/b.lvm", lvm(bytes));
        writeBytes(folder + "/c.tdms", tdms(text));
        writeForeignHdf5((folder + "/d.h5").toStdString(), text);
        writeBytes(folder + "/e.mat", mat(text));
        std::ofstream(folder.toStdString() + "/" + asName(text) + ".csv", std::ios::binary)
            << csv("p").toStdString();
        writeInstrumentFiles(folder.toStdString(), text);
        return folder;
    }

    /// A script that runs the program and has strace write what it looks for into "opened".
    QByteArray tracedProgram() const
    {
        const QString script = path("strace");
        writeBytes(script,
            "#!/bin/sh\nexec strace -f -qq -e trace=open,openat,openat2,access,stat,newfstatat,statx -o '"
                + path("opened").toUtf8() + "' '" + qgetenv("DYNCAL_BINARY") + "' \"$@\"\n");
        QFile(script).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        return script.toUtf8();
    }

    /// Signals the program itself, which strace names first in its lines and ends after.
    void signalTraced(int signal) const
    {
        const QByteArray opened = bytesOf(path("opened"));
        if (const int process = opened.left(opened.indexOf(' ')).toInt(); process > 0)
            ::kill(process, signal);
    }

private slots:
    void cleanupTestCase() { removeFiles(); }

    void plainText_isReadFromEveryInstrument_data()
    {
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char *file, const char *format, const char *shown) {
            QTest::newRow(file) << QByteArray(format) << QByteArray(shown);
        };
        row("lecroy.trc", "lecroy-trc", "int16/8  plain\n");
        row("keysight.bin", "keysight-bin", "model = plain\n");
        row("keysight_serial.bin", "keysight-bin", "serial = plain\n");
        row("rigol.bin", "rigol-bin", "    plain  ");
        row("rigol.wfm", "rigol-wfm", "model = DS1plain\n");
        row("rohde.bin", "rohde-bin", "float32  plain\n");
        row("plain.wav", "wav", "Shot 1 \"plain\"");
        row("level5.mat", "mat", "    plain  ");
        row("level5_packed.mat", "mat", "    plain2 2  ");
        row("level73.mat", "mat73", "float64  plain\n");
    }
    void plainText_isReadFromEveryInstrument()
    {
        QFETCH(QByteArray, format);
        QFETCH(QByteArray, shown);
        const QString file = makeFolder("plain") + "/" + QTest::currentDataTag();
        const Answer answer = runDyncal({"info", file});
        QVERIFY2(answer.exitCode == 0 || answer.exitCode == 1, answer.err); // 1: with a caution
        QVERIFY2(answer.out.contains(": " + format + ", sha256 "), answer.out);
        QVERIFY2(answer.out.contains(shown), answer.out + answer.err);
    }

    void refusals_nameTheTextOfTheFile()
    {
        const QDir folder(makeFolder("plain"));
        const QStringList files = folder.entryList({"refused*"}, QDir::Files);
        QCOMPARE(files.size(), 11);
        for (const QString &file : files) {
            const Answer answer = runDyncal({"info", folder.filePath(file)});
            QVERIFY2(answer.exitCode > 0, qPrintable(file));
            QVERIFY2(answer.err.contains("plain"), answer.err);
        }
    }

    void folders_ofAllFormats_areShownAsText()
    {
        const std::vector<QStringList> verbs{
            {"info"}, {"info", "--json"}, {"check"}, {"check", "--json"}};
        int asked = 0;
        int turn = 0;
        for (const std::string &text : texts(4, 0)) {
            const QString folder = makeFolder(text);
            for (const QStringList &verb : chosen(verbs, 2, turn++)) {
                judge(runDyncal(verb + QStringList{folder}), text);
                ++asked;
                if (QTest::currentTestFailed())
                    return;
            }
        }
        qInfo("%d answers of folders", asked);
    }

    void files_oneByOne_areShownAsText()
    {
        const std::vector<QStringList> verbs{{"info"}, {"check"}, {"compare"}};
        const std::vector<QString> imported{"a.csv", "c.tdms", "keysight.bin"};
        int asked = 0;
        int turn = 0;
        for (const std::string &text : texts(5, 1)) {
            const QDir folder(makeFolder(text));
            const QStringList files = folder.entryList(QDir::Files);
            for (const QString &file : chosen(std::vector(files.begin(), files.end()), 6, turn))
                for (const QStringList &verb : chosen(verbs, 1, asked + turn)) {
                    judge(runDyncal(verb + QStringList{folder.filePath(file)}), text);
                    ++asked;
                    if (QTest::currentTestFailed())
                        return;
                }
            for (const QString &file : chosen(imported, 1, turn)) {
                const QString made = path("imported.h5");
                const Answer answer = runDyncal({"import", folder.filePath(file), "-o", made});
                judge(answer, text);
                QVERIFY2(answer.exitCode != kInternal, answer.err); // no text keeps it from writing
                judge(runDyncal({"info", "--json", made}), text);
                QFile::remove(made);
            }
            ++turn;
        }
        qInfo("%d answers of files", asked);
    }

    void arguments_areShownAsText()
    {
        int asked = 0;
        writeBytes(path("p.csv"), csv("p"));
        for (const std::string &text : texts(24, 0)) {
            // Not longer than the system lets an argument be, and it ends at a NUL anyway.
            const QString word = QFile::decodeName(QByteArray::fromStdString(text).left(20000));
            const std::vector<QStringList> calls{{"info", word}, {"info", "--" + word},
                {"compare", path("p.csv"), "--orders", word},
                {"run", path("p.csv"), "-o", "/dev/null/" + word},
                {"simulate", "-o", path("s.h5"), "--defect", word},
                {"simulate", "-o", path("s.h5"), "--preset", word},
                {"check", path("p.csv"), "--recipe", word}};
            for (const QStringList &call : chosen(calls, 1, asked)) {
                judge(runDyncal(call), text);
                ++asked;
                if (QTest::currentTestFailed())
                    return;
            }
        }
        qInfo("%d answers of arguments", asked);
    }

    void recipes_brokenOrFull_areShownAsText()
    {
        writeBytes(path("p.csv"), csv("p"));
        for (const std::string &text : texts(3, 3)) {
            const nlohmann::json broken{{text, 1}};
            const nlohmann::json wrong{{"import", {{"format", text}, {"unit", text}}}};
            for (const QByteArray &json :
                {jsonBytes(broken), jsonBytes(wrong), QByteArray::fromStdString(text)}) {
                writeBytes(path("r.json"), json);
                judge(runDyncal({"check", path("p.csv"), "--recipe", path("r.json")}), text);
            }
            writeBytes(path("j.dyncal"), QByteArray::fromStdString(text));
            judge(runDyncal({"export", path("j.dyncal"), "-o", path("out")}), text);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void run_everyFile_holdsTextOnly()
    {
        int runs = 0;
        for (const std::string &text : texts(2, 20)) {
            const QString out = path(QString("out%1").arg(runs++));
            const Result<void> written = writeCapture(path("c.h5").toStdString(), text);
            QVERIFY2(written, (testing::sentence(written) + ": " + text).c_str());
            writeBytes(path("r.json"), recipe(text));
            const Answer answer
                = runDyncal({"run", path("c.h5"), "--recipe", path("r.json"), "-o", out});
            judge(answer, text);
            QVERIFY2(answer.exitCode <= 1, answer.err);
            QDirIterator files(out, QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext())
                judgeFile(files.next(), text);
            if (QTest::currentTestFailed())
                return;
        }
        qInfo("%d runs", runs);
    }

    void window_opensNothingThatTextNames()
    {
        // A name that is no markup is among them: the window shows it, and is still alive.
        const QString bait = path("bait");
        QCOMPARE(::mkfifo(QFile::encodeName(bait).constData(), 0600), 0);
        const QByteArray image = "<img src='file://" + bait.toUtf8() + "'>";
        writeBytes(path("image.csv"), csv(image));
        QVERIFY(writeCapture(path("image.h5").toStdString(), image.toStdString()));
        const QByteArray program = qgetenv("DYNCAL_BINARY");
        const auto unwrapped = qScopeGuard([&] { qputenv("DYNCAL_BINARY", program); });
        qputenv("DYNCAL_BINARY", tracedProgram());
        // The notes hold text of files: they are shown, not folded.
        QDir().mkpath(path("home/config/dyncal"));
        writeBytes(path("home/config/dyncal/dyncal.conf"), "[findings]\nnotesOpen=true\n");
        // A table is asked about; a calibration is shown, and has several findings in the end.
        for (const auto &[file, shown] :
            {std::pair{"image.csv", "list importPreview"}, {"image.h5", "list findingsPanel"}}) {
            QFile::remove(path("opened"));
            WindowProcess window(path("home"), {path(file)});
            const auto ended = qScopeGuard([&] { // a failed test leaves no window behind either
                if (window.isRunning())
                    signalTraced(SIGKILL);
            });
            QVERIFY2(window.waitFor(shown, " | "), window.last());
            for (int page = 1; page <= 9; ++page) {
                QCOMPARE(window.ask(QString("key Alt+%1").arg(page)), QString("done"));
                QTest::qWait(50); // until it is painted
            }
            QVERIFY(!window.ask("list findingsPanel").isEmpty());
            signalTraced(SIGTERM);
            QTRY_VERIFY_WITH_TIMEOUT(!window.isRunning(), 20000);
            const QByteArray opened = bytesOf(path("opened"));
            QVERIFY2(opened.contains(file), "strace must have seen the recording opened");
            QVERIFY2(!opened.contains(bait.toUtf8() + '"'), opened.right(2000));
        }
        QFile::remove(bait);
    }

    void commandLine_opensNothingThatTextNames()
    {
        const QByteArray image = "<img src='file://" + path("bait").toUtf8() + "'>";
        QVERIFY(writeCapture(path("image.h5").toStdString(), image.toStdString()));
        writeBytes(path("r.json"), recipe(image.toStdString()));
        QProcess strace;
        strace.start("strace",
            {"-f", "-qq", "-e", "trace=open,openat,openat2", "-o", path("opened"),
                qEnvironmentVariable("DYNCAL_BINARY"), "run", path("image.h5"), "--recipe",
                path("r.json"), "-o", path("traced")});
        QVERIFY(strace.waitForFinished(240000));
        QVERIFY2(strace.exitCode() <= 1, strace.readAllStandardError());
        const QByteArray opened = bytesOf(path("opened"));
        QVERIFY(opened.contains("image.h5") && !opened.contains(path("bait").toUtf8() + '"'));
    }

    void numbersThatAreNone_areNoWords_data()
    {
        QTest::addColumn<OddNumbers>("odd");
        const double inf = std::numeric_limits<double>::infinity();
        std::vector<OddNumbers> rows;
        for (const char *where : {"all", "first", "tail", "one", "side"})
            for (const double value : {std::nan(""), inf, -inf, 1e300, -1e300, 1e-300, 0.0})
                rows.push_back({value, where});
        for (const double interval_s : {1e-300, 1e300, 1e-12, 1.0, 0.0, -1e-6, inf, std::nan("")})
            rows.push_back({0.0, "none", interval_s});
        for (const OddNumbers &odd : chosen(rows, 7))
            QTest::addRow("%s %g, interval %g", odd.where, odd.value, odd.interval_s) << odd;
    }
    void numbersThatAreNone_areNoWords()
    {
        QFETCH(OddNumbers, odd);
        writeBytes(path("n.tdms"), tdms(odd));
        writeBytes(
            path("n.json"), R"({"import": {"channels": {"dut": "dut", "side": "driven_side"}}})");
        QDir(path("n_out")).removeRecursively();
        for (const QStringList &call : {QStringList{"info", path("n.tdms")},
                 {"check", path("n.tdms"), "--recipe", path("n.json")},
                 {"run", path("n.tdms"), "--recipe", path("n.json"), "-o", path("n_out")}}) {
            const Answer answer = runDyncal(call);
            QVERIFY2(answer.exitCode >= 0, answer.err);
            judgeNumbers(answer.out);
            judgeNumbers(answer.err);
        }
        judgeNumbers(bytesOf(path("n_out/results.json")));
    }
};

DYNCAL_TEST(TestHostileText)
#include "tst_hostile_text.moc"
