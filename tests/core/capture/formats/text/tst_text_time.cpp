// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What makes a sample rate of a text: a wrong rate is a wrong frequency.

#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/preview/text_preview.h"
#include "core/capture/formats/text/delimited_text.h"
#include "core/capture/formats/text/header_rate.h"
#include "core/capture/formats/text/time_words.h"
#include "tests/support/test_program.h"

#include "core/capture/formats/text/text_dialect.h"
#include "tests/core/capture/capture_test_support.h"

#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Rates come from printed decimals by a few roundings.
constexpr double kRounding = 1e-9;
constexpr int kRows = 40;

/// Rows "first + k step, noise"; `gapAt` leaves that row out.
QByteArray table(const QByteArray &header, double first, double step, int gapAt = -1)
{
    QByteArray text = header.isEmpty() ? QByteArray() : header + "\n";
    for (int k = 0; k < kRows; ++k) {
        if (k != gapAt)
            text += QByteArray::number(first + k * step, 'g', 12) + ","
                + QByteArray::number(std::sin(7.0 * k), 'f', 5) + "\n";
    }
    return text;
}

bool near(double a, double b)
{
    return std::abs(a - b) <= kRounding * std::abs(b);
}

TextDialect dialectWithHeader(std::vector<std::string_view> header, char separator = ';')
{
    TextDialect dialect;
    dialect.separator = separator;
    dialect.columns = 2;
    dialect.header = std::move(header);
    return dialect;
}

} // namespace

class TestTextTime : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    Result<CaptureSet> read(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        return readDelimitedText(write(m_folder.filePath("t.csv"), bytes), settings, {});
    }

    static ImportSettings stated(double rate_Hz)
    {
        ImportSettings settings;
        settings.sampleRate_Hz = rate_Hz;
        return settings;
    }

