// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/values/cursor_values.h"
#include "ui/plot/values/curve_envelope.h"

#include <QtTest>

#include <limits>

using namespace dyncal;

class TestCursorValues : public QObject
{
    Q_OBJECT

private slots:
    void sampleNear_everyPlace_isTheNearest();
    void sampleNear_oneOrNoSample();
    void valueNear_noNumber_isNone();
};

void TestCursorValues::sampleNear_everyPlace_isTheNearest()
{
    const std::vector<double> x{0.0, 1.0, 2.0, 4.0};
    const std::vector<double> y{10.0, 11.0, 12.0, 14.0};
    const CurveEnvelope samples(x, y);
    const std::vector<std::pair<double, std::optional<Index>>> expected{{-0.6, std::nullopt},
        {-0.4, 0}, {0.0, 0}, {0.4, 0}, {0.6, 1}, {1.0, 1}, {1.9, 2}, {2.9, 2}, {3.1, 3}, {4.0, 3},
        {4.9, 3}, {5.1, std::nullopt}};
    for (const auto &[at, sample] : expected)
        QCOMPARE(sampleNear(samples, at), sample);
    QCOMPARE(valueNear(samples, 3.1), std::optional(14.0));
    QVERIFY(!valueNear(samples, 9.0));
}

void TestCursorValues::sampleNear_oneOrNoSample()
{
    const std::vector<double> one{2.0};
    const CurveEnvelope single(one, one);
    QCOMPARE(sampleNear(single, 2.0), std::optional<Index>(0));
    QVERIFY(!sampleNear(single, 2.1));
    const std::vector<double> none;
    QVERIFY(!sampleNear(CurveEnvelope(none, none), 0.0));
}

void TestCursorValues::valueNear_noNumber_isNone()
{
    const std::vector<double> x{0.0, 1.0};
    const std::vector<double> y{std::numeric_limits<double>::quiet_NaN(), 3.0};
    const CurveEnvelope samples(x, y);
    QVERIFY(!valueNear(samples, 0.1));
    QCOMPARE(valueNear(samples, 0.9), std::optional(3.0));
}

DYNCAL_TEST(TestCursorValues)
#include "tst_cursor_values.moc"
