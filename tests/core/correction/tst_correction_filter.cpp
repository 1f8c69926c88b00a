// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/least_squares.h"
#include "core/correction/correction_filter.h"
#include "core/signal/dft_covariance.h"
#include "tests/support/known_sensor.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 5e6;

ResponseError errorOf(const KnownResponse &response, Complex atAll)
{
    return {"all", Eigen::VectorXcd::Constant(response.knot_Hz.size(), atAll)};
}

/// The response as it would be with one standard deviation of the error.
KnownResponse changed(KnownResponse response, const ResponseError &error, double size)
{
    for (Index k = 0; k < response.knot_Hz.size(); ++k)
        response.atKnots[k] *= std::exp(size * error.atKnots[k]);
    return response;
}

/// A response by a table of five frequencies, 0 to half the rate of eight samples.
KnownResponse tableOfFive()
{
    KnownResponse response;
    response.knot_Hz = Eigen::VectorXd::LinSpaced(5, 0.0, 4.0);
    response.atKnots.resize(5);
    const double amplitude[]{1.0, 1.1, 1.3, 0.9, 0.5};
    const double phase[]{0.0, -0.1, -0.3, -1.0, -2.0};
    for (Index k = 0; k < 5; ++k) {
        response.atKnots[k] = std::polar(amplitude[k], phase[k]);
        for (const Complex error : {Complex(0.01 / amplitude[k], 0.0), Complex(0.0, 0.02)}) {
            response.errors.push_back({"row", Eigen::VectorXcd::Zero(5)});
            response.errors.back().atKnots[k] = error;
        }
    }
    return response;
}

std::string refusal(
    const KnownResponse &response, double rate_Hz, const CorrectionSettings &settings)
{
    const auto filter = designCorrection(response, rate_Hz, settings);
    return filter ? std::string() : english(filter.error().message);
}

} // namespace

class TestCorrectionFilter : public QObject
{
    Q_OBJECT

private slots:
    void lowPass_ofGauss_isFlatToTheBandAndGoneAtTheEdge()
    {
        const LowPass lowPass{LowPassKind::Gaussian, 100e3, 150e3};
        QVERIFY(isNear(lowPass.at(100e3).real(), 1.0 - 1e-4, 1e-12));
        QVERIFY(isNear(lowPass.at(150e3).real(), 1e-4, 1e-9));
        QCOMPARE(lowPass.at(125e3), Complex(0.5));
        QCOMPARE(lowPass.at(0.0), Complex(1.0));
    }

    /// -3 dB at the band's end; no delay at 0 Hz.
    void lowPass_ofTwoPoles_isItsClosedForm()
    {
        const LowPass lowPass{LowPassKind::TwoPole, 100e6, 150e6};
        QVERIFY(isNear(std::abs(lowPass.at(100e6)), 1.0 / (1.0 + std::pow(1.555, -2.0)), 1e-12));
        QVERIFY(std::abs(std::arg(lowPass.at(1e6))) < 1e-6);
        QCOMPARE(lowPassName(lowPass.kind), "two-pole");
    }

    void response_isMeasuredAtTheKnots_andTheShapeBetweenThem()
    {
        const TrueSensor sensor;
        KnownResponse response = sensor.known();
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(500, 0.0, 600e3);
        QVERIFY((response.at(f) - sensor.at(f)).cwiseAbs().maxCoeff() < 1e-12 * 10.0 * sensor.S0);
        response.atKnots
            *= std::polar(1.02, 0.1); // a ratio to the shape that is the same everywhere
        QVERIFY((response.at(f) - std::polar(1.02, 0.1) * sensor.at(f)).cwiseAbs().maxCoeff()
            < 1e-12 * 10.0 * sensor.S0);
    }

    /// A phase that turns several times from knot to knot is followed, not wrapped.
    void response_ofATable_followsThePhase()
    {
        KnownResponse response;
        response.knot_Hz = Eigen::Vector4d(1.0, 2.0, 4.0, 8.0);
        response.atKnots = Eigen::Vector4cd(std::polar(1.0, 0.0), std::polar(1.0, -2.0),
            std::polar(1.0, -4.0), std::polar(1.0, -6.0));
        const Eigen::VectorXcd between
            = response.at(Eigen::Vector2d(std::sqrt(8.0), std::sqrt(32.0)));
        QVERIFY(std::abs(between[0] - std::polar(1.0, -3.0)) < 1e-14);
        QVERIFY(std::abs(between[1] - std::polar(1.0, -5.0)) < 1e-14);
    }

