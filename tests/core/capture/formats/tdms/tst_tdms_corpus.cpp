// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads every TDMS file of the recordings folder: files of npTDMS's own tests with the values that
// npTDMS reads, real ones of LabVIEW, and files made of measured shots. A file is read with all
// values right, refused as it must be, or the test fails.

#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <map>
#include <numeric>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const QStringList kFolders{"nptdms_scenarios", "nptdms_example_files", "tdms_scaling", "go_tdms",
    "derived", "omoriaux_bk"};

/// Both sides compute the same few operations in double precision, in another order.
constexpr double kRounding = 1e-14;

QJsonObject jsonOf(const QString &path)
{
    return QJsonDocument::fromJson(bytesOf(path)).object();
}

bool near(double found, double expected, double scale)
{
    return std::abs(found - expected) <= kRounding * std::max(scale, std::abs(expected));
}

/// Whether the numbers of a JSON array are these; empty text if so.
QString comparedValues(const QJsonArray &expected, const std::vector<double> &found)
{
    if (expected.size() != std::ssize(found))
        return QString("%1 values where there should be %2").arg(found.size()).arg(expected.size());
    double scale = 0.0;
    for (const QJsonValue &value : expected)
        scale = std::max(scale, std::abs(value.toDouble()));
    for (qsizetype i = 0; i < expected.size(); ++i) {
        const double wanted = expected[i].isBool() ? expected[i].toBool() : expected[i].toDouble();
        if (!near(found[static_cast<std::size_t>(i)], wanted, scale))
            return QString("value %1 is %2, should be %3")
                .arg(i)
                .arg(found[static_cast<std::size_t>(i)], 0, 'g', 17)
                .arg(wanted, 0, 'g', 17);
    }
    return {};
}

std::vector<double> rawValues(const Channel &channel)
{
    std::vector<double> values;
    channel.samples.visitBlocks(0, channel.samples.size(), [&](auto block, Index) {
        for (const auto value : block)
            values.push_back(static_cast<double>(value));
    });
    return values;
}

std::vector<double> scaledValues(const Channel &channel)
{
    const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
    return {values.begin(), values.end()};
}

/// The channel of that group and name, which may carry the group where names repeat.
const Channel *find(const CaptureSet &set, const QString &group, const QString &name)
{
    for (const Shot &shot : set.shots) {
        if (set.shots.size() > 1 && !QString::fromStdString(shot.label).endsWith(", " + group))
            continue;
        for (const QString &text : {name, group + "/" + name}) {
            if (const Channel *channel = channelNamed(shot, text.toStdString()))
                return channel;
        }
    }
    return nullptr;
}

bool isSampleType(const QString &type)
{
    return type != "TimeStamp" && type != "String" && type != "None" && !type.startsWith("Complex");
}

/// The counts of DAQmx channels without scale; several kinds of them are channels of their own.
QString comparedScalers(const CaptureSet &set, const QString &group, const QJsonObject &channel)
{
    const QJsonObject scalers = channel["raw_scaler_data"].toObject();
    const QString name = channel["name"].toString();
    for (auto it = scalers.begin(); it != scalers.end(); ++it) {
        const QString suffix
            = scalers.size() > 1 && !channel.contains("data") ? " (counts " + it.key() + ")" : "";
        const Channel *found = find(set, group, name + suffix);
        if (found == nullptr)
            return "counts " + it.key() + " are missing";
        const QString difference
            = comparedValues(it.value().toObject()["values"].toArray(), rawValues(*found));
        if (!difference.isEmpty())
            return difference;
    }
    return {};
}

QString comparedProperties(const Channel &found, const Shot &shot, const QJsonObject &properties)
{
    const auto number
        = [&](const char *name) { return properties[name].toObject()["value"].toDouble(); };
    if (properties.contains("wf_increment")
        && !near(found.sampleRate_Hz * number("wf_increment"), 1.0, 1.0))
        return "rate";
    if (!properties.contains("wf_increment") && found.sampleRate_Hz != 0.0)
        return "rate from nowhere";
    if (found.t0_s != number("wf_start_offset"))
        return "t0";
    if (!properties.contains("wf_start_time"))
        return {};
    const QJsonObject start = properties["wf_start_time"].toObject()["value"].toObject();
    const QString note = QString::fromStdString(shot.notes.at("start_utc"));
    if (!note.startsWith(start["iso"].toString().section('.', 0, 0)))
        return "start " + note;
    const QString digits = start["iso"].toString().section('.', 1);
    const QString found9 = note.section('.', 1).remove('Z').leftJustified(9, '0').left(9);
    return digits == found9 ? QString() : "start " + note;
}

