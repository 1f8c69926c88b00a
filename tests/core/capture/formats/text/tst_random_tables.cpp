// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables with known numbers, written in any dialect, must be read back to the last bit. What is
// true of a number is what the C library reads in its decimal form.

#include "core/capture/formats/preview/text_preview.h"
#include "core/capture/formats/text/delimited_text.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/capture_test_support.h"
#include "tests/core/capture/formats/text/random_table.h"
#include "tests/support/trial_count.h"

#include <QTemporaryDir>

#include <bit>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Rate and begin come from decimals by a few roundings.
constexpr double kRounding = 1e-9;

enum Encoding { Utf8, Utf8WithMark, Latin1, LittleEndian, BigEndian, kEncodings };

QByteArray encoded(const std::string &utf8, int encoding)
{
    const QString text = QString::fromStdString(utf8);
    if (encoding == Utf8)
        return text.toUtf8();
    if (encoding == Utf8WithMark)
        return "\xEF\xBB\xBF" + text.toUtf8();
    if (encoding == Latin1)
        return text.toLatin1();
    QByteArray bytes = encoding == BigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const QChar c : text) {
        bytes += static_cast<char>(encoding == BigEndian ? c.row() : c.cell());
        bytes += static_cast<char>(encoding == BigEndian ? c.cell() : c.row());
    }
    return bytes;
}

bool sameNumber(double a, double b)
{
    return std::isnan(b) ? std::isnan(a)
                         : std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool near(double a, double b)
{
    return std::abs(a - b) <= kRounding * std::abs(b);
}

/// The first `rows` samples of the channel against the column; empty if they are the same.
std::string difference(const Channel &channel, const RandomColumn &column, Index rows)
{
    if (channel.name != column.name || channel.unit != column.unit)
        return "is called " + channel.name + " in " + channel.unit;
    if (channel.samples.size() != rows)
        return "has " + std::to_string(channel.samples.size()) + " samples";
    for (Index k = 0; k < rows; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (!sameNumber(channel.samples.at(k), column.values[at]))
            return "reads \"" + column.cells[at] + "\" as "
                + QString::number(channel.samples.at(k), 'g', 17).toStdString();
    }
    return {};
}

/// What a reader made of the table that is not so; empty if all is as it was written.
std::string difference(const CaptureSet &set, const RandomTable &table, Index rows)
{
    std::vector<RandomColumn> samples = table.columns;
    if (table.time)
        samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(*table.time));
    const std::vector<Channel> &channels = set.shots.at(0).channels;
    if (channels.size() != samples.size())
        return std::to_string(channels.size()) + " channels";
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (const std::string text = difference(channels[i], samples[i], rows); !text.empty())
            return samples[i].name + ' ' + text;
        if (!near(channels[i].sampleRate_Hz, table.rate_Hz))
            return "rate " + std::to_string(channels[i].sampleRate_Hz);
        if (std::abs(channels[i].t0_s - table.first_s) > kRounding * std::abs(table.first_s))
            return "begin " + std::to_string(channels[i].t0_s);
    }
    return {};
}

Index rowsOf(const RandomTable &table)
{
    return static_cast<Index>(table.rows.size());
}

/// Without the last one, and without blank lines above it, which then end the file.
Index rowsBeforeLast(const RandomTable &table)
{
    Index rows = rowsOf(table) - 1;
    while (table.columns.size() == 1
        && table.rows[static_cast<std::size_t>(rows) - 1].find_first_not_of(" ;|,\t")
            == std::string::npos)
        --rows;
    return rows;
}

/// Whether a last line without its end was left out.
bool saysCut(const Findings &findings)
{
    return std::any_of(findings.begin(), findings.end(), [](const Finding &finding) {
        return finding.id == "CAP-018" && finding.severity == Severity::Caution;
    });
}

/// Times and all other columns have the same digits in every row, so that a missing one shows.
bool showsMissingDigits(const RandomTable &table)
{
    const RandomColumn &last = table.columns.back();
    return table.time != table.columns.size() - 1
        && (last.print == Print::Fixed || last.print == Print::Exponent);
}

} // namespace

class TestRandomTables : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    std::string file(const QByteArray &bytes) { return write(m_folder.filePath("t.csv"), bytes); }

    static QByteArray described(
        std::uint64_t seed, const RandomTable &table, const std::string &what)
    {
        return "seed " + QByteArray::number(static_cast<qulonglong>(seed)) + ": "
            + QByteArray::fromStdString(what) + "\n" + QByteArray::fromStdString(table.text());
    }

private slots:
    void read_anyTable_givesItsNumbersBack();
    void read_dialectStated_changesNothing();
    void read_cutAnywhere_neverInventsANumber();
    void preview_anyTable_showsWhatTheImportReads();
};

