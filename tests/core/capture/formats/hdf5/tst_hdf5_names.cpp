// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Captures with every kind of name and note: what is written is what is read, or it is refused.

#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/formats/hdf5/hdf5_content.h"
#include "core/capture/formats/hdf5/hdf5_create.h"
#include "core/capture/formats/hdf5/hdf5_open.h"
#include "core/capture/formats/hdf5/hdf5_scribe.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"

#include <QTest>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const std::string kCreated = "2026-01-02T03:04:05Z";

/// Names that files of other programs bring along, and that HDF5 has uses of its own for.
std::vector<std::string> oddNames()
{
    return {"", ".", "..", "/", "a/b", "a|b", "a|b (2)", "/a", "a/", "unnamed", "unnamed (2)",
        "a\nb", " ", "  a", "\xC3\xA5\xE2\x84\x96", "\xff\xfe", "%1", "\"", "\\",
        std::string("a\0b", 3), std::string(300, 'n'), std::string(5000, '/')};
}

/// As text() keeps it: HDF5 ends texts at a zero.
std::string withoutZeros(std::string text)
{
    std::ranges::replace(text, '\0', '|');
    return text;
}

Shot oneShot()
{
    return shotOf(std::vector<std::int16_t>{1, 2, 3});
}

} // namespace

class TestHdf5Names : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;

    Result<CaptureSet> again(const CaptureSet &set, const char *name = "set.h5") const
    {
        const std::string path = m_folder.file(name);
        return writeHdf5Capture(set, {path, true}, kCreated, "T").and_then([&] {
            return readHdf5Capture(path, {}, {});
        });
    }

