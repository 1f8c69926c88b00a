// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/distributions.h"
#include "core/base/portable_random.h"
#include "core/correction/corrected_pressure.h"
#include "core/correction/fir_passage.h"
#include "tests/support/known_sensor.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 5e6;
constexpr Index kCount = 4000;

/// Noise of a record before the pressure, as it was recorded.
NoiseDensity densityOf(const Eigen::VectorXd &noise)
{
    WindowedResponse response;
    response.sampleRate_Hz = kRate_Hz;
    response.noise = noise.array() - noise.mean();
    response.noiseSd = std::sqrt(response.noise.squaredNorm() / double(noise.size() - 1));
    return NoiseDensity(response);
}

/// Autoregressive noise of the given standard deviation.
Eigen::VectorXd noiseOf(RandomStream &random, Index count, double sd, double ar1)
{
    Eigen::VectorXd values(count);
    double value = sd * random.nextNormal();
    for (double &out : values) {
        out = value;
        value = ar1 * value + sd * std::sqrt(1.0 - ar1 * ar1) * random.nextNormal();
    }
    return values;
}

/// Two bursts within the band on a slow pulse, gone at both ends; in Pa.
Eigen::VectorXd pulses(RandomStream &random)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(kCount);
    for (int i = 0; i < 2; ++i)
        sum += (0.3 + 0.5 * random.nextUniform()) * 1e5
            * burst(kCount, kRate_Hz, (300.0 + 200.0 * random.nextUniform()) * 1e-6,
                (15.0 + 10.0 * random.nextUniform()) * 1e-6, 120e3 * random.nextUniform());
    return sum + 0.5e5 * burst(kCount, kRate_Hz, 400e-6, 40e-6, 0.0);
}

double aloneAt(double frequency_Hz)
{
    return 0.001 + 0.02 * frequency_Hz / 300e3;
}

/// Errors as a calibration has them: of each row alone, growing with frequency; of all rows.
std::vector<ResponseError> errorsOf(const KnownResponse &response)
{
    std::vector<ResponseError> errors;
    const Index knots = response.knot_Hz.size();
    for (Index k = 0; k < knots; ++k) {
        const double u = aloneAt(response.knot_Hz[k]);
        for (const Complex direction : {Complex(1.0, 0.0), Complex(0.0, 1.0)}) {
            errors.push_back({"noise", Eigen::VectorXcd::Zero(knots)});
            errors.back().atKnots[k] = u * direction;
        }
    }
    errors.push_back({"gain_relative", Eigen::VectorXcd::Constant(knots, 0.004)});
    errors.push_back(
        {"onset_s", Eigen::VectorXcd(Complex(0.0, -2e-8 * 2.0 * M_PI) * response.knot_Hz)});
    return errors;
}

/// A calibration of the sensor: its true response, off by a draw of every error.
KnownResponse calibration(const TrueSensor &sensor, RandomStream &random)
{
    KnownResponse response = sensor.known();
    response.errors = errorsOf(response);
    response.u_alone = response.knot_Hz.unaryExpr(&aloneAt);
    for (const ResponseError &error : response.errors) {
        const double drawn = random.nextNormal();
        for (Index k = 0; k < response.knot_Hz.size(); ++k)
            response.atKnots[k] *= std::exp(drawn * error.atKnots[k]);
    }
    TrueSensor near = sensor;
    const double u_f0 = 2e-4, u_zeta = 4e-4;
    near.f0_Hz *= 1.0 + u_f0 * random.nextNormal();
    near.zeta += u_zeta * random.nextNormal();
    response.shape = near.shape();
    const Complex s = near.pole_rad_s();
    const double zeta = near.zeta;
    const Complex byZeta
        = std::abs(s) * Complex(-1.0, -zeta / std::sqrt(1.0 - zeta * zeta)) * u_zeta;
    for (const Complex moved : {s * u_f0, byZeta}) {
        response.errors.push_back({"pole", Eigen::VectorXcd::Zero(response.knot_Hz.size())});
        response.errors.back().polesMoved_rad_s = Eigen::Vector2cd(moved, std::conj(moved));
    }
    return response;
}

/// How many samples of the true pressure lie in the band of 95 %, of how many.
struct Coverage
{
    Index inside = 0;
    Index all = 0;

    void add(const CorrectedPressure &found, const Eigen::VectorXd &truth_Pa)
    {
        const auto first = static_cast<Index>(std::lround(found.time_s * kRate_Hz));
        for (Index i = 0; i < found.pressure_Pa.size(); ++i) {
            const double error = found.pressure_Pa[i] - truth_Pa[first + i];
            inside += std::abs(error) <= found.k[i] * found.u_Pa[i] ? 1 : 0;
            ++all;
        }
    }

    double percent() const { return 100.0 * double(inside) / double(all); }
};

CorrectedPressure corrected(
    const RecordedStretch &stretch, const CorrectionFilter &filter, double noiseSd = 0.0)
{
    RandomStream random(5, 1, 1);
    return correctedPressure(stretch, densityOf(noiseOf(random, 20000, noiseSd, 0.0)), filter)
        .value();
}

} // namespace

