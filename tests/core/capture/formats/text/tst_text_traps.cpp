// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Texts that look like others: what may be read wrongly must be refused, or said.

#include "core/capture/formats/text/delimited_text.h"
#include "core/capture/formats/text/header_rate.h"
#include "core/capture/formats/text/table_end.h"
#include "core/capture/formats/text/text_table.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/capture_test_support.h"

#include <QTemporaryDir>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRounding = 1e-9; ///< of times printed with 17 digits

bool near(double a, double b, double relative = kRounding)
{
    return std::abs(a - b) <= relative * std::abs(b);
}

QByteArray timesAndZeros(const std::vector<double> &times)
{
    QByteArray text("time (s),p (V)\n");
    for (const double time : times)
        text += QByteArray::number(time, 'g', 17) + ",0.5\n";
    return text;
}

} // namespace

class TestTextTraps : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    Result<CaptureSet> read(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        return readDelimitedText(write(m_folder.filePath("t.csv"), bytes), settings, {});
    }

private slots:
    void read_driftingTimes_areRefusedUnlessDigitsExplainThem_data();
    void read_driftingTimes_areRefusedUnlessDigitsExplainThem();
    void read_separatorBehindTheFirstRowOnly_losesNoRow();
    void read_noteAbovePairs_isSaidToBeUnclear();
    void read_blankAboveOneColumn_isNoTitle();
    void read_titlesWithBlanks_giveUnitsToTablesOfBlanks_data();
    void read_titlesWithBlanks_giveUnitsToTablesOfBlanks();
    void headerRates_grouped_areNoStatements_data();
    void headerRates_grouped_areNoStatements();
    void readCell_beyondTheRange_isZeroOnlyIfTooSmall_data();
    void readCell_beyondTheRange_isZeroOnlyIfTooSmall();
    void lastRow_judged_data();
    void lastRow_judged();
    void read_headerNearTheEnd_doesNotHideMissingDigits();
    void time_jitter_isForgivenUpToOnePercent();
    void time_rowTwiceOrMissing_namesItsLine();
    void time_columnsInPairs_needOneAxis_data();
    void time_columnsInPairs_needOneAxis();
};

void TestTextTraps::read_separatorBehindTheFirstRowOnly_losesNoRow()
{
    const QByteArray rows("0.5,1.5,\n1.0,2.5\n1.5,3.5,,\n2.0,4.5\n2.5,5.5\n");
    for (const char *header : {"time (s),p (V)\n", "time (s),p (V),\n"}) {
        const Result<CaptureSet> set = read(header + rows);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const Channel &channel = set->shots.at(0).channels.at(0);
        QCOMPARE(channel.name, std::string("p"));
        QCOMPARE(channel.sampleRate_Hz, 2.0);
        QCOMPARE(channel.t0_s, 0.5);
        QCOMPARE(channel.samples.size(), Index(5));
        QCOMPARE(channel.samples.at(0), 1.5);
        QVERIFY(set->findings.empty());
    }
    // A third number in a later row is no separator too many.
    QCOMPARE(findingId(read("0.5,1.5,\n1.0,2.5\n1.5,3.5\n2.0,4.5\n2.5,5.5,6.5\n")),
        std::string("CAP-018"));
}

void TestTextTraps::read_noteAbovePairs_isSaidToBeUnclear()
{
    for (const char *note : {"shot 12\n", "# a note\n", "shot 12\n\n"}) {
        const Result<CaptureSet> counted = read(note + QByteArray("0,5\n1,7\n2,9\n3,4\n"));
        QVERIFY(counted.has_value());
        QVERIFY2(hasFinding(counted->findings, "CAP-019"), note);
        const Result<CaptureSet> numbers = read(note + QByteArray("20,5\n19,7\n21,9\n"));
        QCOMPARE(numbers->shots.at(0).channels.at(0).samples.at(0), 20.5);
        QVERIFY(numbers->findings.empty());
    }
}

void TestTextTraps::read_blankAboveOneColumn_isNoTitle()
{
    // As without the blank line: the first part counts up, so these are pairs, which is said.
    for (const char *blank : {"", "\n", "  \n\n"}) {
        const Result<CaptureSet> set = read(blank + QByteArray("0,5\n1,7\n2,9\n3,4\n"));
        QVERIFY(set.has_value());
        QVERIFY(hasFinding(set->findings, "CAP-019"));
        QCOMPARE(set->shots.at(0).channels.back().samples.at(1), 7.0);
    }
}