private slots:
    void channels_ofAnyNames_comeBackInTheirOrder()
    {
        std::vector<std::string> names = oddNames();
        const std::vector<std::string> twice = names;
        names.insert(names.end(), twice.begin(), twice.end());
        std::mt19937 random(3);
        for (int trial = 0; trial < 5; ++trial) {
            std::shuffle(names.begin(), names.end(), random);
            CaptureSet set;
            set.shots = {oneShot()};
            set.shots[0].channels.resize(names.size(), set.shots[0].channels[0]);
            for (std::size_t i = 0; i < names.size(); ++i) {
                set.shots[0].channels[i].name = names[i];
                set.shots[0].channels[i].samples
                    = RawSamples(std::vector<std::int16_t>{static_cast<std::int16_t>(i)});
            }
            const Result<CaptureSet> read = again(set);
            QVERIFY2(read, sentence(read).c_str());
            QVERIFY(read->findings.empty());
            QCOMPARE(read->shots[0].channels.size(), names.size());
            for (std::size_t i = 0; i < names.size(); ++i) {
                QCOMPARE(read->shots[0].channels[i].name, withoutZeros(names[i]));
                QCOMPARE(read->shots[0].channels[i].samples.at(0), static_cast<double>(i));
            }
        }
    }

    /// A calibration is of one sensor: another one's serial number on the certificate is a fault
    /// that nobody could see.
    void sensors_ofSimilarNames_areNotMistakenForEachOther()
    {
        CaptureSet set;
        set.shots = {oneShot()};
        const std::vector<std::string> names = oddNames();
        set.shots[0].channels.resize(names.size(), set.shots[0].channels[0]);
        for (std::size_t i = 0; i < names.size(); ++i) {
            set.shots[0].channels[i].name = std::string("channel ").append(std::to_string(i));
            set.shots[0].channels[i].sensorId = names[i];
            if (!names[i].empty()) // no sensor
                set.sensors[names[i]] = {{"serial", std::string("S").append(std::to_string(i))}};
        }
        const Result<CaptureSet> read = again(set);
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->sensors.size(), set.sensors.size());
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::string id = read->shots[0].channels[i].sensorId;
            if (names[i].empty())
                QCOMPARE(id, std::string());
            else
                QCOMPARE(
                    read->sensors.at(id).at("serial"), std::string("S").append(std::to_string(i)));
        }
    }

    void sensorThatIsNotListed_keepsItsName()
    {
        CaptureSet set;
        set.shots = {oneShot()};
        set.shots[0].channels[0].sensorId = "PCB 113B";
        const Result<CaptureSet> read = again(set);
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->shots[0].channels[0].sensorId, std::string("PCB 113B"));
    }

    void texts_ofAnyKind_comeBack()
    {
        for (const std::string &text : oddNames()) {
            CaptureSet set;
            set.shots = {oneShot()};
            set.shots[0].label = text;
            set.shots[0].excludeReason = text;
            set.shots[0].channels[0].unit = text;
            set.shots[0].channels[0].quantity = text;
            set.shots[0].notes["comment"] = text.empty() ? "-" : text;
            const Result<CaptureSet> read = again(set);
            QVERIFY2(read, sentence(read).c_str());
            const Shot &shot = read->shots[0];
            QCOMPARE(shot.label, withoutZeros(text));
            QCOMPARE(shot.excludeReason, withoutZeros(text));
            QCOMPARE(shot.channels[0].unit, withoutZeros(text));
            QCOMPARE(shot.channels[0].quantity, withoutZeros(text));
            QCOMPARE(shot.notes.at("comment"), text.empty() ? "-" : withoutZeros(text));
        }
        CaptureSet large;
        large.shots = {oneShot()};
        large.shots[0].notes["comment"] = std::string(3 << 20, 'c'); // more than an object's header
        const Result<CaptureSet> read = again(large);
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->shots[0].notes.at("comment").size(), std::size_t(3 << 20));
    }

    /// Written, read and written again nothing changes any more.
    void notes_thatLookLikeNumbers_keepTheirValue()
    {
        const std::vector<std::string> values{"0", "-0", "1.50", "1e3", "1e-320", "007", "0x10",
            "1,5", "+5", " 5", "5 ", "1e999", "inf", "nan", "NaN", "12345678901234567890", "1_000",
            "1.", ".5", "2026-01-01", "", "true"};
        CaptureSet set;
        set.shots = {oneShot()};
        for (std::size_t i = 0; i < values.size(); ++i) {
            set.tube[std::string("tube ").append(std::to_string(i))] = values[i];
            set.sensors["s"]["serial"] = "007";
            set.sensors["s"][std::string("key ").append(std::to_string(i))] = values[i];
        }
        const Result<CaptureSet> read = again(set);
        QVERIFY2(read, sentence(read).c_str());
        for (const auto &[key, value] : set.tube) {
            const auto number = parseNumber(value);
            if (number && std::isnan(*number)) // says that nothing was recorded
                continue;
            QVERIFY2(read->tube.contains(key), value.c_str());
            QVERIFY2(
                number ? parseNumber(read->tube.at(key)) == number : read->tube.at(key) == value,
                value.c_str());
        }
        QCOMPARE(read->sensors.at("s").at("serial"), std::string("007"));
        const Result<CaptureSet> twice = again(*read);
        QVERIFY(twice && twice->tube == read->tube && twice->sensors == read->sensors);
    }

    void thousandsOfShots_stayInOrder()
    {
        CaptureSet set;
        for (int i = 0; i < 1100; ++i) {
            set.shots.push_back(oneShot());
            set.shots.back().label = std::string("shot ").append(std::to_string(i));
        }
        const Result<CaptureSet> read = again(set);
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->shots.size(), std::size_t(1100));
        for (std::size_t i = 0; i < 1100; ++i)
            QCOMPARE(read->shots[i].label, set.shots[i].label);
    }

    /// The hashes are of what the scribe says it wrote: it must be what a reader finds.
    void whatTheScribeSays_isWhatTheFileHolds()
    {
        const std::string path = m_folder.file("scribe.h5");
        Hdf5Tree said;
        {
            silenceHdf5();
            Hdf5Handle file = createFile(path);
            Hdf5Scribe root(file.id(), said);
            Hdf5Scribe top = root.group("top");
            Hdf5Scribe group = top.group("b");
            Hdf5Scribe first = top.group("a"); // in the order of creation
            Hdf5Scribe empty = group.dataset("none", RawSamples(std::vector<float>()));
            for (const std::string &text : oddNames())
                QVERIFY(first.text(std::string("t").append(sha256Hex(text)), text));
            QVERIFY(
                group.number("nan", kNan) && group.number("-0", -0.0) && group.integer("i", -7));
            QVERIFY(
                group.byte("y", 1) && group.numbers("n", {1.0, 2.5}) && group.integers("m", {3}));
            QVERIFY(group.attributes({{"serial", "007"}, {"x", "1e3"}, {"y z", "w"}}));
            QVERIFY(!group.number("i", 1.0)); // it is there already
            QVERIFY(!top.group("a").valid() && !top.group("").valid());
            said.objects[1].links.resize(2); // without the two that were refused
            said.objects[2].attributes["i"] = {Hdf5ValueKind::Numbers, {}, {-7.0}};
            QVERIFY(empty.close() && group.close() && first.close() && top.close() && root.close()
                && file.close());
        }
        const Result<Hdf5File> read = openHdf5(path, kUsualExpansion, {});
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(contentList(read->tree), contentList(said));
        QCOMPARE(objectAt(read->tree, "/top")->links.at(0).name, std::string("b"));
        QVERIFY(textAttribute(*objectAt(read->tree, "/top/b"), "serial") == "007");
    }
};

DYNCAL_TEST(TestHdf5Names)
#include "tst_hdf5_names.moc"
