// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts that the readers of text files are made of, one by one.

#include "core/capture/file_kind.h"
#include "core/capture/formats/lvm_header.h"
#include "core/capture/formats/table_end.h"
#include "core/capture/formats/text_dialect.h"
#include "core/capture/formats/text_table.h"
#include "core/capture/formats/text_time.h"
#include "core/capture/formats/time_axis.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kRounding = 1e-12; ///< a few roundings of a quotient

std::vector<double> uniform(double first, double step, int count)
{
    std::vector<double> times;
    for (int k = 0; k < count; ++k)
        times.push_back(first + step * k);
    return times;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= kRounding * std::abs(b);
}

std::string sentence(const Error &error)
{
    return english(error.message);
}

bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

/// A multi-channel LVM head up to the line of names, tab separated.
const char *const kLvmSegment = "Channels\t2\t\t\t\n"
                                "Samples\t10\t\t20\t\n"
                                "X0\t-0,5\t\t0.25\t\n"
                                "Delta_X\t1E-6\t\t2E-6\t\n"
                                "Y_Unit_Label\tVolts\t\tbar\t\n"
                                "Notes\tcold day\n"
                                "***End_of_Header***\n";

LvmTags tagsOf(const char *text)
{
    LineCursor lines(text);
    LvmTags tags;
    readLvmTags(lines, {}, '\t', tags);
    return tags;
}

} // namespace

class TestTextParts : public QObject
{
    Q_OBJECT

private slots:
    void unknownFile_saysWhatItIs_data();
    void unknownFile_saysWhatItIs();
    void isPlainText_controlCharacters_areNone();
    void isForeignFile_needsTheWholeSignature();
    void lines_anyEnd_data();
    void lines_anyEnd();
    void cells_ofBlanks_areRuns();
    void readCell_numbers_data();
    void readCell_numbers();
    void sampleColumn_emptyCells_areInvalidOnlyBeforeAValue();
    void utf8Text_foreignBytes_areWindows1252();
    void dialect_ofLines_data();
    void dialect_ofLines();
    void dialect_stated_isTaken();
    void dialect_withoutNumbers_isNone();
    void titles_unitsAndNames_areSplit();
    void titles_none_areNumbered();
    void time_units_scaleTheRate_data();
    void time_units_scaleTheRate();
    void time_unknownUnit_isCap016();
    void time_namedColumns_withoutTime_haveNone();
    void time_singleRow_hasNoRate();
    void time_gap_namesTheLine();
    void time_decreasing_isNoRate();
    void timeAxis_gap_isLocated();
    void printedResolution_lastDigit_data();
    void printedResolution_lastDigit();
    void lastRow_judged_data();
    void lastRow_judged();
    void unfinishedLine_severity_followsTheEnd();
    void lvmSeparator_standsBehindATag();
    void lvmTags_special_isPassedOver();
    void lvmFileHeader_words();
    void lvmSegment_multi_everyChannelItsColumn();
    void lvmSegment_claims_areChecked();
    void lvmSegment_badNumbers_areUnknown();
};

void TestTextParts::unknownFile_saysWhatItIs_data()
{
    QTest::addColumn<QByteArray>("head");
    QTest::addColumn<QString>("words");
    QTest::addColumn<bool>("foreign");
    const auto row = [](const char *name, const QByteArray &head, const char *words, bool foreign) {
        QTest::newRow(name) << head << words << foreign;
    };
    row("pdf", "%PDF-1.7", "a PDF document", true);
    row("zip", "PK\x03\x04", "a ZIP archive or an office document", true);
    row("doc", "\xD0\xCF\x11\xE0", "an old office document", true);
    row("png", "\x89PNG\r\n", "a PNG picture", true);
    row("jpeg", "\xFF\xD8\xFF\xE0", "a JPEG picture", true);
    row("gif", "GIF89a", "a GIF picture", true);
    row("gzip", "\x1F\x8B\x08", "compressed file (gzip)", true);
    row("7z", "7z\xBC\xAF", "a 7-Zip archive", true);
    row("matlab 5", "MATLAB 5.0 MAT-file, Platform", "like a MATLAB file", true);
    row("matlab 7.3", "MATLAB 7.3 MAT-file, Platform", "a MATLAB file", true);
    row("riff", "RIFF....AVI ", "a RIFF file", true);
    row("elf", QByteArray("\x7F\x45LF\x02"), "a program", true);
    row("empty", "", "is empty", false);
    row("prose", "Dear reader,", "a text without rows of numbers", false);
    row("latin",
        "sm\xF8rebr\xF8"
        "d",
        "a text without rows of numbers", false);
    row("binary", QByteArray("\0\1\2", 3), "a binary file of unknown kind", false);
}

