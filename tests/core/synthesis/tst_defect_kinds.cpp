// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/defect_kinds.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "tests/core/synthesis/simulated_defect.h"

#include <QFile>
#include <QTest>

#include <set>

using namespace dyncal;
using namespace dyncal::testing;

/// What may be typed behind --defect.
class TestDefectKinds : public QObject
{
    Q_OBJECT

private slots:
    void descriptions_everyKindOnce();
    void parse_sizeAndTime();
    void parse_nonsense_usageInOneSentence_data();
    void parse_nonsense_usageInOneSentence();
    void parse_limits_includedAndNoFarther();
    void unknownKind_namesAll();
    void defectOf_lastCounts_defaultsFilledIn();
    void simulate_sizeOutOfRange_usage();
    void nullSizes_countsOfACleanRun_data();
    void nullSizes_countsOfACleanRun();
    void counts_goldenHash_sameOnEveryMachine();
    void kinds_inTheDocument();
};

void TestDefectKinds::descriptions_everyKindOnce()
{
    std::set<DefectKind> kinds;
    std::set<std::string> names;
    for (const DefectDescription &description : defectDescriptions()) {
        kinds.insert(description.kind);
        names.insert(description.name);
        QCOMPARE(describedDefect(description.kind).name, description.name);
        QVERIFY(std::string(description.meaning).size() > 5);
        for (const auto &number : {description.size, description.time_s}) {
            if (number)
                QVERIFY(number->standard >= number->lowest && number->standard <= number->highest);
        }
        QVERIFY(description.size || !description.time_s);
        QVERIFY(parseDefect(description.name).has_value());
    }
    QCOMPARE(kinds.size(), defectDescriptions().size());
    QCOMPARE(names.size(), kinds.size());
    QCOMPARE(*kinds.rbegin(), DefectKind::Flicker); // the last of the enumeration
    QCOMPARE(kinds.size(), static_cast<std::size_t>(DefectKind::Flicker) + 1);
}

void TestDefectKinds::parse_sizeAndTime()
{
    const auto plain = parseDefect("heat");
    QVERIFY(!plain->size && !plain->time_s && plain->shot == 0);
    const auto sized = parseDefect("heat=0.05");
    QCOMPARE(*sized->size, 0.05);
    QVERIFY(!sized->time_s);
    const auto whole = parseDefect("heat=-0.05:1e-4@2");
    QCOMPARE(whole->kind, DefectKind::Heat);
    QCOMPARE(*whole->size, -0.05);
    QCOMPARE(*whole->time_s, 1e-4);
    QCOMPARE(whole->shot, Index(2));
    QCOMPARE(*parseDefect("temperature=-5@3")->size, -5.0);
}

void TestDefectKinds::parse_nonsense_usageInOneSentence_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    const std::pair<const char *, const char *> rows[] = {{"clip=3", "takes no number behind '='"},
        {"clip=", "takes no number behind '='"}, {"flicker=1@2", "takes no number behind '='"},
        {"gain=1.5:1", "takes no number behind ':'"}, {"heat=", "follows '=' must be a number"},
        {"heat=x", "follows '=' must be a number"}, {"heat=1,5", "follows '=' must be a number"},
        {"heat=:1e-3", "follows '=' must be a number"},
        {"heat=0.02:", "follows ':' must be a number"},
        {"heat=0.02:fast", "follows ':' must be a number"}, {"heat=0.02@", "follows '@'"},
        {"heat@2=0.02", "follows '@'"}, {"heat=nan", "must"}, {"heat=inf", "must"},
        {"heat=0.6", "must lie in -0.5 .. 0.5"}, {"heat=0.02:0", "must lie in 1e-06 .. 1"},
        {"humidity=50", "must lie in 0 .. 1"}, {"rate=0", "must lie in 0.01 .. 100"},
        {"scale=-1", "must lie in 1e-06 .. 1e+06"}, {"ar=1", "must lie in -0.9999 .. 0.9999"},
        {"tilt=-1", "must lie in 0 .. 10"}, {"distance=0.01@2", "the whole capture"},
        {"heats=1", "There is no defect 'heats'"}, {"=1", "There is no defect ''"}};
    for (const auto &[text, part] : rows)
        QTest::newRow(text) << QString(text) << QString(part);
}

