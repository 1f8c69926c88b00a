// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"
#include "core/correction/known_response.h"
#include "tests/support/known_sensor.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;
using Complex = std::complex<double>;

namespace {

KnownResponse tableOf(const Eigen::VectorXd &knot_Hz, const Eigen::VectorXcd &values)
{
    KnownResponse response;
    response.knot_Hz = knot_Hz;
    response.atKnots = values;
    return response;
}

Complex valueOf(const KnownResponse &response, double frequency_Hz)
{
    return response.at(Eigen::VectorXd::Constant(1, frequency_Hz))[0];
}

Complex changeOf(const KnownResponse &response, const ResponseError &error, double frequency_Hz)
{
    return response.changeBy(error, Eigen::VectorXd::Constant(1, frequency_Hz))[0];
}

} // namespace

class TestKnownResponse : public QObject
{
    Q_OBJECT

private slots:
    void shapeWithoutPoles_isItsLevel()
    {
        PoleShape shape;
        QCOMPARE(shape.at(1e6), Complex(1.0));
        shape.level = 3.0;
        QCOMPARE(shape.at(0.0), Complex(3.0));
    }

    /// G(0) is the level, G at infinity level + sum c: 0 of a sensor of second order.
    void shapeOfASensor_hasItsEnds()
    {
        const PoleShape shape = TrueSensor().shape();
        QCOMPARE(shape.at(0.0), Complex(1.0));
        QVERIFY(std::abs(shape.at(1e12)) < 1e-9);
    }

    void table_isFollowedByStraightLinesOverLogF()
    {
        const KnownResponse table
            = tableOf(Eigen::Vector3d(10.0, 100.0, 1000.0), Eigen::Vector3cd(1.0, 4.0, 0.25));
        QVERIFY(std::abs(valueOf(table, 10.0) - 1.0) < 1e-14);
        QVERIFY(std::abs(valueOf(table, 1000.0) - 0.25) < 1e-14);
        QVERIFY(std::abs(valueOf(table, std::sqrt(1000.0)) - 2.0) < 1e-14); // half way in log f
        QVERIFY(std::abs(valueOf(table, 100.0 * std::sqrt(10.0)) - 1.0) < 1e-14);
    }

    void table_staysBeyondItsEnds()
    {
        const KnownResponse table
            = tableOf(Eigen::Vector2d(10.0, 100.0), Eigen::Vector2cd(2.0, Complex(0.0, 1.0)));
        QVERIFY(std::abs(valueOf(table, 0.0) - 2.0) < 1e-14);
        QVERIFY(std::abs(valueOf(table, 1.0) - 2.0) < 1e-14);
        QVERIFY(std::abs(valueOf(table, 1e9) - Complex(0.0, 1.0)) < 1e-14);
    }

    /// From a knot at 0 Hz on the line is over f.
    void table_from0Hz_isALineOverF()
    {
        const KnownResponse table
            = tableOf(Eigen::Vector3d(0.0, 100.0, 200.0), Eigen::Vector3cd(1.0, 4.0, 4.0));
        QVERIFY(std::abs(valueOf(table, 50.0) - 2.0) < 1e-14);
        QVERIFY(std::abs(valueOf(table, 25.0) - std::sqrt(2.0)) < 1e-14);
    }

    void oneKnot_isTheSameEverywhere()
    {
        const KnownResponse one
            = tableOf(Eigen::VectorXd::Constant(1, 5.0), Eigen::VectorXcd::Constant(1, 7.0));
        for (const double f : {0.0, 5.0, 1e6})
            QVERIFY(std::abs(valueOf(one, f) - 7.0) < 1e-14);
    }

    /// An error of one knot reaches to its neighbours and no further.
    void errorOfAKnot_endsAtItsNeighbours()
    {
        const KnownResponse table
            = tableOf(Eigen::Vector4d(1.0, 10.0, 100.0, 1000.0), Eigen::Vector4cd::Ones());
        ResponseError error{"noise", Eigen::VectorXcd::Zero(4)};
        error.atKnots[1] = Complex(0.01, -0.02);
        QCOMPARE(changeOf(table, error, 10.0), Complex(0.01, -0.02));
        QVERIFY(std::abs(changeOf(table, error, std::sqrt(10.0)) - Complex(0.005, -0.01)) < 1e-16);
        QVERIFY(std::abs(changeOf(table, error, 100.0)) < 1e-16);
        QVERIFY(std::abs(changeOf(table, error, 500.0)) < 1e-16);
        QVERIFY(std::abs(changeOf(table, error, 0.5)) < 1e-16);
    }

    /// Of a fitted ratio, rows with little noise decide; all together know it better than each.
    void fit_weighsTheRowsAndIsBetterThanEach()
    {
        KnownResponse response = TrueSensor().known();
        response.u_alone = Eigen::VectorXd::Constant(27, 0.01);
        response.terms = 1;
        double variance = 0.0;
        for (Index k = 0; k < 27; ++k) {
            ResponseError error{"noise", Eigen::VectorXcd::Zero(27)};
            error.atKnots[k] = 0.01;
            variance += std::norm(changeOf(response, error, 50e3));
        }
        QVERIFY(std::sqrt(variance) < 0.01 / 3.0);
        response.u_alone.tail(20).setConstant(10.0); // these rows count for next to nothing
        ResponseError far{"noise", Eigen::VectorXcd::Zero(27)};
        far.atKnots[15] = 0.01;
        QVERIFY(std::abs(changeOf(response, far, 5e3)) < 1e-6);
    }

