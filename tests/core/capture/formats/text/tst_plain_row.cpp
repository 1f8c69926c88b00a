// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The fast way through rows of numbers against the careful one: same numbers to the last bit, or
// no answer.

#include "core/capture/formats/text/plain_row.h"
#include "tests/support/test_program.h"

#include "core/capture/formats/text/text_table.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

using namespace dyncal;

namespace {

constexpr unsigned kSeed = 7;
constexpr int kNumbers = 1000000;
constexpr int kLines = 200000;

bool sameBits(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// A number in one of the ways that programs print them.
QByteArray printed(std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const double value
        = uniform(random) * std::pow(10.0, static_cast<double>(random() % 40) - 20.0);
    const int digits = static_cast<int>(random() % 19);
    switch (random() % 6) {
    case 5: { // any double, as programs print them that lose nothing
        const double any = std::bit_cast<double>(random());
        return QByteArray::number(std::isfinite(any) ? any : value, 'e', 16 + digits % 3);
    }
    case 0:
        return QByteArray::number(value, 'f', digits);
    case 1:
        return QByteArray::number(value, 'e', digits);
    case 2:
        return QByteArray::number(value, 'E', digits);
    case 3:
        return QByteArray::number(static_cast<qint64>(random()) >> (random() % 64));
    default:
        return QByteArray::number(value, 'g', digits + 1);
    }
}

/// What CellCursor and readCell make of a line, if it is all numbers.
bool carefulRow(std::string_view line, char separator, char decimal, std::vector<double> &row)
{
    CellCursor cells(line, separator);
    std::size_t count = 0;
    for (std::string_view cell; cells.next(cell); ++count) {
        double value = 0.0;
        const CellKind kind = readCell(cell, decimal, value);
        if (kind == CellKind::Unreadable || (count >= row.size() && kind == CellKind::Number))
            return false;
        if (count < row.size()) {
            if (kind != CellKind::Number)
                return false;
            row[count] = value;
        }
    }
    return count >= row.size();
}

} // namespace

class TestPlainRow : public QObject
{
    Q_OBJECT

private slots:
    void read_printedNumbers_areTheLibrarysToTheLastBit()
    {
        std::mt19937_64 random(kSeed);
        int plain = 0;
        for (int i = 0; i < kNumbers; ++i) {
            const char decimal = i % 2 == 0 ? '.' : ',';
            const QByteArray cell = printed(random).replace('.', decimal);
            const std::string line = (cell + ";1\n").toStdString();
            std::vector<double> row(2);
            double expected = 0.0;
            const CellKind kind = readCell(line.substr(0, line.size() - 3), decimal, expected);
            const char *behind = PlainRowReader(';', decimal).read(line, row);
            if (behind == nullptr)
                continue;
            ++plain;
            QCOMPARE(kind, CellKind::Number);
            QVERIFY2(sameBits(row[0], expected), line.c_str());
        }
        QVERIFY(plain > kNumbers * 99 / 100);
    }

    void read_halfwayBetweenTwoDoubles_roundsToEven()
    {
        // (2^53 + 2k + 1) / 2^j has no double; its decimals are exact and fit 19 digits for j <= 3.
        std::mt19937_64 random(kSeed);
        const PlainRowReader reader(';', '.');
        for (int i = 0; i < kLines; ++i) {
            const std::uint64_t odd = (std::uint64_t(1) << 53) + (random() >> 12) * 2 + 1;
            const int j = i % 4;
            const std::uint64_t thousandths = (odd & ((1U << j) - 1)) * (1000U >> j);
            const std::string decimals = std::to_string(1000 + thousandths).substr(1);
            const std::string tie = std::to_string(odd >> j) + (j > 0 ? "." + decimals : "");
            std::string beside = tie;
            beside.back() = static_cast<char>(beside.back() == '9' ? '8' : beside.back() + 1);
            for (const std::string &cell : {tie, beside}) {
                std::vector<double> row(1);
                double expected = 0.0;
                QCOMPARE(readCell(cell, '.', expected), CellKind::Number);
                QVERIFY(reader.read(cell + "\n", row) != nullptr);
                QVERIFY2(sameBits(row[0], expected), cell.c_str());
            }
        }
    }

    void read_hardCases_areTheLibrarysToTheLastBit()
    {
        for (const char *cell : {"0", "-0", "0.0", "9007199254740992", "9007199254740993",
                 "9007199254740993e22", "1e22", "1e23", "8.98846567431158e307", "1e308", "5e-324",
                 "2.2250738585072011e-308", "123456789012345678", "1234567890123456789",
                 "12345678901234567890", "0.1234567890123456789012345678901234567890", "1e-22",
                 "3e-23", "00000000000000000000000001", "0.000000000000000000000000000001", "1.",
                 ".5", "+1", "1e+5", "1E05", "-1.5e-0005"}) {
            const std::string line = std::string(cell) + "\n";
            std::vector<double> row(1);
            double expected = 0.0;
            QCOMPARE(readCell(cell, '.', expected), CellKind::Number);
            if (PlainRowReader(';', '.').read(line, row) != nullptr)
                QVERIFY2(sameBits(row[0], expected), cell);
        }
    }

    void read_anyLine_isReadAsTheCarefulWayOrNotAtAll()
    {
        // Lines made of what lines are made of, mostly wrong.
        const char kBytes[] = "0123456789..,,--++eE;;\t\t  \"#nx";
        std::mt19937_64 random(kSeed);
        int plain = 0;
        for (int i = 0; i < kLines; ++i) {
            std::string line;
            for (std::uint64_t k = random() % 14; k > 0; --k)
                line += kBytes[random() % (sizeof kBytes - 1)];
            const char separator = ";,\t |"[random() % 5];
            const char decimal = random() % 2 == 0 ? '.' : ',';
            std::vector<double> row(1 + random() % 3);
            std::vector<double> expected(row.size());
            const std::string text = line + "\n";
            if (PlainRowReader(separator, decimal).read(text, row) == nullptr)
                continue;
            ++plain;
            QVERIFY2(carefulRow(line, separator, decimal, expected), line.c_str());
            for (std::size_t k = 0; k < row.size(); ++k)
                QVERIFY2(sameBits(row[k], expected[k]), line.c_str());
        }
        QVERIFY(plain > 1000);
    }

    void read_lineEnds_areTakenWithTheLine()
    {
        std::vector<double> row(2);
        for (const char *end : {"\n", "\r", "\r\n"}) {
            const std::string text = std::string("1;2") + end + "3;4\n";
            const char *behind = PlainRowReader(';', '.').read(text, row);
            QVERIFY(behind != nullptr && *behind == '3');
        }
        QVERIFY(PlainRowReader(';', '.').read("1;2", row) == nullptr); // no end: may be cut
        QVERIFY(PlainRowReader(';', '.').read("", row) == nullptr);
        QVERIFY(PlainRowReader(';', '.').read("1\n2\n", row) == nullptr); // not across lines
        QVERIFY(PlainRowReader(';', '.').read("1;\n2\n", row) == nullptr);
        QVERIFY(PlainRowReader(';', '.').read("1;2;3\n", row) == nullptr);
        QVERIFY(PlainRowReader(';', '.').read(" 1 ; 2 ; ; \n", row) != nullptr);
        QVERIFY(PlainRowReader('\t', '.').read("1\t\t2\n", row) == nullptr);
    }
};

DYNCAL_TEST(TestPlainRow)
#include "tst_plain_row.moc"
