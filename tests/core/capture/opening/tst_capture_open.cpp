// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Several files and folders opened together: what belongs to which file, what is passed over, and
// that nothing that only lies beside recordings hinders them.

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/opening/content_statement.h"
#include "core/capture/opening/format_registry.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"

#include <QElapsedTimer>
#include <QTest>

#include <sys/stat.h>

#include <filesystem>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

/// A capture of so many shots; every sample is `mark`.
std::string capture(
    const ScratchFolder &place, const std::string &name, std::int16_t mark, std::size_t shots = 1)
{
    CaptureSet set;
    for (std::size_t i = 0; i < shots; ++i)
        set.shots.push_back(shotOf(std::vector<std::int16_t>(3, mark)));
    set.tube = {{"name", name}};
    if (!writeHdf5Capture(set, {place.file(name), true}, "2026-01-02T03:04:05Z", "T"))
        qFatal("cannot write %s", name.c_str());
    return place.file(name);
}

std::string put(const ScratchFolder &place, const std::string &name, const std::string &bytes)
{
    fs::create_directories(fs::path(place.file(name)).parent_path());
    return place.write(name, bytes.data(), bytes.size());
}

/// A table that a finding is raised about: its last line lacks a cell.
std::string incompleteTable(const ScratchFolder &place, const std::string &name)
{
    std::string text = "time (s),dut (V)\n";
    for (int i = 0; i < 50; ++i)
        text += std::to_string(i) + "e-6," + std::to_string(i % 5) + ".25\n";
    return put(place, name, text + "50e-6");
}

std::vector<double> marksOf(const CaptureSet &set)
{
    std::vector<double> marks;
    for (const Shot &shot : set.shots)
        marks.push_back(shot.channels.at(0).samples.at(0));
    return marks;
}

} // namespace

class TestCaptureOpen : public QObject
{
    Q_OBJECT

private slots:
    void shots_keepTheirFilesWhateverTheOrder()
    {
        const ScratchFolder place;
        std::vector<std::string> paths{capture(place, "a.h5", 1, 2), capture(place, "b.h5", 2, 1),
            capture(place, "c.h5", 3, 3)};
        const std::map<std::string, std::pair<double, Index>> held{
            {"a.h5", {1, 2}}, {"b.h5", {2, 1}}, {"c.h5", {3, 3}}};
        do {
            const Result<CaptureSet> set = openCaptures(paths, {});
            QVERIFY2(set, sentence(set).c_str());
            QCOMPARE(set->inputs.size(), std::size_t(3));
            std::size_t shot = 0;
            for (std::size_t input = 0; input < 3; ++input) {
                QCOMPARE(set->inputs[input].path, paths[input]);
                const auto [mark, shots] = held.at(set->inputs[input].file);
                for (Index number = 1; number <= shots; ++number, ++shot) {
                    QCOMPARE(set->shots.at(shot).input, static_cast<Index>(input));
                    QCOMPARE(set->shots[shot].inFile, number);
                    QCOMPARE(set->shots[shot].channels[0].samples.at(2), mark);
                }
            }
            QCOMPARE(shot, set->shots.size());
            QCOMPARE(set->tube.at("name"), set->inputs[0].file); // the first that says it counts
        } while (std::next_permutation(paths.begin(), paths.end()));
    }

    void findings_areOfTheShotTheyAreRaisedAbout()
    {
        const ScratchFolder place;
        const std::string many = capture(place, "many.h5", 1, 4);
        const std::string table = incompleteTable(place, "table.csv");
        const Result<CaptureSet> alone = openCaptures({table}, {});
        QVERIFY2(alone, sentence(alone).c_str());
        QVERIFY(!alone->findings.empty());
        const Result<CaptureSet> both = openCaptures({many, table, many, table}, {});
        QVERIFY2(both, sentence(both).c_str());
        const std::size_t each = alone->findings.size();
        QCOMPARE(both->findings.size(), 2 * each);
        for (std::size_t i = 0; i < 2 * each; ++i) {
            const Finding &one = alone->findings[i % each];
            const Index before = i < each ? 4 : 9;
            QCOMPARE(both->findings[i].id, one.id);
            QCOMPARE(both->findings[i].shot, one.shot == 0 ? Index(0) : one.shot + before);
        }
    }

    /// A pipe in the folder would be waited for, a circle of links walked for ever.
    void whatElseLiesInAFolder_isPassedOver()
    {
        const ScratchFolder place;
        fs::create_directory(place.file("in"));
        capture(place, "in/shot2.h5", 2);
        capture(place, "in/shot10.h5", 10);
        fs::create_symlink("shot2.h5", place.file("in/shot3.h5"));
        const Result<CaptureSet> plain = openCaptures({place.file("in")}, {});
        QVERIFY2(plain, sentence(plain).c_str());
        QCOMPARE(marksOf(*plain), (std::vector<double>{2, 2, 10}));
        QVERIFY(plain->findings.empty());
        QCOMPARE(::mkfifo(place.file("in/pipe.h5").c_str(), 0600), 0);
        fs::create_symlink("nowhere.h5", place.file("in/shot4.h5"));
        fs::create_symlink("circle.h5", place.file("in/circle.h5"));
        fs::create_directory_symlink(".", place.file("in/again"));
        capture(place, "deeper.h5", 5);
        fs::create_directory(place.file("in/below"));
        fs::rename(place.file("deeper.h5"), place.file("in/below/shot5.h5"));
        put(place, "in/.hidden.h5", "%PDF");
        put(place, "in/shot2.tdms_index", "TDSh");
        QElapsedTimer timer;
        timer.start();
        const Result<CaptureSet> set = openCaptures({place.file("in")}, {});
        QVERIFY(timer.elapsed() < 5000);
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(marksOf(*set), marksOf(*plain));
        QVERIFY(set->findings.empty());
    }