    /// Off the shape by 6 % at 300 kHz, as an amplifier is that was not there: two terms are
    /// needed, and between the knots the response is the truth.
    void smoothDeparture_isCarriedByItsTerms()
    {
        const TrueSensor sensor;
        KnownResponse response = sensor.known();
        const auto amplifier = [](double f) {
            const double x = f / 300e3;
            return std::exp(Complex(-0.01 * x * x - 0.05 * std::pow(x, 4.0), -0.05 * x));
        };
        for (Index k = 0; k < 27; ++k)
            response.atKnots[k] *= -amplifier(response.knot_Hz[k]);
        const auto carried = carriedByShape(response);
        QVERIFY(carried.has_value());
        QCOMPARE(carried->terms, Index(2));
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(300, 0.0, 300e3);
        const Eigen::VectorXcd found = carried->at(f);
        for (Index i = 0; i < f.size(); ++i)
            QVERIFY(std::abs(found[i] / (-amplifier(f[i]) * sensor.at(f[i])) - 1.0) < 1e-10);
    }

    /// A second resonance of a fifth of the sensor's, which its model lacks.
    void departureFromTheShape_isRefused()
    {
        const TrueSensor sensor;
        const TrueSensor second{110e3, 0.05, 0.2};
        KnownResponse response = sensor.known();
        for (Index k = 0; k < 27; ++k)
            response.atKnots[k] *= 0.8 + second.at(response.knot_Hz[k]);
        const auto carried = carriedByShape(response);
        QVERIFY(!carried && carried.error().kind == ErrorKind::DataBlocked);
        QVERIFY(refusal(response, kRate_Hz, {250e3}).find("departs from the shape")
            != std::string::npos);
    }

    /// Errors of knots that no frequency of the filter needs are left out.
    void knotsBehindTheEdge_takeNoPart()
    {
        KnownResponse response = TrueSensor().known();
        response.errors
            = {{"near", Eigen::VectorXcd::Zero(27)}, {"far", Eigen::VectorXcd::Zero(27)}};
        response.errors[0].atKnots[3] = 0.01;
        response.errors[1].atKnots[26] = 0.01;
        const KnownResponse part = response.upTo(50e3);
        QCOMPARE(part.knot_Hz.size(), Index(19)); // to 50.1 kHz
        QCOMPARE(part.errors.size(), std::size_t(1));
        QCOMPARE(part.errors[0].quantity, std::string("near"));
        QCOMPARE(response.upTo(1e9).knot_Hz.size(), Index(27));
    }