void TestTextTraps::read_titlesWithBlanks_giveUnitsToTablesOfBlanks_data()
{
    QTest::addColumn<QByteArray>("header");
    QTest::addColumn<double>("rate");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("unit");
    const auto row = [](const char *header, double rate, const char *name, const char *unit) {
        QTest::newRow(header) << QByteArray(header) << rate << QString(name) << QString(unit);
    };
    row("time (ms)   p (V)", 1e6, "p", "V");
    row("# time [us] p [bar]", 1e9, "p", "bar");
    row("time (s), p (V)", 1e3, "p", "V");
    row("time(ms) p", 1e6, "p", "1");
    row("time p\n(ms) (V)", 1e6, "p", "V");
    row("Time (ms)  Pressure 1 (bar)", 1e6, "column 2", "1"); // three titles, but one of the time
}

void TestTextTraps::read_titlesWithBlanks_giveUnitsToTablesOfBlanks()
{
    QFETCH(QByteArray, header);
    QFETCH(double, rate);
    QFETCH(QString, name);
    QFETCH(QString, unit);
    const Result<CaptureSet> set
        = read(header + "\n0.000  1.5\n0.001  2.5\n 0.002 -3.5\n0.003\t4.5\n");
    QVERIFY2(set.has_value(), sentence(set).c_str());
    const Channel &channel = set->shots.at(0).channels.at(0);
    QVERIFY2(near(channel.sampleRate_Hz, rate), qPrintable(QString::number(channel.sampleRate_Hz)));
    QCOMPARE(QString::fromStdString(channel.name), name);
    QCOMPARE(QString::fromStdString(channel.unit), unit);
    QVERIFY(set->findings.empty());
}

void TestTextTraps::read_driftingTimes_areRefusedUnlessDigitsExplainThem_data()
{
    QTest::addColumn<double>("secondHalf"); ///< its steps, of those of the first half
    QTest::addColumn<int>("decimals"); ///< of the times in seconds, printed
    QTest::addColumn<bool>("isRead");
    QTest::newRow("steady") << 1.0 << 12 << true;
    QTest::newRow("steady, coarse digits") << 1.0 << 6 << true;
    QTest::newRow("1 % in the second half") << 1.0099 << 12 << false;
    QTest::newRow("1 % less") << 0.9901 << 12 << false;
    QTest::newRow("1 %, coarse digits") << 1.0099 << 7 << false;
    QTest::newRow("0.2 %") << 1.002 << 12 << false; // 3 steps off in the middle
    QTest::newRow("a third of a step") << 1.00022 << 12 << true;
}

void TestTextTraps::read_driftingTimes_areRefusedUnlessDigitsExplainThem()
{
    QFETCH(double, secondHalf);
    QFETCH(int, decimals);
    QFETCH(bool, isRead);
    constexpr double kStep = 1e-6;
    constexpr int kRows = 6000;
    double time = 0.0;
    QByteArray text("time (s),p (V)\n");
    for (int k = 0; k < kRows; ++k) {
        text += QByteArray::number(time, 'f', decimals) + ",0.5\n";
        time += kStep * (k < kRows / 2 ? 1.0 : secondHalf);
    }
    const auto set = read(text);
    QCOMPARE(set.has_value(), isRead);
    if (!isRead) {
        QCOMPARE(findingId(set), std::string("CAP-016"));
        const int middle = kRows / 2 + 2; // the line of that row, below the title
        QVERIFY2(decimals < 12 || contains(sentence(set), "drift"), sentence(set).c_str());
        QVERIFY(decimals < 12 || contains(sentence(set), "line " + std::to_string(middle) + " "));
        return;
    }
    QVERIFY(near(set->shots[0].channels[0].sampleRate_Hz, 2.0 / (1.0 + secondHalf) / kStep, 2e-4));
}