private slots:
    void read_timesWithoutUnit_giveARateOnlyBeyondDoubt_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("rate");
        QTest::addColumn<int>("severity"); ///< of CAP-003; -1: nothing is said
        const int info = int(Severity::Info);
        const int caution = int(Severity::Caution);
        const auto row
            = [](const char *name, const char *header, double step, double rate, int severity) {
                  QTest::newRow(name) << QByteArray(header) << step << rate << severity;
              };
        row("unit stated", "time (s),p", 1e-3, 1e3, -1);
        row("unit stated, slow", "time (s),p", 1.0, 1.0, -1);
        row("unit stated, ms", "time [ms],p", 1e-3, 1e6, -1);
        row("unit in the name", "time_us,p", 0.5, 2e6, -1);
        row("unit in words", "t in ms,p", 1e-3, 1e6, -1);
        row("unit behind", "Zeit ns,p", 10.0, 1e8, -1);
        row("titled, sure", "time,p", 1e-8, 1e8, info);
        row("titled, credible", "time,p", 1e-4, 1e4, caution);
        row("titled by LabVIEW", "X_Value,p", 1e-4, 1e4, caution);
        row("titled, counts", "time,p", 1.0, 0.0, caution);
        row("titled, nanoseconds perhaps", "time,p", 10.0, 0.0, caution);
        row("titled, slow", "time,p", 0.5, 0.0, caution);
        row("untitled, sure", "", 1e-6, 1e6, info);
        row("untitled, ms perhaps", "", 1e-3, 0.0, caution);
        row("untitled, counts", "", 1.0, 0.0, caution);
        row("numbered", "sample,p", 1.0, 0.0, caution);
        row("scope's numbers", "X,CH1\nSequence,Volt", 1.0, 0.0, caution);
    }
    void read_timesWithoutUnit_giveARateOnlyBeyondDoubt()
    {
        QFETCH(QByteArray, header);
        QFETCH(double, step);
        QFETCH(double, rate);
        QFETCH(int, severity);
        for (const double first : {0.0, 1.0}) {
            const Result<CaptureSet> set = read(table(header, first, step));
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QCOMPARE(set->shots.at(0).channels.size(), std::size_t(1)); // times are no samples
            const Channel &channel = set->shots[0].channels[0];
            QVERIFY2(near(channel.sampleRate_Hz, rate), qPrintable(QString::number(rate)));
            QCOMPARE(hasFinding(set->findings, "CAP-003"), severity >= 0);
            if (severity >= 0)
                QCOMPARE(int(worstSeverity(set->findings)), severity);
            QVERIFY(rate > 0.0 || channel.t0_s == 0.0);
        }
    }

    void read_statedRate_tellsTheUnitOfTheTimes()
    {
        for (const double unit_s : {1.0, 1e-3, 1e-6, 1e-9}) {
            const Result<CaptureSet> set
                = read(table("time,p", -20.0, 0.5), stated(1.0 / (0.5 * unit_s)));
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QVERIFY(near(set->shots[0].channels.at(0).sampleRate_Hz, 2.0 / unit_s));
            QVERIFY(near(set->shots[0].channels.at(0).t0_s, -20.0 * unit_s));
            QVERIFY(set->findings.empty());
        }
        const Result<CaptureSet> none = read(table("time,p", 0.0, 0.5), stated(51200.0));
        QCOMPARE(findingId(none), std::string("CAP-003"));
        QVERIFY(contains(sentence(none), "51.2 kHz") && contains(sentence(none), "0.5"));
        // Row numbers go with any rate.
        const Result<CaptureSet> counter = read(table("time,p", 0.0, 1.0), stated(51200.0));
        QVERIFY(counter.has_value() && counter->findings.empty());
    }

    void read_statedRateWithAReason_isLeftToTheImportRules()
    {
        ImportSettings settings = stated(51200.0);
        settings.sampleRateReason = "the clock was external";
        const Result<CaptureSet> times = read(table("time (s),p", 0.0, 1e-6), settings);
        QVERIFY2(times.has_value(), sentence(times).c_str());
        QVERIFY(near(times->shots[0].channels.at(0).sampleRate_Hz, 1e6)); // what the file says
        const Result<CaptureSet> bare = read(table("time,p", 0.0, 0.5), settings);
        QVERIFY2(bare.has_value(), sentence(bare).c_str());
        QCOMPARE(bare->shots[0].channels.at(0).sampleRate_Hz, 0.0);
        QCOMPARE(findingId(read(table("time (s),p", 0.0, 1e-6, 20), settings)),
            std::string("CAP-016")); // a gap has no reason
    }

    void read_frequencies_areNoRecording()
    {
        for (const char *header : {"Frequency,Re", "f (Hz),Re", "Frequenzen /MHz,Re",
                 "freq [kHz],Re", "omega (rad/s),Re", "Fr\xC3\xA9quence,Re"}) {
            const Result<CaptureSet> set = read(table(header, 0.1, 0.1));
            QCOMPARE(findingId(set), std::string("CAP-001"));
            QVERIFY2(contains(sentence(set), "frequencies"), sentence(set).c_str());
        }
        ImportSettings settings;
        settings.columns = {{"dut", 1}};
        QVERIFY(read(table("Frequency,Re", 0.1, 0.1), settings).has_value());
        // A channel of frequencies that does not rise is a channel.
        QVERIFY(read(QByteArray("f (Hz),p\n5.5,1\n5.25,2\n5.75,3\n").repeated(1)).has_value());
    }

    void read_gapInUntitledTimes_isCap016EvenWithAStatedRate()
    {
        for (const ImportSettings &settings : {ImportSettings(), stated(1e6)}) {
            for (const char *header : {"", "X,p", "time,p", "time (s),p"}) {
                const int titles = *header == '\0' ? 0 : 1;
                const Result<CaptureSet> set = read(table(header, 0.0, 1e-6, 20), settings);
                QCOMPARE(findingId(set), std::string("CAP-016"));
                const std::string line = "line " + std::to_string(titles + 21) + " ";
                QVERIFY2(contains(sentence(set), line), sentence(set).c_str());
            }
        }
        QCOMPARE(findingId(read(table("", 0.0, 1.0, 20))), std::string("CAP-016")); // row numbers
    }

    void read_risingColumnOfAnotherName_isNamedAsSuspicious()
    {
        const Result<CaptureSet> set = read(table("Sek,p", 0.0, 1e-6, 20), stated(1e6));
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(2));
        QCOMPARE(set->findings.at(0).id, std::string("CAP-016"));
        QCOMPARE(set->findings[0].severity, Severity::Caution);
        // A unit says what it is.
        QVERIFY(read(table("distance (Pa),p", 0.0, 1e-6, 20), stated(1e6))->findings.empty());
    }

    void read_timesThatTheRecipeLeavesOut_areStillHeard()
    {
        ImportSettings settings = stated(1e6);
        settings.columns = {{"dut", 1}};
        QVERIFY(read(table("time (s),p", 0.0, 1e-6), settings)->findings.empty());
        QVERIFY(read(table("", 0.0, 1e-6), settings)->findings.empty());
        for (const char *header : {"", "time (s),p"}) {
            const Result<CaptureSet> gap = read(table(header, 0.0, 1e-6, 20), settings);
            QVERIFY(gap.has_value());
            QCOMPARE(gap->findings.at(0).id, std::string("CAP-016"));
            QCOMPARE(gap->findings[0].severity, Severity::Caution);
        }
        const Result<CaptureSet> other = read(table("time (s),p", 0.0, 1e-5), settings);
        QCOMPARE(other->findings.at(0).id, std::string("CAP-003"));
        QVERIFY(contains(english(other->findings[0].message), "100 kHz"));
    }

    void read_headerAgainstTimes_isCap003()
    {
        const QByteArray times = table("time (s),p", 0.0, 1e-8);
        for (const char *header : {"Sample rate: 10 MHz\n", "Sampling interval;1e-7;s\n",
                 "# dt = 1e-7\n", "fs=10000000\n"}) {
            const Result<CaptureSet> set = read(header + times);
            if (QByteArray(header).startsWith("fs") || QByteArray(header).startsWith("# dt"))
                continue; // without unit a factor of 10 is checked below
            QCOMPARE(findingId(set), std::string("CAP-003"));
            QVERIFY2(contains(sentence(set), "10 MHz") && contains(sentence(set), "100 MHz"),
                sentence(set).c_str());
        }
        for (const char *header : {"fs=10000000\n", "# dt = 1e-7\n"})
            QCOMPARE(findingId(read(header + times)), std::string("CAP-003"));
        for (const char *header : {"Sample rate: 100 MHz\n", "Sampling interval,1e-8,s\n",
                 "fs = 100.05e6 Hz\n", "fs = 100000\n", "made by a person\n"}) {
            const Result<CaptureSet> set = read(header + times);
            QVERIFY2(set.has_value(), sentence(set).c_str());
            QVERIFY(near(set->shots[0].channels.at(0).sampleRate_Hz, 1e8));
        }
        // The recipe decides between the two, or against both.
        const Result<CaptureSet> decided = read("Sample rate: 10 MHz\n" + times, stated(1e8));
        QVERIFY2(decided.has_value(), sentence(decided).c_str());
        QCOMPARE(decided->findings.at(0).severity, Severity::Caution);
        QCOMPARE(
            findingId(read("Sample rate: 10 MHz\n" + times, stated(1e7))), std::string("CAP-003"));
        ImportSettings against = stated(1e7);
        against.columns = {{"dut", 1}};
        QVERIFY(read("Sample rate: 10 MHz\n" + times, against).has_value());
    }

    void read_headerRate_servesWhereThereAreNoTimes()
    {
        const QByteArray values("p (V)\n0.5\n0.25\n0.75\n");
        const Result<CaptureSet> set = read("Sample rate: 10 MHz\n" + values);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.at(0).sampleRate_Hz, 1e7);
        QVERIFY(set->findings.empty());
        const Result<CaptureSet> bare = read("dt = 1e-6\n" + values);
        QVERIFY(near(bare->shots[0].channels.at(0).sampleRate_Hz, 1e6));
        QCOMPARE(bare->findings.at(0).severity, Severity::Info);
        QCOMPARE(read("dt = 10\n" + values)->shots[0].channels.at(0).sampleRate_Hz, 0.0);
        const Result<CaptureSet> both = read("Sample rate: 10 MHz\nInterval\ndt: 1 us\n" + values);
        QCOMPARE(findingId(both), std::string("CAP-003"));
        QVERIFY(contains(sentence(both), "10 MHz") && contains(sentence(both), "1 MHz"));
        QVERIFY(read("Sample rate: 10 MHz\ndt: 0,1 us\n" + values).has_value());
    }

    void read_scopeTableWithIncrement_takesItsRate()
    {
        QByteArray text(
            "X,CH1,CH2,Start,Increment\nSequence,Volt,Volt,-6.000000e-04,2.000000e-06\n");
        for (int k = 0; k < 20; ++k)
            text += QByteArray::number(k) + ",1.5e+00," + QByteArray::number(k * k) + ",\n";
        const Result<CaptureSet> set = read(text);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(2));
        QVERIFY(near(set->shots[0].channels[0].sampleRate_Hz, 5e5));
        QCOMPARE(set->shots[0].channels[0].name, std::string("CH1"));
        QCOMPARE(set->shots[0].channels[1].unit, std::string("Volt"));
        QCOMPARE(set->shots[0].channels[1].samples.at(3), 9.0);
    }

    void headerRates_statements_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<double>("rate"); ///< 0: none
        QTest::addColumn<bool>("unit");
        const auto row = [](const char *line, double rate, bool unit) {
            QTest::newRow(line) << QByteArray(line) << rate << unit;
        };
        row("Sample rate: 10 MHz", 1e7, true);
        row("SAMPLE RATE;10;MS/s", 1e7, true);
        row("Sampling Rate [kHz]\t51.2", 51200.0, true);
        row("sample_rate_hz = 1e6", 1e6, true);
        row("# fs=50000", 5e4, false);
        row("Sampling interval 1e-8", 1e8, false);
        row("Sample Interval,2.000000e-09,s", 5e8, true);
        row("\"Sample Interval\";\"2,0E-09\";\"s\"", 5e8, true);
        row("Abtastrate: 2,5 MSa/s", 2.5e6, true);
        row("dt (us) : 0.5", 2e6, true);
        row("dt", 0.0, false);
        row("dt (s),p", 0.0, false);
        row("fs = 50", 0.0, false); // too slow to be believed without unit
        row("fs = 50 Hz", 50.0, true);
        row("fs = -1000", 0.0, false);
        row("fs = 0", 0.0, false);
        row("fs = nan", 0.0, false);
        row("Sample rate: 10 apples", 0.0, false);
        row("Sample rate: 10 ms", 0.0, false);
        row("offset 1e-8", 0.0, false); // "fs" within a word
        row("width=1e-8", 0.0, false);
    }
    void headerRates_statements()
    {
        QFETCH(QByteArray, line);
        QFETCH(double, rate);
        QFETCH(bool, unit);
        const std::string text = line.toStdString();
        const std::vector<HeaderRate> rates = headerRates(dialectWithHeader({"made by x", text}));
        QCOMPARE(rates.size(), std::size_t(rate > 0.0 ? 1 : 0));
        if (rate > 0.0) {
            QVERIFY2(near(rates[0].rate_Hz, rate), qPrintable(QString::number(rates[0].rate_Hz)));
            QCOMPARE(rates[0].unitStated, unit);
            QCOMPARE(rates[0].line, Index(2));
            QCOMPARE(rates[0].text, text);
        }
    }

    void riseOf_columns_areToldApart()
    {
        std::vector<double> values;
        for (int k = 0; k < 20; ++k)
            values.push_back(0.25 * k);
        QCOMPARE(riseOf(values), ColumnRise::Uniform);
        std::vector<double> gap = values;
        gap.erase(gap.begin() + 5);
        QCOMPARE(riseOf(gap), ColumnRise::Gaps);
        gap[7] = kNan;
        QCOMPARE(riseOf(gap), ColumnRise::Gaps);
        std::vector<double> counter, uneven;
        for (const double value : values) {
            counter.push_back(4.0 * value + 3.0);
            uneven.push_back(value * value);
        }
        QCOMPARE(riseOf(counter), ColumnRise::Counter);
        QCOMPARE(riseOf(uneven), ColumnRise::Uneven);
        values[12] = 0.0;
        QCOMPARE(riseOf(values), ColumnRise::None);
        QCOMPARE(riseOf(std::span(counter).first(5)), ColumnRise::None); // too few to tell
        QCOMPARE(riseOf(std::vector<double>(20, 1.0)), ColumnRise::None);
        QCOMPARE(riseOf({}), ColumnRise::None);
    }

    void titles_words_areKnown()
    {
        QVERIFY(
            isTimeTitle({"Time", ""}) && isTimeTitle({"t", "ms"}) && isTimeTitle({"Zeit ms", ""}));
        QVERIFY(!isTimeTitle({"T", "K"}) && !isTimeTitle({"timer", ""}) && !isTimeTitle({"", "s"}));
        QVERIFY(isTimeTitle({"time", "fortnight"})); // so that the unit is asked for
        QVERIFY(isNeutralTitle({"column 1", ""}) && isNeutralTitle({"X", ""}));
        QVERIFY(!isNeutralTitle({"p", ""}));
        QVERIFY(isRowNumberTitle({"Index", ""}) && isRowNumberTitle({"X", "Sequence"}));
        QCOMPARE(secondsPerUnit("Millisecond").value_or(0.0), 1e-3);
        QCOMPARE(hertzPerUnit("GSa/s").value_or(0.0), 1e9);
        QVERIFY(!secondsPerUnit("") && !hertzPerUnit("s"));
    }

    void preview_asksWhatTheImportWouldAsk()
    {
        const auto preview = [&](const QByteArray &text, const ImportSettings &settings = {}) {
            return previewText(write(m_folder.filePath("p.csv"), text), settings).value();
        };
        const TextPreview sure
            = preview("# by me\n" + table("time (us);p [bar]", 0.0, 0.5).replace(',', ';'));
        QVERIFY2(sure.question.empty(), sure.question.c_str());
        QCOMPARE(sure.columnTitles, (std::vector<std::string>{"time", "p"}));
        QCOMPARE(sure.units, (std::vector<std::string>{"us", "bar"}));
        QCOMPARE(sure.headerLines, Index(2));
        QCOMPARE(sure.dataRows, Index(kRows));
        QCOMPARE(sure.rows.size(), std::size_t(kRows));
        QCOMPARE(sure.rows.at(1).at(0), std::string("0.5"));
        QCOMPARE(sure.separator, ';');
        QCOMPARE(sure.timeColumn.value_or(-1), Index(0));
        QVERIFY(near(sure.sampleRate_Hz, 2e6));
        QCOMPARE(sure.encoding, std::string("UTF-8"));
        const TextPreview unsure = preview(table("time,p", 0.0, 1.0));
        QCOMPARE(unsure.sampleRate_Hz, 0.0);
        QVERIFY(contains(unsure.question, "sample_rate_hz"));
        QVERIFY(preview(table("time,p", 0.0, 1.0), stated(1e6)).question.empty());
        QVERIFY(!preview("1.5\n2.5\n3.5\n").question.empty()); // no rate
        const TextPreview grouped = preview("1,234;5,678\n2,345;6,789\n9,999;1,111\n", stated(1e6));
        QVERIFY(grouped.decimalAmbiguous && !grouped.question.empty());
    }

    void preview_badCells_areCountedAndTheFirstIsNamed()
    {
        const std::string path = write(m_folder.filePath("p.csv"),
            "a;b\n1,5;2\n2,5;3\n3,5;4\n4.5;x\n5,5\n6,5;1;7\n7,5;\xE4\n");
        const Result<TextPreview> preview = previewText(path, {});
        QVERIFY2(preview.has_value(), sentence(preview).c_str());
        QCOMPARE(preview->unreadableCells, Index(5));
        QVERIFY2(contains(preview->question, "line 5"), preview->question.c_str());
        QCOMPARE(preview->encoding, std::string("Windows-1252"));
        QCOMPARE(preview->rows.back().back(), std::string("\xC3\xA4"));
    }

    void preview_largeFile_looksAtItsBeginning()
    {
        const QByteArray row = "0.000001,1.5\n";
        const std::string path
            = write(m_folder.filePath("p.csv"), row.repeated(300000) + "not a number\n");
        const Result<TextPreview> preview = previewText(path, {});
        QVERIFY(preview.has_value());
        QCOMPARE(preview->dataRows, Index((1 << 20) / row.size()));
        QCOMPARE(preview->rows.size(), std::size_t(50));
        QCOMPARE(preview->unreadableCells, Index(0));
    }
};

DYNCAL_TEST(TestTextTime)
#include "tst_text_time.moc"