void TestTextParts::unknownFile_saysWhatItIs()
{
    QFETCH(QByteArray, head);
    QFETCH(QString, words);
    QFETCH(bool, foreign);
    const std::string bytes = head.toStdString();
    const Error error = unknownFile("a/b.dat", bytes, "HDF5 and CSV").value();
    QCOMPARE(error.kind, ErrorKind::FileUnreadable);
    QCOMPARE(error.findingId, std::string("CAP-001"));
    QVERIFY2(contains(sentence(error), words.toStdString()), sentence(error).c_str());
    QVERIFY(contains(sentence(error), "a/b.dat"));
    QVERIFY(contains(sentence(error), "Readable are: HDF5 and CSV."));
    QCOMPARE(isForeignFile(bytes), foreign);
}

void TestTextParts::isPlainText_controlCharacters_areNone()
{
    QVERIFY(isPlainText(""));
    QVERIFY(isPlainText("1;2\r\n\t3\f"));
    QVERIFY(isPlainText("\xC2\xB5s"));
    QVERIFY(!isPlainText(std::string_view("1\0", 2)));
    QVERIFY(!isPlainText("\x1B[0m"));
}

void TestTextParts::isForeignFile_needsTheWholeSignature()
{
    for (const char *head : {"%PD", "PK", "GIF", "MATLAB 5", " %PDF", "0.1;0.2"})
        QVERIFY2(!isForeignFile(head), head);
}

void TestTextParts::lines_anyEnd_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("terminated");
    QTest::newRow("LF") << QByteArray("a\n\nb\n") << true;
    QTest::newRow("CR LF") << QByteArray("a\r\n\r\nb\r\n") << true;
    QTest::newRow("CR") << QByteArray("a\r\rb\r") << true;
    QTest::newRow("no end") << QByteArray("a\n\nb") << false;
}

void TestTextParts::lines_anyEnd()
{
    QFETCH(QByteArray, text);
    QFETCH(bool, terminated);
    const std::string bytes = text.toStdString();
    LineCursor lines(bytes);
    std::vector<std::string> found;
    bool lastTerminated = false;
    for (std::string_view line; lines.next(line); lastTerminated = lines.terminated())
        found.emplace_back(line);
    QCOMPARE(found, (std::vector<std::string>{"a", "", "b"}));
    QCOMPARE(lines.number(), Index(3));
    QCOMPARE(lastTerminated || lines.terminated(), terminated);
}

void TestTextParts::cells_ofBlanks_areRuns()
{
    QCOMPARE(
        cellsOf("  1 \t 2   3 ", kBlankSeparator), (std::vector<std::string_view>{"1", "2", "3"}));
    QCOMPARE(cellsOf(" 1 ;; 2;", ';'), (std::vector<std::string_view>{"1", "", "2", ""}));
}

