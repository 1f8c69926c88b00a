// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/counter_fit.h"
#include "tests/support/test_program.h"

#include <Eigen/LU>
#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kInch_m = 0.0254;

/// Arrivals of a shock whose velocity is W0 + k x at distance x to the end wall.
std::vector<Sighting> arrivals(const std::vector<double> &distances_m, double W0_m_s,
    double k_per_s, double u_distance_m = 1e-4, double u_time_s = 1e-7)
{
    std::vector<Sighting> list;
    for (const double x : distances_m) {
        const double time_s
            = k_per_s == 0.0 ? -x / W0_m_s : -std::log1p(k_per_s * x / W0_m_s) / k_per_s;
        Sighting s;
        s.channel = "toa";
        s.distance_m = x;
        s.u_distance_m = x > 0.0 ? u_distance_m : 0.0;
        s.time_s = 0.123 + time_s;
        s.u_time_s = u_time_s;
        s.isDut = x == 0.0;
        list.push_back(s);
    }
    return list;
}

/// The real shot of formats.md: four counters between five sensors.
std::vector<CounterReading> realCounters()
{
    const double lengths_m[]
        = {11.996 * kInch_m, 11.994 * kInch_m, 11.991 * kInch_m, 11.992 * kInch_m};
    const double times_s[] = {2.6362e-4, 2.6297e-4, 2.6336e-4, 2.6429e-4};
    const double middles_m[] = {1.4199, 1.1152, 0.8106, 0.5060};
    std::vector<CounterReading> readings;
    for (int i = 0; i < 4; ++i)
        readings.push_back({middles_m[i] + 0.5 * lengths_m[i], middles_m[i] - 0.5 * lengths_m[i],
            times_s[i], 0.0, 0.0});
    return readings;
}

} // namespace

class TestVelocityFit : public QObject
{
    Q_OBJECT

private slots:
    void twoPlaces_distanceOverTime();
    void manyPlaces_onALine_exact();
    void weights_moreCertainPlaceWins();
    void attenuation_linear_recoversVelocityAtTheWall();
    void range_onePlaceBeforeTheWall_decidesAlone();
    void range_manyPlaces_arrivalsDecide();
    void range_isAnObservation_asInTheNormalEquations();
    void range_counters_sameAsPlaces();
    void attenuation_threePlacesStated_uncertaintyKnown();
    void scatter_unstatedDistances_isEstimated();
    void chiSquare_ofStatedUncertainties();
    void refitted_sameInputs_sameVelocity();
    void counters_realShot_endWallVelocity();
    void counters_constantOrFew();
    void sensorsAtOnePlace_areNoThirdPlace_data();
    void sensorsAtOnePlace_areNoThirdPlace();
    void countersOverOneStretch_areNoSecondPlace();
    void nonsense_refused();
};

void TestVelocityFit::twoPlaces_distanceOverTime()
{
    const auto fit = fitVelocity(arrivals({0.8, 0.0}, 512.8, 0.0), Attenuation::None);
    QVERIFY(std::abs(fit->velocity_m_s / 512.8 - 1.0) < 1e-13);
    QVERIFY(std::abs(fit->arrivalAtWall_s - 0.123) < 1e-12);
    QCOMPARE(fit->dof, Index(0));
    QVERIFY(!fit->scatterEstimated && !fit->gradient_per_s && !fit->chiSquare);
}

void TestVelocityFit::manyPlaces_onALine_exact()
{
    for (const Attenuation attenuation : {Attenuation::None, Attenuation::Linear}) {
        const auto fit = fitVelocity(arrivals({1.4, 1.1, 0.8, 0.5, 0.2}, 512.8, 0.0), attenuation);
        QVERIFY(std::abs(fit->velocity_m_s / 512.8 - 1.0) < 1e-10);
        QVERIFY(fit->residual.cwiseAbs().maxCoeff() < 1e-14);
    }
}

void TestVelocityFit::weights_moreCertainPlaceWins()
{
    std::vector<Sighting> list = arrivals({0.8, 0.4, 0.0}, 500.0, 0.0);
    list[1].time_s += 1e-5;
    list[1].u_time_s = 1.0; // worth nothing
    const auto fit = fitVelocity(list, Attenuation::None);
    QVERIFY(std::abs(fit->velocity_m_s / 500.0 - 1.0) < 1e-9);
}

