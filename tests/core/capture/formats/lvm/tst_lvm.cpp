// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/capture_test_support.h"
#include "tests/support/decimal_comma.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

namespace dyncal {

using namespace testing;

namespace {

/// Sums of 51200 values of 1e5 with six decimals, added in another order.
constexpr double kSumTolerance = 1e-6;

/// What a generated file is to be; channel c holds value(c, k).
struct Recipe
{
    QByteArray xColumns = "One";
    char separator = '\t';
    char decimal = '.';
    bool decimalTag = true;
    bool multiHeadings = true;
    int channels = 2;
    QList<int> rows{8, 8}; ///< per channel
    int segments = 1;
    double delta = 1e-5;
    int declaredMore = 0;
    QByteArray unit = "V";
    QByteArray comment = {};
    QByteArray lineEnd = "\r\n";
};

double value(int channel, int row)
{
    return (channel + 1) * 0.125 + row * (channel == 0 ? 1.0 : -2.0);
}

QByteArray number(double x, char decimal)
{
    return QByteArray::number(x, 'f', 6).replace('.', decimal);
}

/// One line of the file; tags repeat per channel where the column of that channel is.
QByteArray tagLine(const Recipe &recipe, const QByteArray &tag, const QList<QByteArray> &cells)
{
    QByteArray line = tag;
    for (const QByteArray &cell : cells) {
        line += recipe.separator + cell;
        if (recipe.xColumns == "Multi")
            line += recipe.separator;
    }
    return line + recipe.lineEnd;
}

QByteArray segment(const Recipe &recipe, bool header)
{
    QByteArray text;
    const QByteArray sep(1, recipe.separator);
    const auto each = [&](auto cell) {
        QList<QByteArray> cells;
        for (int c = 0; c < recipe.channels; ++c)
            cells += cell(c);
        return cells;
    };
    if (header) {
        text += tagLine(recipe, "Channels", {QByteArray::number(recipe.channels)});
        text += tagLine(recipe, "Samples",
            each([&](int c) { return QByteArray::number(recipe.rows[c] + recipe.declaredMore); }));
        text += tagLine(recipe, "Unknown_Tag", {"what", "ever"});
        text += tagLine(recipe, "Date", each([](int) { return QByteArray("2024/05/06"); }));
        text += tagLine(recipe, "Time", each([](int) { return QByteArray("01:02:03.5"); }));
        text += tagLine(recipe, "Y_Unit_Label", each([&](int) { return recipe.unit; }));
        text += tagLine(recipe, "X0", each([&](int) { return number(-0.5, recipe.decimal); }));
        text += tagLine(recipe, "Delta_X", each([&](int) {
            return QByteArray::number(recipe.delta, 'E', 6).replace('.', recipe.decimal);
        }));
        text += "***End_of_Header***" + sep + recipe.lineEnd;
        const bool multi = recipe.xColumns == "Multi";
        for (int c = 0; c < recipe.channels; ++c)
            text += (c == 0 || multi ? "X_Value" + sep : QByteArray()) + "ch "
                + QByteArray::number(c) + sep;
        text += "Comment" + recipe.lineEnd;
    }
    const int rows = *std::max_element(recipe.rows.begin(), recipe.rows.end());
    for (int k = 0; k < rows; ++k) {
        QList<QByteArray> cells;
        for (int c = 0; c < recipe.channels; ++c) {
            const QByteArray x
                = QByteArray::number(-0.5 + k * recipe.delta, 'E', 9).replace('.', recipe.decimal);
            const bool there = k < recipe.rows[c];
            if (recipe.xColumns == "Multi" || c == 0)
                cells += recipe.xColumns == "No" || !there ? QByteArray() : x;
            cells += there ? number(value(c, k), recipe.decimal) : QByteArray();
        }
        text += cells.join(sep);
        if (k == 2 && !recipe.comment.isEmpty())
            text += sep + recipe.comment;
        text += recipe.lineEnd;
    }
    return text + recipe.lineEnd;
}

QByteArray lvm(const Recipe &recipe)
{
    const QByteArray sep(1, recipe.separator);
    QByteArray text;
    const QList<QList<QByteArray>> tags{{"LabVIEW Measurement", ""}, {"Writer_Version", "2"},
        {"Separator", recipe.separator == ',' ? "Comma" : "Tab"},
        {"Multi_Headings", recipe.multiHeadings ? "Yes" : "No"}, {"X_Columns", recipe.xColumns},
        {"Operator", "J\xF8rgen"}, {"Date", "1903/12/31"}};
    for (const QList<QByteArray> &tag : tags)
        text += tag.join(sep) + recipe.lineEnd;
    if (recipe.decimalTag)
        text += "Decimal_Separator" + sep + recipe.decimal + recipe.lineEnd;
    text += "***Start_Special***" + recipe.lineEnd + "X_Columns" + sep + "Bogus" + recipe.lineEnd
        + "***End_Special***" + recipe.lineEnd;
    text += "***End_of_Header***" + sep + recipe.lineEnd + sep + recipe.lineEnd;
    for (int s = 0; s < recipe.segments; ++s)
        text += segment(recipe, recipe.multiHeadings || s == 0);
    return text;
}

std::vector<double> valuesOf(const Channel &channel)
{
    std::vector<double> values;
    for (Index i = 0; i < channel.samples.size(); ++i)
        values.push_back(channel.samples.at(i));
    return values;
}

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

