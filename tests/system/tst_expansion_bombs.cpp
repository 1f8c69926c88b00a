// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/measured_run.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/sound_stderr.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;

/// Small files that unpack to gigabytes, given to the built program: refused in a sentence, within
/// a second and within what a file of their size may take of memory, helper processes included.
class TestExpansionBombs : public QObject
{
    Q_OBJECT

private:
    static constexpr double kLongest_s = 1.0; ///< of the processor: others may be busy here

    QTemporaryDir m_folder;
    double m_program_MiB = 0.0; ///< what the program takes for a small file

    static std::string program() { return qEnvironmentVariable("DYNCAL_BINARY").toStdString(); }

    MeasuredRun measured(
        const QString &verb, const QString &file, const QStringList &more = {}) const
    {
        std::vector<std::string> command{
            program(), verb.toStdString(), m_folder.filePath(file).toStdString()};
        for (const QString &argument : more)
            command.push_back(argument.toStdString());
        return measuredRun(command, m_folder.filePath("err").toStdString());
    }

    double allowed_MiB(const QString &file) const
    {
        return m_program_MiB + 64.0
            + 20.0 * double(QFileInfo(m_folder.filePath(file)).size()) / (1 << 20);
    }

private slots:
    void initTestCase()
    {
        const QString script
            = qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/system/expansion_bombs.py";
        const PythonAnswer made = python({script, m_folder.path()});
        QVERIFY2(made.ran, made.err);
        m_program_MiB
            = measuredRun({program(), "--version"}, m_folder.filePath("err").toStdString())
                  .peak_MiB;
        qInfo("the program itself takes %.0f MiB", m_program_MiB);
    }

    void bombs_areRefusedWithinTheBudget_data()
    {
        QTest::addColumn<QString>("file");
        const QDir folder(m_folder.path());
        for (const QString &name : folder.entryList(QDir::Files, QDir::Name)) {
            if (QFileInfo(name).suffix() != "json" && name != "err")
                QTest::newRow(qPrintable(name)) << name;
        }
    }

    void bombs_areRefusedWithinTheBudget()
    {
        QFETCH(QString, file);
        for (const QString verb : {"info", "check", "run"}) {
            const QStringList output{"-o", m_folder.filePath("out-" + file)};
            const MeasuredRun run = measured(verb, file, verb == "run" ? output : QStringList());
            qInfo("%s: exit code %d after %.2f s (%.2f s of the processor), %.0f of %.0f MiB: %s",
                qPrintable(verb), run.exitCode, run.wall_s, run.processor_s, run.peak_MiB,
                allowed_MiB(file), run.err.c_str());
            QCOMPARE(run.exitCode, 3);
            QVERIFY(run.processor_s < kLongest_s);
            QVERIFY(run.peak_MiB < allowed_MiB(file));
            QCOMPARE(faultOfStderr(run.err, run.exitCode), QString());
        }
    }

    void aTrustedFile_isReadWithTheRecipesFactor()
    {
        const QString recipe = m_folder.filePath("trust.json");
        QVERIFY(writeBytes(
            recipe, R"({"schema": "dyncal-recipe/1", "import": {"max_expansion": 10000}})"));
        const MeasuredRun run = measured("info", "gzip_chunk_60MiB.h5", {"--recipe", recipe});
        QVERIFY2(run.exitCode < 2, run.err.c_str());
    }
};

DYNCAL_TEST(TestExpansionBombs)
#include "tst_expansion_bombs.moc"