void TestVelocityFit::attenuation_linear_recoversVelocityAtTheWall()
{
    // 1 % per metre; a parabola leaves terms of order (k x/W)^2/3: a few parts in 1e5.
    const auto fit
        = fitVelocity(arrivals({1.0, 0.8, 0.6, 0.4, 0.2}, 512.8, 5.128), Attenuation::Linear);
    QVERIFY(fit->attenuated);
    QVERIFY2(std::abs(fit->velocity_m_s / 512.8 - 1.0) < 4e-5,
        qPrintable(QString::number(fit->velocity_m_s, 'g', 10)));
    QVERIFY(std::abs(*fit->gradient_per_s / 5.128 - 1.0) < 0.02);
    const auto straight
        = fitVelocity(arrivals({1.0, 0.8, 0.6, 0.4, 0.2}, 512.8, 5.128), Attenuation::None);
    QVERIFY(straight->velocity_m_s > 514.0); // what ignoring it costs
}

void TestVelocityFit::range_onePlaceBeforeTheWall_decidesAlone()
{
    // Mean velocity over x is W (1 + a x/2) to first order: here a is the middle of the range.
    for (const double u_distance_m : {2e-4, 0.0}) {
        const auto fit
            = fitVelocity(arrivals({0.8, 0.0}, 512.8, 0.0, u_distance_m), Attenuation::Automatic);
        QVERIFY(std::abs(fit->velocity_m_s / 512.8 - (1.0 - 0.0025 * 0.4)) < 2e-6);
        QVERIFY(fit->attenuated && !fit->gradient_per_s && fit->dof == 0);
        QVERIFY(std::abs(fit->attenuation->u_per_m() - 0.015 / std::sqrt(12.0)) < 1e-15);
        const auto known = fitVelocity(arrivals({0.8, 0.0}, 512.8, 5.128, u_distance_m),
            Attenuation::Automatic, {0.0099, 0.0101});
        QVERIFY(std::abs(known->velocity_m_s / 512.8 - 1.0) < 5e-5);
    }
}

void TestVelocityFit::range_manyPlaces_arrivalsDecide()
{
    // Nearly exact arrivals: the range, although it does not hold the truth, hardly counts.
    const auto fit = fitVelocity(
        arrivals({1.0, 0.8, 0.6, 0.4, 0.2}, 512.8, 10.256, 1e-7, 1e-10), Attenuation::Automatic);
    // What the parabola leaves of the logarithm grows with the square of the gradient: 4e-5 above.
    QVERIFY(std::abs(fit->velocity_m_s / 512.8 - 1.0) < 4.0 * 4e-5);
    QVERIFY(std::abs(*fit->seenAttenuation_per_m / 0.02 - 1.0) < 0.03);
    QVERIFY(*fit->chiSquare > 10.0); // it contradicts the range
}

void TestVelocityFit::range_isAnObservation_asInTheNormalEquations()
{
    const std::vector<Sighting> list = arrivals({0.8, 0.5, 0.2, 0.0}, 500.0, 3.0, 2e-4, 3e-7);
    const auto fit = fitVelocity(list, Attenuation::Automatic);
    // (X'WX + P) c = X'W t + P c_prior, solved directly.
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (Index i = 0; i < 4; ++i) {
        const Sighting &s = list[static_cast<std::size_t>(i)];
        const Eigen::Vector3d row(1.0, s.distance_m, s.distance_m * s.distance_m);
        normal += fit->weight[i] * row * row.transpose();
        right += fit->weight[i] * row * (s.time_s - list[0].time_s);
    }
    const double scale = fit->attenuation->scale;
    const double weight = 12.0 / std::pow(0.015 * scale, 2);
    normal(2, 2) += weight;
    right[2] += weight * scale * 0.0025;
    const Eigen::Vector3d c = normal.fullPivLu().solve(right);
    QVERIFY(std::abs(-1.0 / c[1] / fit->velocity_m_s - 1.0) < 1e-9);
    QVERIFY(std::abs(*fit->u_gradient_per_s
                    / (2.0 * std::sqrt(normal.inverse()(2, 2)) * std::pow(fit->velocity_m_s, 2))
                - 1.0)
        < 1e-6);
    Eigen::VectorXd x(4), t(4);
    for (Index i = 0; i < 4; ++i) {
        x[i] = list[static_cast<std::size_t>(i)].distance_m;
        t[i] = list[static_cast<std::size_t>(i)].time_s;
    }
    QVERIFY(std::abs(refittedVelocity_m_s(*fit, x, t, 0.0025) / fit->velocity_m_s - 1.0) < 1e-12);
    QVERIFY(refittedVelocity_m_s(*fit, x, t, 0.01) < fit->velocity_m_s);
}

