// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Files under adverse conditions, and hashes and numbers as Python reads them.

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/base/writing/atomic_file.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

using namespace dyncal;
using dyncal::testing::contentOf;
using dyncal::testing::python;
using dyncal::testing::ScratchFolder;
namespace fs = std::filesystem;

namespace {

std::size_t filesBeside(const std::string &path)
{
    const fs::directory_iterator folder(fs::path(path).parent_path());
    return static_cast<std::size_t>(std::distance(fs::begin(folder), fs::end(folder)));
}

bool isBeingWritten(const Error &error)
{
    return error.kind == ErrorKind::Usage
        && english(error.message).find("is being written by another program") != std::string::npos;
}

/// No file of this process may grow beyond `bytes` meanwhile, as if the disk were full.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes)
        : m_signal(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk &) = delete;
    FullDisk &operator=(const FullDisk &) = delete;
    ~FullDisk()
    {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_signal);
    }

private:
    void (*m_signal)(int);
    rlimit m_before{};
};

/// Doubles of every size, and those at the edges.
std::vector<double> manyNumbers()
{
    std::vector<double> values{0.0, -0.0, 0.1, 1.0 / 3.0, 1e22, 1e23, 5e-324,
        2.2250738585072014e-308, 1.7976931348623157e308, 9007199254740993.0, 123456789012345678.0,
        1e15, 999999999999999.9, 1e-4, 9.9999999999999999e-5, 0.00012345};
    std::mt19937_64 bits(7);
    while (values.size() < 3000) {
        const double value = std::bit_cast<double>(bits());
        if (std::isfinite(value))
            values.push_back(value);
        values.push_back(std::ldexp(static_cast<double>(bits() % 2000000) - 1e6, -10));
    }
    return values;
}

} // namespace

class TestFilesAndText : public QObject
{
    Q_OBJECT

private slots:
    void fullDisk_leavesTheOldFileAndNothingElse();
    void folderWithoutPermission_isAUsageErrorThatNamesThePath();
    void namesOfEveryKind_areWrittenAsTheyAre();
    void namesThatAreNone_areRefused();
    void links_areReplacedAndTheirTargetsKept();
    void readers_seeOneWholeFileAlways();
    void writersAtOnce_oneWritesAndTheOthersAreTold();
    void hash_inPieces_isThatOfTheWhole();
    void hashOfAFile_tellsHowFarAndStops();
    void numbers_arePythonsNumbers();
    void numbersWithUnit_keepTheirValue();
};

void TestFilesAndText::fullDisk_leavesTheOldFileAndNothingElse()
{
    const ScratchFolder folder;
    const std::string path = folder.file("results.json");
    QVERIFY(writeFileAtomically(path, "old").has_value());
    for (const bool isThere : {true, false}) {
        const std::string target = isThere ? path : folder.file("new.json");
        const FullDisk full(1000);
        const auto done = writeFileAtomically(target, std::string(5000, 'x'));
        QVERIFY(!done);
        QCOMPARE(done.error().kind, ErrorKind::Internal);
        QVERIFY(english(done.error().message).starts_with(target + " cannot be written: "));
    }
    QCOMPARE(contentOf(path), std::string("old"));
    QCOMPARE(filesBeside(path), std::size_t(1));
    QVERIFY(writeFileAtomically(path, std::string(5000, 'x')).has_value()); // room again
}

void TestFilesAndText::folderWithoutPermission_isAUsageErrorThatNamesThePath()
{
    const ScratchFolder folder;
    const std::string path = folder.file("results.json");
    QVERIFY(writeFileAtomically(path, "old").has_value());
    fs::permissions(fs::path(path).parent_path(), fs::perms::owner_read | fs::perms::owner_exec);
    const uid_t who = ::geteuid();
    constexpr uid_t kNobody = 65534;
    if (who == 0)
        QCOMPARE(::seteuid(kNobody), 0); // whom permissions hold back
    const auto done = writeFileAtomically(path, "new");
    if (who == 0)
        QCOMPARE(::seteuid(who), 0);
    fs::permissions(fs::path(path).parent_path(), fs::perms::owner_all);
    QVERIFY(!done);
    QCOMPARE(done.error().kind, ErrorKind::Usage);
    QVERIFY(english(done.error().message).starts_with(path + " cannot be written: "));
    QCOMPARE(contentOf(path), std::string("old"));
    QCOMPARE(filesBeside(path), std::size_t(1));
}

