// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/guarded_run.h"
#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "core/capture/formats/preview/foreign_datasets.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"
#include "tests/support/same_samples.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QDirIterator>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <numeric>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr GuardedLimits kLimits{64U << 20, std::chrono::milliseconds(300)};
constexpr qint64 kHang_ms = 5000; ///< of R4 in the reliability bars

/// Largest memory this process has used, in MiB.
double peakMemory_MiB()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct GuardedResult
{
    GuardedOutcome outcome;
    std::string received;
};

GuardedResult guarded(const std::function<void(GuardedOutput &)> &work,
    std::size_t mostBytes = 1 << 20, const std::stop_token &stop = {})
{
    GuardedResult result{GuardedOutcome::NotStarted, {}};
    const auto receive = [&](std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes)
            result.received += static_cast<char>(byte);
        return result.received.size() <= mostBytes;
    };
    result.outcome = runGuarded(work, receive, kLimits, stop);
    return result;
}

void say(GuardedOutput &output, std::string_view text)
{
    output.write(std::as_bytes(std::span(text)));
}

std::vector<std::int16_t> counts(std::size_t size)
{
    std::vector<std::int16_t> values(size);
    std::iota(values.begin(), values.end(), std::int16_t(-7));
    return values;
}

/// A small file with what readers look at: groups, attributes, contiguous, chunked and compressed
/// samples. The old format has no checksums, so that damage reaches the library.
void writeSmallFile(const std::string &path, bool newest)
{
    const Hdf5TestFile file(path, 0, newest);
    const std::vector<std::int16_t> values = counts(200);
    file.dataset("/g/a", {200}, {H5T_STD_I16LE, {}}, H5T_NATIVE_INT16, values.data());
    file.dataset("/g/b", {200}, {H5T_STD_I16LE, {64}}, H5T_NATIVE_INT16, values.data());
    file.dataset("/g/c", {200}, {H5T_STD_I16LE, {64}, true, 4}, H5T_NATIVE_INT16, values.data());
    file.number("/g/a", "fs", 1e6);
    file.text("/g/a", "units", "V");
}

/// Whether every channel holds what writeSmallFile wrote.
bool isAsWritten(const CaptureSet &set)
{
    const RawSamples expected(counts(200));
    return std::all_of(set.shots[0].channels.begin(), set.shots[0].channels.end(),
        [&](const Channel &channel) { return testing::sameSamples(channel.samples, expected); });
}

} // namespace

class TestHdf5Guarded : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::string path(const char *name = "f.h5") const
    {
        return m_folder.filePath(name).toStdString();
    }

    /// Opens as a user would; error or not, quickly and without bloat.
    Result<CaptureSet> openWithinBounds(const std::string &file) const
    {
        constexpr double kBloat_MiB = 64.0;
        const double before_MiB = peakMemory_MiB();
        QElapsedTimer timer;
        timer.start();
        Result<CaptureSet> set = openCapture(file, {});
        if (timer.elapsed() > kHang_ms || peakMemory_MiB() - before_MiB > kBloat_MiB)
            return fail(ErrorKind::Internal,
                {"took %1 ms and %2 MiB",
                    {std::to_string(timer.elapsed()),
                        std::to_string(peakMemory_MiB() - before_MiB)}});
        return set;
    }