void TestVelocityFit::range_counters_sameAsPlaces()
{
    // One counter over the last 0.8 m is one sensor there and one in the wall.
    const CounterReading reading{0.8, 0.0, 0.8 / 512.8, 2e-4, 3e-7};
    const auto counter = fitCounters({reading}, Attenuation::Automatic);
    const auto places = fitVelocity(arrivals({0.8, 0.0}, 512.8, 0.0), Attenuation::Automatic);
    QVERIFY(std::abs(counter->velocity_m_s / places->velocity_m_s - 1.0) < 3e-6);
    QVERIFY(
        std::abs(
            refittedCounterVelocity_m_s(*counter, {reading}, 0.0025) / counter->velocity_m_s - 1.0)
        < 1e-12);
    const auto real = fitCounters(realCounters(), Attenuation::Automatic);
    QVERIFY(real->scatterEstimated && real->scatter_m_s > 0.0 && real->gradient_per_s);
}

void TestVelocityFit::attenuation_threePlacesStated_uncertaintyKnown()
{
    const auto fit = fitVelocity(arrivals({0.9, 0.5, 0.1}, 512.8, 5.0), Attenuation::Linear);
    QVERIFY(fit->attenuated);
    QVERIFY(fit->u_gradient_per_s.has_value());
    QCOMPARE(fit->dof, Index(0));
    // Without stated distances nothing is left to say what it is worth: a straight line.
    const auto unstated
        = fitVelocity(arrivals({0.9, 0.5, 0.1}, 512.8, 5.0, 0.0), Attenuation::Linear);
    QVERIFY(!unstated->attenuated);
    QVERIFY(!unstated->u_gradient_per_s.has_value());
}

void TestVelocityFit::scatter_unstatedDistances_isEstimated()
{
    std::vector<Sighting> list = arrivals({0.8, 0.4, 0.0}, 500.0, 0.0, 0.0);
    list[1].time_s += 3e-6;
    const auto fit = fitVelocity(list, Attenuation::None);
    QVERIFY(fit->scatterEstimated);
    QCOMPARE(fit->dof, Index(1));
    // Residuals -1, 2, -1 us: s^2 = 6e-12; u(slope) = s/sqrt(0.32); u(W) = u(slope) W^2.
    const double expected = std::sqrt(6e-12 / 0.32) * fit->velocity_m_s * fit->velocity_m_s;
    QVERIFY(std::abs(fit->scatter_m_s / expected - 1.0) < 1e-9);
    QVERIFY(!fit->chiSquare);
}

void TestVelocityFit::chiSquare_ofStatedUncertainties()
{
    std::vector<Sighting> list = arrivals({0.8, 0.4, 0.0}, 500.0, 0.0, 1e-12, 1e-6);
    list[1].time_s += 3e-6;
    const auto fit = fitVelocity(list, Attenuation::None);
    QVERIFY(std::abs(*fit->chiSquare - 6.0) < 1e-6);
}

void TestVelocityFit::refitted_sameInputs_sameVelocity()
{
    const std::vector<Sighting> list = arrivals({1.0, 0.8, 0.6, 0.4, 0.2}, 512.8, 5.128);
    for (const Attenuation attenuation : {Attenuation::None, Attenuation::Linear}) {
        const auto fit = fitVelocity(list, attenuation);
        Eigen::VectorXd x(5), t(5);
        for (Index i = 0; i < 5; ++i) {
            x[i] = list[static_cast<std::size_t>(i)].distance_m;
            t[i] = list[static_cast<std::size_t>(i)].time_s;
        }
        QVERIFY(std::abs(refittedVelocity_m_s(*fit, x, t, 0.0) / fit->velocity_m_s - 1.0) < 1e-12);
    }
    const auto counters = fitCounters(realCounters(), Attenuation::Linear);
    QVERIFY(std::abs(refittedCounterVelocity_m_s(*counters, realCounters(), 0.0)
                - counters->velocity_m_s)
        < 1e-9);
}