void TestTextParts::readCell_numbers_data()
{
    QTest::addColumn<QString>("cell");
    QTest::addColumn<QChar>("decimal");
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("value");
    const auto row = [](const char *cell, char decimal, CellKind kind, double value) {
        QTest::addRow("'%s' %c", cell, decimal)
            << cell << QChar(decimal) << static_cast<int>(kind) << value;
    };
    row("1.5", '.', CellKind::Number, 1.5);
    row("-1,5", ',', CellKind::Number, -1.5);
    row("+2e3", '.', CellKind::Number, 2000.0);
    row("1,5E-03", ',', CellKind::Number, 0.0015);
    row("", '.', CellKind::Empty, 0.0);
    row("1,5", '.', CellKind::Unreadable, 0.0);
    row("1.5", ',', CellKind::Unreadable, 0.0);
    row("1.5V", '.', CellKind::Unreadable, 0.0);
    row("0x10", '.', CellKind::Unreadable, 0.0);
    row("--1", '.', CellKind::Unreadable, 0.0);
    row("1 000", '.', CellKind::Unreadable, 0.0);
    row("e5", '.', CellKind::Unreadable, 0.0);
}

void TestTextParts::readCell_numbers()
{
    QFETCH(QString, cell);
    QFETCH(QChar, decimal);
    QFETCH(int, kind);
    QFETCH(double, value);
    double found = 0.0;
    const std::string text = cell.toStdString();
    QCOMPARE(static_cast<int>(readCell(text, decimal.toLatin1(), found)), kind);
    if (kind == static_cast<int>(CellKind::Number))
        QCOMPARE(found, value);
}

void TestTextParts::sampleColumn_emptyCells_areInvalidOnlyBeforeAValue()
{
    SampleColumn column;
    column.addValueAt(0, 1.0);
    QCOMPARE(column.size(), Index(1));
    QVERIFY(!column.hasGaps());
    column.addValueAt(3, 2.0);
    QCOMPARE(column.size(), Index(4));
    QVERIFY(std::isnan(column.values()[1]) && std::isnan(column.values()[2]));
    QCOMPARE(column.values()[3], 2.0);
    QVERIFY(column.hasGaps());
}

void TestTextParts::utf8Text_foreignBytes_areWindows1252()
{
    QCOMPARE(utf8Text("\xC2\xB5s"), std::string("\xC2\xB5s"));
    QCOMPARE(utf8Text("\xB5s"), std::string("\xC2\xB5s"));
    QCOMPARE(utf8Text("plain"), std::string("plain"));
    QCOMPARE(lowerCase("\xC3\x85 Time"), std::string("\xC3\x85 time"));
}

void TestTextParts::dialect_ofLines_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QChar>("separator");
    QTest::addColumn<QChar>("decimal");
    QTest::addColumn<int>("headerLines");
    QTest::addColumn<int>("columns");
    const auto row = [](const char *name, const char *text, char separator, char decimal,
                         int headerLines, int columns) {
        QTest::newRow(name) << QByteArray(text) << QChar(separator) << QChar(decimal) << headerLines
                            << columns;
    };
    row("comma", "t,p\n0.1,1.5\n0.2,2.5\n0.3,3.5\n", ',', '.', 1, 2);
    row("semicolon", "t;p\n0,1;1,5\n0,2;2,5\n0,3;3,5\n", ';', ',', 1, 2);
    row("tab", "# made today\nt\tp\tq\n0.1\t1.5\t1\n0.2\t2.5\t2\n", '\t', '.', 2, 3);
    row("blanks", "0.1   1.5\n0.2   2.5\n0.3   3.5\n", ' ', '.', 0, 2);
    row("bar", "0.1|1.5\n0.2|2.5\n0.3|3.5\n", '|', '.', 0, 2);
}

void TestTextParts::dialect_ofLines()
{
    QFETCH(QByteArray, text);
    QFETCH(QChar, separator);
    QFETCH(QChar, decimal);
    QFETCH(int, headerLines);
    QFETCH(int, columns);
    const std::string bytes = text.toStdString();
    const auto dialect = dialectOf(bytes, {});
    QVERIFY(dialect.has_value());
    QCOMPARE(QChar(dialect->separator), separator);
    QCOMPARE(QChar(dialect->decimal), decimal);
    QCOMPARE(dialect->headerLines(), Index(headerLines));
    QCOMPARE(dialect->columns, Index(columns));
    QVERIFY(dialect->ambiguous.empty());
}

