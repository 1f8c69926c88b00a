// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/measured_run.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/mutation.h"
#include "tests/system/sound_stderr.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <map>
#include <mutex>

using namespace dyncal;
using namespace dyncal::testing;

/// The built program is given damaged files of every format: it reads them or says in a sentence
/// why not, and neither dies, hangs nor takes more memory than a file of that size may.
class TestMutants : public QObject
{
    Q_OBJECT

private:
    struct Seed
    {
        QString ending; ///< "recipe" for recipes
        std::string bytes;
    };

    struct Tally
    {
        std::map<int, int> exits;
        double longest_s = 0.0;
        double largest_MiB = 0.0;
        QStringList faults;
        int textFaults = 0; ///< of those, what stderr says
    };

    static constexpr qint64 kLargestSeed = 65536;

    QTemporaryDir m_folder;
    QString m_capture;
    QMap<QString, QList<Seed>> m_seeds; ///< by ending, so that each format gets its share
    double m_least_MiB = 0.0; ///< what the program takes for a small file
    double m_leastRun_MiB = 0.0;

    static std::string program() { return qEnvironmentVariable("DYNCAL_BINARY").toStdString(); }

    void addSeeds(const QString &folder)
    {
        static const QStringList kNoRecordings{"json", "xml", "md", "py", "tdms_index"};
        QDirIterator entry(folder, QDir::Files, QDirIterator::Subdirectories);
        QStringList files;
        while (entry.hasNext())
            files << entry.next();
        files.sort();
        for (const QString &file : files) {
            const QString ending = QFileInfo(file).suffix().toLower();
            if (QFileInfo(file).size() <= kLargestSeed && !ending.isEmpty()
                && !kNoRecordings.contains(ending))
                m_seeds[ending] << Seed{ending, bytesOf(file).toStdString()};
        }
    }

    /// Runs one mutant and notes what is wrong with the answer.
    void tryOne(std::uint64_t number, const QString &folder, Tally &tally, std::mutex &mutex)
    {
        Mutation mutation(number);
        const QString kind
            = m_seeds.keys()[static_cast<qsizetype>(number % std::uint64_t(m_seeds.size()))];
        const QList<Seed> &seeds = m_seeds[kind];
        const auto any = [&] {
            return seeds[static_cast<qsizetype>(mutation.below(std::size_t(seeds.size())))].bytes;
        };
        const std::string bytes = mutation.of(any(), any());
        const QString file = folder + "/mutant." + kind;
        writeBytes(file, QByteArray::fromStdString(bytes));
        const std::string path = file.toStdString();
        const std::string out = (folder + "/out").toStdString();
        const bool recipe = kind == "recipe";
        const bool runs = mutation.below(16) == 0;
        const std::string verb = runs ? "run" : recipe || mutation.below(4) == 0 ? "check" : "info";
        std::vector<std::string> command{program(), verb, recipe ? m_capture.toStdString() : path};
        if (recipe)
            command.insert(command.end(), {"--recipe", path});
        if (runs)
            command.insert(command.end(), {"-o", out});
        const MeasuredRun run = measuredRun(command, (folder + "/err").toStdString());
        QDir(QString::fromStdString(out)).removeRecursively();
        const double base_MiB = verb == "info" ? m_least_MiB : m_leastRun_MiB;
        const QString fault = faultOf(run, bytes.size(), base_MiB, recipe);
        const std::scoped_lock lock(mutex);
        ++tally.exits[run.signal != 0 ? -run.signal : run.exitCode];
        tally.longest_s = std::max(tally.longest_s, run.processor_s);
        tally.largest_MiB = std::max(tally.largest_MiB, run.peak_MiB);
        // What blocks is the answer of check, on stdout.
        constexpr int kBlocked = 2;
        const bool isAnswered = verb == "check" && run.exitCode == kBlocked;
        const QString text = faultOfStderr(run.err, isAnswered ? 0 : run.exitCode);
        tally.textFaults += text.isEmpty() ? 0 : 1;
        if (fault.isEmpty() && text.isEmpty())
            return;
        const QString kept = keptFolder() + QString("/%1.%2").arg(number).arg(kind);
        QFile::copy(file, kept);
        tally.faults
            << QString("%1 (%2): %3 %4").arg(kept, QString::fromStdString(verb), fault, text);
    }