void TestDefectKinds::parse_nonsense_usageInOneSentence()
{
    QFETCH(QString, text);
    QFETCH(QString, part);
    const auto defect = parseDefect(text.toStdString());
    QVERIFY(!defect.has_value());
    QCOMPARE(defect.error().kind, ErrorKind::Usage);
    const QString sentence = QString::fromStdString(english(defect.error().message));
    QVERIFY2(sentence.contains(part), qPrintable(sentence));
    QCOMPARE(sentence.count('\n'), 0);
    QVERIFY(sentence.endsWith('.'));
}

void TestDefectKinds::parse_limits_includedAndNoFarther()
{
    for (const DefectDescription &description : defectDescriptions()) {
        if (!description.size)
            continue;
        const auto typed = [&](double size) {
            return parseDefect(std::string(description.name) + '=' + exactNumber(size));
        };
        const double span = description.size->highest - description.size->lowest;
        QVERIFY2(typed(description.size->lowest).has_value(), description.name);
        QVERIFY2(typed(description.size->highest).has_value(), description.name);
        QVERIFY2(!typed(description.size->lowest - 1e-3 * span).has_value(), description.name);
        QVERIFY2(!typed(description.size->highest + 1e-3 * span).has_value(), description.name);
    }
}

void TestDefectKinds::unknownKind_namesAll()
{
    const std::string sentence = english(parseDefect("help").error().message);
    for (const DefectDescription &description : defectDescriptions())
        QVERIFY2(sentence.find(description.name) != std::string::npos, description.name);
}

void TestDefectKinds::defectOf_lastCounts_defaultsFilledIn()
{
    const SimulationSettings settings
        = withDefects({"heat", "heat=0.05:1e-4@2", "gain", "echo=0.1", "attenuation=0.002@3"});
    const auto first = defectOf(settings, DefectKind::Heat, 1);
    QCOMPARE(*first->size, 0.02);
    QCOMPARE(*first->time_s, 0.5e-3);
    const auto second = defectOf(settings, DefectKind::Heat, 2);
    QCOMPARE(*second->size, 0.05);
    QCOMPARE(*second->time_s, 1e-4);
    QVERIFY(!hasDefect(settings, DefectKind::Gain, 1)); // one shot, the middle one
    QCOMPARE(defectSize(settings, DefectKind::Gain, 2, 1.0), 1.5);
    QVERIFY(!hasDefect(settings, DefectKind::Gain, 3));
    QCOMPARE(*defectOf(settings, DefectKind::Echo, 3)->time_s, 0.1e-3);
    QCOMPARE(defectSize(settings, DefectKind::Attenuation, 1, 7.0), 7.0);
    QCOMPARE(defectSize(settings, DefectKind::Attenuation, 3, 7.0), 0.002);
}

void TestDefectKinds::simulate_sizeOutOfRange_usage()
{
    const auto refused = [](const SimulationSettings &settings, const char *part) {
        const auto capture = simulateShots(settings);
        QVERIFY2(!capture.has_value(), part);
        QCOMPARE(capture.error().kind, ErrorKind::Usage);
        const std::string sentence = english(capture.error().message);
        QVERIFY2(sentence.find(part) != std::string::npos, sentence.c_str());
    };
    SimulationSettings settings = smallSettings();
    settings.defects = {{DefectKind::Humidity, 0, 2.0}};
    refused(settings, "'humidity' is asked for with 2");
    settings.defects = {{DefectKind::Clip, 0, 2.0}};
    refused(settings, "'clip'");
    settings.defects = {{DefectKind::Distance, 2, 0.01}};
    refused(settings, "the whole capture");
    settings.defects = {{DefectKind::Heat, 4}};
    refused(settings, "1 to 3");
    settings.defects = {{DefectKind::Heat, 0, 0.02, 1e-3}, {DefectKind::AcCoupling, 0, 1e-3}};
    refused(settings, "coincide");
    settings.shots = {ShotLevel::High, ShotLevel::High};
    settings.defects = {{DefectKind::Levels, 0}};
    refused(settings, "two levels");
}