void TestFilesAndText::namesOfEveryKind_areWrittenAsTheyAre()
{
    const ScratchFolder folder;
    for (const char *name : {"Åsa Ström.json", "日本", "a b\tc\nd", "-rf", "x.part-1-0", "%1 %n",
             "\xFF\xFE" /* no UTF-8 */, "..."}) {
        const std::string path = folder.file(name);
        QVERIFY2(writeFileAtomically(path, name).has_value(), name);
        QCOMPARE(contentOf(path), std::string(name));
    }
    QCOMPARE(filesBeside(folder.file("x")), std::size_t(8));
    QVERIFY(writeFileAtomically(folder.file("empty"), "").has_value());
    QCOMPARE(contentOf(folder.file("empty")), std::string());
}

void TestFilesAndText::namesThatAreNone_areRefused()
{
    const ScratchFolder folder;
    const std::string file = folder.file("file");
    QVERIFY(writeFileAtomically(file, "old").has_value());
    for (const std::string &path : {std::string(), std::string("/"), folder.file(""), file + "/",
             file + "/below", folder.file(std::string(300, 'x')), std::string(10000, '/') + "x"}) {
        const auto done = writeFileAtomically(path, "new");
        QVERIFY2(!done || path.size() == 10001, path.c_str()); // the last is /x of many slashes
        if (!done)
            QVERIFY2(done.error().kind == ErrorKind::Usage, path.c_str());
    }
    QCOMPARE(contentOf(file), std::string("old"));
    QCOMPARE(filesBeside(file), std::size_t(1));
}

void TestFilesAndText::links_areReplacedAndTheirTargetsKept()
{
    const ScratchFolder folder;
    const std::string target = folder.file("target");
    QVERIFY(writeFileAtomically(target, "kept").has_value());
    fs::create_symlink(target, folder.file("soft"));
    fs::create_symlink(folder.file("nowhere"), folder.file("dangling"));
    fs::create_hard_link(target, folder.file("hard"));
    for (const char *link : {"soft", "dangling", "hard"}) {
        QVERIFY2(writeFileAtomically(folder.file(link), "new").has_value(), link);
        QCOMPARE(contentOf(folder.file(link)), std::string("new"));
        QVERIFY(!fs::is_symlink(folder.file(link)));
    }
    QCOMPARE(contentOf(target), std::string("kept"));
    QVERIFY(!fs::exists(folder.file("nowhere")));
    fs::create_directory_symlink(fs::path(target).parent_path(), folder.file("folder"));
    QVERIFY(!writeFileAtomically(folder.file("folder"), "new"));
}

void TestFilesAndText::readers_seeOneWholeFileAlways()
{
    constexpr std::size_t kSize = 200000;
    const ScratchFolder folder;
    const std::string path = folder.file("busy");
    QVERIFY(writeFileAtomically(path, std::string(kSize, 'a')).has_value());
    std::atomic<bool> ended = false, wasTorn = false;
    std::jthread reader([&] {
        while (!ended) {
            const std::string seen = contentOf(path);
            if (seen.size() != kSize || seen.find_first_not_of(seen[0]) != std::string::npos)
                wasTorn = true;
        }
    });
    for (int i = 0; i < 100; ++i)
        QVERIFY(writeFileAtomically(path, std::string(kSize, i % 2 ? 'a' : 'b')).has_value());
    ended = true;
    reader.join();
    QVERIFY(!wasTorn);
}

void TestFilesAndText::writersAtOnce_oneWritesAndTheOthersAreTold()
{
    constexpr std::size_t kSize = 100000;
    const ScratchFolder folder;
    const std::string path = folder.file("busy");
    std::atomic<int> written = 0, failed = 0;
    {
        std::vector<std::jthread> writers;
        for (char letter = 'a'; letter < 'i'; ++letter)
            writers.emplace_back([&, letter] {
                for (int i = 0; i < 20; ++i) {
                    const auto done = writeFileAtomically(path, std::string(kSize, letter));
                    written += done ? 1 : 0;
                    failed += done || isBeingWritten(done.error()) ? 0 : 1;
                }
            });
    }
    QVERIFY(written > 0);
    QCOMPARE(failed.load(), 0); // whoever does not write is told that somebody else does
    const std::string last = contentOf(path);
    QVERIFY(last.size() == kSize && last.find_first_not_of(last[0]) == std::string::npos);
    QCOMPARE(filesBeside(path), std::size_t(1));
}