void TestRandomTables::read_anyTable_givesItsNumbersBack()
{
    const auto trials = static_cast<std::uint64_t>(trials::count(3000, 200000));
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        const RandomTable table = TableMaker(seed).make();
        const QByteArray bytes = encoded(table.text(), static_cast<int>(seed % kEncodings));
        const Result<CaptureSet> set = readDelimitedText(file(bytes), {}, {});
        QVERIFY2(set.has_value(), described(seed, table, sentence(set)));
        const bool cut = saysCut(set->findings);
        const std::string wrong = difference(*set, table, rowsOf(table) - (cut ? 1 : 0));
        QVERIFY2(wrong.empty(), described(seed, table, wrong));
        QVERIFY2(!cut || (!table.lastLineEnds && !showsMissingDigits(table)),
            described(seed, table, "row left out"));
        if (table.lastLineEnds && !set->findings.empty()) {
            // All commas with three digits behind them look like thousands; nothing else is said.
            QVERIFY2(set->findings.size() == 1 && set->findings[0].id == "CAP-019"
                    && table.decimal == ',',
                described(seed, table, english(set->findings[0].message)));
        }
        const std::string_view head(bytes.data(), static_cast<std::size_t>(bytes.size()));
        QCOMPARE(recogniseDelimitedText("t.csv", head), 60);
    }
}

void TestRandomTables::read_dialectStated_changesNothing()
{
    const auto trials = static_cast<std::uint64_t>(trials::count(1000, 50000));
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        const RandomTable table = TableMaker(seed).make();
        ImportSettings settings;
        settings.separator = table.separator == '\t' ? std::string("tab")
            : table.separator == ' '                 ? std::string("space")
                                                     : std::string(1, table.separator);
        settings.decimal = std::string(1, table.decimal);
        settings.skipRows = static_cast<Index>(table.header.size());
        const std::string path = file(encoded(table.text(), Utf8));
        const Result<CaptureSet> stated = readDelimitedText(path, settings, {});
        QVERIFY2(stated.has_value(), described(seed, table, sentence(stated)));
        const bool cut = saysCut(stated->findings);
        const std::string wrong = difference(*stated, table, rowsOf(table) - (cut ? 1 : 0));
        QVERIFY2(wrong.empty(), described(seed, table, wrong));
        QVERIFY(!hasFinding(stated->findings, "CAP-019"));
    }
}

void TestRandomTables::read_cutAnywhere_neverInventsANumber()
{
    int tables = 0;
    for (std::uint64_t seed = 1; tables < trials::count(60, 3000); ++seed) {
        const RandomTable table = TableMaker(seed).make();
        if (!table.lastLineEnds || !showsMissingDigits(table))
            continue;
        ++tables;
        const std::string whole = table.text();
        const std::size_t end = whole.size() - table.lineEnd.size();
        for (std::size_t size = end - table.rows.back().size(); size < end; ++size) {
            const Result<CaptureSet> set
                = readDelimitedText(file(encoded(whole.substr(0, size), Utf8)), {}, {});
            const std::string shown = std::to_string(size);
            QVERIFY2(set.has_value(), described(seed, table, shown + ": " + sentence(set)));
            const Index rows = set->shots.at(0).channels.at(0).samples.size();
            QVERIFY2(rows <= rowsOf(table) && rows >= rowsBeforeLast(table),
                described(seed, table, shown + ": " + std::to_string(rows) + " rows"));
            const std::string wrong = difference(*set, table, rows);
            QVERIFY2(wrong.empty(), described(seed, table, shown + ": " + wrong));
        }
    }
}

void TestRandomTables::preview_anyTable_showsWhatTheImportReads()
{
    const auto trials = static_cast<std::uint64_t>(trials::count(1000, 50000));
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        const RandomTable table = TableMaker(seed).make();
        const std::string path = file(encoded(table.text(), static_cast<int>(seed % kEncodings)));
        const Result<TextPreview> preview = previewText(path, {});
        QVERIFY2(preview.has_value(), described(seed, table, sentence(preview)));
        QCOMPARE(preview->columnTitles.size(), table.columns.size());
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            QCOMPARE(preview->columnTitles[i], table.columns[i].name);
            QCOMPARE(preview->units[i], table.columns[i].unit);
        }
        QCOMPARE(preview->headerLines, static_cast<Index>(table.header.size()));
        QCOMPARE(preview->unreadableCells, Index(0));
        QCOMPARE(preview->timeColumn.has_value(), table.time.has_value());
        QCOMPARE(preview->timeColumn.value_or(0), static_cast<Index>(table.time.value_or(0)));
        QVERIFY2(near(preview->sampleRate_Hz, table.rate_Hz), described(seed, table, "rate"));
        QVERIFY(!preview->problem);
        QVERIFY(table.columns.size() == 1 || preview->separator == table.separator);
    }
}

DYNCAL_TEST(TestRandomTables)
#include "tst_random_tables.moc"