    /// What all rows have is taken over whole; a delay stays a delay.
    void fit_takesOverWhatTheRowsShare()
    {
        KnownResponse response = TrueSensor().known();
        response.terms = 1;
        const ResponseError gain{"gain_relative", Eigen::VectorXcd::Constant(27, 0.005)};
        const ResponseError late{
            "onset_s", Eigen::VectorXcd(Complex(0.0, -1e-7) * response.knot_Hz)};
        for (const double f : {0.0, 3e3, 100e3, 300e3}) {
            QVERIFY(std::abs(changeOf(response, gain, f) - 0.005) < 1e-12);
            QVERIFY(std::abs(changeOf(response, late, f) - Complex(0.0, -1e-7 * f)) < 1e-10);
        }
    }

    /// The stated u of the fit is the scatter of 300 calibrations with noise in the rows.
    void fit_scattersAsItsErrorsSay()
    {
        const TrueSensor sensor;
        RandomStream random(12, 1, 1);
        KnownResponse response = sensor.known();
        response.u_alone = Eigen::VectorXd::Constant(27, 0.01);
        response.terms = 2;
        const double f = 120e3;
        double stated = 0.0;
        for (Index k = 0; k < 27; ++k) {
            ResponseError error{"noise", Eigen::VectorXcd::Zero(27)};
            error.atKnots[k] = 0.01;
            stated += std::norm(changeOf(response, error, f));
        }
        double scatter = 0.0;
        for (int i = 0; i < 300; ++i) {
            KnownResponse drawn = response;
            for (Index k = 0; k < 27; ++k)
                drawn.atKnots[k] *= std::exp(0.01 * random.nextNormal());
            const double error = std::log(std::abs(valueOf(drawn, f) / sensor.at(f)));
            scatter += error * error / 300.0;
        }
        QVERIFY2(
            std::abs(scatter / stated - 1.0) < 0.25, qPrintable(QString::number(scatter / stated)));
    }

    /// Noise as stated needs one term; of 200 draws hardly any is refused.
    void noiseAsStated_isCarried()
    {
        RandomStream random(13, 1, 1);
        int refused = 0;
        for (int i = 0; i < 200; ++i) {
            KnownResponse response = TrueSensor().known();
            response.u_alone = Eigen::VectorXd::Constant(27, 0.01);
            for (Index k = 1; k < 27; ++k)
                response.atKnots[k]
                    *= std::exp(0.01 * Complex(random.nextNormal(), random.nextNormal()));
            const auto carried = carriedByShape(response);
            refused += carried ? 0 : 1;
            QVERIFY(!carried || carried->terms <= kMostTerms);
        }
        QVERIFY(refused <= 6);
    }

    /// Ten times the stated noise is a contradiction, and the worst row is named.
    void moreThanTheStatedNoise_isRefused()
    {
        KnownResponse response = TrueSensor().known();
        response.u_alone = Eigen::VectorXd::Constant(27, 0.001);
        response.atKnots[11] *= 1.05;
        const auto carried = carriedByShape(response);
        QVERIFY(!carried && carried.error().kind == ErrorKind::DataBlocked);
        QVERIFY(english(carried.error().message).find("10 kHz") != std::string::npos);
    }

    void valuesThatAreNoNumbers_areRefused()
    {
        KnownResponse response = TrueSensor().known();
        response.atKnots[4] = Complex(NAN, 0.0);
        QVERIFY(!carriedByShape(response));
    }

    void part_keepsTheFirstKnotAtOrAbove()
    {
        const KnownResponse table
            = tableOf(Eigen::Vector4d(1.0, 10.0, 100.0, 1000.0), Eigen::Vector4cd::Ones());
        QCOMPARE(table.upTo(10.0).knot_Hz.size(), Index(2));
        QCOMPARE(table.upTo(11.0).knot_Hz.size(), Index(3));
        QCOMPARE(table.upTo(0.1).knot_Hz.size(), Index(1));
        QCOMPARE(table.upTo(5000.0).knot_Hz.size(), Index(4));
        QCOMPARE(table.upTo(11.0).atKnots.size(), Index(3));
    }

    /// Errors of poles stay, whatever is cut off.
    void part_keepsErrorsOfPoles()
    {
        KnownResponse response = TrueSensor().known();
        ResponseError error{"pole_frequency", Eigen::VectorXcd::Zero(27)};
        error.polesMoved_rad_s = 1e-4 * response.shape.s_rad_s;
        response.errors = {error};
        const KnownResponse part = response.upTo(5e3);
        QCOMPARE(part.errors.size(), std::size_t(1));
        QCOMPARE(part.errors[0].atKnots.size(), part.knot_Hz.size());
        QVERIFY(std::abs(changeOf(part, part.errors[0], 4.5e3)) > 0.0);
    }
};

DYNCAL_TEST(TestKnownResponse)
#include "tst_known_response.moc"
