// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the MAT file says, as scipy reads it and as the program's own reader does.

#include "core/capture/opening/capture_open.h"
#include "core/results/mat_writer.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

/// Entry (i, j) of the n-th matrix of a test: exact as a double and different everywhere.
double entry(int n, Index i, Index j)
{
    return 1000.0 * n + 10.0 * static_cast<double>(i) - 0.125 * static_cast<double>(j);
}

Eigen::MatrixXd matrix(int n, Index rows, Index columns)
{
    return Eigen::MatrixXd::NullaryExpr(
        rows, columns, [=](Index i, Index j) { return entry(n, i, j); });
}

testing::PythonAnswer askScipy(
    const testing::ScratchFolder &folder, const MatWriter &writer, const char *program)
{
    const std::string &bytes = writer.bytes();
    const std::string path = folder.write("a.mat", bytes.data(), bytes.size());
    const QByteArray head = "import sys, numpy as np; from scipy.io import loadmat, whosmat\n"
                            "m = loadmat(sys.argv[1])\n";
    return testing::python({"-c", head + program, QString::fromStdString(path)});
}

} // namespace

class TestMatWriter : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy and scipy is missing: MAT files are not read back.");
    }

    void everyShape_isReadInItsOrder()
    {
        MatWriter writer;
        int n = 0;
        for (const Index rows : {0, 1, 2, 5}) {
            for (const Index columns : {0, 1, 3, 4}) {
                const std::string name = "m" + std::to_string(rows) + "_" + std::to_string(columns);
                writer.add(name, matrix(n, rows, columns));
                const Eigen::MatrixXcd z = Complex(0.0, 1.0) * matrix(n + 1, rows, columns);
                writer.add(name + "z", Eigen::MatrixXcd(z + matrix(n, rows, columns)));
                ++n;
            }
        }
        const testing::ScratchFolder folder;
        const testing::PythonAnswer answer = askScipy(folder, writer, R"py(
n = 0
for rows in (0, 1, 2, 5):
    for columns in (0, 1, 3, 4):
        i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
        value = lambda n: 1000.0 * n + 10.0 * i - 0.125 * j
        name = "m%d_%d" % (rows, columns)
        assert m[name].shape == (rows, columns), name
        assert m[name].dtype == np.float64 and np.array_equal(m[name], value(n)), name
        assert np.array_equal(m[name + "z"], value(n) + 1j * value(n + 1)), name
        n += 1
assert len(whosmat(sys.argv[1])) == 32
)py");
        QVERIFY2(answer.ran, answer.err);
    }

    void namesOfEveryLength_areKept()
    {
        // Names are filled up to eight bytes; one byte too many or too few shifts all behind them.
        MatWriter writer;
        for (std::size_t length = 1; length <= 63; ++length)
            writer.add(std::string(length, 'n'), static_cast<double>(length));
        const testing::ScratchFolder folder;
        const testing::PythonAnswer answer = askScipy(folder, writer,
            "for k in range(1, 64):\n    assert m['n' * k].item() == k, k\n"
            "assert [v[0] for v in whosmat(sys.argv[1])] == ['n' * k for k in range(1, 64)]\n");
        QVERIFY2(answer.ran, answer.err);
    }

    void valuesThatAreNoNumbers_areKeptToo()
    {
        using Limits = std::numeric_limits<double>;
        Eigen::MatrixXd values(2, 4);
        values << Limits::infinity(), -0.0, Limits::denorm_min(), 0.1, -Limits::infinity(),
            Limits::quiet_NaN(), Limits::max(), -1e-300;
        MatWriter writer;
        writer.add("x", values);
        writer.add("nan", Limits::quiet_NaN());
        Eigen::MatrixXcd z(1, 2);
        z << Complex(Limits::quiet_NaN(), 1.0), Complex(2.0, -0.0);
        writer.add("z", z);
        const testing::ScratchFolder folder;
        const testing::PythonAnswer answer = askScipy(folder, writer, R"py(
inf, nan = float("inf"), float("nan")
x = np.array([[inf, -0.0, 5e-324, 0.1], [-inf, nan, 1.7976931348623157e308, -1e-300]])
assert np.array_equal(m["x"], x, equal_nan=True)
assert np.signbit(m["x"][0, 1]) and np.isnan(m["nan"].item())
z = m["z"].ravel()
assert np.isnan(z[0].real) and z[0].imag == 1 and z[1].real == 2 and np.signbit(z[1].imag)
)py");
        QVERIFY2(answer.ran, answer.err);
    }

    void sameMatrices_giveTheSameBytes()
    {
        const auto bytes = [] {
            MatWriter writer;
            writer.add("a", matrix(1, 3, 2));
            writer.add("b", Eigen::MatrixXcd(matrix(2, 3, 2)));
            return writer.bytes();
        };
        QVERIFY(bytes() == bytes());
        QCOMPARE(bytes().size() % 8, std::size_t(0));
        QCOMPARE(MatWriter().bytes().size(), std::size_t(128));
    }

    void series_areReadBackByTheProgram()
    {
        // The exported y and its rate are a recording like any other.
        MatWriter writer;
        writer.add("fs", 2.5e6);
        Eigen::MatrixXd y(400, 2);
        for (Index i = 0; i < y.size(); ++i)
            y(i) = std::sin(0.3 * static_cast<double>(i * i));
        writer.add("y", y);
        const testing::ScratchFolder folder;
        const std::string path
            = folder.write("again.mat", writer.bytes().data(), writer.bytes().size());
        const auto set = openCaptures({path}, {}, {});
        QVERIFY2(set.has_value(), set ? "" : english(set.error().message).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(2));
        for (Index c = 0; c < 2; ++c) {
            const Channel &channel = set->shots[0].channels[static_cast<std::size_t>(c)];
            QCOMPARE(channel.sampleRate_Hz, 2.5e6);
            QCOMPARE(channel.samples.size(), Index(400));
            for (const Index i : {Index(0), Index(1), Index(399)})
                QCOMPARE(channel.samples.at(i), y(i, c));
        }
    }
};

DYNCAL_TEST(TestMatWriter)
#include "tst_mat_writer.moc"
