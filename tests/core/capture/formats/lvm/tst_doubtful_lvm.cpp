// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of LabVIEW with something amiss: refused, or read with a finding.

#include "core/capture/formats/lvm/lvm.h"
#include "tests/core/capture/formats/lvm/made_lvm.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

class TestDoubtfulLvm : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    Result<CaptureSet> read(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        return readLvm(write(m_folder.filePath("t.lvm"), bytes), settings, {});
    }

private slots:
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

    void read_xOfAnotherKind_isNoRecording_data()
    {
        QTest::addColumn<QByteArray>("tag");
        QTest::addColumn<double>("unit_s"); ///< 0: refused
        QTest::newRow("time") << QByteArray("X_Dimension\tTime\tTime") << 1.0;
        QTest::newRow("seconds") << QByteArray("X_Unit_Label\ts\ts") << 1.0;
        QTest::newRow("milliseconds") << QByteArray("X_Unit_Label\tms\tms") << 1e-3;
        QTest::newRow("frequency") << QByteArray("X_Dimension\tFrequency\tFrequency") << 0.0;
        QTest::newRow("length") << QByteArray("X_Dimension\tTime\tLength") << 0.0;
        QTest::newRow("hertz") << QByteArray("X_Unit_Label\tHz\tHz") << 0.0;
    }

    void read_xOfAnotherKind_isNoRecording()
    {
        QFETCH(QByteArray, tag);
        QFETCH(double, unit_s);
        QByteArray text = lvm({});
        text.replace("X0\t", tag + "\r\nX0\t");
        const Result<CaptureSet> set = read(text);
        QCOMPARE(set.has_value(), unit_s > 0.0);
        if (unit_s == 0.0) {
            QCOMPARE(findingId(set), std::string("CAP-001"));
            return;
        }
        const Channel &channel = set->shots[0].channels[1];
        QCOMPARE(channel.sampleRate_Hz, 1.0 / LvmRecipe().delta / unit_s);
        QCOMPARE(channel.t0_s, -0.5 * unit_s);
    }

    void read_declaredSamples_areOnlyCompared()
    {
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
        LvmRecipe recipe;
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
};

DYNCAL_TEST(TestDoubtfulLvm)
#include "tst_doubtful_lvm.moc"
