// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/preview/text_preview.h"
#include "core/capture/formats/text/delimited_text.h"
#include "core/capture/import_rules.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/formats/text/delimited_cases.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr int kRows = 40;
constexpr double kStep_s = 1e-6;

double valueOf(int column, int row)
{
    return 0.25 * column + std::sin(0.1 * row * column);
}

/// Times, then three columns of samples.
QByteArray threeColumns(const QByteArray &header = "time [s],low [kPa],mid [kPa],high [bar]\n")
{
    QByteArray text = header;
    for (int row = 0; row < kRows; ++row) {
        text += QByteArray::number(row * kStep_s, 'g', 17);
        for (int column = 1; column <= 3; ++column)
            text += ',' + QByteArray::number(valueOf(column, row), 'g', 17);
        text += '\n';
    }
    return text;
}

ImportSettings shotColumns(std::map<std::string, Index> columns = {})
{
    ImportSettings settings = withColumns(std::move(columns));
    settings.columnsAre = kColumnsAreShots;
    return settings;
}

} // namespace

/// Tables whose columns are shots of one sensor.
class TestShotColumns : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    std::string file(const QByteArray &bytes)
    {
        return write(m_folder.filePath("series 7.csv"), bytes);
    }

private slots:
    void everyColumn_isAShotOfOneSensor()
    {
        const Result<CaptureSet> set = readDelimitedText(file(threeColumns()), shotColumns(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t(3));
        const std::vector<std::string> titles{"low", "mid", "high"};
        const std::vector<std::string> units{"kPa", "kPa", "bar"};
        for (std::size_t i = 0; i < 3; ++i) {
            const Shot &shot = set->shots[i];
            QCOMPARE(shot.label, "series 7, " + titles[i]);
            QCOMPARE(shot.channels.size(), std::size_t(1));
            const Channel &channel = shot.channels[0];
            QCOMPARE(channel.name, std::string("DUT"));
            QCOMPARE(channel.role, ChannelRole::Dut);
            QCOMPARE(channel.unit, units[i]);
            QVERIFY(near(channel.sampleRate_Hz, 1.0 / kStep_s, kRateAllowance));
            const std::vector<double> values = valuesOf(channel);
            QCOMPARE(values.size(), std::size_t(kRows));
            for (int row = 0; row < kRows; ++row)
                QCOMPARE(
                    values[static_cast<std::size_t>(row)], valueOf(static_cast<int>(i) + 1, row));
        }
    }

    void samples_areThoseOfTheChannels()
    {
        const std::string path = file(threeColumns());
        const Result<CaptureSet> channels = readDelimitedText(path, {}, {});
        const Result<CaptureSet> shots = readDelimitedText(path, shotColumns(), {});
        QVERIFY(channels && shots);
        QCOMPARE(channels->shots.size(), std::size_t(1));
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(
                valuesOf(shots->shots[i].channels[0]), valuesOf(channels->shots[0].channels[i]));
    }

    void settingsOfTheSensor_holdForAllShots()
    {
        ImportSettings settings = shotColumns();
        settings.channelDetails["DUT"].gain = 10.0;
        settings.levels = {"low", "medium", "high"};
        settings.exclude = {{2, "leaked"}};
        const std::string path = file(threeColumns());
        const Result<CaptureSet> set = readCapture(path, settings).and_then([&](CaptureSet read) {
            return applyImportSettings(std::move(read), settings);
        });
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t(3));
        const std::vector<double> kPa{1e3, 1e3, 1e5}; // Pa per unit of the column
        for (std::size_t i = 0; i < 3; ++i) {
            const Channel &channel = set->shots[i].channels[0];
            QCOMPARE(channel.unit, std::string("Pa"));
            QCOMPARE(set->shots[i].inFile, static_cast<Index>(i) + 1);
            const double expected = valueOf(static_cast<int>(i) + 1, 30) * kPa[i] / 10.0;
            QVERIFY(near(physicalValues(channel, 30, 1)[0], expected, 1e-12));
        }
        QVERIFY(set->shots[0].included && !set->shots[1].included && set->shots[2].included);
        QCOMPARE(set->shots[2].level, ShotLevel::High);
    }

    void oneFile_mayBeOfTheOtherKind()
    {
        ImportSettings settings;
        settings.files["series 7.csv"].columnsAre = kColumnsAreShots;
        const std::string shots = file(threeColumns());
        const std::string channels = write(m_folder.filePath("other.csv"), threeColumns());
        const Result<CaptureSet> set = openCaptures({shots, channels}, settings);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t(4));
        QCOMPARE(set->shots[3].channels.size(), std::size_t(3));
    }

    void columnsWithAnotherRole_areNoShots()
    {
        const Result<CaptureSet> set = readDelimitedText(
            file(threeColumns()), shotColumns({{"time", 0}, {"trigger", 2}}), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t(2));
        QCOMPARE(set->shots[0].label, std::string("series 7, low"));
        QCOMPARE(set->shots[1].label, std::string("series 7, high"));
        QVERIFY(near(set->shots[1].channels[0].sampleRate_Hz, 1e6, kRateAllowance));
    }

    void tableWithoutTimes_hasShotsWithoutARate()
    {
        const Result<CaptureSet> set
            = readDelimitedText(file("a,b\n1.5,2\n-3,4.5\n2,-1\n1,0\n"), shotColumns(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t(2));
        QCOMPARE(valuesOf(set->shots[1].channels[0]), (std::vector<double>{2.0, 4.5, -1.0, 0.0}));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
    }

    void dutAmongTheColumns_isRefused()
    {
        const Result<CaptureSet> set
            = readDelimitedText(file(threeColumns()), shotColumns({{"time", 0}, {"dut", 1}}), {});
        QVERIFY(!set);
        QCOMPARE(set.error().kind, ErrorKind::Usage);
        QVERIFY2(contains(sentence(set), "import.columns_are"), sentence(set).c_str());
        // Where nothing is left that could be a shot, that is said.
        QCOMPARE(findingId(readDelimitedText(file(threeColumns()),
                     shotColumns({{"time", 0}, {"trigger", 1}, {"driver", 2}, {"other", 3}}), {})),
            std::string("CAP-018"));
    }

    void preview_saysWhichShotEachColumnIs()
    {
        const std::string path = file(threeColumns());
        const Result<TextPreview> plain = previewText(path, {});
        QVERIFY(plain && plain->shots.empty());
        const Result<TextPreview> preview = previewText(path, shotColumns());
        QVERIFY(preview && !preview->problem);
        QCOMPARE(preview->shots, (std::vector<Index>{0, 1, 2, 3}));
        QCOMPARE(preview->timeColumn, std::optional<Index>(0));
        const Result<TextPreview> fewer
            = previewText(path, shotColumns({{"time", 0}, {"other", 1}}));
        QVERIFY(fewer);
        QCOMPARE(fewer->shots, (std::vector<Index>{0, 0, 1, 2}));
        const Result<TextPreview> refused = previewText(path, shotColumns({{"dut", 1}}));
        QVERIFY(refused && refused->problem);
    }
};

DYNCAL_TEST(TestShotColumns)
#include "tst_shot_columns.moc"