void TestTextTraps::headerRates_grouped_areNoStatements_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<char>("separator");
    QTest::addColumn<char>("decimal");
    QTest::addColumn<double>("rate"); ///< 0: none
    const auto row = [](const char *line, char separator, char decimal, double rate) {
        QTest::addRow("%s %c%c", line, separator, decimal)
            << QByteArray(line) << separator << decimal << rate;
    };
    row("Sample rate: 50,000 Hz", ';', '.', 0.0);
    row("Sample rate: 50,000 Hz", ';', ',', 50.0); // as all commas below
    row("Sample rate: 50.000 Hz", ';', ',', 0.0);
    row("Sample rate: 50.000 Hz", ';', '.', 50.0);
    row("Sample rate: 500,000 Hz", ',', '.', 0.0);
    row("Sample rate;\"1,000,000\";Hz", ';', '.', 0.0);
    row("Sample rate: 2.500.000 Hz", ';', ',', 0.0);
    row("Sample rate: 51.2 kHz", ';', ',', 51200.0);
    row("Sample rate: 51,25 kHz", ';', '.', 51250.0);
    row("Sample rate: 0,125 kHz", ';', '.', 125.0); // no thousands begin with 0
    row("Sampling interval: 1.000E-6 s", ';', ',', 1e6);
    row("Sampling interval: 1.0000 us", ';', ',', 1e6);
    row("Sample rate,1000000,200", ',', '.', 1e6);
    for (const char *mark : {" ", "'", "\u00A0", "\u2009", "\u202F", "\u2019"}) {
        const auto grouped = [&](QByteArray line, double rate) {
            row(line.replace('_', mark).constData(), ';', '.', rate);
        };
        grouped("Sample rate: 200_000 Hz", 2e5);
        grouped("Sample rate: 100_000_000 Hz", 1e8);
        grouped("Sample rate: 500_000 S/s", 5e5);
        grouped("Sample rate: 1_250.5 kHz", 1.2505e6);
        grouped("Sample rate [Hz]: 200_000", 2e5);
        grouped("Sample rate: 200_000", 0.0); // without a unit: one number, or two
    }
    row("Sample rate 200 000 Hz", ' ', '.', 0.0); // blanks separate cells
    row("Sample rate: 1000 500 Hz", ';', '.', 1000.0); // no group has four digits
    row("Max sample rate: 5 GS/s", ';', '.', 0.0);
    row("Max. sample rate: 5 GS/s", ';', '.', 0.0);
    row("Sample rate (max): 5 GS/s", ';', '.', 0.0);
    row("Sample rate 5 GS/s max", ';', '.', 0.0);
    row("Not sample rate 5e6", ';', '.', 0.0);
    row("Original sample rate: 5 MHz", ';', '.', 0.0);
    row("Max voltage: 5 V, sample rate: 5 MHz", ';', '.', 5e6);
    row("Sample rate: 5 MHz, max voltage: 5 V", ';', '.', 5e6);
    row("Actual sample rate: 5 MHz", ';', '.', 5e6);
}

void TestTextTraps::headerRates_grouped_areNoStatements()
{
    QFETCH(QByteArray, line);
    QFETCH(char, separator);
    QFETCH(char, decimal);
    QFETCH(double, rate);
    const std::string text = line.toStdString();
    TextDialect dialect;
    dialect.separator = separator;
    dialect.decimal = decimal;
    dialect.columns = 2;
    dialect.header = {text};
    const std::vector<HeaderRate> rates = headerRates(dialect);
    QCOMPARE(rates.size(), std::size_t(rate > 0.0 ? 1 : 0));
    QVERIFY(rates.empty() || near(rates[0].rate_Hz, rate));
}

void TestTextTraps::readCell_beyondTheRange_isZeroOnlyIfTooSmall_data()
{
    QTest::addColumn<QByteArray>("cell");
    QTest::addColumn<bool>("number");
    QTest::addColumn<double>("value"); ///< with its sign
    const auto row = [](const char *name, const QByteArray &cell, bool number, double value) {
        QTest::newRow(name) << cell << number << value;
    };
    const QByteArray zeros(400, '0');
    row("1e-400", "1e-400", true, 0.0);
    row("-1e-400", "-1e-400", true, -0.0);
    row("+1E-400", "+1E-400", true, 0.0);
    row("small without exponent", "0." + zeros + "1", true, 0.0);
    row("small with large exponent", "-0." + zeros + "1e+30", true, -0.0);
    row("small with absurd exponent", "1e-99999999999999999999", true, 0.0);
    row("in range by its exponent", "1" + zeros + "e-400", true, 1.0);
    row("in range by its zeros", "0." + zeros + "1e401", true, 1.0);
    row("1e400", "1e400", false, 0.0);
    row("large without exponent", "1" + zeros, false, 0.0);
    row("large with small exponent", "1" + zeros + "e-5", false, 0.0);
    row("large with mark", "1" + zeros + ".5E-10", false, 0.0);
    row("large with absurd exponent", "-1e+99999999999999999999", false, 0.0);
    row("zero with absurd exponent", "0e99999", true, 0.0);
}

