// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Scales as such: tables against numpy, and one polynomial in place of a chain only where nobody
// could tell.

#include "core/capture/formats/tdms/tdms_scale.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;
using Node = TdmsScaleNode;

namespace {

Node polynomial(std::size_t left, std::vector<double> coefficients)
{
    Node node;
    node.kind = Node::Kind::Polynomial;
    node.left = left;
    node.coefficients = std::move(coefficients);
    return node;
}

TdmsScaleChain chainOf(const std::vector<std::vector<double>> &polynomials)
{
    TdmsScaleChain chain;
    chain.nodes.emplace_back();
    for (std::size_t i = 0; i < polynomials.size(); ++i)
        chain.nodes.push_back(polynomial(i, polynomials[i]));
    return chain;
}

std::vector<double> evaluated(const TdmsScaleChain &chain, const std::vector<double> &counts)
{
    std::vector<double> values(counts.size());
    evaluate(chain, std::vector<std::vector<double>>{counts}, values);
    return values;
}

long double powers(const std::vector<double> &coefficients, double x)
{
    long double sum = 0.0L;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        sum += static_cast<long double>(coefficients[i])
            * std::pow(static_cast<long double>(x), static_cast<long double>(i));
    return sum;
}

} // namespace

class TestTdmsScaleChain : public QObject
{
    Q_OBJECT

private slots:
    void onePolynomial_isTheChainAtEveryCount()
    {
        // Not only where it was compared when it was taken: at random counts of the range.
        std::mt19937_64 random(6);
        const auto number = [&random] {
            return (static_cast<double>(random() >> 11U) * 0x1p-52 - 1.0)
                * std::pow(10.0, static_cast<double>(random() % 9) - 6.0);
        };
        int taken = 0;
        for (int trial = 0; trial < 2000; ++trial) {
            std::vector<std::vector<double>> links(1 + random() % 3);
            for (std::vector<double> &link : links) {
                link.resize(2 + random() % 3);
                for (double &coefficient : link)
                    coefficient = number();
            }
            const TdmsScaleChain chain = chainOf(links);
            const auto one = asPolynomial(chain, -32768.0, 32767.0);
            if (!one)
                continue;
            ++taken;
            std::vector<double> counts{-32768.0, 0.0, 32767.0};
            for (int i = 0; i < 200; ++i)
                counts.push_back(static_cast<double>(random() % 65536) - 32768.0);
            const std::vector<double> expected = evaluated(chain, counts);
            double largest = 0.0;
            for (const double value : expected)
                largest = std::max(largest, std::abs(value));
            for (std::size_t i = 0; i < counts.size(); ++i) {
                const double off = std::abs(
                    static_cast<double>(powers(one->coefficients, counts[i])) - expected[i]);
                QVERIFY2(off <= 1e-14 * largest, qPrintable(QString::number(off / largest)));
            }
        }
        QVERIFY2(taken > 500, qPrintable(QString::number(taken)));
    }

    void unboundedCounts_joinOnlyStraightLines()
    {
        QVERIFY(asPolynomial(chainOf({{1.0, 2.0}, {3.0, 4.0}}), 0.0, 0.0).has_value());
        QCOMPARE(asPolynomial(chainOf({{1.0, 2.0}, {3.0, 4.0}}), 0.0, 0.0)->coefficients,
            (std::vector<double>{7.0, 8.0}));
        QVERIFY(asPolynomial(chainOf({{1.0, 2.0, 3.0}}), 0.0, 0.0).has_value());
        QVERIFY(!asPolynomial(chainOf({{1.0, 2.0, 3.0}, {0.0, 1.0}}), 0.0, 0.0).has_value());
        QCOMPARE(asPolynomial(chainOf({}), 0.0, 0.0)->coefficients,
            (std::vector<double>{0.0, 1.0})); // the counts
        QCOMPARE(asPolynomial(chainOf({{5.0}}), 0.0, 0.0)->coefficients,
            (std::vector<double>{5.0, 0.0})); // a constant
    }