void TestTextParts::dialect_stated_isTaken()
{
    ImportSettings settings;
    settings.separator = ",";
    settings.decimal = ".";
    const auto pairs = dialectOf("1,5\n2,5\n", settings);
    QVERIFY(pairs.has_value());
    QCOMPARE(pairs->columns, Index(2));
    QVERIFY(pairs->ambiguous.empty());
    settings.separator = ";";
    settings.decimal = ",";
    QCOMPARE(dialectOf("1,5\n2,5\n", settings).value().columns, Index(1));
    settings.skipRows = 1;
    QCOMPARE(dialectOf("1,5\n2,5\n", settings).value().headerLines(), Index(1));
}

void TestTextParts::dialect_withoutNumbers_isNone()
{
    for (const char *text : {"", "\n\n", "no numbers\nat all\n", ";;;\n;;;\n"})
        QVERIFY2(!dialectOf(text, {}), text);
}

void TestTextParts::titles_unitsAndNames_areSplit()
{
    TextDialect dialect;
    dialect.separator = ';';
    dialect.columns = 4;
    dialect.header = {"some words", "Time [ms];p (bar);force / N;p"};
    const std::vector<ColumnTitle> titles = columnTitles(dialect);
    QCOMPARE(titles.size(), std::size_t(4));
    QCOMPARE(titles[0].name, std::string("Time"));
    QCOMPARE(titles[0].unit, std::string("ms"));
    QCOMPARE(titles[1].unit, std::string("bar"));
    QCOMPARE(titles[2].name, std::string("force"));
    QCOMPARE(titles[2].unit, std::string("N"));
    QCOMPARE(titles[3].name, std::string("p, column 4"));
}

void TestTextParts::titles_none_areNumbered()
{
    TextDialect dialect;
    dialect.columns = 2;
    QCOMPARE(columnTitles(dialect)[1].name, std::string("column 2"));
    QVERIFY(columnTitles(dialect)[1].unit.empty());
}

void TestTextParts::time_units_scaleTheRate_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("seconds");
    QTest::newRow("s") << "Time"
                       << "s" << 1.0;
    QTest::newRow("ms") << "Zeit"
                        << "ms" << 1e-3;
    QTest::newRow("us") << "x"
                        << "us" << 1e-6;
    QTest::newRow("micro sign") << "x" << QString::fromUtf8("\xC2\xB5s") << 1e-6;
    QTest::newRow("Greek mu") << "x" << QString::fromUtf8("\xCE\xBCs") << 1e-6;
    QTest::newRow("ns") << "x"
                        << "ns" << 1e-9;
    QTest::newRow("suffix") << "time_ms"
                            << "" << 1e-3;
    QTest::newRow("capitals") << "TIME"
                              << "MS" << 1e-3;
}

void TestTextParts::time_units_scaleTheRate()
{
    QFETCH(QString, name);
    QFETCH(QString, unit);
    QFETCH(double, seconds);
    const std::vector<ColumnTitle> titles{{name.toStdString(), unit.toStdString()}, {"p", "V"}};
    const auto time
        = timeOfTable("f", {}, {}, titles, {uniform(-2.0, 0.5, 20), std::vector<double>(20, 1.0)});
    QVERIFY(time.has_value());
    QCOMPARE(time->column.value_or(-1), Index(0));
    QVERIFY(isNear(time->sampleRate_Hz, 2.0 / seconds));
    QVERIFY(isNear(time->first_s, -2.0 * seconds));
}

void TestTextParts::time_unknownUnit_isCap016()
{
    const auto time = timeOfTable("f.csv", {}, {}, {{"time", "fortnight"}, {"p", "V"}},
        {uniform(0.0, 1.0, 9), uniform(0.0, 1.0, 9)});
    QVERIFY(!time);
    QCOMPARE(time.error().findingId, std::string("CAP-016"));
    QVERIFY(contains(sentence(time.error()), "\"fortnight\""));
}