void TestVelocityFit::counters_realShot_endWallVelocity()
{
    const auto fit = fitCounters(realCounters(), Attenuation::Linear);
    qInfo("U(end wall) = %.3f m/s (oracle 1152.05), gradient %.4f (m/s)/m (oracle 3.9221)",
        fit->velocity_m_s, *fit->gradient_per_s);
    QVERIFY(std::abs(fit->velocity_m_s - 1152.05) < 0.005);
    QVERIFY(std::abs(*fit->gradient_per_s - 3.9221) < 5e-4); // middles are printed to 0.1 mm
    QVERIFY(fit->attenuated && fit->scatterEstimated);
    QCOMPARE(fit->dof, Index(2));
}

void TestVelocityFit::counters_constantOrFew()
{
    const auto mean = fitCounters(realCounters(), Attenuation::None);
    QVERIFY(std::abs(mean->velocity_m_s - (1155.82 + 1158.49 + 1156.48 + 1152.51) / 4.0) < 0.01);
    const auto one = fitCounters({realCounters().front()}, Attenuation::Linear);
    QVERIFY(std::abs(one->velocity_m_s - 1155.82) < 0.01);
    QVERIFY(!one->scatterEstimated);
}

void TestVelocityFit::sensorsAtOnePlace_areNoThirdPlace_data()
{
    QTest::addColumn<double>("disagreement_s");
    QTest::addColumn<bool>("asked");
    QTest::newRow("as it should be") << 1e-8 << false;
    QTest::newRow("one is wrong") << 2e-6 << false;
    QTest::newRow("agree, attenuation asked for") << 1e-8 << true;
    QTest::newRow("one is wrong, attenuation asked for") << 2e-6 << true;
}

void TestVelocityFit::sensorsAtOnePlace_areNoThirdPlace()
{
    // Two sensors face each other at 0.6 m: a change of the velocity cannot be seen, whatever they
    // say. Their mean and the wall make the line.
    QFETCH(double, disagreement_s);
    QFETCH(bool, asked);
    for (const double u_distance_m : {1e-4, 0.0}) {
        auto seen = arrivals({0.6, 0.6, 0.0}, 512.8, 0.0, u_distance_m);
        seen[0].time_s += disagreement_s;
        seen[1].time_s -= disagreement_s;
        const auto fit = fitVelocity(seen, asked ? Attenuation::Linear : Attenuation::None);
        QVERIFY(fit.has_value());
        QVERIFY(!fit->attenuated);
        QVERIFY(!fit->gradient_per_s && !fit->u_gradient_per_s);
        QVERIFY(std::abs(fit->velocity_m_s / 512.8 - 1.0) < 1e-10);
    }
}

void TestVelocityFit::countersOverOneStretch_areNoSecondPlace()
{
    for (const Attenuation attenuation : {Attenuation::None, Attenuation::Linear}) {
        const auto fit = fitCounters(
            {{1.0, 0.5, 1e-3, 1e-4, 1e-7}, {1.0, 0.5, 1.01e-3, 1e-4, 1e-7}}, attenuation);
        QVERIFY(!fit->attenuated && !fit->gradient_per_s);
        QVERIFY(fit->velocity_m_s > 0.5 / 1.01e-3 && fit->velocity_m_s < 500.0);
    }
}

void TestVelocityFit::nonsense_refused()
{
    QCOMPARE(fitVelocity({}, Attenuation::None).error().kind, ErrorKind::Usage);
    QCOMPARE(
        fitVelocity(arrivals({0.8}, 500.0, 0.0), Attenuation::None).error().kind, ErrorKind::Usage);
    QCOMPARE(fitVelocity(arrivals({0.8, 0.8}, 500.0, 0.0), Attenuation::None).error().kind,
        ErrorKind::Usage);
    const auto away = fitVelocity(arrivals({0.8, 0.1}, -500.0, 0.0), Attenuation::None);
    QCOMPARE(away.error().findingId, std::string("SHK-001"));
    std::vector<Sighting> together = arrivals({0.8, 0.1}, 500.0, 0.0);
    together[1].time_s = together[0].time_s;
    QVERIFY(!fitVelocity(together, Attenuation::None));
    QCOMPARE(fitCounters({}, Attenuation::None).error().kind, ErrorKind::Usage);
    QCOMPARE(fitCounters({{0.5, 0.8, 1e-4, 0.0, 0.0}}, Attenuation::None).error().kind,
        ErrorKind::Usage);
}

DYNCAL_TEST(TestVelocityFit)
#include "tst_velocity_fit.moc"