void TestTextTraps::readCell_beyondTheRange_isZeroOnlyIfTooSmall()
{
    QFETCH(QByteArray, cell);
    QFETCH(bool, number);
    QFETCH(double, value);
    for (const char decimal : {'.', ','}) {
        const std::string text = QByteArray(cell).replace('.', decimal).toStdString();
        double found = 7.0;
        QCOMPARE(readCell(text, decimal, found), number ? CellKind::Number : CellKind::Unreadable);
        if (number) {
            QCOMPARE(found, value);
            QCOMPARE(std::signbit(found), std::signbit(value));
        }
    }
}

void TestTextTraps::lastRow_judged_data()
{
    QTest::addColumn<QByteArray>("above");
    QTest::addColumn<QByteArray>("last");
    QTest::addColumn<RowEnd>("end");
    const auto row = [](const char *name, const char *above, const char *last, RowEnd end) {
        QTest::newRow(name) << QByteArray(above) << QByteArray(last) << end;
    };
    const char *fixed = "1,5;2,50\n1,6;nan\n1,7;\n1,8;3,25\n";
    row("as above", fixed, "1,9;4,75", RowEnd::Whole);
    row("digit missing beside no numbers", fixed, "1,9;4,7", RowEnd::Cut);
    row("more digits than above", fixed, "1,9;4,755", RowEnd::Unclear);
    row("longer exponent", "1;2,5e-05\n", "1;2,5e-105", RowEnd::Unclear);
    row("no exponent", "1;2,5e-05\n", "1;2,512", RowEnd::Cut);
    const char *quoted = "\"1,5\";\"2,50\"\n\"1,6\";\"3,25\"\n";
    row("quote closed", quoted, "\"1,7\";\"4\"", RowEnd::Whole);
    row("quote closed, blank behind", quoted, "\"1,7\";\"4\" ", RowEnd::Whole);
    row("quote open", quoted, "\"1,7\";\"4,25", RowEnd::Cut);
    row("first quote open", quoted, "\"1", RowEnd::Cut);
    row("quote without a number", quoted, "\"1,7\";\"", RowEnd::Cut);
    row("only a header above", "a;b\n", "1;2", RowEnd::Unclear);
}

void TestTextTraps::lastRow_judged()
{
    QFETCH(QByteArray, above);
    QFETCH(QByteArray, last);
    QFETCH(RowEnd, end);
    TextDialect dialect;
    dialect.separator = ';';
    dialect.decimal = ',';
    dialect.columns = 2;
    const std::string text = (above + last).toStdString();
    const std::string_view line
        = std::string_view(text).substr(text.size() - std::size_t(last.size()));
    QCOMPARE(lastRowEnd(text, line, dialect), end);
}

void TestTextTraps::read_headerNearTheEnd_doesNotHideMissingDigits()
{
    // Within the stretch that is compared with the last line stands the header, too.
    for (const qsizetype length : {10, 4000, 5000, 9000}) {
        const QByteArray note = QByteArray(length, 'n') + "\ntime (s),p (V)\n";
        const Result<CaptureSet> set = read(note + "0.10,1.25\n0.20,1.50\n0.30,1.75\n0.40,2.0");
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.at(0).channels.at(0).samples.size(), Index(3));
        QCOMPARE(worstSeverity(set->findings), Severity::Caution);
    }
}

void TestTextTraps::time_jitter_isForgivenUpToOnePercent()
{
    constexpr std::size_t kRows = 200;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> offset(-0.0049, 0.0049); // two neighbours: 0.98 %
    for (const double step : {1.0, 2.5e-7, 0.037, 1e-9}) {
        std::vector<double> times;
        for (std::size_t k = 0; k < kRows; ++k)
            times.push_back((static_cast<double>(k) + offset(random)) * step);
        times.front() = 0.0;
        times.back() = static_cast<double>(kRows - 1) * step;
        const Result<CaptureSet> set = read(timesAndZeros(times));
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QVERIFY(near(set->shots.at(0).channels.at(0).sampleRate_Hz, 1.0 / step));
        for (const double late : {0.012, -0.012}) {
            std::vector<double> once = times;
            once[77] = once[76] + (1.0 + late) * step;
            once[78] = once[77] + step;
            once[79] = once[78] + step;
            for (std::size_t k = 80; k < kRows; ++k) // goes on from there, without another fault
                once[k] = once[k - 1] + step;
            const Result<CaptureSet> refused = read(timesAndZeros(once));
            QCOMPARE(findingId(refused), std::string("CAP-016"));
            QVERIFY2(contains(sentence(refused), "line 79 "), sentence(refused).c_str());
        }
    }
}