void TestTextParts::time_namedColumns_withoutTime_haveNone()
{
    ImportSettings settings;
    settings.columns["dut"] = 1;
    const std::vector<std::vector<double>> columns{uniform(0.0, 1e-6, 9), uniform(0.0, 1.0, 9)};
    const auto time = timeOfTable("f", settings, {}, {{"time", "s"}, {"p", "V"}}, columns);
    QVERIFY(time && !time->column);
    QCOMPARE(time->sampleRate_Hz, 0.0);
    settings.columns["time"] = 0;
    QVERIFY(isNear(
        timeOfTable("f", settings, {}, {{"x", ""}, {"p", "V"}}, columns).value().sampleRate_Hz,
        1e6));
}

void TestTextParts::time_singleRow_hasNoRate()
{
    for (const std::vector<double> &values : {std::vector<double>{}, std::vector<double>{1.0}}) {
        const auto time = timeOfTable("f", {}, {}, {{"time", "s"}, {"p", "V"}}, {values, values});
        QVERIFY(time.has_value());
        QCOMPARE(time->sampleRate_Hz, 0.0);
    }
}

void TestTextParts::time_gap_namesTheLine()
{
    std::vector<double> times = uniform(0.0, 1e-6, 100);
    for (std::size_t k = 40; k < times.size(); ++k)
        times[k] += 2e-6; // two samples missing before row 40 (from 0)
    TextDialect dialect;
    dialect.header.resize(3);
    const auto time = timeOfTable(
        "f.csv", {}, dialect, {{"time", "s"}, {"p", "V"}}, {times, uniform(0.0, 1.0, 100)});
    QVERIFY(!time);
    QCOMPARE(time.error().findingId, std::string("CAP-016"));
    QVERIFY2(contains(sentence(time.error()), "line 44 "), sentence(time.error()).c_str());
}

void TestTextParts::time_decreasing_isNoRate()
{
    const auto time = timeOfTable("f.csv", {}, {}, {{"time", "s"}, {"p", "V"}},
        {uniform(1.0, -1e-3, 20), uniform(0.0, 1.0, 20)});
    QVERIFY(!time || time->sampleRate_Hz >= 0.0);
    const auto constant = timeOfTable("f.csv", {}, {}, {{"time", "s"}, {"p", "V"}},
        {std::vector<double>(20, 1.0), uniform(0.0, 1.0, 20)});
    QVERIFY(!constant || std::isfinite(constant->sampleRate_Hz));
}

void TestTextParts::timeAxis_gap_isLocated()
{
    std::vector<double> times = uniform(0.0, 0.5, 50);
    const TimeAxis whole = timeAxisOf(times);
    QVERIFY(!whole.irregular);
    QCOMPARE(whole.step, 0.5);
    times.erase(times.begin() + 20);
    const TimeAxis gap = timeAxisOf(times);
    QCOMPARE(gap.irregular.value_or(-1), Index(20));
    QCOMPARE(gap.step, 0.5);
    times[5] = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(timeAxisOf(times).irregular.value_or(-1), Index(5));
}

void TestTextParts::printedResolution_lastDigit_data()
{
    QTest::addColumn<QString>("cell");
    QTest::addColumn<QChar>("decimal");
    QTest::addColumn<double>("resolution");
    QTest::newRow("fixed") << "0.0120" << QChar('.') << 1e-4;
    QTest::newRow("exponent") << "1.5E-5" << QChar('.') << 1e-6;
    QTest::newRow("plus") << "1.25e+3" << QChar('.') << 10.0;
    QTest::newRow("integer") << "17" << QChar('.') << 1.0;
    QTest::newRow("comma") << "0,25" << QChar(',') << 0.01;
}

void TestTextParts::printedResolution_lastDigit()
{
    QFETCH(QString, cell);
    QFETCH(QChar, decimal);
    QFETCH(double, resolution);
    const std::string text = cell.toStdString();
    QVERIFY(isNear(printedResolution(text, decimal.toLatin1()), resolution));
}

