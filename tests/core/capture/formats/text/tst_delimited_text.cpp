// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/delimited_text.h"
#include "tests/core/capture/formats/text/delimited_cases.h"
#include "tests/support/decimal_comma.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QElapsedTimer>
#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

class TestDelimitedText : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    Result<CaptureSet> read(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        return readDelimitedText(write(m_folder.filePath("t.csv"), bytes), settings, {});
    }

private slots:
    void read_anyDialect_sameNumbers_data()
    {
        QTest::addColumn<QByteArray>("separator");
        QTest::addColumn<char>("decimal");
        QTest::addColumn<QByteArray>("header");
        for (const char *separator : {",", ";", "\t", "|", " ", "   ", ", ", " ; "}) {
            for (const char decimal : {'.', ','}) {
                if (decimal == ',' && QByteArray(separator).contains(','))
                    continue;
                for (const char *header : {"", "made by x\n\n", "a note, with; all\tof | them\n"})
                    QTest::addRow("'%s' %c %d", separator, decimal, int(strlen(header)))
                        << QByteArray(separator) << decimal << QByteArray(header);
            }
        }
    }
    void read_anyDialect_sameNumbers()
    {
        QFETCH(QByteArray, separator);
        QFETCH(char, decimal);
        QFETCH(QByteArray, header);
        const int rows = 40;
        const double step = 1.25e-7;
        for (const char *lineEnd : {"\n", "\r\n", "\r"}) {
            QByteArray text = header + table(rows, step, separator, decimal);
            text.replace("\n", lineEnd);
            const Result<CaptureSet> set = read(text);
            QVERIFY2(set.has_value(), sentence(set).c_str());
            const Shot &shot = set->shots.at(0);
            QCOMPARE(shot.channels.size(), std::size_t(2)); // the first column is the time
            for (int k = 0; k < rows; ++k) {
                QCOMPARE(shot.channels[0].samples.at(k), std::sin(0.1 * k));
                QCOMPARE(shot.channels[1].samples.at(k), 0.5 * k * k);
            }
            QVERIFY(near(shot.channels[0].sampleRate_Hz, 1.0 / step, kRateAllowance));
            // Without a title that the numbers are seconds is sure, but said.
            QVERIFY(hasFinding(set->findings, "CAP-003"));
            QCOMPARE(worstSeverity(set->findings), Severity::Info);
        }
    }

    void read_oneColumn_hasNoRateAndNoRole()
    {
        const Result<CaptureSet> set = read("1.5\n-2e-3\n+3\n0x\n", {});
        QCOMPARE(findingId(set), std::string("CAP-018"));
        const Result<CaptureSet> good = read("1.5\n-2e-3\n+3\n");
        QVERIFY(good.has_value());
        const Channel &channel = good->shots.at(0).channels.at(0);
        QCOMPARE(valuesOf(channel), (std::vector<double>{1.5, -2e-3, 3.0}));
        QCOMPARE(channel.sampleRate_Hz, 0.0);
        QCOMPARE(channel.role, ChannelRole::Other);
        QCOMPARE(channel.name, std::string("column 1"));
        QVERIFY(channel.sha256.empty()); // sealing comes later
        QCOMPARE(good->shots[0].label, std::string("t"));
    }

    void read_titles_giveNamesUnitsAndTimeUnit_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("rate");
        QTest::newRow("round brackets") << QByteArray("time (s),p1 (bar)") << "p1"
                                        << "bar" << 1.0;
        QTest::newRow("square, ms") << QByteArray("t [ms],p1 [mV]") << "p1"
                                    << "mV" << 1e3;
        QTest::newRow("slash") << QByteArray("Zeit / \xC2\xB5s,p1 / MPa") << "p1"
                               << "MPa" << 1e6;
        QTest::newRow("latin-1 micro") << QByteArray("tid/\xB5s,p1/Pa") << "p1"
                                       << "Pa" << 1e6;
        QTest::newRow("suffix") << QByteArray("TIME_ns,p 1") << "p 1"
                                << "1" << 1e9;
        QTest::newRow("unit row") << QByteArray("X,CH1\nSecond,Volt") << "CH1"
                                  << "Volt" << 1.0;
        QTest::newRow("bracketed row") << QByteArray("t,CH1\n(ms),(kN)") << "CH1"
                                       << "kN" << 1e3;
        QTest::newRow("comment") << QByteArray("# by me\n# time [s], signal") << "signal"
                                 << "1" << 1.0;
        QTest::newRow("quotes") << QByteArray("\"time (s)\",\"p (V)\"") << "p"
                                << "V" << 1.0;
        QTest::newRow("other name") << QByteArray("age (us),p") << "p"
                                    << "1" << 1e6;
        QTest::newRow("accent") << QByteArray("t / s,Druck\xFC") << "Druck\u00FC"
                                << "1" << 1.0;
    }
    void read_titles_giveNamesUnitsAndTimeUnit()
    {
        QFETCH(QByteArray, header);
        QFETCH(QString, name);
        QFETCH(QString, unit);
        QFETCH(double, rate);
        const Result<CaptureSet> set = read(header + "\n-0.5,1.5\n0.0,2.5\n0.5,3.5\n1.0,4.5\n");
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(1));
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(QString::fromStdString(channel.name), name);
        QCOMPARE(QString::fromStdString(channel.unit), unit);
        QVERIFY(near(channel.sampleRate_Hz, 2.0 * rate, kRateAllowance));
        QVERIFY(near(channel.t0_s, -0.5 / rate, kRateAllowance));
    }

    void read_equalTitles_staySeparate()
    {
        const Result<CaptureSet> set = read("time,p,p,\n0.1,1,2,3\n0.2,1,2,3\n0.3,1,2,3\n");
        QVERIFY(set.has_value());
        QCOMPARE(set->shots[0].channels.at(1).name, std::string("p, column 3"));
        const Result<CaptureSet> named = read("time,p,p,q\n0.1,1,2,3\n0.2,1,2,3\n0.3,1,2,3\n");
        QCOMPARE(named->shots.at(0).channels.at(0).name, std::string("p"));
        QCOMPARE(named->shots.at(0).channels.at(2).name, std::string("q"));
        QCOMPARE(set->shots[0].channels.at(2).name, std::string("column 4"));
    }

    void read_byteOrderMarks_areNoText()
    {
        const QByteArray text("time,p\n0.1,1\n0.2,2\n0.3,3\n");
        const QString wide = QString::fromLatin1(text);
        QByteArray little("\xFF\xFE");
        QByteArray big("\xFE\xFF");
        for (const QChar c : wide) {
            little += QByteArray(1, c.toLatin1()) + QByteArray(1, '\0');
            big += QByteArray(1, '\0') + QByteArray(1, c.toLatin1());
        }
        for (const QByteArray &bytes : {"\xEF\xBB\xBF" + text, little, big}) {
            const Result<CaptureSet> set = read(bytes);
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QCOMPARE(set->shots[0].channels.size(), std::size_t(1));
            QCOMPARE(valuesOf(set->shots[0].channels[0]), (std::vector<double>{1, 2, 3}));
            QVERIFY(recogniseDelimitedText(
                        "x.csv", std::string_view(bytes.data(), std::size_t(bytes.size())))
                > 0);
        }
    }

    void read_columns_giveRolesAndLeaveOutTheRest()
    {
        const QByteArray text = table(20, 1e-6, ",", '.');
        const Result<CaptureSet> both
            = read(text, withColumns({{"time", 0}, {"dut", 2}, {"driven_side", 1}}));
        QVERIFY(both.has_value());
        QCOMPARE(both->shots[0].channels.size(), std::size_t(2));
        QCOMPARE(both->shots[0].channelWithRole(ChannelRole::Dut)->samples.at(4), 8.0);
        QCOMPARE(both->shots[0].channels[0].role, ChannelRole::DrivenSide);

        const Result<CaptureSet> one = read(text, withColumns({{"dut", 1}}));
        QCOMPARE(one->shots.at(0).channels.size(), std::size_t(1));
        QCOMPARE(one->shots[0].channels[0].sampleRate_Hz, 0.0); // the time was not named

        const Result<CaptureSet> time = read(text, withColumns({{"time", 0}}));
        QCOMPARE(time->shots.at(0).channels.size(), std::size_t(2));

        const Result<CaptureSet> none = read(text, withColumns({{"dut", 3}}));
        QCOMPARE(none.error().kind, ErrorKind::Usage);
        QVERIFY(contains(sentence(none), "0 to 2"));
    }

    void read_counterColumn_isNeitherTimeNorSamples()
    {
        const Result<CaptureSet> set
            = read("1;5,5\n2;5,6\n3;5,1\n4;5,2\n5;5,3\n6;5,9\n7;5,1\n8;5,2\n9;5,0\n");
        QVERIFY(set.has_value());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(1));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(set->findings, "CAP-003"));
    }

    void read_quotedCells_areWhatStandsBetweenTheQuotes()
    {
        const Result<CaptureSet> set
            = read("\"time, or so (s)\",\"p (V)\"\n\"0,5\",\"1,25E-04\"\n\"1,0\",\"-2,5\"\n"
                   "\"1,5\" , \"3,75\"\n");
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const Shot &shot = set->shots.at(0);
        QCOMPARE(shot.channels.size(), std::size_t(1)); // the first column has a unit of time
        QCOMPARE(shot.channels[0].name, std::string("p"));
        QCOMPARE(shot.channels[0].sampleRate_Hz, 2.0);
        QCOMPARE(valuesOf(shot.channels[0]), (std::vector<double>{1.25e-4, -2.5, 3.75}));
        const Result<CaptureSet> plain = read("\"a\";b\n\"1.5\";\"\"\n2.5;\"3\"\n\"3.5\";4\n");
        QVERIFY2(plain.has_value(), sentence(plain).c_str());
        QVERIFY(std::isnan(plain->shots.at(0).channels.at(1).samples.at(0)));
        QCOMPARE(plain->shots[0].channels[1].samples.at(1), 3.0);
        QCOMPARE(findingId(read("a;b\n1;2\n3;4\n5;6\n\"7\"8;9\n1;2\n")), std::string("CAP-018"));
    }

    void read_anyEncoding_sameTable_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QString text = QString::fromUtf8("Zeit (\xC2\xB5s);Dr\xC3\xBC"
                                               "ck (V)\n0,0;1,5\n0,5;2,5\n1,0;-3,5\n");
        const auto wide = [&](bool bigEndian) {
            QByteArray bytes;
            for (const QChar c : text) {
                bytes += static_cast<char>(bigEndian ? c.row() : c.cell());
                bytes += static_cast<char>(bigEndian ? c.cell() : c.row());
            }
            return bytes;
        };
        QTest::newRow("UTF-8") << text.toUtf8();
        QTest::newRow("UTF-8 with mark") << "\xEF\xBB\xBF" + text.toUtf8();
        QTest::newRow("Windows-1252") << text.toLatin1();
        QTest::newRow("UTF-16 LE") << "\xFF\xFE" + wide(false);
        QTest::newRow("UTF-16 BE") << "\xFE\xFF" + wide(true);
        QTest::newRow("UTF-16 LE without mark") << wide(false);
        QTest::newRow("UTF-16 BE without mark") << wide(true);
    }
    void read_anyEncoding_sameTable()
    {
        QFETCH(QByteArray, text);
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const Channel &channel = set->shots.at(0).channels.at(0);
        QCOMPARE(QString::fromStdString(channel.name),
            QString::fromUtf8("Dr\xC3\xBC"
                              "ck"));
        QCOMPARE(valuesOf(channel), (std::vector<double>{1.5, 2.5, -3.5}));
        QVERIFY(near(channel.sampleRate_Hz, 2e6, kRateAllowance));
        QVERIFY(recogniseDelimitedText("t.csv", text.toStdString()) > 0);
    }

    void read_germanExport_isReadWhole()
    {
        QByteArray text;
        for (int line = 1; line < 12; ++line)
            text += "Zeile " + QByteArray::number(line) + ";Wert\n";
        text += "Zeit[s];Kanal 1 [V];Kanal 2 [V]\n";
        for (int k = 0; k < 30; ++k)
            text += QByteArray::number(k * 1e-8, 'f', 8).replace('.', ',') + ";20,66;1,2E-04\n";
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QVERIFY(set->findings.empty());
        const std::vector<Channel> &channels = set->shots.at(0).channels;
        QCOMPARE(channels.at(0).samples.at(29), 20.66);
        QCOMPARE(channels.at(1).samples.at(29), 1.2e-4);
        QCOMPARE(channels.at(1).name, std::string("Kanal 2"));
        QVERIFY(near(channels.at(0).sampleRate_Hz, 1e8, kRateAllowance));
    }

    void read_skipRows_startsThere()
    {
        ImportSettings settings;
        settings.skipRows = 2;
        const Result<CaptureSet> set = read("2500\n2e-9\n0.5\n0.75\n", settings);
        QCOMPARE(valuesOf(set->shots.at(0).channels.at(0)), (std::vector<double>{0.5, 0.75}));
        settings.skipRows = 100;
        QCOMPARE(findingId(read("1\n2\n", settings)), std::string("CAP-001"));
    }

    void read_germanLocale_changesNothing()
    {
        const QByteArray text = table(20, 0.5, ";", ',');
        const std::vector<double> before = valuesOf(read(text)->shots.at(0).channels.at(1));
        const DecimalComma locale;
        QVERIFY(locale.isInForce());
        const std::vector<double> after = valuesOf(read(text)->shots.at(0).channels.at(1));
        QCOMPARE(after, before);
    }

    void recognise_textsAndOthers_byContent()
    {
        QCOMPARE(recogniseDelimitedText("a.csv", "1,2\n3,4\n"), 60);
        QCOMPARE(recogniseDelimitedText("a.bin", "1,2\n3,4\n"), 40);
        QCOMPARE(recogniseDelimitedText("a.CSV", "1.5\n2.5\n"), 60);
        for (const char *other : {"", "hello\nworld\n", "%PDF-1.4\n1 2 3\n\x01", "a,b\nc,d\n"})
            QCOMPARE(recogniseDelimitedText("a.csv", other), 0);
    }

    void read_stopRequested_isCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const std::string path
            = write(m_folder.filePath("long.csv"), QByteArray("1.5\n").repeated(70000));
        QCOMPARE(readDelimitedText(path, {}, {source.get_token(), {}}).error().kind,
            ErrorKind::Cancelled);
    }

    void read_manyRows_isFast()
    {
        const int rows = 400000;
        const std::string path
            = write(m_folder.filePath("big.csv"), "time,a,b\n" + table(rows, 1e-8, ",", '.'));
        QElapsedTimer timer;
        timer.start();
        const Result<CaptureSet> set = readDelimitedText(path, {}, {});
        const double megabytes
            = static_cast<double>(QFileInfo(QString::fromStdString(path)).size()) / 1e6;
        qInfo("%.1f MB in %lld ms", megabytes, static_cast<long long>(timer.elapsed()));
        QVERIFY(set.has_value());
        QCOMPARE(set->shots[0].channels[0].samples.size(), Index(rows));
    }

    void read_measuredTexts_matchAnIndependentParser()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("the folder of recordings is missing (DYNCAL_DATA)");
        struct Expectation
        {
            QString pattern, folder;
            std::size_t channels;
            std::size_t firstColumn;
            double rate_Hz;
            double tolerance;
        };
        // The nominal rates; single files differ a little as their number of rows does.
        const QList<Expectation> all{{"*.csv", "synthetic", 1, 0, 0.0, 0.0},
            {"acc_pcb_a*.txt", "highrate_ds5_impact", 1, 1, 50e3, 1e-3},
            {"acc_base_a*.txt", "highrate_ds5_impact", 1, 1, 49.958e3, 1e-3},
            {"csv_*.*", "derived", 3, 1, 1e6, 1e-9}};
        int files = 0;
        for (const Expectation &expected : all) {
            QDirIterator entry(folder + "/" + expected.folder, {expected.pattern}, QDir::Files,
                QDirIterator::Subdirectories);
            int here = 0;
            while (entry.hasNext()) {
                const std::string path = entry.next().toStdString();
                const Result<CaptureSet> set = readDelimitedText(path, {}, {});
                QVERIFY2(set.has_value(), sentence(set).c_str());
                QVERIFY2(worstSeverity(set->findings) == Severity::Info, path.c_str());
                const std::vector<Channel> &channels = set->shots.at(0).channels;
                const auto times = textColumn(path, 0);
                const double rows = static_cast<double>(times->size());
                const double rate_Hz = expected.firstColumn == 0
                    ? 0.0
                    : (rows - 1.0) / ((*times)[times->size() - 1] - (*times)[0]);
                QCOMPARE(channels.size(), expected.channels);
                for (std::size_t i = 0; i < channels.size(); ++i) {
                    const auto values = textColumn(path, expected.firstColumn + i);
                    const std::vector<double> read = valuesOf(channels[i]);
                    // The oracle takes the "1" of a title "shot 1" for a number, too.
                    const Index titles = values->size() - static_cast<Index>(read.size());
                    QVERIFY(titles == 0 || (titles == 1 && expected.firstColumn == 1));
                    QVERIFY(std::equal(read.begin(), read.end(), values->begin() + titles));
                    QVERIFY(near(channels[i].sampleRate_Hz, rate_Hz, kRateAllowance));
                    QVERIFY(near(rate_Hz, expected.rate_Hz, expected.tolerance));
                }
                ++here;
            }
            qInfo("%s: %d files", qPrintable(expected.pattern), here);
            files += here;
        }
        QVERIFY(files > 0);
    }
};

DYNCAL_TEST(TestDelimitedText)
#include "tst_delimited_text.moc"