QString comparedChannel(const CaptureSet &set, const QString &group, const QJsonObject &channel)
{
    const QString type = channel["data_type"].toString("None");
    const QString name = channel["name"].toString();
    const Channel *found = find(set, group, name);
    if (!isSampleType(type) || channel["n"].toInt() == 0)
        return found == nullptr ? QString() : "should have been left out";
    if (channel.contains("raw_scaler_data"))
        return comparedScalers(set, group, channel);
    if (found == nullptr)
        return "is missing";
    QString difference
        = comparedValues(channel["data"].toObject()["values"].toArray(), scaledValues(*found));
    if (difference.isEmpty() && channel.contains("raw_data"))
        difference
            = comparedValues(channel["raw_data"].toObject()["values"].toArray(), rawValues(*found));
    if (difference.isEmpty())
        difference
            = comparedProperties(*found, set.shots.front(), channel["properties"].toObject());
    return difference;
}

/// Everything that npTDMS reads from the file is in the set.
QString comparedFile(const Result<CaptureSet> &set, const QJsonObject &expected)
{
    if (!expected["opens"].toBool())
        return set ? "should have been refused" : QString();
    bool anySamples = false;
    for (const QJsonValue &group : expected["groups"].toArray()) {
        for (const QJsonValue &value : group.toObject()["channels"].toArray()) {
            const QJsonObject channel = value.toObject();
            anySamples = anySamples
                || (isSampleType(channel["data_type"].toString("None"))
                    && channel["n"].toInt() > 0);
            if (!set)
                continue;
            const QString difference
                = comparedChannel(*set, group.toObject()["name"].toString(), channel);
            if (!difference.isEmpty())
                return channel["path"].toString() + ": " + difference;
        }
    }
    if (anySamples != set.has_value())
        return "readable or not: " + QString::fromStdString(sentence(set));
    if (set && expected["incomplete"].toBool() && !hasFinding(set->findings, "CAP-018"))
        return "does not say that it is incomplete";
    return {};
}

} // namespace