    /// Every value, rate and name that the recipe put in.
    static bool isAsMade(const CaptureSet &set, const Recipe &recipe)
    {
        bool good = set.shots.size() == std::size_t(recipe.segments);
        for (const Shot &shot : set.shots) {
            good = good && shot.channels.size() == std::size_t(recipe.channels);
            for (int c = 0; good && c < recipe.channels; ++c) {
                const Channel &channel = shot.channels[std::size_t(c)];
                const std::vector<double> values = valuesOf(channel);
                good = values.size() == std::size_t(recipe.rows[c]) && channel.t0_s == -0.5
                    && channel.sampleRate_Hz == 1.0 / recipe.delta
                    && channel.role == ChannelRole::Other
                    && channel.name == "ch " + std::to_string(c);
                for (int k = 0; good && k < recipe.rows[c]; ++k)
                    good = values[std::size_t(k)] == value(c, k);
            }
        }
        return good;
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
        Recipe recipe;
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
        Recipe recipe;
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

    void read_emptyCellBeforeAValue_isAnInvalidSample()
    {
        QByteArray text = lvm({});
        text.replace("2.125000", "");
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const std::vector<double> values = valuesOf(set->shots.at(0).channels.at(0));
        QCOMPARE(values.size(), std::size_t(8));
        QVERIFY(std::isnan(values[2]) && values[3] == 3.125);
    }

    void read_declaredSamples_areOnlyCompared()
    {
        Recipe recipe;
        recipe.declaredMore = 5;
        const Result<CaptureSet> fewer = read(lvm(recipe));
        QVERIFY(isAsMade(*fewer, recipe));
        QCOMPARE(fewer->findings.at(0).id, std::string("CAP-018"));
        QCOMPARE(fewer->findings.at(0).severity, Severity::Caution);
        recipe.declaredMore = -3;
        const Result<CaptureSet> more = read(lvm(recipe));
        QVERIFY(isAsMade(*more, recipe));
        QCOMPARE(more->findings.at(0).severity, Severity::Caution); // appended: another shot?
        QVERIFY(contains(english(more->findings.at(0).message), "blocks were appended"));
        recipe.declaredMore = -7;
        const Result<CaptureSet> stream = read(lvm(recipe));
        QCOMPARE(stream->findings.at(0).severity, Severity::Info); // one by one: one record
    }

    void read_hugeClaims_areRefusedOrIgnored()
    {
        Recipe recipe;
        const QByteArray text = lvm(recipe);
        for (const char *claim : {"3", "1000000000", "99999999999999999999", "-1", "x"}) {
            QByteArray changed = text;
            changed.replace("Channels\t2", QByteArray("Channels\t") + claim);
            const Result<CaptureSet> set = read(changed);
            QVERIFY(set.has_value() || findingId(set) == "CAP-018");
            QVERIFY(!set.has_value() || isAsMade(*set, recipe));
        }
        QByteArray samples = text;
        samples.replace("Samples\t8\t8", "Samples\t999999999999999\t8");
        QVERIFY(isAsMade(*read(samples), recipe));
    }

    void read_timesAgainstDelta_leaveTheRateUnknown()
    {
        Recipe recipe;
        QByteArray text = lvm(recipe);
        text.replace("1.000000E-05", "1.010000E-05");
        const Result<CaptureSet> set = read(text);
        QVERIFY(set.has_value());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(set->findings, "CAP-016"));

        QByteArray gap = lvm({.xColumns = "Multi"});
        gap.replace("-4.999700000E-01", "-4.999600000E-01");
        const Result<CaptureSet> irregular = read(gap);
        QVERIFY(irregular.has_value());
        QCOMPARE(irregular->shots[0].channels[0].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(irregular->findings, "CAP-016"));
    }

