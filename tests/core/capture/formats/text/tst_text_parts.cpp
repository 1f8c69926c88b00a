// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts that the readers of text files are made of, one by one.

#include "core/capture/formats/text/column_titles.h"
#include "core/capture/formats/text/table_end.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_table.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestTextParts : public QObject
{
    Q_OBJECT

private slots:
    void lines_anyEnd_data();
    void lines_anyEnd();
    void cells_ofBlanks_areRuns();
    void readCell_numbers_data();
    void readCell_numbers();
    void sampleColumn_emptyCells_areInvalidOnlyBeforeAValue();
    void dialect_ofLines_data();
    void dialect_ofLines();
    void dialect_stated_isTaken();
    void dialect_withoutNumbers_isNone();
    void titles_unitsAndNames_areSplit();
    void titles_none_areNumbered();
    void lastRow_judged_data();
    void lastRow_judged();
    void unfinishedLine_severity_followsTheEnd();
};

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

DYNCAL_TEST(TestTextParts)
#include "tst_text_parts.moc"