void TestFilesAndText::hash_inPieces_isThatOfTheWhole()
{
    std::string bytes(100003, '\0');
    std::mt19937_64 random(3);
    for (char &byte : bytes)
        byte = static_cast<char>(random());
    const std::string whole = sha256Hex(bytes);
    const auto all = std::as_bytes(std::span(bytes.data(), bytes.size()));
    for (const std::size_t piece : {1U, 63U, 64U, 65U, 4096U, 99999U}) {
        Sha256 hash;
        for (std::size_t at = 0; at < all.size(); at += piece)
            hash.add(all.subspan(at, std::min(piece, all.size() - at)));
        hash.add({});
        QCOMPARE(hash.hex(), whole);
    }
    bytes[50000] = static_cast<char>(bytes[50000] ^ 1); // one bit
    QVERIFY(sha256Hex(bytes) != whole);
    const ScratchFolder folder;
    const std::string path = folder.write("bytes", bytes.data(), bytes.size());
    const auto answer = python({"-c",
        "import hashlib, sys; print(hashlib.sha256(open(sys.argv[1], 'rb').read()).hexdigest())",
        QString::fromStdString(path)});
    QVERIFY(answer.ran);
    QCOMPARE(sha256OfFile(path), answer.out.trimmed().toStdString());
}

void TestFilesAndText::hashOfAFile_tellsHowFarAndStops()
{
    const ScratchFolder folder;
    const std::string bytes((3 << 20) + 5, 'x');
    const std::string path = folder.write("bytes", bytes.data(), bytes.size());
    std::vector<std::uintmax_t> told;
    const auto tell = [&](std::uintmax_t done) {
        told.push_back(done);
        return true;
    };
    QCOMPARE(sha256OfFile(path, tell), sha256Hex(bytes));
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    QCOMPARE(told.back(), static_cast<std::uintmax_t>(bytes.size()));
    int asked = 0;
    QVERIFY(sha256OfFile(path, [&](std::uintmax_t) { return ++asked < 2; }).empty());
    QCOMPARE(asked, 2);
    const std::string empty = folder.write("empty", "", 0);
    QCOMPARE(sha256OfFile(empty), sha256Hex(std::string_view()));
}

/// Python reads every text as the same number, has no shorter one, and rounds to digits alike.
void TestFilesAndText::numbers_arePythonsNumbers()
{
    const std::vector<double> values = manyNumbers();
    std::string table;
    for (const double value : values) {
        char hex[64];
        std::snprintf(hex, sizeof hex, "%a", value);
        table.append(hex).append(" ").append(numberText(value));
        for (const int digits : {1, 3, 6, 17})
            table.append(" ").append(numberText(value, digits));
        table += '\n';
    }
    const ScratchFolder folder;
    const std::string path = folder.write("numbers", table.data(), table.size());
    const auto answer = python({"-c", R"py(
import sys
for line in open(sys.argv[1]):
    exact, shortest, *rounded = line.split()
    x = float.fromhex(exact)
    if float(shortest) != x or len(shortest) > len(repr(x)):
        print('shortest', line)
    for n, text in zip((1, 3, 6, 17), rounded):
        if float(text) != float('%.*e' % (n - 1, x)):
            print(n, 'digits', line)
        if 1e-4 <= abs(float(text)) < 1e15 and 'e' in text:
            print('exponent', line)
)py",
        QString::fromStdString(path)});
    QVERIFY2(answer.ran, answer.err.constData());
    QCOMPARE(answer.out, QByteArray());
}

void TestFilesAndText::numbersWithUnit_keepTheirValue()
{
    const std::map<QString, double> prefixes{{"G", 1e9}, {"M", 1e6}, {"k", 1e3}, {"", 1.0},
        {"m", 1e-3}, {"\u00B5", 1e-6}, {"n", 1e-9}, {"p", 1e-12}, {"f", 1e-15}};
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> exponent(-15.0, 11.9);
    for (int i = 0; i < 20000; ++i) {
        const double value = (i % 2 ? -1.0 : 1.0) * std::pow(10.0, exponent(random));
        const int digits = 1 + i % 8;
        const QStringList words
            = QString::fromStdString(numberWithUnit(value, "Hz", digits)).split(' ');
        QCOMPARE(words.size(), qsizetype(2));
        const double shown = words[0].toDouble() * prefixes.at(words[1].chopped(2));
        QVERIFY2(std::abs(shown / value - 1.0) <= 0.5 * std::pow(10.0, 1 - digits) * (1.0 + 1e-9),
            qPrintable(words.join(' ')));
        if (digits >= 3) // 1 to 999 before the prefix
            QVERIFY2(std::abs(words[0].toDouble()) < 1000.0 && std::abs(words[0].toDouble()) >= 1.0,
                qPrintable(words.join(' ')));
    }
}

DYNCAL_TEST(TestFilesAndText)
#include "tst_files_and_text.moc"
