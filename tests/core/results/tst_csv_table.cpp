// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables as another program reads them: python's csv module and its floats.

#include "core/results/csv_table.h"
#include "tests/support/hostile_text.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

/// The table's numbers as bits, row by row; "-" for an empty cell, "|" behind a row.
const char *const kBitsOfCells = R"py(
import csv, struct, sys
with open(sys.argv[1], newline='', encoding='ascii') as f:
    rows = list(csv.reader(f, strict=True))
for row in rows[1:]:
    for cell in row:
        print('%016x' % struct.unpack('<Q', struct.pack('<d', float(cell)))[0] if cell else '-')
    print('|')
)py";

/// Header cells, one a line, as hex; fails where the file is more than one row of them.
const char *const kHeader = R"py(
import csv, sys
for mark in ',;':
    with open(sys.argv[1], newline='', encoding='utf-8') as f:
        for row in csv.reader(f, delimiter=mark):
            for cell in row:
                bare = cell.lstrip(' ' + chr(34))
                assert not bare.startswith(('=', '+', '-', '@', '\t', '\r', '\n')), (mark, cell)
with open(sys.argv[1], newline='', encoding='utf-8') as f:
    rows = list(csv.reader(f, strict=True))
assert len(rows) == 2, rows
print(len(rows[0]), len(rows[1]))
)py";

QString written(const testing::ScratchFolder &folder, const std::string &text)
{
    return QString::fromStdString(folder.write("table.csv", text.data(), text.size()));
}

QByteArray bits(double value)
{
    return QByteArray::number(qulonglong(std::bit_cast<std::uint64_t>(value)), 16)
        .rightJustified(16, '0');
}

} // namespace

class TestCsvTable : public QObject
{
    Q_OBJECT

private slots:
    void everyDouble_comesBackToTheBit()
    {
        using Limits = std::numeric_limits<double>;
        Eigen::VectorXd awkward(14);
        awkward << 0.0, -0.0, 0.1 + 0.2, 1.0 / 3.0, Limits::max(), -Limits::min(),
            Limits::denorm_min(), 1e22, 1e23, 123456789012345680.0, 2.5e-7, 0x1.fffffffffffffp-1,
            9007199254740993.0, -1e300;
        CsvTable table;
        table.add("a", awkward);
        table.add("b", awkward.reverse());
        const testing::ScratchFolder folder;
        const testing::PythonAnswer answer
            = testing::python({"-c", kBitsOfCells, written(folder, table.text())});
        QVERIFY2(answer.ran, answer.err);
        QList<QByteArray> expected;
        for (Index i = 0; i < awkward.size(); ++i)
            expected << bits(awkward[i]) << bits(awkward[awkward.size() - 1 - i]) << "|";
        QCOMPARE(answer.out.simplified().split(' '), expected);
    }

    void columnsOfAnyLength_keepTheirRows()
    {
        const double inf = std::numeric_limits<double>::infinity();
        CsvTable table;
        table.add("short", Eigen::VectorXd::Constant(1, 1.0));
        table.add("none", Eigen::VectorXd());
        table.add("broken", Eigen::Vector3d(inf, -inf, std::nan("")));
        table.add("long", Eigen::Vector4d(1.0, 2.0, 3.0, 4.0));
        const testing::ScratchFolder folder;
        const testing::PythonAnswer answer
            = testing::python({"-c", kBitsOfCells, written(folder, table.text())});
        QVERIFY2(answer.ran, answer.err);
        QList<QByteArray> expected{bits(1.0), "-", "-", bits(1.0), "|"};
        for (const double value : {2.0, 3.0, 4.0})
            expected << "-"
                     << "-"
                     << "-" << bits(value) << "|";
        QCOMPARE(answer.out.simplified().split(' '), expected);
    }

    void hostileNames_areNoFormulaAndNoRowOfTheirOwn_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char *name : {"=cmd|' /C calc'!A0", "+1+1", "-2+3", "@SUM(A1:A9)", "\t=1",
                 "a\nb", "a\r\n=1", "x\";=1;\"", "x,=1,y", " =1", "\"=1\"", "'=1", "a;;=b",
                 "a,\"=b\"", "", "\"", ";", ",", "\xff\xfe=1", "\xe2\x80\xae=1"})
            QTest::addRow("%s", QByteArray(name).toPercentEncoding().constData())
                << QByteArray(name);
    }
    void hostileNames_areNoFormulaAndNoRowOfTheirOwn()
    {
        // Names come from recordings; spreadsheets of some countries part cells at semicolons.
        QFETCH(QByteArray, name);
        CsvTable table;
        table.add("first", Eigen::VectorXd::Ones(1));
        table.add(name.toStdString(), Eigen::VectorXd::Ones(1));
        table.add("last", Eigen::VectorXd::Ones(1));
        const testing::ScratchFolder folder;
        const testing::PythonAnswer answer
            = testing::python({"-c", kHeader, written(folder, table.text())});
        QVERIFY2(answer.ran, answer.err);
        QCOMPARE(answer.out.simplified(), QByteArray("3 3"));
    }

    void cell_staysOneCell()
    {
        for (const std::string &text : test::hostileTexts()) {
            const std::string cell = csvCell(text);
            QVERIFY(cell.find('\n') == std::string::npos && cell.find('\r') == std::string::npos);
            const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
            QCOMPARE(std::count(cell.begin(), cell.end(), '"') % 2, std::ptrdiff_t(0));
            QVERIFY(quoted || cell.find_first_of(",;\"") == std::string::npos);
        }
    }
};

DYNCAL_TEST(TestCsvTable)
#include "tst_csv_table.moc"