void TestTextTraps::time_rowTwiceOrMissing_namesItsLine()
{
    std::mt19937_64 random(6);
    for (int k = 0; k < 40; ++k) {
        std::vector<double> times;
        for (int row = 0; row < 100; ++row)
            times.push_back(-0.5 + row * 1.5e-6);
        const auto at = static_cast<std::ptrdiff_t>(1 + random() % 98);
        const bool twice = k % 2 == 0;
        if (twice)
            times.insert(times.begin() + at, times[static_cast<std::size_t>(at) - 1]);
        else
            times.erase(times.begin() + at);
        // Row `at` (from 0) stands in line at + 2 behind the header.
        const Result<CaptureSet> set = read(timesAndZeros(times));
        QCOMPARE(findingId(set), std::string("CAP-016"));
        const std::string place = "line " + std::to_string(at + 2) + ' ';
        QVERIFY2(contains(sentence(set), place), sentence(set).c_str());
        ImportSettings settings; // the recipe may leave the times out, but hears of it
        settings.columns = {{"dut", 1}};
        settings.sampleRate_Hz = 1.0 / 1.5e-6;
        const Result<CaptureSet> without = read(timesAndZeros(times), settings);
        QCOMPARE(without->findings.at(0).id, std::string("CAP-016"));
        QVERIFY(contains(english(without->findings[0].message), place));
    }
}

void TestTextTraps::time_columnsInPairs_needOneAxis_data()
{
    QTest::addColumn<QByteArray>("titles");
    QTest::addColumn<double>("first"); ///< of the second column of times
    QTest::addColumn<double>("step");
    QTest::addColumn<bool>("same");
    const auto row
        = [](const char *name, const char *titles, double first, double step, bool same) {
              QTest::newRow(name) << QByteArray(titles) << first << step << same;
          };
    row("same", "t1 (s),p1,t2 (s),p2", 0.0, 0.5, true);
    row("same in ms", "t1 (s),p1,t2 (ms),p2", 0.0, 500.0, true);
    row("same without unit", "time (s),p1,time,p2", 0.0, 0.5, true);
    row("slower", "t1 (s),p1,t2 (s),p2", 0.0, 1.0, false);
    row("slower, same title", "time (s),p1,time (s),p2", 0.0, 1.0, false);
    row("other unit", "time (s),p1,time_ms,p2", 0.0, 0.5, false);
    row("later", "t1 (s),p1,t2 (s),p2", 2.0, 0.5, false);
    row("no times", "t1 (s),p1,length (m),p2", 0.0, 1.0, true);
}

void TestTextTraps::time_columnsInPairs_needOneAxis()
{
    QFETCH(QByteArray, titles);
    QFETCH(double, first);
    QFETCH(double, step);
    QFETCH(bool, same);
    QByteArray text = titles + "\n";
    for (int k = 0; k < 20; ++k)
        text += QByteArray::number(0.5 * k) + ",1," + QByteArray::number(first + step * k) + ",2\n";
    const Result<CaptureSet> set = read(text);
    QCOMPARE(findingId(set), std::string(same ? "" : "CAP-003"));
    if (!same)
        QVERIFY2(contains(sentence(set), "holds other times than"), sentence(set).c_str());
    else
        QCOMPARE(set->shots.at(0).channels.at(0).sampleRate_Hz, 2.0);
    ImportSettings settings; // as the sentence says
    settings.columns = {{"time", 2}, {"dut", 3}};
    const Result<CaptureSet> named = read(text, settings);
    if (!same) {
        QVERIFY2(named.has_value(), sentence(named).c_str());
        const double unit_s = titles.contains("time_ms") ? 1e-3 : 1.0;
        QVERIFY(near(named->shots.at(0).channels.at(0).sampleRate_Hz, 1.0 / (step * unit_s)));
    }
}

DYNCAL_TEST(TestTextTraps)
#include "tst_text_traps.moc"
