// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The distributions against their finite sums in sixty decimal digits, far into the tails and for
// many degrees of freedom, and what they say outside their domains.

#include "core/base/distributions.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using dyncal::testing::python;

namespace {

/// Relative, by the header; and how much it grows per degree of freedom of Student's t.
constexpr double kPromised = 1e-12;
constexpr double kPerDegree = 1e-16;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

/// Sums of Abramowitz and Stegun 26.4.21 (chi-square, even degrees) and 26.7.3, 26.7.4 (Student):
/// "chi x degrees" and "t t degrees" per argument, the survival probability per line.
const char *const kSums = R"py(
import sys
from decimal import Decimal as D, getcontext
getcontext().prec = 60
PI = D('3.14159265358979323846264338327950288419716939937510582097494459')

def atan(x):
    halvings = 0
    while x > D('0.01'):
        x = x / (1 + (1 + x * x).sqrt())
        halvings += 1
    total, power, n = D(0), x, 1
    while abs(power) > D(10) ** -65:
        total += power / n
        power *= -x * x
        n += 2
    return total * 2 ** halvings

def chi(x, degrees):
    half = D(x) / 2
    term = total = D(1)
    for k in range(1, degrees // 2):
        term *= half / k
        total += term
    return total * (-half).exp()

def student(t, dof):
    tangent = D(t) / D(dof).sqrt()
    cosine2 = 1 / (1 + tangent * tangent)
    sine = tangent * cosine2.sqrt()
    if dof % 2 == 0:
        term = total = D(1)
        for k in range(2, dof - 1, 2):
            term *= cosine2 * (k - 1) / k
            total += term
        inside = sine * total
    else:
        term = total = cosine2.sqrt() if dof > 1 else D(0)
        for k in range(3, dof - 1, 2):
            term *= cosine2 * (k - 1) / k
            total += term
        inside = 2 / PI * (atan(tangent) + sine * total)
    return (1 - inside) / 2

for line in sys.argv[1:]:
    kind, value, degrees = line.split()
    p = chi(float(value), int(degrees)) if kind == 'chi' else student(float(value), int(degrees))
    print('%.20e' % p)
)py";

bool agrees(double found, double expected, double relative = kPromised)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

QString shown(double found, double expected)
{
    return QString("%1, exactly %2 (relative %3)")
        .arg(found, 0, 'g', 17)
        .arg(expected, 0, 'g', 17)
        .arg(found / expected - 1.0);
}

struct Case
{
    double value;
    int degrees;
};

/// What Python answers for the cases, one number each.
QList<double> exactly(const char *kind, const std::vector<Case> &cases)
{
    QStringList arguments{"-c", kSums};
    for (const Case &c : cases)
        arguments << QString("%1 %2 %3").arg(kind).arg(c.value, 0, 'g', 17).arg(c.degrees);
    QList<double> answers;
    for (const QByteArray &line : python(arguments).out.split('\n')) {
        if (!line.isEmpty())
            answers << line.toDouble();
    }
    return answers;
}

} // namespace

class TestDistributionsExact : public QObject
{
    Q_OBJECT

private slots:
    void chiSquare_equalsItsSum();
    void student_equalsItsSum();
    void studentQuantile_turnsSurvivalRound();
    void studentQuantile_isOddAboutTheMiddle();
    void student_tinyDegrees_stayAProbability();
    void normal_isTheLimitOfStudent();
    void nothingOutsideTheDomain_isAProbability();
    void ends_areTheEnds();
    void survival_falls();
};