void TestTextParts::lastRow_judged_data()
{
    QTest::addColumn<QByteArray>("above");
    QTest::addColumn<QByteArray>("last");
    QTest::addColumn<int>("end");
    const auto row = [](const char *name, const char *above, const char *last, RowEnd end) {
        QTest::newRow(name) << QByteArray(above) << QByteArray(last) << static_cast<int>(end);
    };
    const char *fixed = "0.1,1.50\n0.2,2.50\n0.3,3.50\n";
    row("same digits", fixed, "0.4,4.50", RowEnd::Whole);
    row("digit missing", fixed, "0.4,4.5", RowEnd::Cut);
    row("number missing", fixed, "0.4,", RowEnd::Cut);
    row("cell missing", fixed, "0.4", RowEnd::Cut);
    row("no number", fixed, "0.4,-", RowEnd::Cut);
    row("separator behind", fixed, "0.4,4.5,", RowEnd::Whole);
    row("exponent cut", "0.1,1.5e-05\n0.2,2.5e-05\n", "0.3,3.5e-0", RowEnd::Cut);
    row("exponent whole", "0.1,1.5e-05\n0.2,2.5e-05\n", "0.3,3.5e-05", RowEnd::Whole);
    row("varying", "0.1,1.5\n0.2,2.125\n0.3,3\n", "0.4,4.2", RowEnd::Unclear);
    row("nothing above", "", "0.4,4.5", RowEnd::Unclear);
}

void TestTextParts::lastRow_judged()
{
    QFETCH(QByteArray, above);
    QFETCH(QByteArray, last);
    QFETCH(int, end);
    TextDialect dialect;
    dialect.columns = 2;
    const std::string text = (above + last).toStdString();
    const std::string_view line
        = std::string_view(text).substr(static_cast<std::size_t>(above.size()));
    QCOMPARE(static_cast<int>(lastRowEnd(text, line, dialect)), end);
}

void TestTextParts::unfinishedLine_severity_followsTheEnd()
{
    const Finding cut = unfinishedLine("f.csv", 17, RowEnd::Cut);
    QCOMPARE(cut.id, std::string("CAP-018"));
    QCOMPARE(cut.severity, Severity::Caution);
    QVERIFY(contains(english(cut.message), "line 17"));
    QCOMPARE(unfinishedLine("f.csv", 17, RowEnd::Unclear).severity, Severity::Info);
}

void TestTextParts::lvmSeparator_standsBehindATag()
{
    QCOMPARE(lvmSeparator("LabVIEW Measurement\t\nWriter_Version\t2\n"), '\t');
    QCOMPARE(lvmSeparator("LabVIEW Measurement,\nSeparator,Comma\n"), ',');
    QCOMPARE(lvmSeparator("***End_of_Header***,\nSeparator\tTab\n"), ',');
    QCOMPARE(lvmSeparator("***End_of_Header***\nSeparator,Comma\n"), '\t'); // behind the header
    QCOMPARE(lvmSeparator(""), '\t');
}

void TestTextParts::lvmTags_special_isPassedOver()
{
    LineCursor lines("***Start_Special***\nOperator\tnobody\n***End_of_Header***\n"
                     "***End_Special***\n\nOperator\tsomebody\nOperator\tlater\n"
                     "***End_of_Header***\t\nrest\n");
    LvmTags tags;
    QVERIFY(readLvmTags(lines, "Project\tx", '\t', tags));
    QCOMPARE(tags.at("Operator").at(0), std::string_view("somebody")); // the first one counts
    QCOMPARE(tags.at("Project").at(0), std::string_view("x"));
    std::string_view rest;
    QVERIFY(lines.next(rest) && rest == "rest");
    LineCursor endless("Operator\tx\n");
    QVERIFY(!readLvmTags(endless, {}, '\t', tags));
}

