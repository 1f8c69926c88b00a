// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/same_samples.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"

#include <QTemporaryDir>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const std::string kCreated = "2026-01-02T03:04:05Z";
constexpr rlim_t kWholeFile = 420'000; ///< more than the file of setToWrite() needs

CaptureSet setToWrite()
{
    CaptureSet set;
    set.shots = {shotOf(std::vector<std::int16_t>(100'000, 77)),
        shotOf(std::vector<std::int16_t>(100'000, -77))};
    return set;
}

/// What a writer left behind; the exit codes of the child below.
enum Outcome { kAsItShouldBe = 0, kWritten = 10, kOtherError, kOldFileChanged, kTemporaryLeft };

/// Files cannot grow beyond `bytes`: writes past that fail as on a full disk.
void limitFileSize(rlim_t bytes)
{
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

Outcome outcomeOfFailure(
    const Result<void> &done, const std::string &path, const std::string &oldHash)
{
    if (done)
        return kWritten;
    if (done.error().kind != ErrorKind::Internal && done.error().kind != ErrorKind::Usage)
        return kOtherError;
    if (sha256OfFile(path) != oldHash)
        return kOldFileChanged;
    const std::filesystem::directory_iterator folder(std::filesystem::path(path).parent_path());
    return std::any_of(std::filesystem::begin(folder), std::filesystem::end(folder),
               [](const auto &entry) {
                   return entry.path().filename().string().starts_with(".dyncal-");
               })
        ? kTemporaryLeft
        : kAsItShouldBe;
}

} // namespace

/// A limit on the size of files stands for the full disk: it fails the same writes with the same
/// consequences inside libhdf5, and needs no file system of its own. Every attempt is made in a
/// process of its own, which must also end as usual: the library used to crash at exit.
class TestHdf5FullDisk : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::string path(const char *name) const { return m_folder.filePath(name).toStdString(); }

private slots:
    void write_diskFullAtAnyPoint_oldFileStaysAndProcessEndsAsUsual()
    {
        CaptureSet old;
        old.shots = {shotOf(std::vector<std::int16_t>{1, 2, 3})};
        const std::string target = path("full.h5");
        QVERIFY(writeHdf5Capture(old, {target, true}, kCreated, ""));
        const std::string oldHash = sha256OfFile(target);
        const CaptureSet set = setToWrite();
        std::vector<rlim_t> sizes{0, 1, 7, 8, 47, 48, 95, 96, 511, 512, 1023, 1024, 2047, 2048};
        for (rlim_t bytes = 4096; bytes < 400'000; bytes += 9973)
            sizes.push_back(bytes);
        for (const rlim_t bytes : sizes) {
            const int code = exitCodeOf([&] {
                limitFileSize(bytes);
                return outcomeOfFailure(
                    writeHdf5Capture(set, {target, true}, kCreated, ""), target, oldHash);
            });
            QVERIFY2(code == kAsItShouldBe,
                qPrintable(QString("limit of %1 bytes: %2").arg(bytes).arg(code)));
        }
        QVERIFY(writeHdf5Capture(set, {target, true}, kCreated, ""));
        QVERIFY(std::filesystem::file_size(target) > 400'000);
        QVERIFY(std::filesystem::file_size(target) < kWholeFile);
    }

    void write_spaceComesBack_sameProcessWritesTheFile()
    {
        const std::string target = path("again.h5");
        const int code = exitCodeOf([&] {
            for (const rlim_t bytes : {rlim_t(0), rlim_t(3000), rlim_t(150'000)}) {
                limitFileSize(bytes);
                if (writeHdf5Capture(setToWrite(), {target, true}, kCreated, ""))
                    return int(kWritten);
            }
            limitFileSize(kWholeFile);
            const Result<void> done = writeHdf5Capture(setToWrite(), {target, true}, kCreated, "");
            return int(done ? kAsItShouldBe : kOtherError);
        });
        QCOMPARE(code, int(kAsItShouldBe));
        const Result<CaptureSet> read = readHdf5Capture(target, {}, {});
        QVERIFY2(read, sentence(read).c_str());
        QVERIFY(testing::sameSamples(
            read->shots[1].channels[0].samples, setToWrite().shots[1].channels[0].samples));
    }

    void write_overAnything_onlyWhereReplacingIsAskedFor()
    {
        const std::string target = path("taken.h5");
        QVERIFY(writeHdf5Capture(setToWrite(), {target}, kCreated, ""));
        const std::string hash = sha256OfFile(target);
        const Result<void> again = writeHdf5Capture(setToWrite(), {target}, kCreated, "other");
        QVERIFY(!again);
        QCOMPARE(again.error().kind, ErrorKind::Usage);
        QVERIFY2(english(again.error().message).starts_with(target + " exists already"),
            english(again.error().message).c_str());
        QCOMPARE(sha256OfFile(target), hash);
        QVERIFY(writeHdf5Capture(setToWrite(), {target, true}, kCreated, "other"));
        QVERIFY(sha256OfFile(target) != hash);
    }

    void write_whatLiesBesideUnderOldTemporaryNames_isNotTouched()
    {
        const std::string target = path("beside.h5");
        const std::string precious = path("precious");
        std::ofstream(precious) << "precious";
        std::filesystem::create_symlink(precious, target + ".part");
        QVERIFY(writeHdf5Capture(setToWrite(), {target}, kCreated, ""));
        QVERIFY(std::filesystem::is_symlink(target + ".part"));
        QCOMPARE(std::filesystem::file_size(precious), std::uintmax_t(8));
    }
};

DYNCAL_TEST(TestHdf5FullDisk)

#include "tst_hdf5_full_disk.moc"