    void whatIsNoChainOfPolynomials_isNone()
    {
        TdmsScaleChain sum = chainOf({{1.0, 2.0}});
        Node both;
        both.kind = Node::Kind::Sum;
        both.left = 0;
        both.right = 1;
        sum.nodes.push_back(both);
        QVERIFY(!asPolynomial(sum, 0.0, 100.0));
        TdmsScaleChain skipping = chainOf({{1.0, 2.0}});
        skipping.nodes.push_back(polynomial(0, {0.0, 3.0})); // leaves the first link out
        QVERIFY(!asPolynomial(skipping, 0.0, 100.0));
        QVERIFY(!asPolynomial(chainOf({std::vector<double>(14, 1.0)}), 0.0, 1.0));
        const double inf = std::numeric_limits<double>::infinity();
        QVERIFY(!asPolynomial(chainOf({{0.0, inf}, {0.0, 1.0}}), 0.0, 10.0));
        // Each is finite; together they are not, and 0 counts would come out as no number.
        QVERIFY(!asPolynomial(chainOf({{0.0, 1e200}, {0.0, 1e200}}), 0.0, 10.0));
    }

    void table_isNumpysInterpolation()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy is missing: the table is not compared.");
        Node table;
        table.kind = Node::Kind::Table;
        table.inputs = {-5.0, -4.5, 0.0, 0.001, 7.0, 1e6};
        table.outputs = {1.0, -3.0, 0.25, 1e3, 1e3, -2.0};
        TdmsScaleChain chain;
        chain.nodes = {{}, table};
        std::mt19937_64 random(1);
        std::vector<double> counts = table.inputs;
        for (const double x : {-1e300, -5.5, 2e6, 1e300, -0.0})
            counts.push_back(x);
        for (int i = 0; i < 500; ++i)
            counts.push_back(static_cast<double>(random() >> 11U) * 0x1p-53 * 20.0 - 8.0);
        QString words;
        for (const double x : counts)
            words += QString::number(x, 'g', 17) + ' ';
        const testing::PythonAnswer answer = testing::python({"-c",
            "import sys, numpy as np\n"
            "x = np.array(sys.argv[1].split(), float)\n"
            "y = np.interp(x, [-5, -4.5, 0, 0.001, 7, 1e6], [1, -3, 0.25, 1e3, 1e3, -2])\n"
            "print(*[repr(float(v)) for v in y])",
            words});
        QVERIFY2(answer.ran, answer.err);
        const std::vector<double> found = evaluated(chain, counts);
        const QList<QByteArray> expected = answer.out.simplified().split(' ');
        QCOMPARE(expected.size(), std::ssize(found));
        for (qsizetype i = 0; i < expected.size(); ++i)
            QVERIFY(std::abs(found[std::size_t(i)] - expected[i].toDouble()) < 1e-9);
        QVERIFY(std::isnan(evaluated(chain, {std::nan("")})[0])); // an invalid sample stays one
    }

    void sumAndDifference_ofTwoKindsOfCounts()
    {
        TdmsScaleChain chain;
        chain.nodes.resize(3);
        chain.nodes[1].stream = 1;
        chain.nodes[2].left = 0;
        chain.nodes[2].right = 1;
        const std::vector<std::vector<double>> counts{{1.0, 2.0, -7.0}, {10.0, 0.5, std::nan("")}};
        std::vector<double> values(3);
        chain.nodes[2].kind = Node::Kind::Sum;
        evaluate(chain, counts, values);
        QVERIFY(values[0] == 11.0 && values[1] == 2.5 && std::isnan(values[2]));
        chain.nodes[2].kind = Node::Kind::Difference;
        evaluate(chain, counts, values);
        QVERIFY(values[0] == 9.0 && values[1] == -1.5 && std::isnan(values[2])); // right - left
    }
};

DYNCAL_TEST(TestTdmsScaleChain)
#include "tst_tdms_scale_chain.moc"
