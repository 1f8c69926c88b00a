// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Texts with something amiss: refused, or read with a finding.

#include "core/capture/formats/text/delimited_text.h"
#include "tests/core/capture/formats/text/delimited_cases.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

class TestDoubtfulText : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    Result<CaptureSet> read(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        return readDelimitedText(write(m_folder.filePath("t.csv"), bytes), settings, {});
    }

private slots:
    void read_irregularTimes_areCap016()
    {
        QByteArray gap("time,p\n");
        for (int k = 0; k < 100; ++k) {
            if (k < 50 || k > 52)
                gap += QByteArray::number(k * 1e-5, 'g', 12) + ",1.5\n";
        }
        const Result<CaptureSet> set = read(gap);
        QCOMPARE(findingId(set), std::string("CAP-016"));
        QVERIFY2(contains(sentence(set), "line 52 "), sentence(set).c_str());
        QCOMPARE(findingId(read("t,p\n0,1\n1,1\n2,1\n3.02,1\n4,1\n")), std::string("CAP-016"));
        QVERIFY(read("t,p\n0,1\n1,1\n2,1\n3.005,1\n4,1\n").has_value());
        QCOMPARE(findingId(read("t,p\n3,1\n2,1\n1,1\n")), std::string("CAP-016")); // backwards
        QCOMPARE(findingId(read("t,p\n1,1\n1,1\n1,1\n")), std::string("CAP-016")); // stands still
        QCOMPARE(findingId(read("t,p\n0,1\n,1\n2,1\n")), std::string("CAP-016")); // no time
    }

    void read_timesPrintedCoarsely_areForgivenUpToHalfAStep()
    {
        QByteArray fine("time,p\n");
        QByteArray coarse("time,p\n");
        for (int k = 0; k < 2000; ++k) {
            fine += QByteArray::number(k * 1.953125e-5, 'f', 6) + ",1.5\n";
            coarse += QByteArray::number(k * 1.953125e-5, 'f', 4) + ",1.5\n";
        }
        const Result<CaptureSet> set = read(fine);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        // Both ends are known to half a digit of 1e-6 in 0.039 s.
        QVERIFY(near(set->shots[0].channels[0].sampleRate_Hz, 51200.0, 3e-5));
        QCOMPARE(findingId(read(coarse)), std::string("CAP-016"));
    }

    void read_statedRateAgainstTimes_isCap003()
    {
        ImportSettings settings;
        settings.sampleRate_Hz = 10e6;
        const QByteArray text = "time (ns),p\n0,1.5\n10,1.5\n20,1.5\n30,1.5\n";
        const Result<CaptureSet> set = read(text, settings);
        QCOMPARE(findingId(set), std::string("CAP-003"));
        QVERIFY(contains(sentence(set), "10 MHz") && contains(sentence(set), "100 MHz"));
        settings.sampleRate_Hz = 100.05e6; // 0.05 %
        QVERIFY(read(text, settings).has_value());
    }

    void read_invalidCells_areNan()
    {
        const Result<CaptureSet> set
            = read("a,b\n1.5,2.5\n,3.5\nnan,4.5\nNaN,5.5\n2.5,\n3.5,1.5\n");
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const std::vector<double> a = valuesOf(set->shots[0].channels[0]);
        const std::vector<double> b = valuesOf(set->shots[0].channels[1]);
        QCOMPARE(a.size(), std::size_t(6));
        QCOMPARE(b.size(), std::size_t(6));
        QVERIFY(std::isnan(a[1]) && std::isnan(a[2]) && std::isnan(a[3]) && std::isnan(b[4]));
        QCOMPARE(a[5], 3.5);
    }

    void read_blankLines_keepTheirPlaceInTimeOrEndTheFile()
    {
        const Result<CaptureSet> set = read("1.5\n2.5\n3.5\n\n5.5\n\n\n");
        QVERIFY(set.has_value());
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.samples.size(), Index(5));
        QVERIFY(std::isnan(channel.samples.at(3)));
        QCOMPARE(channel.samples.at(4), 5.5);
    }

    void read_unreadableCell_isNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        const QByteArray head = "a;b\n1,5;2\n2,5;3\n3,5;4\n";
        QTest::newRow("letters") << head + "4,5;x\n1,5;2\n"
                                 << "line 5, column 2: \"x\"";
        QTest::newRow("other mark") << head + "4.5;2\n1,5;2\n"
                                    << "line 5, column 1: \"4.5\"";
        QTest::newRow("too large") << head + "1e999;2\n1,5;2\n"
                                   << "\"1e999\"";
        QTest::newRow("short row") << head + "1,5\n1,5;2\n"
                                   << "line 5 has 1 cells";
        QTest::newRow("long row") << head + "1,5;2;3\n1,5;2\n"
                                  << "line 5 has 3 cells";
        QTest::newRow("first row")
            << QByteArray("0#1,1.5\n0.2,1.6\n0.3,1.7\n0.4,2\n") << "line 1, column 1: \"0#1\"";
        QTest::newRow("two marks") << head + "1,234,567;2\n"
                                   << "\"1,234,567\"";
    }
    void read_unreadableCell_isNamed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const Result<CaptureSet> set = read(text);
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY2(contains(sentence(set), words.toStdString()), sentence(set).c_str());
    }

    void read_decimalCommaAlone_neverBecomesTwoColumns()
    {
        const Result<CaptureSet> set = read("20,66\n20,05\n19,98\n");
        QVERIFY(set.has_value());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(1));
        QCOMPARE(valuesOf(set->shots[0].channels[0]), (std::vector<double>{20.66, 20.05, 19.98}));
        QVERIFY(set->findings.empty()); // "05" tells
        const Result<CaptureSet> unclear = read("20,66\n20,15\n19,98\n");
        QCOMPARE(valuesOf(unclear->shots.at(0).channels.at(0)).at(0), 20.66);
        QVERIFY(hasFinding(unclear->findings, "CAP-019"));
        const Result<CaptureSet> titled = read("time,counts\n0,66\n1,15\n2,98\n");
        QCOMPARE(titled->shots.at(0).channels.at(0).samples.at(0), 66.0);
        QVERIFY(!hasFinding(titled->findings, "CAP-019"));
        ImportSettings settings;
        settings.separator = std::string(1, ',');
        QCOMPARE(read("20,66\n20,15\n19,98\n", settings)->shots[0].channels.size(), std::size_t(2));
    }

    void read_threeDigitsBehindEveryComma_isCap019()
    {
        const QByteArray text("1,234;5,678\n2,345;6,789\n9,999;1,111\n");
        const Result<CaptureSet> set = read(text);
        QVERIFY(set.has_value());
        QCOMPARE(set->findings.size(), std::size_t(1));
        QCOMPARE(set->findings[0].id, std::string("CAP-019"));
        QCOMPARE(set->findings[0].severity, Severity::Caution);
        QCOMPARE(set->shots[0].channels[0].samples.at(0), 1.234);
        ImportSettings settings;
        settings.decimal = std::string(1, ',');
        QVERIFY(read(text, settings)->findings.empty());
        QVERIFY(read(text + "1,25;1,111\n")->findings.empty());
        QVERIFY(read(text + "0,125;1,111\n")->findings.empty()); // no thousands begin with 0
    }

    void read_namesThatDoNotFit_areNotUsedButTheTimeIs()
    {
        // Two header lines for seven columns above six.
        QByteArray text("Time (ms),s1,s2,s3,s4,s5,mean\nms,g,g,g,g,g,g\n");
        for (int k = 0; k < 20; ++k)
            text += QByteArray::number(9.5 + k * 1e-3, 'f', 3) + ",1.5,2.5,3.5,4.5,5.5\n";
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const std::vector<Channel> &channels = set->shots.at(0).channels;
        QCOMPARE(channels.size(), std::size_t(5));
        QCOMPARE(channels[0].name, std::string("column 2"));
        QCOMPARE(channels[4].samples.at(0), 5.5);
        QVERIFY(near(channels[0].sampleRate_Hz, 1e6, kRateAllowance));
        QVERIFY(near(channels[0].t0_s, 9.5e-3, kRateAllowance));
        QCOMPARE(set->findings.size(), std::size_t(1));
        QVERIFY(contains(english(set->findings[0].message), "7 cells above 6 columns"));
    }

    void read_headerOfBareCounts_isNoSample()
    {
        QByteArray text("20\n2.e-09\n3\n.485382\n");
        for (int k = 0; k < 20; ++k)
            text += QByteArray::number(0.001 * std::cos(k), 'f', 9) + "\n";
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.at(0).channels.at(0).samples.size(), Index(20));
        QCOMPARE(set->shots[0].channels[0].samples.at(0), 0.001);
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 5e8);
        QCOMPARE(set->findings.at(0).id, std::string("CAP-003"));
        const Result<CaptureSet> shorter = read(text.left(text.lastIndexOf('\n', -2) + 1));
        QCOMPARE(findingId(shorter), std::string("CAP-018"));
        QCOMPARE(findingId(read(text + "0.000123456\n")), std::string("CAP-018"));
        ImportSettings settings;
        settings.skipRows = 0;
        QCOMPARE(read(text, settings)->shots.at(0).channels.at(0).samples.at(0), 20.0);
        // Two lines of header, and a column that only begins like one.
        const QByteArray values = text.mid(text.indexOf(".485382\n") + 8);
        QCOMPARE(read("20\n1e-6\n" + values)->shots.at(0).channels.at(0).samples.size(), Index(20));
        QCOMPARE(
            read("20.5\n1e-6\n" + values)->shots.at(0).channels.at(0).samples.size(), Index(22));
        QCOMPARE(read("20\n0.5\n" + values)->shots.at(0).channels.at(0).samples.size(), Index(22));
    }

    void read_comments_mayFollowTheDataButNotInterruptIt()
    {
        const QByteArray head("# made by x\ntime (s),p\n0.0,1.5\n0.5,2.5\n1.0,3.5\n");
        const Result<CaptureSet> behind = read(head + "# end\n\n# really, 1, 2\n");
        QVERIFY2(behind.has_value(), sentence(behind).c_str());
        QCOMPARE(behind->shots.at(0).channels.at(0).samples.size(), Index(3));
        QVERIFY(behind->findings.empty());
        const Result<CaptureSet> within = read(head + "# lost trigger\n1.5,4.5\n");
        QCOMPARE(findingId(within), std::string("CAP-018"));
        QVERIFY2(contains(sentence(within), "line 6 is a comment"), sentence(within).c_str());
        QCOMPARE(findingId(read(head + "end of data\n")), std::string("CAP-018"));
    }

    void read_commaAsSeparatorAndMark_isCap019()
    {
        const Result<CaptureSet> set = read("t (s),p (V)\n0,1,1,5\n0,2,2,5\n0,3,3,5\n");
        QCOMPARE(findingId(set), std::string("CAP-019"));
        QVERIFY2(contains(sentence(set), "names 2 columns"), sentence(set).c_str());
        QVERIFY(read("a,b\n0.1,1,1,5\n0,2,2,5\n0,3,3,5\n").has_value()); // points: four columns
    }

    void read_rowOfNumbersAboveOtherText_isSaid()
    {
        const Result<CaptureSet> set = read("0.0,1.5\nlater:\n0.5,2.5\n1.0,3.5\n1.5,4.5\n");
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.at(0).channels.at(0).samples.size(), Index(3));
        QCOMPARE(set->findings.at(0).id, std::string("CAP-018"));
        QCOMPARE(set->findings.at(0).severity, Severity::Caution);
    }

    void read_noNumbers_isCap001()
    {
        for (const char *text : {"", "\n\n", "words only\n", ";;;\n;;;\n"})
            QCOMPARE(findingId(read(text)), std::string("CAP-001"));
        QCOMPARE(findingId(readDelimitedText("/no/such", {}, {})), std::string("CAP-018"));
    }

    void read_lastLineWithoutEnd_isJudgedByTheRowsAbove()
    {
        const QByteArray fixed = "0.10,1.25\n0.20,1.50\n0.30,1.75\n";
        const auto rows = [&](const QByteArray &text) {
            const Result<CaptureSet> set = read(text);
            return set ? set->shots.at(0).channels.at(0).samples.size() : Index(-1);
        };
        QCOMPARE(rows(fixed + "0.40,2.00"), Index(4));
        QVERIFY(read(fixed + "0.40,2.00")->findings.empty());
        for (const char *cut : {"0", "0.40", "0.40,", "0.40,2", "0.40,2.", "0.40,2.0"}) {
            QCOMPARE(rows(fixed + cut), Index(3));
            const Result<CaptureSet> set = read(fixed + cut);
            QCOMPARE(set->findings.at(0).id, std::string("CAP-018"));
            QCOMPARE(set->findings.at(0).severity, Severity::Caution);
        }
        const Result<CaptureSet> unclear = read("1\n20\n300");
        QCOMPARE(unclear->shots.at(0).channels.at(0).samples.size(), Index(3));
        QCOMPARE(unclear->findings.at(0).severity, Severity::Info);
        const Result<CaptureSet> exponent = read("1e-06\n1.5e-05\n2.25e-0");
        QCOMPARE(exponent->shots.at(0).channels.at(0).samples.size(), Index(2)); // not 2.25
    }

    void read_cutAtEveryByte_isAPrefixOrAnError()
    {
        const QByteArray whole = "# my table\ntime [us];p [bar]\n" + table(12, 0.5, ";", ',');
        const Result<CaptureSet> all = read(whole, withColumns({{"time", 0}, {"dut", 1}}));
        QVERIFY(all.has_value());
        const std::vector<double> expected = valuesOf(all->shots[0].channels[0]);
        int readable = 0;
        for (qsizetype size = 0; size < whole.size(); ++size) {
            const Result<CaptureSet> set
                = read(whole.left(size), withColumns({{"time", 0}, {"dut", 1}}));
            if (!set) {
                QVERIFY(!sentence(set).empty());
                continue;
            }
            ++readable;
            const std::vector<double> values = valuesOf(set->shots[0].channels[0]);
            QVERIFY(values.size() <= expected.size());
            QVERIFY(std::equal(values.begin(), values.end() - 1, expected.begin()));
        }
        QVERIFY(readable > whole.size() / 2);
    }

    void read_oneByteChanged_neverCrashes()
    {
        const QByteArray whole = "time,p\n" + table(6, 0.5, ",", '.');
        for (qsizetype at = 0; at < whole.size(); ++at) {
            for (const char byte : {'\0', '\n', ',', 'e', '-', '\xFF', '9'}) {
                QByteArray changed = whole;
                changed[at] = byte;
                const Result<CaptureSet> set = read(changed);
                QVERIFY(set.has_value() || !sentence(set).empty());
            }
        }
    }
};

DYNCAL_TEST(TestDoubtfulText)
#include "tst_doubtful_text.moc"