    void filter_invertsTheSensorUpToTheBand_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("band_Hz");
        QTest::newRow("far below the resonance") << 0.02 << 50e3;
        QTest::newRow("beyond the resonance, hardly damped") << 0.005 << 310e3;
        QTest::newRow("well damped") << 0.7 << 300e3;
    }

    void filter_invertsTheSensorUpToTheBand()
    {
        QFETCH(double, zeta);
        QFETCH(double, band_Hz);
        const TrueSensor sensor{300e3, zeta, -2e-9}; // a pressure that lowers the voltage
        const auto filter = designCorrection(sensor.known(), kRate_Hz, {band_Hz});
        QVERIFY(filter.has_value());
        QCOMPARE(filter->unit, std::string("Pa/V"));
        QVERIFY(filter->passError <= kLargestPassError);
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(997, 0.0, band_Hz);
        const Eigen::VectorXcd whole = filter->at(f).cwiseProduct(sensor.at(f));
        for (Index i = 0; i < f.size(); ++i)
            QVERIFY(std::abs(whole[i] - filter->lowPass.at(f[i])) < 1.05 * kLargestPassError);
        QVERIFY(isNear(filter->gain(), 1.0 / sensor.S0, kLargestPassError));
        const Eigen::VectorXd beyond
            = Eigen::VectorXd::LinSpaced(200, 1.6 * band_Hz, 0.5 * kRate_Hz);
        QVERIFY(filter->at(beyond).cwiseAbs().maxCoeff() < 0.05 / std::abs(sensor.S0));
    }

    /// A sine comes out with its size, late by exactly the stated delay.
    void delayAndGain_areAsStated()
    {
        const TrueSensor sensor;
        for (const std::optional<double> delay_s :
            {std::optional<double>(), std::optional(80e-6)}) {
            const auto filter = designCorrection(sensor.known(), kRate_Hz, {200e3, {}, delay_s});
            QVERIFY(filter.has_value());
            if (delay_s)
                QVERIFY(std::abs(filter->delay_s() - *delay_s) < 0.5 / kRate_Hz);
            const double f_Hz = 150e3;
            const Complex S = sensor.at(f_Hz);
            const Index n = filter->taps.size() - 1;
            double out = 0.0;
            for (Index k = 0; k <= n; ++k)
                out += filter->taps[k]
                    * (S * std::polar(1.0, 2.0 * M_PI * f_Hz * double(n - k) / kRate_Hz)).real();
            const double pressure
                = std::cos(2.0 * M_PI * f_Hz * double(n - filter->delaySamples) / kRate_Hz);
            QVERIFY(std::abs(out - pressure) < 1.05 * kLargestPassError);
        }
    }

    /// Independent way: least squares of all taps against L/S over the whole circle.
    /// |L/S| over that at 0 Hz, from the closed form on a fine grid: 1 below a resonance, more
    /// where a damped sensor falls off.
    void noiseAmplification_isTheLargestGain()
    {
        for (const double zeta : {0.05, 0.9}) {
            TrueSensor sensor;
            sensor.zeta = zeta;
            const auto filter = designCorrection(sensor.known(), kRate_Hz, {250e3});
            QVERIFY(filter.has_value());
            double largest = 0.0;
            for (double f_Hz = 0.0; f_Hz < 450e3; f_Hz += 100.0)
                largest = std::max(
                    largest, std::abs(filter->lowPass.at(f_Hz) / sensor.at(f_Hz)) * sensor.S0);
            QVERIFY2(std::abs(filter->noiseAmplification() / largest - 1.0) < 1e-3,
                qPrintable(QString::number(filter->noiseAmplification())));
            QVERIFY(zeta > 0.5 ? largest > 1.5 : largest < 1.001);
        }
    }

    void taps_areTheLeastSquaresOfTheInverse()
    {
        const TrueSensor sensor{200e3, 0.3, 1.0};
        const double rate_Hz = 1.5e6;
        const auto filter = designCorrection(sensor.known(), rate_Hz, {200e3});
        QVERIFY(filter.has_value());
        const Index n = 4096;
        const Eigen::VectorXcd inverse = inverseOf(sensor.known(), filter->lowPass, rate_Hz, n);
        Eigen::MatrixXd A(2 * inverse.size(), filter->taps.size());
        Eigen::VectorXd b(A.rows());
        for (Index i = 0; i < inverse.size(); ++i) {
            const double weight = i == 0 || 2 * i == n ? 1.0 : std::sqrt(2.0);
            b[2 * i] = weight * inverse[i].real();
            b[2 * i + 1] = weight * inverse[i].imag();
            for (Index k = 0; k < A.cols(); ++k) {
                const double angle
                    = -2.0 * M_PI * double(i) * double(k - filter->delaySamples) / double(n);
                A(2 * i, k) = weight * std::cos(angle);
                A(2 * i + 1, k) = weight * std::sin(angle);
            }
        }
        const Eigen::VectorXd best = leastSquares(A, Eigen::MatrixXd(b));
        QVERIFY((best - filter->taps).cwiseAbs().maxCoeff()
            < 1e-10 * filter->taps.cwiseAbs().maxCoeff());
    }

    /// Each column is what a small part of its error changes the taps by.
    void tapErrors_areTheDerivatives()
    {
        const TrueSensor sensor;
        KnownResponse response = sensor.known();
        ResponseError one{"noise", Eigen::VectorXcd::Zero(27)};
        one.atKnots[18] = Complex(0.02, 0.0);
        ResponseError late{"onset_s", Eigen::VectorXcd::Zero(27)};
        for (Index k = 0; k < 27; ++k)
            late.atKnots[k] = Complex(0.0, -1e-8 * 2.0 * M_PI * response.knot_Hz[k]);
        response.errors = {errorOf(response, 0.01), one, late};
        const CorrectionSettings settings{200e3, {}, 60e-6};
        const auto filter = designCorrection(response, kRate_Hz, settings);
        QVERIFY(filter.has_value());
        for (std::size_t j = 0; j < 3; ++j) {
            const ResponseError &error = response.errors[j];
            const auto up = designCorrection(changed(response, error, 1e-3), kRate_Hz, settings);
            const auto down = designCorrection(changed(response, error, -1e-3), kRate_Hz, settings);
            const Index n = std::min({up->taps.size(), down->taps.size(), filter->taps.size()});
            const Eigen::VectorXd slope = (up->taps.head(n) - down->taps.head(n)) / 2e-3;
            const Eigen::VectorXd column = filter->tapErrors.col(Index(j)).head(n);
            QVERIFY((slope - column).norm() < 1e-4 * column.norm());
        }
        QVERIFY(isNear(filter->u_taps()[100], filter->tapErrors.row(100).norm(), 1e-15));
        QCOMPARE(filter->errorNames[2], std::string("onset_s"));
    }

    /// A moved pole moves what lies between the rows, not the rows; against the closed form.
    void movedPole_changesWhatIsBetweenTheRows()
    {
        const TrueSensor sensor;
        const double step = 1e-5;
        TrueSensor faster = sensor;
        faster.f0_Hz *= 1.0 + step;
        KnownResponse response = sensor.known();
        KnownResponse moved = response;
        moved.shape = faster.shape();
        ResponseError error{"pole_frequency", Eigen::VectorXcd::Zero(27)};
        error.polesMoved_rad_s = step * response.shape.s_rad_s;
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(300, 0.0, 500e3);
        const Eigen::VectorXcd expected = moved.at(f).cwiseQuotient(response.at(f)).array().log();
        const Eigen::VectorXcd found = response.changeBy(error, f);
        QVERIFY((found - expected).cwiseAbs().maxCoeff() < 1e-3 * found.cwiseAbs().maxCoeff());
        QVERIFY(response.changeBy(error, response.knot_Hz).cwiseAbs().maxCoeff() < 1e-18);
        QVERIFY(found.cwiseAbs().maxCoeff() > 0.1 * step);
    }

    /// PyDynamic's deconvolution of eight samples by a table (GUM_DFT, AmpPhase2DFT, DFT_deconv).
    void inverse_ofATable_equalsPyDynamic()
    {
        Eigen::VectorXd x(8), u(8);
        x << 0.0, 1.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05;
        u << 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08;
        const Eigen::VectorXd bins = Eigen::VectorXd::LinSpaced(5, 0.0, 4.0);
        const auto lines = dftWithCovariance(x, u.cwiseAbs2(), 8.0, bins);
        const KnownResponse table = tableOfFive();
        const Eigen::VectorXcd inverse
            = inverseOf(table, {LowPassKind::Gaussian, 1e6, 2e6}, 8.0, 8); // a low-pass of 1
        const double re[]{4.9, -.2986595668, -1.1303341087, -.8677989022, -.2496881019};
        const double im[]{0.0, -2.8641993881, -.5106920219, .0837260391, .5455784561};
        const double u_re[]{.151, .1004701157, .0730504669, .1255211779, .1194794554};
        const double u_im[]{.098, .1037677819, .0862615386, .0991337013, .2600243445};
        for (std::size_t k = 0; k < 5; ++k) {
            const auto i = static_cast<Index>(k);
            const Complex T = inverse[i];
            const Complex X = T * lines[k].value;
            const Eigen::Matrix2d turn
                = (Eigen::Matrix2d() << T.real(), -T.imag(), T.imag(), T.real()).finished();
            Eigen::Matrix2d covariance = turn * lines[k].covariance * turn.transpose();
            for (const ResponseError &one : table.errors) {
                const Complex error = inverseChange(inverse, table, one, 8.0)[i] * lines[k].value;
                const Eigen::Vector2d parts(error.real(), error.imag());
                covariance += parts * parts.transpose();
            }
            QVERIFY(isNear(X.real(), re[k]) && std::abs(X.imag() - im[k]) < 1e-9);
            QVERIFY(isNear(std::sqrt(covariance(0, 0)), u_re[k]));
            QVERIFY(isNear(std::sqrt(covariance(1, 1)), u_im[k]));
        }
    }

    void widestBand_endsWhereItIsKnownAndWhereNoiseIsAmplified()
    {
        const TrueSensor sensor;
        KnownResponse response = sensor.known();
        QVERIFY(isNear(widestBand_Hz(response, kRate_Hz), response.knot_Hz[26]));
        QVERIFY(isNear(widestBand_Hz(response, 0.6e6), 0.45 * 0.6e6 / 1.5));
        response.validTo_Hz = 200e3;
        QVERIFY(isNear(widestBand_Hz(response, kRate_Hz), 200e3 / 1.5));
        const KnownResponse slow = TrueSensor{20e3, 0.7, 1.0}.known(); // 1/50 at 141 kHz
        QVERIFY(isNear(widestBand_Hz(slow, kRate_Hz), 20e3 * std::sqrt(50.0), 0.01));
        QVERIFY(designCorrection(slow, kRate_Hz).has_value());
    }

    void impossibleRequests_areRefusedWithTheReason_data()
    {
        QTest::addColumn<double>("rate_Hz");
        QTest::addColumn<double>("band_Hz");
        QTest::addColumn<double>("edge_Hz");
        QTest::addColumn<double>("delay_s");
        QTest::addColumn<QString>("says");
        const double no = -1.0;
        QTest::newRow("band not measured")
            << 5e6 << 400e3 << no << no << "measured from 1 kHz to 316.2 kHz";
        QTest::newRow("band below") << 5e6 << 500.0 << no << no << "measured from 1 kHz";
        QTest::newRow("no band") << 5e6 << double(NAN) << no << no << "not possible";
        QTest::newRow("edge in the band")
            << 5e6 << 100e3 << 90e3 << no << "must lie above the end 100 kHz";
        QTest::newRow("edge unknown") << 5e6 << 300e3 << 1.2e6 << no << "known up to 1 MHz only";
        QTest::newRow("slow recording")
            << 500e3 << 200e3 << no << no << "holds only what lies below 225 kHz";
        QTest::newRow("no rate") << 0.0 << 200e3 << no << no << "no sample rate";
        QTest::newRow("rate infinite") << double(INFINITY) << 200e3 << no << no << "no sample rate";
        QTest::newRow("delay too short") << 5e6 << 200e3 << no << 1e-6 << "needs at least";
        QTest::newRow("delay absurd") << 5e6 << 200e3 << no << 1e9 << "takes at most";
    }

    void impossibleRequests_areRefusedWithTheReason()
    {
        QFETCH(double, rate_Hz);
        QFETCH(double, band_Hz);
        QFETCH(double, edge_Hz);
        QFETCH(double, delay_s);
        QFETCH(QString, says);
        CorrectionSettings settings{band_Hz};
        if (edge_Hz > 0.0)
            settings.edge_Hz = edge_Hz;
        if (delay_s > 0.0)
            settings.delay_s = delay_s;
        const QString said
            = QString::fromStdString(refusal(TrueSensor().known(), rate_Hz, settings));
        QVERIFY2(said.contains(says), qPrintable(said));
    }

    void wherePressureIsLostInNoise_isRefused()
    {
        const KnownResponse slow = TrueSensor{20e3, 0.7, 1.0}.known();
        const auto filter = designCorrection(slow, kRate_Hz, {300e3});
        QVERIFY(!filter && filter.error().kind == ErrorKind::DataBlocked);
        QVERIFY(
            english(filter.error().message).find("weaker than at the lowest") != std::string::npos);
    }

    /// An inverse that rings longer than any filter: a zero of S that is hardly damped.
    void inverseThatDoesNotDieAway_isRefused()
    {
        KnownResponse response;
        response.knot_Hz = Eigen::Vector2d(10.0, 400e3);
        response.atKnots = Eigen::Vector2cd::Ones();
        response.validTo_Hz = 1e6;
        const double w = 2.0 * M_PI * 100e3;
        const Complex s(-1e-6 * w, w); // 1 - c + c jw/(jw - s) ...: S is nearly 0 at 100 kHz
        response.shape.level = 1.0;
        response.shape.s_rad_s = Eigen::Vector2cd(1.002 * s, 1.002 * std::conj(s));
        response.shape.c = Eigen::Vector2cd(0.002, 0.002);
        const auto filter = designCorrection(response, 2e6, {300e3});
        QVERIFY(!filter && filter.error().kind == ErrorKind::DataBlocked);
    }
};

DYNCAL_TEST(TestCorrectionFilter)
#include "tst_correction_filter.moc"
