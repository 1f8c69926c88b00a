// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/values/dashes.h"

#include <QtTest>

#include <cmath>
#include <limits>

using dyncal::Dashes;

namespace {

const QRectF kClip(0.0, 0.0, 400.0, 200.0);
constexpr double kRounding = 1e-9;

double lengthOf(const QVector<QLineF> &parts)
{
    double sum = 0.0;
    for (const QLineF &part : parts)
        sum += part.length();
    return sum;
}

} // namespace

class TestDashes : public QObject
{
    Q_OBJECT

private slots:
    void straightLine_isCutByThePattern();
    void corner_patternGoesOn();
    void outside_countsButIsNotDrawn();
    void gap_isSkipped();
    void farPoints_endAtOnce();
};

void TestDashes::straightLine_isCutByThePattern()
{
    QVector<QLineF> parts;
    Dashes({4.0, 2.0}).add({0.0, 10.0}, {12.0, 10.0}, kClip, parts);
    QCOMPARE(parts.size(), 2);
    QCOMPARE(parts[0], QLineF(0.0, 10.0, 4.0, 10.0));
    QCOMPARE(parts[1], QLineF(6.0, 10.0, 10.0, 10.0));
}

void TestDashes::corner_patternGoesOn()
{
    QVector<QLineF> parts;
    Dashes dashes({4.0, 2.0});
    dashes.add({0.0, 0.0}, {3.0, 0.0}, kClip, parts);
    dashes.add({3.0, 0.0}, {3.0, 9.0}, kClip, parts);
    // 3 along, 1 up, gap 2, 4 up, gap 2
    QCOMPARE(parts.size(), 3);
    QVERIFY(std::abs(lengthOf(parts) - 8.0) < kRounding);
    QVERIFY(std::abs(parts[2].y1() - 3.0) < kRounding);
    QVERIFY(std::abs(parts[2].y2() - 7.0) < kRounding);
}

void TestDashes::outside_countsButIsNotDrawn()
{
    QVector<QLineF> parts;
    Dashes dashes({4.0, 2.0});
    dashes.add({-100.0, 10.0}, {-95.0, 10.0}, kClip, parts); // in the gap now
    QVERIFY(parts.isEmpty());
    dashes.add({0.0, 10.0}, {3.0, 10.0}, kClip, parts);
    QCOMPARE(parts.size(), 1);
    QVERIFY(std::abs(parts[0].x1() - 1.0) < kRounding);
}

void TestDashes::gap_isSkipped()
{
    QVector<QLineF> parts;
    Dashes dashes({4.0, 2.0});
    const double none = std::numeric_limits<double>::quiet_NaN();
    dashes.add({0.0, 0.0}, {5.0, none}, kClip, parts);
    dashes.add({5.0, none}, {10.0, 0.0}, kClip, parts);
    dashes.add({10.0, 0.0}, {10.0, 0.0}, kClip, parts);
    QVERIFY(parts.isEmpty());
}

/// Zoomed in far, a point may lie millions of pixels away; lengths lose the digits of a dash.
void TestDashes::farPoints_endAtOnce()
{
    QVector<QLineF> parts;
    Dashes dashes({4.0, 2.0, 1.0, 2.0});
    dashes.add({-1e12, 100.0}, {1e12, 100.0}, kClip, parts);
    QCOMPARE(parts.size(), 1); // solid
    dashes.add({10.0, 1e300}, {20.0, -1e300}, kClip, parts);
    for (int i = 0; i < 10'000; ++i)
        dashes.add({0.1 * i, 50.0}, {0.1 * (i + 1), 50.0 + 1e-13}, kClip, parts);
    QVERIFY(parts.size() > 100);
}

DYNCAL_TEST(TestDashes)
#include "tst_dashes.moc"