void TestDefectKinds::nullSizes_countsOfACleanRun_data()
{
    QTest::addColumn<QString>("text");
    for (const char *text : {"heat=0", "echo=0", "gain=1@2", "scatter=0", "attenuation=0",
             "delay=0", "distance=0", "temperature=0", "pressure=0", "gas=0", "humidity=0",
             "rate=1", "scale=1", "front=0", "tilt=0", "clock=0", "bow=0", "ar=0"})
        QTest::newRow(text) << QString(text);
}

void TestDefectKinds::nullSizes_countsOfACleanRun()
{
    QFETCH(QString, text);
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture with = simulated(withDefects({text.toStdString()}));
    QVERIFY(haveSameCounts(with, clean));
    QCOMPARE(with.set.tube, clean.set.tube);
    for (std::size_t s = 0; s < 3; ++s) {
        QCOMPARE(with.set.shots[s].environment.T1_K, clean.set.shots[s].environment.T1_K);
        QCOMPARE(with.set.shots[s].environment.p1_Pa, clean.set.shots[s].environment.p1_Pa);
        QCOMPARE(channelOf(with, s, 0).sampleRate_Hz, channelOf(clean, s, 0).sampleRate_Hz);
        QCOMPARE(channelOf(with, s, 0).t0_s, channelOf(clean, s, 0).t0_s);
        QCOMPARE(channelOf(with, s, 0).polynomial, channelOf(clean, s, 0).polynomial);
    }
}

void TestDefectKinds::counts_goldenHash_sameOnEveryMachine()
{
    // The counts are a promise, as those of a clean run are.
    const SimulatedCapture capture = simulated(
        withDefects({"heat", "ac@2", "echo", "gain=0.9", "scatter", "attenuation", "delay",
            "gas=0.3", "humidity", "front@1", "tilt@3", "clock", "bow", "ar@1", "flicker@3"}));
    std::string text;
    for (std::size_t s = 0; s < 3; ++s) {
        for (std::size_t c = 0; c < 3; ++c)
            text += channelOf(capture, s, c).sha256;
    }
    QCOMPARE(QString::fromStdString(sha256Hex(text)),
        QString("82716a748813b5f069e97413f598d66935b718568b3fb1c3bb6c29889f9b8f65"));
}

void TestDefectKinds::kinds_inTheDocument()
{
    const QString folder = qEnvironmentVariable("DYNCAL_SOURCE_DIR", ".");
    QFile document(folder + "/docs/simulator.md");
    if (!document.open(QIODevice::ReadOnly))
        QSKIP("docs/simulator.md not found: set DYNCAL_SOURCE_DIR");
    const QStringList lines = QString::fromUtf8(document.readAll()).split('\n');
    const auto number = [](double value) { return QString::fromStdString(numberText(value)); };
    for (const DefectDescription &description : defectDescriptions()) {
        const QStringList rows = lines.filter(QString("| `%1` |").arg(description.name));
        QVERIFY2(rows.size() == 1, description.name);
        const QStringList cells = rows[0].split('|');
        QString standard = "-";
        QString range = "-";
        if (description.size) {
            standard = number(description.size->standard);
            range = number(description.size->lowest) + " .. " + number(description.size->highest);
        }
        if (description.time_s) {
            standard += ':' + number(description.time_s->standard);
            range += ", " + number(description.time_s->lowest) + " .. "
                + number(description.time_s->highest);
        }
        QCOMPARE(cells.at(2).trimmed(), standard);
        QCOMPARE(cells.at(3).trimmed(), range);
    }
}

DYNCAL_TEST(TestDefectKinds)
#include "tst_defect_kinds.moc"