class TestCorrectedPressure : public QObject
{
    Q_OBJECT

private slots:
    void passage_isTheSumWrittenOut()
    {
        RandomStream random(1, 1, 1);
        const Eigen::VectorXd x = noiseOf(random, 101, 1.0, 0.0);
        const Eigen::VectorXd taps = noiseOf(random, 7, 1.0, 0.0);
        const FirPassage passage(x, 7);
        const Eigen::VectorXd y = passage.through(taps);
        QCOMPARE(y.size(), Index(95));
        QCOMPARE(passage.size(), y.size());
        for (Index n = 0; n < y.size(); ++n)
            QVERIFY(std::abs(y[n] - taps.dot(x.segment(n, 7).reverse())) < 1e-13);
    }

    /// Pressure by Fourier's synthesis through the closed form, without noise: its size, its place
    /// in time, and where it is stated.
    void pressure_withinTheBand_comesBack()
    {
        RandomStream random(3, 1, 1);
        const TrueSensor sensor{300e3, 0.02, -3e-9};
        const Eigen::VectorXd truth = pulses(random);
        const auto filter = designCorrection(sensor.known(), kRate_Hz, {250e3}).value();
        const CorrectedPressure found
            = corrected({sensor.recordOf(truth, kRate_Hz), -50e-6}, filter);
        const auto first = static_cast<Index>(std::lround((found.time_s + 50e-6) * kRate_Hz));
        QVERIFY(first > 0 && first + found.pressure_Pa.size() < kCount);
        QVERIFY(found.pressure_Pa.size() > 3000);
        const double error = (found.pressure_Pa - truth.segment(first, found.pressure_Pa.size()))
                                 .cwiseAbs()
                                 .maxCoeff();
        QVERIFY2(error < 2.0 * kLargestPassError * truth.cwiseAbs().maxCoeff(),
            qPrintable(QString::number(error)));
        QCOMPARE(found.u_noise_Pa, 0.0);
    }

    void noise_isTheScatterOfWhatComesOut_data()
    {
        QTest::addColumn<double>("ar1");
        QTest::newRow("white") << 0.0;
        QTest::newRow("slow") << 0.9;
        QTest::newRow("fast") << -0.5;
    }

    void noise_isTheScatterOfWhatComesOut()
    {
        QFETCH(double, ar1);
        RandomStream random(7, 1, 1);
        const TrueSensor sensor;
        const auto filter = designCorrection(sensor.known(), kRate_Hz, {200e3}).value();
        const NoiseDensity density = densityOf(noiseOf(random, 40000, 1e-5, ar1));
        const RecordedStretch stretch{noiseOf(random, 200000, 1e-5, ar1), 0.0};
        const CorrectedPressure found = correctedPressure(stretch, density, filter).value();
        const double scatter
            = std::sqrt(found.pressure_Pa.squaredNorm() / double(found.pressure_Pa.size()));
        QVERIFY2(std::abs(found.u_noise_Pa / scatter - 1.0) < 0.03,
            qPrintable(QString::number(found.u_noise_Pa / scatter)));
        // What is not there is not bounded: the largest of noise seldom exceeds three sigmas.
        const Index bounded = (found.bound_Pa.array() > 0.0).count();
        QVERIFY(double(bounded) < 0.1 * double(found.bound_Pa.size()));
        QVERIFY(found.bound_Pa.maxCoeff() < 4.0 * found.u_noise_Pa);
    }

    /// What the sensor's errors make of each sample, from the definition: the taps' covariance.
    void responseShare_isThatOfTheTapsCovariance()
    {
        RandomStream random(9, 1, 1);
        const TrueSensor sensor;
        const auto filter
            = designCorrection(calibration(sensor, random), kRate_Hz, {200e3}).value();
        const Eigen::VectorXd record = sensor.recordOf(pulses(random), kRate_Hz);
        const CorrectedPressure found = corrected({record, 0.0}, filter);
        const Eigen::MatrixXd covariance = filter.tapErrors * filter.tapErrors.transpose();
        const Index n = filter.taps.size();
        for (const Index i : {Index(500), Index(1200), Index(2000)}) {
            const auto at = static_cast<Index>(std::lround(found.time_s * kRate_Hz)) + i
                + filter.delaySamples; // the last sample that the filter sees
            const Eigen::VectorXd seen = record.segment(at - n + 1, n).reverse();
            QVERIFY(isNear(found.u_response_Pa[i], std::sqrt(seen.dot(covariance * seen)), 1e-6));
            QVERIFY(isNear(found.u_Pa[i] * found.u_Pa[i],
                std::pow(found.u_response_Pa[i], 2) + std::pow(found.bound_Pa[i], 2) / 3.0
                    + std::pow(found.u_noise_Pa, 2),
                1e-12));
        }
    }