class TestTdmsCorpus : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_folder = recordingsFolder();
        for (const QString &name : kFolders) {
            QDirIterator files(m_folder + "/" + name, {"*.tdms", "*.tdms_index"}, QDir::Files,
                QDirIterator::Subdirectories);
            while (!m_folder.isEmpty() && files.hasNext())
                m_files << files.next();
        }
        m_files.sort();
        qInfo("TDMS corpus: %d files in %s", int(m_files.size()),
            m_folder.isEmpty() ? "(the folder of recordings is missing)" : qPrintable(m_folder));
        if (m_files.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("The folder of recordings is missing: no file was covered.");
    }

    void everyFile_isReadOrRefusedAsItMustBe()
    {
        int read = 0;
        int refused = 0;
        int noCapture = 0;
        for (const QString &path : m_files) {
            const Result<CaptureSet> set = readCapture(path.toStdString(), {});
            if (set) {
                ++read;
                QVERIFY2(!set->shots.empty(), qPrintable(path));
                continue;
            }
            QCOMPARE(set.error().kind, ErrorKind::FileUnreadable);
            QVERIFY2(contains(sentence(set), path.toStdString()), sentence(set).c_str());
            ++(set.error().findingId == "CAP-001" ? noCapture : refused);
            QVERIFY2(set.error().findingId == "CAP-001" || set.error().findingId == "CAP-018",
                qPrintable(path));
        }
        qInfo("read %d, refused %d, not a capture %d, of %d", read, refused, noCapture,
            int(m_files.size()));
        QCOMPARE(read + refused + noCapture, int(m_files.size()));
    }

    void scenarios_giveTheValuesThatNpTdmsReads()
    {
        int covered = 0;
        for (const QString &path : m_files.filter(QRegularExpression("nptdms_scenarios.*tdms$"))) {
            const QJsonObject expected = jsonOf(QString(path).replace(".tdms", ".json"));
            QVERIFY2(!expected.isEmpty(), qPrintable(path));
            const QString difference = comparedFile(readCapture(path.toStdString(), {}), expected);
            QVERIFY2(difference.isEmpty(), qPrintable(path + ": " + difference));
            ++covered;
        }
        qInfo("scenarios covered: %d", covered);
    }

    void scales_giveRawAndScaledValues()
    {
        int covered = 0;
        for (const QString &path : m_files.filter(QRegularExpression("tdms_scaling.*tdms$"))) {
            const QJsonObject expected = jsonOf(QString(path).replace(".tdms", ".json"));
            const Result<CaptureSet> set = readCapture(path.toStdString(), {});
            ++covered;
            if (path.endsWith("unsupported_scale_type.tdms")) {
                // npTDMS gives out the counts; a number without its scale would be a wrong one.
                QVERIFY(!set && contains(sentence(set), "Unknown"));
                continue;
            }
            QVERIFY2(set.has_value(), sentence(set).c_str());
            const Channel &channel = set->shots.at(0).channels.at(0);
            QString difference
                = comparedValues(expected["scaled"].toArray(), scaledValues(channel));
            QVERIFY2(difference.isEmpty(), qPrintable(path + ": " + difference));
            if (expected["raw_dtype"].toString() != "int16")
                continue;
            QCOMPARE(channel.samples.type(), SampleType::Int16);
            difference = comparedValues(expected["raw"].toArray(), rawValues(channel));
            QVERIFY2(difference.isEmpty(), qPrintable(path + ": " + difference));
        }
        qInfo("files with scales covered: %d", covered);
    }

    void measuredShots_haveTheCountsTheyWereMadeOf()
    {
        const QJsonObject expected = jsonOf(m_folder + "/derived/expected_shots123.json");
        for (int n = 1; n <= 3; ++n) {
            const QString path
                = m_folder + QString("/derived/ds1_shot%1_signalexpress_like.tdms").arg(n);
            const Result<CaptureSet> set = readCapture(path.toStdString(), {});
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QCOMPARE(set->shots.size(), std::size_t{1});
            const QJsonObject channels = expected[QString("shot%1").arg(n)].toObject();
            QCOMPARE(std::ssize(set->shots[0].channels), channels.size());
            for (auto it = channels.begin(); it != channels.end(); ++it) {
                const Channel *channel = channelNamed(set->shots[0], it.key().toStdString());
                QVERIFY2(channel != nullptr, qPrintable(it.key()));
                compareStatistics(*channel, it.value().toObject());
            }
        }
    }

    void damagedShots_keepWhatIsThere()
    {
        const auto read = [&](const char *name) {
            return readCapture((m_folder + "/derived/" + name).toStdString(), {});
        };
        const Result<CaptureSet> half = read("bad_truncated_half.tdms");
        QVERIFY2(half.has_value(), sentence(half).c_str());
        constexpr Index kSamplesThere = 14018; // of 20000, as npTDMS counts them
        QCOMPARE(half->shots.at(0).channels.at(0).samples.size(), kSamplesThere);
        QVERIFY(hasFinding(half->findings, "CAP-018"));
        const Result<CaptureSet> open = read("incomplete_last_segment_all_ff.tdms");
        QVERIFY2(open.has_value(), sentence(open).c_str());
        QCOMPARE(open->shots.at(0).channels.at(0).samples.size(), Index{20000});
        QVERIFY(hasFinding(open->findings, "CAP-018"));
        QVERIFY(contains(sentence(read("bad_truncated_in_leadin.tdms")), "no data"));
        QVERIFY(contains(sentence(read("bad_empty.tdms")), "empty"));
        QCOMPARE(findingId(read("bad_wrong_magic.tdms")), std::string("CAP-001"));
    }

    void realDaqmxFile_hasCountsScaleAndTime()
    {
        const std::string path = (m_folder + "/nptdms_example_files/raw1.tdms").toStdString();
        const Result<CaptureSet> set = readCapture(path, {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t{1});
        QCOMPARE(set->shots[0].channels.size(), std::size_t{7});
        for (const Channel &channel : set->shots[0].channels) {
            QCOMPARE(channel.samples.size(), Index{2000});
            QCOMPARE(channel.samples.type(), SampleType::Int16);
            QCOMPARE(channel.polynomial, (std::vector<double>{0.0, 0.0003051850947599719}));
            QCOMPARE(channel.sampleRate_Hz, 50000.0);
            QCOMPARE(channel.unit, std::string("Volts"));
        }
        QCOMPARE(
            set->shots[0].notes.at("start_1904"), std::string("3564686121 s + 903382430 / 2^64 s"));
    }

    void realSignalExpressLog_isOneShotWithoutThinnedCopies()
    {
        const std::string path
            = (m_folder + "/nptdms_example_files/Digital_Input.tdms").toStdString();
        const Result<CaptureSet> set = readCapture(path, {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t{1});
        QCOMPARE(set->shots[0].channels.size(), std::size_t{1});
        QCOMPARE(set->shots[0].channels[0].samples.size(), Index{20000});
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 2000.0);
        QVERIFY(hasFinding(set->findings, "CAP-026"));
    }

    void indexFiles_areNamedForWhatTheyAre()
    {
        for (const QString &path : m_files.filter(QRegularExpression("tdms_index$"))) {
            const Result<CaptureSet> set = readCapture(path.toStdString(), {});
            QVERIFY2(!set && findingId(set) == "CAP-001" && contains(sentence(set), "index"),
                qPrintable(path));
        }
    }

private:
    void compareStatistics(const Channel &channel, const QJsonObject &expected)
    {
        QCOMPARE(channel.samples.type(), SampleType::Int16);
        QCOMPARE(channel.sampleRate_Hz, 1e6);
        QCOMPARE(channel.polynomial.at(1), expected["scale"].toDouble());
        const std::vector<double> counts = rawValues(channel);
        QCOMPARE(std::ssize(counts), static_cast<qsizetype>(expected["n"].toInt()));
        const auto least = std::min_element(counts.begin(), counts.end());
        const auto most = std::max_element(counts.begin(), counts.end()); // the first, as argmax
        QCOMPARE(*most, expected["max_count"].toDouble());
        QCOMPARE(most - counts.begin(), static_cast<std::ptrdiff_t>(expected["argmax"].toInt()));
        QCOMPARE(*least, expected["min_count"].toDouble());
        QCOMPARE(
            std::accumulate(counts.begin(), counts.end(), 0.0), expected["sum_counts"].toDouble());
    }

    QString m_folder;
    QStringList m_files;
};

DYNCAL_TEST(TestTdmsCorpus)
#include "tst_tdms_corpus.moc"
