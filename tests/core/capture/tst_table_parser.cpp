// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables so long that several threads read them, against one line after the other.

#include "core/capture/formats/table_parser.h"

#include "core/capture/formats/plain_rows_ahead.h"
#include "core/capture/formats/text_table.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

using namespace dyncal;

namespace {

constexpr unsigned kSeed = 11;
constexpr std::size_t kBytes = 5 << 20; ///< several parts on any machine with two cores
const std::string kPath = "table.csv";

TextDialect dialect(Index columns)
{
    TextDialect result;
    result.separator = ';';
    result.columns = columns;
    return result;
}

std::string cell(std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    return QByteArray::number(uniform(random), 'e', 3 + static_cast<int>(random() % 15))
        .toStdString();
}

/// Rows of two numbers; every `odd`-th line on average is one that no fast way reads.
std::string table(std::mt19937_64 &random, std::uint64_t odd, const std::string &lineEnd)
{
    std::string text;
    while (text.size() < kBytes) {
        const std::string a = cell(random);
        const std::string b = cell(random);
        switch (random() % odd) {
        case 0:
            text += '"' + a + "\";" + b;
            break;
        case 1:
            text += a + ";";
            break;
        case 2:
            text += "nan ;" + b;
            break;
        case 3:
            break;
        default:
            text += a + ';' + b;
        }
        text += lineEnd;
    }
    return text + "1.5e+00;2.5e+00" + lineEnd;
}

/// What the rules say, a line and a cell at a time.
std::vector<std::vector<double>> lineByLine(const std::string &text)
{
    std::vector<std::vector<double>> columns(2);
    LineCursor lines(text);
    for (std::string_view line; lines.next(line);) {
        const auto cells = cellsOf(line, ';');
        for (std::size_t i = 0; i < columns.size(); ++i) {
            double value = std::numeric_limits<double>::quiet_NaN();
            if (i < cells.size())
                readCell(cells[i], '.', value);
            columns[i].push_back(value);
        }
    }
    return columns;
}

bool sameBits(const std::vector<double> &a, const std::vector<double> &b)
{
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0 && !(std::isnan(a[i]) && std::isnan(b[i])))
            return false;
    }
    return a.size() == b.size();
}

} // namespace

class TestTableParser : public QObject
{
    Q_OBJECT

private slots:
    void parseTable_long_isWhatEachLineSays_data()
    {
        QTest::addColumn<quint64>("odd");
        QTest::addColumn<QByteArray>("lineEnd");
        for (const char *end : {"\n", "\r\n", "\r"}) {
            const QByteArray name = QByteArray(end).replace('\r', "CR").replace('\n', "LF");
            QTest::newRow("plain, " + name) << quint64(1ULL << 62) << QByteArray(end);
            QTest::newRow("few others, " + name) << quint64(20000) << QByteArray(end);
            QTest::newRow("many others, " + name) << quint64(5) << QByteArray(end);
        }
    }
    void parseTable_long_isWhatEachLineSays()
    {
        QFETCH(quint64, odd);
        QFETCH(QByteArray, lineEnd);
        std::mt19937_64 random(kSeed);
        const std::string text = table(random, odd, lineEnd.toStdString());
        const Result<TableColumns> parsed = parseTable(kPath, TextSource(text), dialect(2), {});
        QVERIFY2(parsed.has_value(), parsed ? "" : english(parsed.error().message).c_str());
        const auto expected = lineByLine(text);
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY(sameBits(parsed->columns.at(i), expected[i]));
        QVERIFY(parsed->findings.empty());
    }

    void parseTable_badCellFarBehind_isNamedByItsLine()
    {
        std::mt19937_64 random(kSeed);
        const std::string good = table(random, 20000, "\n");
        const auto lines = std::count(good.begin(), good.end(), '\n');
        const std::string text = good + "1;x\n" + good;
        const Result<TableColumns> parsed = parseTable(kPath, TextSource(text), dialect(2), {});
        QVERIFY(!parsed);
        const std::string said = english(parsed.error().message);
        const std::string place = "line " + std::to_string(lines + 1) + ", column 2";
        QVERIFY2(said.find(place) != std::string::npos, said.c_str());
    }

    void parseTable_commentWithinTheData_isRefusedWhereverItStands()
    {
        std::mt19937_64 random(kSeed);
        const std::string good = table(random, 1ULL << 62, "\n");
        for (const double where : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            const auto feed = good.find('\n', static_cast<std::size_t>(where * kBytes));
            const std::string text
                = good.substr(0, feed + 1) + "# second table\n" + good.substr(feed + 1);
            const Result<TableColumns> parsed = parseTable(kPath, TextSource(text), dialect(2), {});
            QVERIFY(!parsed);
            QVERIFY(english(parsed.error().message).find("is a comment") != std::string::npos);
        }
    }

    void parseTable_commentsBehindTheData_arePassedOver()
    {
        // From before the middle to the end: other threads begin within them.
        std::mt19937_64 random(kSeed);
        const std::string rows = table(random, 1ULL << 62, "\n");
        std::string text = rows;
        while (text.size() < 3 * rows.size())
            text += "# saved by an instrument\n";
        const Result<TableColumns> parsed = parseTable(kPath, TextSource(text), dialect(2), {});
        QVERIFY(parsed.has_value());
        QVERIFY(sameBits(parsed->columns.at(1), lineByLine(rows).at(1)));
    }

    void parseTable_stopped_isCancelled()
    {
        std::mt19937_64 random(kSeed);
        std::string text = table(random, 1ULL << 62, "\n");
        text += text + text;
        std::stop_source stop;
        stop.request_stop();
        const Result<TableColumns> parsed
            = parseTable(kPath, TextSource(text), dialect(2), {stop.get_token(), {}});
        QVERIFY(!parsed && parsed.error().kind == ErrorKind::Cancelled);
    }

    void parseTable_long_reportsUpToOneAndNeverBackwards()
    {
        std::mt19937_64 random(kSeed);
        const std::string text = table(random, 20000, "\n");
        double last = 0.0;
        bool forwards = true;
        const Result<TableColumns> parsed = parseTable(
            kPath, TextSource(text), dialect(2), {{}, [&](double fraction) {
                                                      forwards = forwards && fraction >= last;
                                                      last = fraction;
                                                  }});
        QVERIFY(parsed.has_value() && forwards && last == 1.0);
    }

    void rowsAhead_partThatEndsEarly_saysWhere()
    {
        std::mt19937_64 random(kSeed);
        const std::string text = table(random, 1ULL << 62, "\n") + "no number\n1;2\n";
        const PlainRowReader reader(';', '.');
        const TextSource source{std::string_view(text)};
        PlainRowsAhead ahead(reader, source, 0, 2, {});
        std::uint64_t behind = 0;
        Index parts = 0;
        for (; ahead.nextBegin(); ++parts) {
            const std::uint64_t begin = *ahead.nextBegin();
            QVERIFY(text[begin - 1] == '\n' && (parts == 0 || behind == begin));
            const PlainRows rows = ahead.take();
            behind = rows.behind;
            const auto at = [&](std::uint64_t place) {
                return text.begin() + static_cast<std::ptrdiff_t>(place);
            };
            QCOMPARE(rows.rows(), std::count(at(begin), at(behind), '\n'));
        }
        if (parts == 0)
            QSKIP("this machine has one core: nothing is read ahead");
        QCOMPARE(text.substr(behind), std::string("no number\n1;2\n"));
    }
};

QTEST_APPLESS_MAIN(TestTableParser)
#include "tst_table_parser.moc"