    void namedThings_areReadOrSaid()
    {
        const ScratchFolder place;
        const std::string good = capture(place, "good.h5", 1);
        fs::create_directory(place.file("empty"));
        QCOMPARE(::mkfifo(place.file("pipe.h5").c_str(), 0600), 0);
        fs::create_symlink("nowhere", place.file("dangling.h5"));
        for (const std::string &bad : {place.file("pipe.h5"), place.file("dangling.h5"),
                 place.file("none.h5"), std::string()}) {
            const Result<CaptureSet> set = openCaptures({good, bad}, {});
            QVERIFY2(!set && set.error().kind == ErrorKind::FileUnreadable, bad.c_str());
            QVERIFY(contains(sentence(set), bad));
        }
        const Result<CaptureSet> set = openCaptures({place.file("empty"), good}, {});
        QVERIFY2(set, sentence(set).c_str()); // an empty folder adds nothing
        QCOMPARE(marksOf(*set), std::vector<double>{1});
    }

    void closedFilesAndFolders_areSaid()
    {
        const ScratchFolder place;
        QCOMPARE(::chmod(place.file("").c_str(), 0755), 0);
        fs::create_directory(place.file("closed"));
        const std::string shut = capture(place, "shut.h5", 1);
        const std::string good = capture(place, "good.h5", 1);
        QCOMPARE(::chmod(good.c_str(), 0644), 0);
        QCOMPARE(::chmod(shut.c_str(), 0), 0);
        QCOMPARE(::chmod(place.file("closed").c_str(), 0), 0);
        constexpr uid_t kNobody = 65534;
        QCOMPARE(exitCodeOf([&] {
            if (::geteuid() == 0 && ::setuid(kNobody) != 0)
                return 1;
            for (const std::string &path : {shut, place.file("closed")}) {
                const Result<CaptureSet> set = openCaptures({good, path}, {});
                if (set || findingId(set) != "CAP-018" || !contains(sentence(set), path))
                    return 2;
            }
            return openCaptures({good}, {}) ? 7 : 3;
        }),
            7);
        QCOMPARE(::chmod(place.file("closed").c_str(), 0755), 0);
    }

    void formatThatIsNamed_isTriedWhateverTheFileLooksLike()
    {
        const ScratchFolder place;
        const std::string good = capture(place, "good.h5", 1);
        for (const CaptureFormat &format : captureFormats()) {
            ImportSettings settings;
            settings.format = format.id;
            const auto found = formatOf(good, settings);
            QVERIFY(found && (*found)->id == format.id);
            const Result<CaptureSet> set = openCapture(good, settings);
            const bool isOwn = format.id == "dyncal-capture";
            QVERIFY2(!isOwn || set, format.id.c_str());
            QVERIFY2(set || set.error().kind == ErrorKind::FileUnreadable, format.id.c_str());
        }
        ImportSettings own; // what one file has of its own wins over what all have
        own.format = "wav";
        own.files["good.h5"].format = "dyncal-capture";
        QVERIFY(openCapture(good, own));
    }

    /// One file on which the library fails must not take the answers about the others with it.
    void statedHashes_areThoseOfTheirFiles()
    {
        const ScratchFolder place;
        const std::string first = capture(place, "first.h5", 1);
        const std::string second = capture(place, "second.h5", 2);
        const std::string bytes = contentOf(first);
        const std::string cut = put(place, "cut.h5", bytes.substr(0, bytes.size() / 3));
        const std::string text = put(place, "text.h5", "no HDF5");
        const PythonAnswer answer = python({"-c",
            "import h5py, sys\nfor p in sys.argv[1:]: print(h5py.File(p).attrs['content_sha256'])",
            QString::fromStdString(first), QString::fromStdString(second)});
        QVERIFY2(answer.ran, answer.err.constData());
        const std::string one = answer.out.split('\n')[0].toStdString();
        const std::string two = answer.out.split('\n')[1].toStdString();
        QVERIFY(isSha256Hex(one) && isSha256Hex(two) && one != two);
        const std::map<std::string, std::string> stated{{first, one}, {second, two}, {cut, ""},
            {text, ""}, {place.file("none.h5"), ""}, {place.file(""), ""}};
        std::vector<std::string> paths;
        for (int round = 0; round < 3; ++round)
            for (const auto &[path, hash] : stated)
                paths.insert(paths.begin() + std::ssize(paths) / 2, path);
        const std::vector<std::string> hashes = statedContentHashes(paths).value();
        QCOMPARE(hashes.size(), paths.size());
        for (std::size_t i = 0; i < paths.size(); ++i)
            QCOMPARE(hashes[i], stated.at(paths[i]));
        QVERIFY(statedContentHashes({}).value().empty());
    }
};

DYNCAL_TEST(TestCaptureOpen)
#include "tst_capture_open.moc"