    void read_deltaWithFewDigits_saysHowGoodTheRateIs()
    {
        struct Case
        {
            const char *delta;
            double rate_Hz;
            const char *words;
            Severity severity;
        };
        for (const Case &expected :
            {Case{"0.000977", 1.0 / 0.000977, "known to 0.051 % only", Severity::Info},
                Case{"0.000250", 4000.0, "known to 0.2 % only", Severity::Caution},
                Case{"0.000003", 0.0, "not taken", Severity::Caution}}) {
            QByteArray text = lvm({.xColumns = "No"});
            text.replace("1.000000E-05", expected.delta);
            const Result<CaptureSet> set = read(text);
            QVERIFY2(set.has_value(), sentence(set).c_str());
            for (const Channel &channel : set->shots.at(0).channels)
                QCOMPARE(channel.sampleRate_Hz, expected.rate_Hz);
            QCOMPARE(set->findings.size(), std::size_t(1));
            QCOMPARE(set->findings[0].id, std::string("CAP-003"));
            QCOMPARE(set->findings[0].severity, expected.severity);
            const std::string said = english(set->findings[0].message);
            QVERIFY2(contains(said, expected.words), said.c_str());
        }
    }

    void read_deltaWithFewDigits_isRefinedByFineTimes()
    {
        // 1/1024 s: the header prints 0.000977, but the times of 200 rows give it to a millionth.
        const double step = 1.0 / 1024.0;
        Recipe recipe;
        recipe.rows = {200, 200};
        recipe.delta = step;
        QByteArray text = lvm(recipe);
        text.replace("9.765625E-04", "0.000977");
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        constexpr double kHalfDigits = 1e-9 / (199.0 / 1024.0); // of the last X cell
        QVERIFY(std::abs(set->shots[0].channels[0].sampleRate_Hz / 1024.0 - 1.0) < kHalfDigits);
        QVERIFY(set->findings.empty());
    }

    void read_slowChannelAppendedInBlocks_hasNoRate()
    {
        Recipe recipe;
        recipe.rows = {8, 8};
        recipe.delta = 0.5;
        QByteArray text = lvm(recipe);
        text.replace("Delta_X\t5.000000E-01\t5.000000E-01", "Delta_X\t5.000000E-01\t1.000000E+00");
        for (const int row : {1, 2, 3, 5, 6, 7})
            text.replace("\t" + number(value(1, row), '.') + "\r\n", "\t\r\n");
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const std::vector<Channel> &channels = set->shots.at(0).channels;
        QCOMPARE(channels[0].sampleRate_Hz, 2.0);
        QCOMPARE(channels[1].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(set->findings, "CAP-016"));
        QCOMPARE(channels[1].samples.size(), Index(5));
        QVERIFY(std::isnan(channels[1].samples.at(1)));
        QCOMPARE(channels[1].samples.at(4), value(1, 4));
    }

    void read_channelsWithoutSamples_areLeftOutAndSaid()
    {
        Recipe recipe;
        recipe.rows = {8, 0};
        const Result<CaptureSet> set = read(lvm(recipe));
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.at(0).channels.size(), std::size_t(1));
        QCOMPARE(set->findings.size(), std::size_t(1));
        QVERIFY(contains(english(set->findings[0].message), "1 of 2 channels have no samples"));
    }

