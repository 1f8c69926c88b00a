// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables so long that several threads read them, against one line after the other.

#include "core/capture/formats/text/table_parser.h"
#include "tests/support/test_program.h"

#include "core/capture/formats/text/plain_rows_ahead.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_table.h"
#include "tests/support/scratch_folder.h"

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

        const testing::ScratchFolder folder; // the same, a block at a time
        for (const std::string &mark : {std::string(), std::string("\xEF\xBB\xBF")}) {
            const std::string bytes = mark + text;
            const auto source = openText(folder.write("table.csv", bytes.data(), bytes.size()));
            QVERIFY(source.has_value() && !source->inMemory() && source->size() == text.size());
            const Result<TableColumns> inBlocks = parseTable(kPath, *source, dialect(2), {});
            QVERIFY(inBlocks.has_value());
            for (std::size_t i = 0; i < expected.size(); ++i)
                QVERIFY(sameBits(inBlocks->columns.at(i), expected[i]));
        }
    }

    void parseTable_headerOverSeveralBlocks_isPassedOver()
    {
        std::mt19937_64 random(kSeed);
        const std::string rows = table(random, 1ULL << 62, "\n");
        std::string text;
        std::vector<std::string> header;
        for (const std::size_t length : {3U, 300000U, 5U, 1200000U}) // longer than a block, too
            header.emplace_back(length, 'x');
        TextDialect withHeader = dialect(2);
        for (const std::string &line : header) {
            text += line + "\n";
            withHeader.header.emplace_back(line);
        }
        text += rows;
        const testing::ScratchFolder folder;
        const auto source = openText(folder.write("table.csv", text.data(), text.size()));
        const Result<TableColumns> parsed = parseTable(kPath, *source, withHeader, {});
        QVERIFY2(parsed.has_value(), parsed ? "" : english(parsed.error().message).c_str());
        QVERIFY(sameBits(parsed->columns.at(0), lineByLine(rows).at(0)));
    }

    void parseTable_lastLineWithoutEnd_isJudgedByTheRowsAbove()
    {
        std::mt19937_64 random(kSeed);
        const std::string rows = table(random, 1ULL << 62, "\n");
        const testing::ScratchFolder folder;
        for (const char *last : {"1.25e+00;2.5e+00", "1.25e+00;2.5e+0", "1.25e+00"}) {
            const std::string text = rows + last;
            const auto source = openText(folder.write("table.csv", text.data(), text.size()));
            const Result<TableColumns> inBlocks = parseTable(kPath, *source, dialect(2), {});
            const Result<TableColumns> whole = parseTable(kPath, TextSource(text), dialect(2), {});
            QVERIFY(inBlocks.has_value() && whole.has_value());
            QCOMPARE(inBlocks->columns.at(0).size(), whole->columns.at(0).size());
            QVERIFY(inBlocks->findings == whole->findings && !whole->findings.empty());
        }
    }

    void parseTable_fileThatShrinksMeanwhile_isRefused()
    {
        std::mt19937_64 random(kSeed);
        std::string text = table(random, 1ULL << 62, "\n");
        text += text;
        const testing::ScratchFolder folder;
        const std::string path = folder.write("table.csv", text.data(), text.size());
        const auto source = openText(path);
        QVERIFY(source.has_value());
        folder.write("table.csv", text.data(), text.size() / 3);
        const Result<TableColumns> parsed = parseTable(path, *source, dialect(2), {});
        QVERIFY(!parsed);
        QCOMPARE(parsed.error().findingId, std::string("CAP-018"));
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

    void parseTable_longLines_areReadWithoutParts()
    {
        // Each longer than the stretch that is searched for the end of a part.
        std::mt19937_64 random(kSeed);
        std::string text;
        while (text.size() < kBytes)
            text += std::string(200000, ' ') + cell(random) + ";" + cell(random) + "\n";
        const Result<TableColumns> parsed = parseTable(kPath, TextSource(text), dialect(2), {});
        QVERIFY(parsed.has_value());
        QVERIFY(sameBits(parsed->columns.at(0), lineByLine(text).at(0)));
        QVERIFY(sameBits(parsed->columns.at(1), lineByLine(text).at(1)));
    }

    void parseTable_longOne_stopsSoonAfterItIsAsked()
    {
        std::mt19937_64 random(kSeed);
        const std::string text = table(random, 1ULL << 62, "\n");
        std::stop_source stop;
        double reported = 0.0;
        const auto stopEarly = [&](double fraction) {
            reported = fraction;
            if (fraction > 0.2)
                stop.request_stop();
        };
        const Result<TableColumns> parsed
            = parseTable(kPath, TextSource(text), dialect(2), {stop.get_token(), stopEarly});
        QVERIFY(!parsed && parsed.error().kind == ErrorKind::Cancelled);
        QVERIFY(reported < 0.5);
    }

    void rowsAhead_partThatEndsEarly_saysWhere()
    {
        std::mt19937_64 random(kSeed);
        const std::string text = table(random, 1ULL << 62, "\n") + "no number\n1;2\n";
        const PlainRowReader reader(';', '.');
        const TextSource source{std::string_view(text)};
        PlainRowsAhead ahead(reader, source, 0, 2);
        const auto expected = lineByLine(text);
        std::uint64_t behind = 0;
        std::size_t row = 0;
        for (Index parts = 0; ahead.nextBegin(); ++parts) {
            const std::uint64_t begin = *ahead.nextBegin();
            QVERIFY(parts == 0 || (text[begin - 1] == '\n' && behind == begin));
            const PlainRowsAhead::Taken taken = ahead.take();
            QVERIFY(taken.rows.rows() > 0);
            const auto at = [&](std::uint64_t place) {
                return text.begin() + static_cast<std::ptrdiff_t>(place);
            };
            QCOMPARE(taken.rows.rows(), std::count(at(begin), at(taken.behind), '\n'));
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const std::span<const double> column = taken.rows.column(i);
                QVERIFY(std::equal(column.begin(), column.end(), &expected[i][row]));
            }
            row += static_cast<std::size_t>(taken.rows.rows());
            behind = taken.behind;
        }
        QCOMPARE(text.substr(behind), std::string("no number\n1;2\n"));
    }

    void rowsAhead_droppedOrSkippedHalfway_endsAtOnce()
    {
        std::mt19937_64 random(kSeed);
        const std::string text = table(random, 1ULL << 62, "\n");
        const PlainRowReader reader(';', '.');
        const TextSource source{std::string_view(text)};
        for (int k = 0; k < 50; ++k) {
            PlainRowsAhead ahead(reader, source, 0, 2);
            for (int taken = 0; taken < k % 5; ++taken)
                ahead.take();
            if (k % 2 == 0)
                ahead.skip();
            QVERIFY(!ahead.nextBegin() || *ahead.nextBegin() == 0
                || text[*ahead.nextBegin() - 1] == '\n');
        }
    }

    void rowsAhead_noText_hasNoParts()
    {
        const PlainRowReader reader(';', '.');
        const TextSource source{std::string_view("1;2\n")};
        QVERIFY(!PlainRowsAhead(reader, source, source.size(), 2).nextBegin());
    }
};

DYNCAL_TEST(TestTableParser)
#include "tst_table_parser.moc"