    /// A front that the band does not hold: the bound covers what the low-pass takes away where
    /// less lies beyond the band than in its upper half.
    void bound_coversWhatTheLowPassTakesAway()
    {
        const TrueSensor sensor;
        for (const double frequency_Hz : {60e3, 90e3, 110e3}) {
            const Eigen::VectorXd truth = 1e5 * burst(kCount, kRate_Hz, 400e-6, 5e-6, frequency_Hz);
            const auto filter = designCorrection(sensor.known(), kRate_Hz, {110e3}).value();
            const CorrectedPressure found
                = corrected({sensor.recordOf(truth, kRate_Hz), 0.0}, filter);
            const auto first = static_cast<Index>(std::lround(found.time_s * kRate_Hz));
            const Eigen::VectorXd lost
                = (found.pressure_Pa - truth.segment(first, found.pressure_Pa.size())).cwiseAbs();
            QVERIFY(lost.maxCoeff() > 0.003 * 1e5);
            QVERIFY((lost.array() <= found.bound_Pa.array() + 30.0).all());
        }
    }

    void bound_thatIsStated_holdsEverywhere()
    {
        RandomStream random(3, 1, 1);
        const TrueSensor sensor;
        const auto filter = designCorrection(sensor.known(), kRate_Hz, {200e3}).value();
        const RecordedStretch stretch{sensor.recordOf(pulses(random), kRate_Hz), 0.0};
        const CorrectedPressure found
            = correctedPressure(stretch, densityOf(Eigen::VectorXd::Zero(1000)), filter, 600.0)
                  .value();
        QCOMPARE(found.bound_Pa.minCoeff(), 600.0);
        QVERIFY(isNear(found.u_Pa[100], 600.0 / std::sqrt(3.0)));
        QVERIFY(isNear(found.k[100], normalQuantile(0.975)));
    }

    /// Where one error of three degrees of freedom makes all of u, k is Student's of three.
    void coverageFactor_followsTheDegreesOfFreedom()
    {
        RandomStream random(3, 1, 1);
        const TrueSensor sensor;
        KnownResponse response = sensor.known();
        response.errors = {{"gain", Eigen::VectorXcd::Constant(27, 0.01), 3.2}};
        const auto filter = designCorrection(response, kRate_Hz, {200e3}).value();
        const RecordedStretch stretch{sensor.recordOf(pulses(random), kRate_Hz), 0.0};
        const CorrectedPressure found
            = correctedPressure(stretch, densityOf(Eigen::VectorXd::Zero(1000)), filter, 0.0)
                  .value();
        Index largest = 0;
        const double most = found.pressure_Pa.cwiseAbs().maxCoeff(&largest);
        QVERIFY(isNear(found.k[largest], studentQuantile(0.975, 3.0)));
        QVERIFY(isNear(found.u_Pa[largest], 0.01 * most, 1e-9));
    }

    /// 100 sensors calibrated with errors, pulses of known pressure, noise of two colours.
    void truePressure_isInsideItsBandOf95percent()
    {
        Coverage coverage;
        const int sensors = trials::count(100, 1000);
        for (int i = 0; i < sensors; ++i) {
            RandomStream random(2026, i + 1, 1);
            const TrueSensor sensor{(250.0 + 150.0 * random.nextUniform()) * 1e3,
                0.01 + 0.1 * random.nextUniform(), 3e-9};
            const auto filter
                = designCorrection(calibration(sensor, random), kRate_Hz, {200e3}).value();
            const double ar1 = i % 2 == 0 ? 0.0 : 0.7;
            const double sd = 3e-9 * 1e5 * (0.002 + 0.02 * random.nextUniform());
            const Eigen::VectorXd truth = pulses(random);
            const Eigen::VectorXd before = noiseOf(random, 8000, sd, ar1);
            Eigen::VectorXd record = sensor.recordOf(truth, kRate_Hz);
            record += noiseOf(random, kCount, sd, ar1)
                - Eigen::VectorXd::Constant(kCount, before.mean());
            coverage.add(
                correctedPressure({record, 0.0}, densityOf(before), filter).value(), truth);
        }
        qInfo("%.2f %% of %lld samples", coverage.percent(), static_cast<long long>(coverage.all));
        QVERIFY(coverage.percent() >= 92.0 && coverage.percent() <= 98.0);
    }

    void unusableStretches_areRefused()
    {
        const TrueSensor sensor;
        const auto filter = designCorrection(sensor.known(), kRate_Hz, {200e3}).value();
        const NoiseDensity noise = densityOf(Eigen::VectorXd::Zero(1000));
        const auto tooShort = correctedPressure({Eigen::VectorXd::Zero(100), 0.0}, noise, filter);
        QVERIFY(!tooShort && tooShort.error().kind == ErrorKind::Usage);
        QVERIFY(english(tooShort.error().message).find("has 100 samples") != std::string::npos);
        Eigen::VectorXd gap = Eigen::VectorXd::Zero(kCount);
        gap[2000] = NAN;
        const auto withGap = correctedPressure({gap, 0.0}, noise, filter);
        QVERIFY(!withGap && withGap.error().kind == ErrorKind::DataBlocked);
    }
};

DYNCAL_TEST(TestCorrectedPressure)
#include "tst_corrected_pressure.moc"