private slots:
    void guarded_work_outputArrives()
    {
        const GuardedResult result = guarded([](GuardedOutput &output) {
            say(output, "one ");
            say(output, std::string(300'000, 'x'));
        });
        QVERIFY(result.outcome == GuardedOutcome::Finished);
        QCOMPARE(result.received, "one " + std::string(300'000, 'x'));
    }

    void guarded_whatGoesWrong_died_data()
    {
        QTest::addColumn<int>("how");
        int how = 0;
        for (const char *name :
            {"segmentation fault", "abort", "division by zero", "exception", "exit code",
                "endless loop", "too much memory", "too much output", "writes a file"})
            QTest::addRow("%s", name) << how++;
    }

    void guarded_whatGoesWrong_died()
    {
        QFETCH(int, how);
        const std::string file = path("written");
        const GuardedResult result = guarded([&](GuardedOutput &output) {
            say(output, "begun");
            switch (how) {
            case 0:
                ::raise(SIGSEGV);
                break;
            case 1:
                std::abort();
            case 2:
                ::raise(SIGFPE);
                break;
            case 3:
                throw std::bad_alloc();
            case 4:
                ::_exit(3);
            case 5:
                for (QElapsedTimer timer;;)
                    timer.start();
            case 6: {
                std::vector<char> much(std::size_t(256) << 20, 'x');
                say(output, std::string_view(much.data(), 1));
                break;
            }
            case 7:
                say(output, std::string(2 << 20, 'x'));
                break;
            default: {
                QFile written(QString::fromStdString(file));
                if (written.open(QIODevice::WriteOnly) && written.write("x") == 1)
                    written.flush();
                if (written.size() == 0)
                    ::_exit(1);
            }
            }
        });
        QVERIFY(result.outcome == GuardedOutcome::Died);
    }

    void guarded_warningToAFile_doesNotEndIt()
    {
        // As the library's, where the program's stderr is a file: the helper may write to none.
        QFile log(m_folder.filePath("log"));
        QVERIFY(log.open(QIODevice::WriteOnly));
        const GuardedResult result = guarded([&](GuardedOutput &output) {
            const bool written = ::write(log.handle(), "warning", 7) == 7;
            say(output, written ? "written" : "not written");
        });
        QVERIFY(result.outcome == GuardedOutcome::Finished);
        QCOMPARE(result.received, std::string("not written"));
    }

    void guarded_workThatMakesProgress_mayTakeLong()
    {
        const GuardedResult result = guarded([](GuardedOutput &output) {
            QElapsedTimer timer;
            timer.start();
            for (qint64 said = 0; timer.elapsed() < 900;) {
                if (timer.elapsed() / 50 > said) {
                    say(output, ".");
                    said = timer.elapsed() / 50;
                }
            }
        });
        QVERIFY(result.outcome == GuardedOutcome::Finished);
    }

    void guarded_requestsToEnd_areTheProgramsToJudge()
    {
        const GuardedResult result = guarded([](GuardedOutput &output) {
            for (const int number : {SIGINT, SIGTERM, SIGHUP})
                ::raise(number);
            say(output, "went on");
        });
        QVERIFY(result.outcome == GuardedOutcome::Finished);
        QCOMPARE(result.received, std::string("went on"));
    }

    void guarded_killedByOthers_isNotTheWorksFault()
    {
        const GuardedResult result = guarded([](GuardedOutput &) { ::raise(SIGKILL); });
        QVERIFY(result.outcome == GuardedOutcome::Killed);
    }

    void guarded_diedWhileStopWasRequested_isStopped()
    {
        std::stop_source stop;
        const auto receive = [&](std::span<const std::byte>) {
            stop.request_stop();
            return false;
        };
        const auto work = [](GuardedOutput &output) { say(output, "unwanted"); };
        QVERIFY(runGuarded(work, receive, kLimits, stop.get_token()) == GuardedOutcome::Stopped);
    }

    void guarded_stopRequested_endsAtOnce()
    {
        std::stop_source stop;
        stop.request_stop();
        QElapsedTimer timer;
        timer.start();
        const GuardedResult result
            = guarded([](GuardedOutput &) { ::pause(); }, 1, stop.get_token());
        QVERIFY(result.outcome == GuardedOutcome::Stopped);
        QVERIFY(timer.elapsed() < kHang_ms);
    }

    void open_filesThatCrashTheLibrary_refusedAtOnce()
    {
        const QString folder = recordingsFolder() + "/hdf5_crashers";
        const QStringList files = QDir(folder).entryList({"*.h5"}, QDir::Files);
        if (files.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("data folder missing: 0 files that crash libhdf5 covered");
        for (const QString &name : files) {
            const std::string file = (folder + "/" + name).toStdString();
            QElapsedTimer timer;
            timer.start();
            for (const auto &read : {openCapture(file, {}), readForeignHdf5(file, {}, {})})
                QCOMPARE(findingId(read), std::string("CAP-018"));
            QCOMPARE(findingId(listDatasets(file)), std::string("CAP-018"));
            qInfo("%s: refused three times in %lld ms", qPrintable(name), timer.elapsed());
            QVERIFY(timer.elapsed() < 3 * kHang_ms);
        }
        qInfo("%d files that crash libhdf5 covered", static_cast<int>(files.size()));
    }

    void open_sparseClaims_refused_data()
    {
        QTest::addColumn<bool>("chunked");
        QTest::addColumn<int>("deflate");
        QTest::newRow("contiguous") << false << 0;
        QTest::newRow("chunked") << true << 0;
        QTest::newRow("compressed") << true << 9;
    }

    void open_sparseClaims_refused()
    {
        QFETCH(bool, chunked);
        QFETCH(int, deflate);
        {
            const Hdf5TestFile file(path());
            StoredAs as{H5T_STD_I16LE, {}};
            if (chunked)
                as.chunk = {1 << 16};
            as.deflate = deflate;
            file.claim("/a", {hsize_t(1) << 46}, as);
            as.chunk = chunked ? std::vector<hsize_t>{1} : std::vector<hsize_t>{};
            file.claim("/b", {1'000'000'000}, as); // as many chunks
        }
        QCOMPARE(findingId(openWithinBounds(path())), std::string("CAP-018"));
    }

    void open_deflateBomb_refused()
    {
        const std::string file = path("bomb.h5");
        const QString script
            = "import sys, h5py\n"
              "f = h5py.File(sys.argv[1], 'w')\n"
              "d = f.create_dataset('a', shape=(2**33,), chunks=(2**22,), dtype='i1', compression=9)\n"
              "import zlib, numpy as np\n"
              "block = zlib.compress(np.zeros(2**22, dtype='i1').tobytes(), 9)\n"
              "for i in range(2**11): d.id.write_direct_chunk((i * 2**22,), block)\n"
              "f.close()\n";
        if (!runPython(script, {QString::fromStdString(file)}))
            QSKIP("no Python with h5py here: deflate bomb of 8 GiB not covered");
        const Result<CaptureSet> set = openWithinBounds(file);
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY2(contains(sentence(set), "import.max_expansion"), sentence(set).c_str());
    }

    void open_manyAttributes_refused()
    {
        {
            const Hdf5TestFile file(path(), 0, true);
            file.dataset("/a", {200}, {H5T_STD_I16LE, {}}, H5T_NATIVE_INT16, counts(200).data());
            for (int i = 0; i < 20'000; ++i)
                file.number("/a", std::string("a").append(std::to_string(i)), i);
        }
        const Result<CaptureSet> set = openWithinBounds(path());
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY2(contains(sentence(set), "attributes"), sentence(set).c_str());
    }

    void open_manyObjects_withinBounds()
    {
        {
            const Hdf5TestFile file(path(), 0, true);
            for (int i = 0; i < 30'000; ++i)
                file.group("/g" + std::to_string(i));
        }
        QVERIFY(!openWithinBounds(path()));
    }

    void open_deepGroups_whatIsNotTooDeepIsRead()
    {
        std::string group;
        {
            const Hdf5TestFile file(path());
            for (int depth = 0; depth < 500; ++depth) {
                group += "/g";
                file.group(group);
                if (depth == 10 || depth == 499)
                    file.dataset(group + "/a", {200}, {H5T_STD_I16LE, {}}, H5T_NATIVE_INT16,
                        counts(200).data());
            }
        }
        const Result<CaptureSet> set = openWithinBounds(path());
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), 1U);
        QVERIFY(isAsWritten(*set));
        QVERIFY(hasFinding(set->findings, "CAP-026"));
    }

    void open_circleOfGroups_readOnce()
    {
        {
            const Hdf5TestFile file(path());
            file.group("/x");
            file.group("/x/y");
            H5Lcreate_hard(file.id(), "/x", file.id(), "/x/y/back", H5P_DEFAULT, H5P_DEFAULT);
            H5Lcreate_hard(file.id(), "/x/y", file.id(), "/x/y/self", H5P_DEFAULT, H5P_DEFAULT);
            file.dataset(
                "/x/y/a", {200}, {H5T_STD_I16LE, {}}, H5T_NATIVE_INT16, counts(200).data());
        }
        const Result<CaptureSet> set = openWithinBounds(path());
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), 1U);
    }

    void open_dataOfOtherFiles_refused()
    {
        const hsize_t size = 100;
        write(m_folder.filePath("secret"), QByteArray(400, 'x'));
        {
            const Hdf5TestFile file(path("source.h5"));
            file.dataset("/a", {200}, {H5T_STD_I16LE, {}}, H5T_NATIVE_INT16, counts(200).data());
        }
        {
            const Hdf5TestFile file(path(), 0, true);
            const hid_t space = H5Screate_simple(1, &size, nullptr);
            const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
            H5Pset_external(external, path("secret").c_str(), 0, 200);
            H5Dclose(H5Dcreate2(
                file.id(), "/external", H5T_STD_I16LE, space, H5P_DEFAULT, external, H5P_DEFAULT));
            const hid_t virtualData = H5Pcreate(H5P_DATASET_CREATE);
            const hsize_t sourceSize = 200;
            const hid_t sourceSpace = H5Screate_simple(1, &sourceSize, nullptr);
            H5Pset_virtual(virtualData, sourceSpace, path("source.h5").c_str(), "/a", sourceSpace);
            H5Dclose(H5Dcreate2(file.id(), "/virtual", H5T_STD_I16LE, sourceSpace, H5P_DEFAULT,
                virtualData, H5P_DEFAULT));
            H5Pclose(external);
            H5Pclose(virtualData);
            H5Sclose(space);
            H5Sclose(sourceSpace);
            H5Lcreate_external(
                path("source.h5").c_str(), "/a", file.id(), "/link", H5P_DEFAULT, H5P_DEFAULT);
        }
        const Result<CaptureSet> set = openWithinBounds(path());
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY2(contains(sentence(set), "lie in another file"), sentence(set).c_str());
    }

    void open_cutAtEveryByte_errorOrWhatWasWritten()
    {
        for (const bool newest : {false, true}) { // the old format makes a longer file
            const int step = newest ? trials::count(4, 1) : trials::count(48, 8);
            writeSmallFile(path("whole.h5"), newest);
            const QByteArray bytes = bytesOf(m_folder.filePath("whole.h5"));
            int read = 0;
            for (int length = 0; length < bytes.size(); length += step) {
                const std::string cut = write(m_folder.filePath("cut.h5"), bytes.left(length));
                const Result<CaptureSet> set = readForeignHdf5(cut, {}, {});
                if (!set)
                    QVERIFY(set.error().kind == ErrorKind::FileUnreadable);
                else
                    QVERIFY2(isAsWritten(*set), qPrintable(QString("cut at %1").arg(length)));
                read += set ? 1 : 0;
            }
            qInfo("%d of %lld cut files read, with the right samples", read, bytes.size() / step);
        }
    }

    void open_countparentSurvives()
    {
        const int count = trials::count(500, 20000);
        writeSmallFile(path("seed.h5"), false);
        const QByteArray seed = bytesOf(m_folder.filePath("seed.h5"));
        std::mt19937 random(20260101);
        int read = 0;
        QElapsedTimer timer;
        qint64 slowest_ms = 0;
        for (int i = 0; i < count; ++i) {
            QByteArray mutant = seed;
            const int changes = 1 + static_cast<int>(random() % 8);
            for (int change = 0; change < changes; ++change) {
                const auto at
                    = static_cast<qsizetype>(random() % static_cast<unsigned>(seed.size()));
                mutant[at] = static_cast<char>(random() % 3 == 0 ? 0xFF : random());
            }
            const std::string file = write(m_folder.filePath("mutant.h5"), mutant);
            timer.start();
            const Result<CaptureSet> set = readForeignHdf5(file, {}, {});
            slowest_ms = std::max(slowest_ms, timer.elapsed());
            if (!set)
                QVERIFY(set.error().kind == ErrorKind::FileUnreadable);
            else
                for (const Channel &channel : set->shots[0].channels)
                    (void)physicalValues(channel, 0, channel.samples.size());
            read += set ? 1 : 0;
        }
        qInfo("%d of %d mutants read; the slowest took %lld ms", read, count, slowest_ms);
        QVERIFY(slowest_ms < 2 * kHang_ms);
    }

    void open_recordings_allReadOrRefused()
    {
        int read = 0;
        int refused = 0;
        QDirIterator files(
            recordingsFolder(), {"*.h5", "*.hdf5"}, QDir::Files, QDirIterator::Subdirectories);
        while (!recordingsFolder().isEmpty() && files.hasNext()) {
            const std::string file = files.next().toStdString();
            const Result<CaptureSet> set = openCapture(file, {});
            if (!set)
                QVERIFY2(set.error().kind == ErrorKind::FileUnreadable, file.c_str());
            (set ? read : refused) += 1;
        }
        if (read + refused == 0)
            DYNCAL_SKIP_WITHOUT_DATA("data folder missing: 0 HDF5 recordings covered");
        qInfo("HDF5 recordings covered: %d read, %d refused", read, refused);
    }
};

DYNCAL_TEST(TestHdf5Guarded)

#include "tst_hdf5_guarded.moc"