void TestDistributionsExact::chiSquare_equalsItsSum()
{
    std::vector<Case> cases;
    for (const int degrees : {2, 4, 10, 100, 2000, 200000}) {
        const double sd = std::sqrt(2.0 * degrees);
        for (const double sigmas : {-3.0, -0.5, 0.0, 0.1, 1.0, 4.0, 12.0}) {
            if (degrees + sigmas * sd > 0.0)
                cases.push_back({degrees + sigmas * sd, degrees});
        }
    }
    const QList<double> exact = exactly("chi", cases);
    QCOMPARE(exact.size(), static_cast<qsizetype>(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double found = chiSquareSurvival(cases[i].value, cases[i].degrees);
        const double expected = exact[static_cast<qsizetype>(i)];
        QVERIFY2(agrees(found, expected),
            qPrintable(QString("%1 of %2: ").arg(cases[i].value).arg(cases[i].degrees)
                + shown(found, expected)));
    }
}

void TestDistributionsExact::student_equalsItsSum()
{
    std::vector<Case> cases;
    for (const int degrees : {1, 2, 3, 4, 7, 10, 99, 1000, 20001, 200000}) {
        for (const double t : {1e-3, 0.5, 1.0, 2.0, 5.0, 9.0})
            cases.push_back({t, degrees});
    }
    cases.push_back({1e6, 1}); // far tails of few degrees
    cases.push_back({1e6, 3});
    cases.push_back({200.0, 10});
    const QList<double> exact = exactly("t", cases);
    QCOMPARE(exact.size(), static_cast<qsizetype>(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double found = studentSurvival(cases[i].value, cases[i].degrees);
        const double expected = exact[static_cast<qsizetype>(i)];
        QVERIFY2(agrees(found, expected, std::max(kPromised, kPerDegree * cases[i].degrees)),
            qPrintable(QString("%1 of %2: ").arg(cases[i].value).arg(cases[i].degrees)
                + shown(found, expected)));
    }
}

/// Both tails alike: a small probability must not lose its digits to 1 - p.
void TestDistributionsExact::studentQuantile_turnsSurvivalRound()
{
    constexpr double kTurned = 1e-11; // the quantile's 1e-12 times d ln p / d ln t of up to 10
    for (const double dof : {0.5, 1.0, 2.5, 10.0, 333.3, 1e6}) {
        for (const double tail : {0.4, 0.025, 1e-3, 1e-9, 1e-15, 1e-40}) {
            const double below = studentQuantile(tail, dof);
            QVERIFY2(below < 0.0, qPrintable(QString::number(below)));
            const double turned = studentSurvival(-below, dof);
            QVERIFY2(std::abs(turned / tail - 1.0) < kTurned * std::max(1.0, -std::log(tail)),
                qPrintable(QString("dof %1: ").arg(dof) + shown(turned, tail)));
        }
    }
}

void TestDistributionsExact::studentQuantile_isOddAboutTheMiddle()
{
    for (const double dof : {0.7, 2.0, 30.0, 1e9}) {
        for (const double p : {0.25, 0.0625, 0.03125}) // 1 - p is exact
            QCOMPARE(studentQuantile(p, dof), -studentQuantile(1.0 - p, dof));
        QVERIFY(std::abs(studentQuantile(0.5, dof)) < 1e-15);
    }
    // One degree is Cauchy's: tan(pi (p - 1/2)), in the tail -1/(pi p).
    for (const double p : {1e-3, 1e-8, 1e-14})
        QVERIFY(std::abs(studentQuantile(p, 1.0) * std::tan(std::acos(-1.0) * p) + 1.0) < 1e-12);
}

/// Squares of t overflow here; P(T > t) ~ C t^-dof says how it must fall.
void TestDistributionsExact::student_tinyDegrees_stayAProbability()
{
    for (const double dof : {0.01, 0.1, 1.0}) {
        for (const double t : {1e120, 1e140, 1e150, 1e153, 1e160, 1e200}) {
            const double here = studentSurvival(t, dof), there = studentSurvival(10.0 * t, dof);
            QVERIFY(here > 0.0 && here < 0.5);
            QVERIFY2(std::abs(here / there / std::pow(10.0, dof) - 1.0) < 1e-10,
                qPrintable(shown(here / there, std::pow(10.0, dof))));
        }
    }
    const double far = studentQuantile(1.0 - 0x1p-53, 0.1); // the last draw of a Monte Carlo
    QVERIFY(std::isfinite(far));
    QVERIFY(std::abs(studentSurvival(far, 0.1) / 0x1p-53 - 1.0) < 1e-10);
}

/// P_t - P_z ~ phi(t) (t^3 + t)/(4 dof) for many degrees (Abramowitz and Stegun 26.7.5).
void TestDistributionsExact::normal_isTheLimitOfStudent()
{
    for (const double dof : {1e4, 1e5, 3e6}) {
        for (const double t : {0.3, 1.96, 4.0}) {
            const double density = std::exp(-0.5 * t * t) / std::sqrt(2.0 * std::acos(-1.0));
            const double normal = 0.5 * std::erfc(t / std::sqrt(2.0));
            const double excess = studentSurvival(t, dof) - normal;
            const double expected = density * (t * t * t + t) / (4.0 * dof);
            // next term of the series, and what the header allows
            QVERIFY2(
                std::abs(excess - expected) < 50.0 * expected / dof + kPerDegree * dof * normal,
                qPrintable(shown(excess, expected)));
        }
    }
    QCOMPARE(studentSurvival(1.0, kInfinity), studentSurvival(1.0, 1e9));
}

/// A zero for "no probability" would be a coverage factor of 0 or a test that always passes.
void TestDistributionsExact::nothingOutsideTheDomain_isAProbability()
{
    for (const double bad : {kNan, 0.0, -1.0, -kInfinity}) {
        QVERIFY(std::isnan(upperGammaRatio(bad, 1.0)));
        QVERIFY(std::isnan(chiSquareSurvival(1.0, bad)));
        QVERIFY(std::isnan(studentSurvival(1.0, bad)));
        QVERIFY(std::isnan(studentQuantile(0.975, bad)));
    }
    QVERIFY(std::isnan(upperGammaRatio(1.0, kNan)));
    QVERIFY(std::isnan(chiSquareSurvival(kNan, 3.0)));
    QVERIFY(std::isnan(studentSurvival(kNan, 3.0)));
    for (const double bad : {kNan, -0.1, 1.1, kInfinity, -kInfinity}) {
        QVERIFY(std::isnan(normalQuantile(bad)));
        QVERIFY(std::isnan(studentQuantile(bad, 3.0)));
        QVERIFY(std::isnan(studentQuantile(bad, kInfinity)));
    }
}

void TestDistributionsExact::ends_areTheEnds()
{
    QCOMPARE(chiSquareSurvival(-1.0, 3.0), 1.0);
    QCOMPARE(chiSquareSurvival(kInfinity, 3.0), 0.0);
    QCOMPARE(studentSurvival(kInfinity, 3.0), 0.0);
    QCOMPARE(studentSurvival(-kInfinity, 3.0), 1.0);
    QCOMPARE(normalQuantile(0.0), -kInfinity);
    QCOMPARE(normalQuantile(1.0), kInfinity);
    QVERIFY(normalQuantile(std::numeric_limits<double>::min()) < -37.0);
}

/// Where the series hands over to the continued fraction nothing jumps up.
void TestDistributionsExact::survival_falls()
{
    for (const double a : {0.3, 1.0, 9.99, 10.0, 250.0, 1e5}) {
        double before = 1.0;
        for (double share = 0.5; share < 1.6; share *= 1.0001) {
            const double here = upperGammaRatio(a, share * (a + 1.0));
            QVERIFY(here <= before * (1.0 + kPromised) && here >= 0.0);
            before = here;
        }
    }
    for (const double dof : {0.4, 3.0, 21.0, 5e4}) {
        double before = 1.0;
        for (double t = -6.0; t < 6.0; t += 1e-3) {
            const double here = studentSurvival(t, dof);
            QVERIFY(here <= before * (1.0 + kPromised));
            QVERIFY(std::abs(here + studentSurvival(-t, dof) - 1.0) < 1e-15);
            before = here;
        }
    }
}

DYNCAL_TEST(TestDistributionsExact)
#include "tst_distributions_exact.moc"
