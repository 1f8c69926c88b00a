// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm.h"
#include "tests/core/capture/formats/lvm/made_lvm.h"
#include "tests/support/decimal_comma.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Sums of 51200 values of 1e5 with six decimals, added in another order.
constexpr double kSumTolerance = 1e-6;

} // namespace

class TestLvm : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    Result<CaptureSet> read(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        return readLvm(write(m_folder.filePath("t.lvm"), bytes), settings, {});
    }

private slots:
    void read_anyVariant_isAsMade_data()
    {
        QTest::addColumn<QByteArray>("xColumns");
        QTest::addColumn<char>("separator");
        QTest::addColumn<char>("decimal");
        QTest::addColumn<bool>("decimalTag");
        for (const char *x : {"No", "One", "Multi"}) {
            QTest::addRow("%s tab .", x) << QByteArray(x) << '\t' << '.' << true;
            QTest::addRow("%s tab ,", x) << QByteArray(x) << '\t' << ',' << true;
            QTest::addRow("%s tab . untold", x) << QByteArray(x) << '\t' << '.' << false;
            QTest::addRow("%s tab , untold", x) << QByteArray(x) << '\t' << ',' << false;
            QTest::addRow("%s comma", x) << QByteArray(x) << ',' << '.' << true;
        }
    }
    void read_anyVariant_isAsMade()
    {
        LvmRecipe recipe;
        QFETCH(QByteArray, xColumns);
        recipe.xColumns = xColumns;
        QFETCH(char, separator);
        recipe.separator = separator;
        QFETCH(char, decimal);
        recipe.decimal = decimal;
        QFETCH(bool, decimalTag);
        recipe.decimalTag = decimalTag;
        for (const char *lineEnd : {"\n", "\r\n"}) {
            for (const int segments : {1, 3}) {
                for (const bool headings : {true, false}) {
                    recipe.lineEnd = lineEnd;
                    recipe.segments = segments;
                    recipe.multiHeadings = headings;
                    recipe.rows = {9, 5};
                    const Result<CaptureSet> set = read(lvm(recipe));
                    QVERIFY2(set.has_value(), sentence(set).c_str());
                    QVERIFY(isAsMade(*set, recipe));
                    QVERIFY(set->findings.empty());
                }
            }
        }
    }

    void read_notesUnitsAndComments_areUtf8()
    {
        LvmRecipe recipe;
        recipe.unit = "\xB0"
                      "C";
        recipe.comment = "LOST\xB5";
        recipe.segments = 2;
        const Result<CaptureSet> set = read(lvm(recipe));
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const Shot &shot = set->shots.at(1);
        QCOMPARE(shot.channels[0].unit, std::string("\u00B0C"));
        QCOMPARE(shot.notes.at("comment"), std::string("LOST\u00B5"));
        QCOMPARE(shot.notes.at("operator"), std::string("J\u00F8rgen"));
        QCOMPARE(shot.notes.at("start_local"), std::string("2024/05/06 01:02:03.5"));
        QCOMPARE(shot.label, std::string("t, segment 2"));
    }

    void read_manyRows_fastAndCarefulWayAgree()
    {
        // Behind the first rows lines are read another way; a comment now and then goes back.
        for (const char *xColumns : {"No", "One", "Multi"}) {
            for (const char decimal : {'.', ','}) {
                LvmRecipe recipe;
                recipe.xColumns = xColumns;
                recipe.decimal = decimal;
                recipe.rows = {3000, 1500};
                recipe.comment = "look";
                const Result<CaptureSet> set = read(lvm(recipe));
                QVERIFY2(set.has_value(), sentence(set).c_str());
                QVERIFY(isAsMade(*set, recipe));
                QCOMPARE(set->shots[0].notes.at("comment"), std::string("look"));
            }
        }
    }

    void recognise_firstWords_areCertain()
    {
        QCOMPARE(recogniseLvm("x.txt", "LabVIEW Measurement\t\nWriter"), 100);
        QCOMPARE(recogniseLvm("x.lvm", "1\t2\n"), 0);
        QCOMPARE(findingId(read("1\t2\n")), std::string("CAP-001"));
    }

    void read_germanLocale_changesNothing()
    {
        LvmRecipe recipe;
        recipe.decimal = ',';
        const DecimalComma locale;
        QVERIFY(locale.isInForce());
        const Result<CaptureSet> set = read(lvm(recipe));
        QVERIFY(isAsMade(*set, recipe));
    }

    void read_impactTests_haveTheExpectedExtremes()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("the folder of recordings is missing (DYNCAL_DATA)");
        const QJsonObject expected
            = QJsonDocument::fromJson(bytesOf(folder + "/expected/ds5_lvm.json")).object();
        QDirIterator entry(
            folder + "/highrate_ds5_impact", {"*.lvm"}, QDir::Files, QDirIterator::Subdirectories);
        int files = 0;
        while (entry.hasNext()) {
            const std::string path = entry.next().toStdString();
            const QJsonObject file = expected[entry.fileName()].toObject();
            const Result<CaptureSet> set = readLvm(path, {}, {});
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QVERIFY(set->findings.empty());
            const Shot &shot = set->shots.at(0);
            QCOMPARE(shot.channels.size(), std::size_t(6));
            for (const QString &name : file["ch"].toObject().keys()) {
                const QJsonObject truth = file["ch"].toObject()[name].toObject();
                const Channel &channel = *channelNamed(shot, name.toStdString());
                const std::vector<double> values = valuesOf(channel);
                QCOMPARE(double(values.size()), file["n"].toDouble());
                QCOMPARE(channel.sampleRate_Hz, 1.0 / file["delta_x"].toDouble());
                QCOMPARE(channel.unit, file["unit"].toString().toStdString());
                const auto low = std::min_element(values.begin(), values.end());
                const auto high = std::max_element(values.begin(), values.end());
                QCOMPARE(*high, truth["max"].toDouble());
                QCOMPARE(*low, truth["min"].toDouble());
                QCOMPARE(double(high - values.begin()), truth["argmax"].toDouble());
                QCOMPARE(double(low - values.begin()), truth["argmin"].toDouble());
                double sum = 0.0;
                for (const double v : values)
                    sum += v;
                QVERIFY(std::abs(sum - truth["sum"].toDouble())
                    <= kSumTolerance * std::abs(truth["sum"].toDouble()));
            }
            const QJsonArray impedance = file["impedance_5x4"].toArray();
            for (int row = 0; row < impedance.size(); ++row) {
                for (int c = 0; c < 4; ++c)
                    QCOMPARE(shot.channels[std::size_t(c) + 2].samples.at(row),
                        impedance[row].toArray()[c].toDouble());
            }
            QCOMPARE(shot.channels[5].samples.size(), Index(5));
            ++files;
        }
        qInfo("%d impact files", files);
        QVERIFY(files > 0);
    }

    void read_filesOfOtherLabs_haveTheirPrintedValues()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("the folder of recordings is missing (DYNCAL_DATA)");
        struct Expectation
        {
            QString file;
            std::size_t shots, channels;
            Index samples;
            double first, last; ///< of the first channel in the first shot
            double rate_Hz; ///< of that
            const char *finding;
        };
        // with_comments.lvm: Delta_X 1, but X goes 0, 0.33, 1.21, ...; no_decimal_separator.lvm:
        // Delta_X 0.000250 is known to 0.2 % only.
        const QList<Expectation> all{
            {"lvm_read/data/short.lvm", 1, 2, 10, 0.914018, 0.680572, 1.0 / 3.906250e-5, ""},
            {"lvm_read/data/multi_time_column.lvm", 1, 2, 3, -0.035229, -0.034191,
                1.0 / 1.953125e-5, "CAP-018"},
            {"lvm_read/data/no_decimal_separator.lvm", 1, 3, 4, -0.008807, 0.059248, 4000.0,
                "CAP-003"},
            {"lvm_read/data/with_comments.lvm", 1, 3, 9, 1.833787, 1.717152, 0.0, "CAP-016"},
            {"derived/lvm_3seg_tab_xone.lvm", 3, 2, 4000, 1.040858, 0.080963, 1e6, ""}};
        int files = 0;
        for (const Expectation &expected : all) {
            if (!QFile::exists(folder + "/" + expected.file))
                continue;
            const Result<CaptureSet> set
                = readLvm((folder + "/" + expected.file).toStdString(), {}, {});
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QCOMPARE(set->shots.size(), expected.shots);
            QCOMPARE(set->shots[0].channels.size(), expected.channels);
            const Channel &channel = set->shots[0].channels[0];
            QCOMPARE(channel.samples.size(), expected.samples);
            QCOMPARE(channel.samples.at(0), expected.first);
            QCOMPARE(channel.samples.at(expected.samples - 1), expected.last);
            QCOMPARE(channel.sampleRate_Hz, expected.rate_Hz);
            if (*expected.finding == '\0')
                QVERIFY2(set->findings.empty(), qPrintable(expected.file));
            else
                QVERIFY2(hasFinding(set->findings, expected.finding), qPrintable(expected.file));
            ++files;
        }
        qInfo("%d of %d files", files, int(all.size()));
        QVERIFY(files > 0);
    }
};

DYNCAL_TEST(TestLvm)
#include "tst_lvm.moc"