void TestTextParts::lvmFileHeader_words()
{
    const LvmFileHeader comma
        = lvmFileHeader(tagsOf("Decimal_Separator\t,\nX_Columns\tMulti\nOperator\tJ\xF8rgen\n"
                               "Date\t2024/05/06\nTime\t01:02:03\n***End_of_Header***\n"),
            '\t');
    QCOMPARE(comma.decimal.value_or('?'), ',');
    QCOMPARE(comma.xColumns, LvmXColumns::Multi);
    QCOMPARE(comma.notes.at("operator"), std::string("J\xC3\xB8rgen"));
    QCOMPARE(comma.notes.at("start_local"), std::string("2024/05/06 01:02:03"));
    const LvmFileHeader plain
        = lvmFileHeader(tagsOf("X_Columns\tNo\nDate\t1903/12/31\n***End_of_Header***\n"), '\t');
    QVERIFY(!plain.decimal && plain.notes.empty()); // that date means none
    QCOMPARE(plain.xColumns, LvmXColumns::None);
    QCOMPARE(lvmFileHeader({}, ',').xColumns, LvmXColumns::One);
}

void TestTextParts::lvmSegment_multi_everyChannelItsColumn()
{
    LvmFileHeader file;
    file.xColumns = LvmXColumns::Multi;
    const auto segment
        = lvmSegment(tagsOf(kLvmSegment), "X_Value\tDUT\tX_Value\tside\tComment", file);
    QVERIFY(segment.has_value());
    QCOMPARE(segment->channels.size(), std::size_t(2));
    const LvmChannel &dut = segment->channels[0];
    const LvmChannel &side = segment->channels[1];
    QCOMPARE(dut.name, std::string("DUT"));
    QCOMPARE(dut.column, Index(1));
    QCOMPARE(dut.xColumn.value_or(-1), Index(0));
    QCOMPARE(dut.x0, -0.5); // either decimal mark
    QCOMPARE(dut.deltaX, 1e-6);
    QCOMPARE(dut.declaredSamples.value_or(-1), Index(10));
    QCOMPARE(side.name, std::string("side"));
    QCOMPARE(side.column, Index(3));
    QCOMPARE(side.xColumn.value_or(-1), Index(2));
    QCOMPARE(side.unit, std::string("bar"));
    QCOMPARE(side.deltaX, 2e-6);
    QCOMPARE(side.declaredSamples.value_or(-1), Index(20));
    QCOMPARE(segment->notes.at("comment"), std::string("cold day"));
}

void TestTextParts::lvmSegment_claims_areChecked()
{
    LvmFileHeader file;
    const char *end = "***End_of_Header***\n";
    const auto claimed = [&](const std::string &count, const char *names) {
        const std::string text = "Channels\t" + count + "\n" + end;
        LineCursor lines(text);
        LvmTags tags;
        readLvmTags(lines, {}, '\t', tags);
        const auto segment = lvmSegment(tags, names, file);
        return segment ? static_cast<int>(segment->channels.size()) : -1;
    };
    QCOMPARE(claimed("2", "X_Value\ta\tb\tComment"), 2);
    QCOMPARE(claimed("1", "X_Value\ta\tb\tComment"), 1);
    QCOMPARE(claimed("3", "X_Value\ta\tb\tComment"), -1);
    QCOMPARE(claimed("1e15", "X_Value\ta\tComment"), -1);
    QCOMPARE(claimed("0", "X_Value\ta\tComment"), -1);
    QCOMPARE(claimed("-1", "X_Value\ta\tComment"), 1); // no count: the names tell
    QCOMPARE(claimed("many", "X_Value\ta\tb"), 2);
    QCOMPARE(claimed("1", ""), -1);
    QCOMPARE(claimed("1", "X_Value"), -1);
}

void TestTextParts::lvmSegment_badNumbers_areUnknown()
{
    const auto segment = lvmSegment(
        tagsOf("Channels\t1\nSamples\t1e300\nX0\tnan\nDelta_X\t-1\n***End_of_Header***\n"),
        "X_Value\ta\tComment", {});
    QVERIFY(segment.has_value());
    QVERIFY(!segment->channels[0].declaredSamples);
    QCOMPARE(segment->channels[0].x0, 0.0);
    QCOMPARE(segment->channels[0].deltaX, 0.0);
}

DYNCAL_TEST(TestTextParts)
#include "tst_text_parts.moc"