    /// Where what went wrong can be looked at.
    static QString keptFolder()
    {
        const QString folder = QDir::tempPath() + "/dyncal-mutants";
        QDir().mkpath(folder);
        return folder;
    }

    static QString faultOf(
        const MeasuredRun &run, std::size_t fileBytes, double base_MiB, bool recipe)
    {
        constexpr double kLongest_s = 10.0;
        constexpr int kUnreadable = 3;
        constexpr int kUsage = 4;
        const double allowed_MiB
            = base_MiB + 64.0 + 20.0 * static_cast<double>(fileBytes) / (1 << 20);
        if (run.signal != 0)
            return QString("ended by signal %1").arg(run.signal);
        if (run.exitCode > (recipe ? kUsage : kUnreadable))
            return QString("exit code %1").arg(run.exitCode);
        if (run.processor_s > kLongest_s)
            return QString("took %1 s").arg(run.processor_s);
        if (run.peak_MiB > allowed_MiB)
            return QString("took %1 MiB of %2").arg(run.peak_MiB).arg(allowed_MiB);
        return {};
    }

private slots:
    void initTestCase()
    {
        m_capture = m_folder.filePath("capture.h5");
        QCOMPARE(runDyncal({"simulate", "-o", m_capture, "--sample-rate-hz", "1e6", "--duration-s",
                               "0.005", "--shots", "low", "--preset", "piezo"})
                     .exitCode,
            0);
        m_seeds["h5"] << Seed{"h5", bytesOf(m_capture).toStdString()};
        QDir().mkpath(m_folder.filePath("made"));
        const QString script
            = qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/fuzz/hdf5_seeds.py";
        QVERIFY(python({script, m_folder.filePath("made")}).ran);
        addSeeds(m_folder.filePath("made"));
        std::string table = "time_s,DUT_V\n";
        for (int i = 0; i < 400; ++i)
            table += std::to_string(i * 1e-6) + ","
                + std::to_string(i > 200 ? 1.0 : 0.001 * (i % 7)) + "\n";
        m_seeds["csv"] << Seed{"csv", table};
        m_seeds["recipe"] << Seed{"recipe",
            bytesOf(qEnvironmentVariable("DYNCAL_SOURCE_DIR")
                + "/tests/core/project/interface_example.json")
                .toStdString()};
        const QString data = qEnvironmentVariable(
            "DYNCAL_DATA", qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/../shared/data");
        if (QDir(data).exists())
            addSeeds(data);
        else
            qInfo("data folder missing: mutants of generated files only");
        const std::string err = m_folder.filePath("err").toStdString();
        m_least_MiB = measuredRun({program(), "info", m_capture.toStdString()}, err).peak_MiB;
        m_leastRun_MiB = measuredRun({program(), "run", m_capture.toStdString(), "-o",
                                         m_folder.filePath("out").toStdString()},
            err)
                             .peak_MiB;
        qInfo("a small file takes %.0f MiB, a run %.0f MiB", m_least_MiB, m_leastRun_MiB);
    }

    void mutants_areReadOrRefusedInASentence()
    {
        constexpr int kWorkers = 2;
        const int trials = trials::count(120, 20000);
        std::atomic<int> next = 0;
        Tally tally;
        std::mutex mutex;
        std::vector<std::thread> workers;
        for (int worker = 0; worker < kWorkers; ++worker)
            workers.emplace_back([&, worker] {
                const QString folder = m_folder.filePath(QString::number(worker));
                QDir().mkpath(folder);
                for (int i = 0; (i = next++) < trials;)
                    tryOne(static_cast<std::uint64_t>(i), folder, tally, mutex);
            });
        for (std::thread &worker : workers)
            worker.join();
        QStringList exits;
        for (const auto &[code, count] : tally.exits)
            exits << QString("%1 x %2").arg(code).arg(count);
        qInfo(
            "%d mutants of %lld endings: exit codes %s; at most %.2f s and %.0f MiB; %d with a fault in stderr",
            trials, static_cast<long long>(m_seeds.size()), qPrintable(exits.join(", ")),
            tally.longest_s, tally.largest_MiB, tally.textFaults);
        for (const QString &fault : tally.faults.mid(0, 40))
            qWarning("%s", qPrintable(fault));
        QCOMPARE(tally.faults.size(), 0);
    }
};

DYNCAL_TEST(TestMutants)
#include "tst_mutants.moc"