    void read_moreColumnsThanDeclared_isSaid()
    {
        QByteArray text = lvm({});
        text.replace("Channels\t2", "Channels\t1");
        const Result<CaptureSet> set = read(text);
        // The second column then stands where the comment is.
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.at(0).channels.size(), std::size_t(1));
        QVERIFY(contains(english(set->findings.at(0).message), "2 columns have names"));
    }

    void read_commaAsSeparatorAndMark_isRefused()
    {
        Recipe recipe;
        recipe.separator = ',';
        recipe.decimal = ',';
        QCOMPARE(findingId(read(lvm(recipe))), std::string("CAP-019"));
    }

    void read_twoLinesRunTogether_areNotTakenForAComment()
    {
        QByteArray text = lvm({});
        const QByteArray row = number(value(0, 3), '.') + "\t" + number(value(1, 3), '.');
        QVERIFY(text.contains(row + "\r\n"));
        text.replace(row + "\r\n", row + "\t");
        const Result<CaptureSet> set = read(text);
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY2(contains(sentence(set), "cells more than"), sentence(set).c_str());
    }

    void read_manyRows_fastAndCarefulWayAgree()
    {
        // Behind the first rows lines are read another way; a comment now and then goes back.
        for (const char *xColumns : {"No", "One", "Multi"}) {
            for (const char decimal : {'.', ','}) {
                Recipe recipe;
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

    void read_noDelta_takesTheRateFromTheTimes()
    {
        QByteArray text = lvm({});
        text.replace("Delta_X", "Delta_Y");
        const Result<CaptureSet> set = read(text);
        QVERIFY(set.has_value());
        QVERIFY(std::abs(set->shots[0].channels[0].sampleRate_Hz - 1e5) < 1e-3);
        QByteArray none = lvm({.xColumns = "No"});
        none.replace("Delta_X", "Delta_Y");
        QCOMPARE(read(none)->shots.at(0).channels.at(0).sampleRate_Hz, 0.0);
    }

    void read_unreadableCell_isNamed()
    {
        QByteArray text = lvm({});
        text.replace("3.125000", "3.1#5000");
        const Result<CaptureSet> set = read(text);
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY2(contains(sentence(set), "\"3.1#5000\""), sentence(set).c_str());
        QVERIFY(contains(sentence(set), "column 2"));
    }

    void read_decimalStatedWrong_failsInsteadOfMisreading()
    {
        ImportSettings settings;
        settings.decimal = std::string(1, ',');
        QCOMPARE(findingId(read(lvm({}), settings)), std::string("CAP-018"));
    }

    void read_cutAtEveryByte_keepsWholeRowsOrFails()
    {
        Recipe recipe;
        recipe.segments = 2;
        recipe.rows = {5, 3};
        for (const char *xColumns : {"No", "One", "Multi"}) {
            recipe.xColumns = xColumns;
            const QByteArray whole = lvm(recipe);
            int readable = 0;
            for (qsizetype size = 0; size < whole.size(); ++size) {
                const Result<CaptureSet> set = read(whole.left(size));
                if (!set) {
                    QVERIFY(!sentence(set).empty());
                    continue;
                }
                ++readable;
                for (const Shot &shot : set->shots) {
                    for (std::size_t c = 0; c < shot.channels.size(); ++c) {
                        const std::vector<double> values = valuesOf(shot.channels[c]);
                        QVERIFY(values.size() <= std::size_t(recipe.rows[int(c)]));
                        for (std::size_t k = 0; k < values.size(); ++k)
                            QCOMPARE(values[k], value(int(c), int(k)));
                    }
                }
                const bool all
                    = set->shots.size() == 2 && set->shots[1].channels[0].samples.size() == 5;
                const bool beginsSecond = size > whole.size() / 2 + 200;
                QVERIFY(all || !beginsSecond || hasFinding(set->findings, "CAP-018"));
            }
            QVERIFY(readable > 100);
        }
    }

    void read_oneByteChanged_neverCrashes()
    {
        Recipe recipe;
        recipe.rows = {3, 2};
        const QByteArray whole = lvm(recipe);
        for (qsizetype at = 0; at < whole.size(); ++at) {
            for (const char byte : {'\0', '\n', '\t', '-', '\xFF', '9'}) {
                QByteArray changed = whole;
                changed[at] = byte;
                const Result<CaptureSet> set = read(changed);
                QVERIFY(set.has_value() || !sentence(set).empty());
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
        Recipe recipe;
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

} // namespace dyncal

DYNCAL_TEST(dyncal::TestLvm)
#include "tst_lvm.moc"
