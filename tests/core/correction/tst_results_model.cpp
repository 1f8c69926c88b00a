// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/results_model.h"
#include "tests/support/made_results.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using namespace dyncal::testing;
using Complex = std::complex<double>;
using Json = MadeJson;

namespace {

constexpr double kFLow_Hz = 700.0;

/// One mode of a model in modal form: its rate and its amplitude in the step response.
struct Mode
{
    Complex s_rad_s;
    Complex c;
};

/// A model of several modes (of pairs the upper half only) with the level c0 and poles with u.
Json modelOf(const std::vector<Mode> &modes, double c0, double dt_s)
{
    Index n = 0;
    for (const Mode &mode : modes)
        n += mode.s_rad_s.imag() == 0.0 ? 1 : 2;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n, 1);
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(1, n);
    double D = c0;
    Json poles = Json::array();
    const auto addPole = [&](Complex z, Complex s) {
        const double size = std::abs(s);
        poles.push_back(
            {{"re", z.real()}, {"im", z.imag()}, {"frequency_hz", size / (2.0 * std::numbers::pi)},
                {"u_frequency_hz", 1e-4 * size / (2.0 * std::numbers::pi)},
                {"damping_ratio", -s.real() / size}, {"u_damping_ratio", 1e-4}});
    };
    Index at = 0;
    for (const auto &[s, c] : modes) {
        const Complex z = std::exp(s * dt_s);
        const Complex r = c * (z - 1.0);
        addPole(z, s);
        if (s.imag() == 0.0) {
            A(at, at) = z.real();
            B(at, 0) = 1.0;
            C(0, at) = r.real();
            D += c.real();
            ++at;
            continue;
        }
        addPole(std::conj(z), std::conj(s));
        A.block(at, at, 2, 2) << z.real(), z.imag(), -z.imag(), z.real();
        B(at, 0) = 2.0;
        C.block(0, at, 1, 2) << r.real(), r.imag();
        D += 2.0 * c.real();
        at += 2;
    }
    const auto rows = [](const Eigen::MatrixXd &matrix) {
        Json list = Json::array();
        for (Index i = 0; i < matrix.rows(); ++i) {
            Json row = Json::array();
            for (Index j = 0; j < matrix.cols(); ++j)
                row.push_back(matrix(i, j));
            list.push_back(row);
        }
        return list;
    };
    return {{"A", rows(A)}, {"B", rows(B)}, {"C", rows(C)},
        {"D", rows(Eigen::MatrixXd::Constant(1, 1, D))}, {"dt_s", dt_s}, {"poles", poles}};
}

/// G(jw) from the modes, as written.
Complex responseOf(const std::vector<Mode> &modes, double c0, double frequency_Hz)
{
    const Complex jw(0.0, 2.0 * std::numbers::pi * frequency_Hz);
    Complex G = c0;
    for (const auto &[s, c] : modes) {
        G += c * jw / (jw - s);
        if (s.imag() != 0.0)
            G += std::conj(c) * jw / (jw - std::conj(s));
    }
    return G;
}

Mode mode(double f0_Hz, double zeta, Complex c)
{
    return {2.0 * std::numbers::pi * f0_Hz * Complex(-zeta, std::sqrt(1.0 - zeta * zeta)), c};
}

std::string whyNoShape(const Json &model)
{
    const auto shape = shapeOf(model, kFLow_Hz);
    return shape ? std::string() : english(shape.error().message);
}

} // namespace

class TestResultsModel : public QObject
{
    Q_OBJECT

private slots:
    void shape_ofASensorOfSecondOrder_isItsClosedForm_data()
    {
        QTest::addColumn<double>("f0_Hz");
        QTest::addColumn<double>("zeta");
        QTest::newRow("hardly damped") << 300e3 << 0.005;
        QTest::newRow("well damped") << 50e3 << 0.7;
        QTest::newRow("near half the rate") << 480e3 << 0.05;
        QTest::newRow("low") << 2e3 << 0.1;
    }

    void shape_ofASensorOfSecondOrder_isItsClosedForm()
    {
        QFETCH(double, f0_Hz);
        QFETCH(double, zeta);
        MadeResults results;
        results.sensor = {f0_Hz, zeta, 1.0};
        const auto shape = shapeOf(results.model(), kFLow_Hz);
        QVERIFY(shape.has_value());
        QVERIFY(isNear(shape->level, 1.0));
        for (const double f : {0.0, 1e3, 0.5 * f0_Hz, f0_Hz, 1.7 * f0_Hz})
            QVERIFY(std::abs(shape->at(f) - results.sensor.at(f))
                < 1e-9 * std::abs(results.sensor.at(f0_Hz)));
    }

    void shape_ofManyModes_isTheirSum()
    {
        std::vector<Mode> modes;
        for (int i = 0; i < 12; ++i)
            modes.push_back(
                mode(20e3 + 35e3 * i, 0.01 + 0.02 * i, Complex(-0.1 + 0.01 * i, 0.02 * i)));
        modes.push_back({Complex(-2e5, 0.0), Complex(0.2, 0.0)});
        const auto shape = shapeOf(modelOf(modes, 1.3, 1e-6), kFLow_Hz);
        QVERIFY(shape.has_value());
        QCOMPARE(shape->s_rad_s.size(), Index(25));
        for (const double f : {0.0, 5e3, 20e3, 111e3, 405e3})
            QVERIFY(std::abs(shape->at(f) - responseOf(modes, 1.3, f)) < 1e-8);
    }

    /// Two modes a thousandth apart: the circle about each is small enough.
    void shape_ofNearlyEqualPoles_isTheirSum()
    {
        const std::vector<Mode> modes{
            mode(100e3, 0.05, Complex(-2.0, 1.0)), mode(100.1e3, 0.05, Complex(1.7, -0.8))};
        const auto shape = shapeOf(modelOf(modes, 1.0, 1e-6), kFLow_Hz);
        QVERIFY(shape.has_value());
        for (const double f : {1e3, 99e3, 100e3, 250e3})
            QVERIFY(std::abs(shape->at(f) - responseOf(modes, 1.0, f)) < 1e-7);
    }

    /// A drift (heat, AC coupling) is slower than the lowest frequency: its mode counts as not yet
    /// gone, and the level is that at the onset.
    void slowRealMode_countsAsSettled()
    {
        const Mode ringing = mode(100e3, 0.05, Complex(-0.5, 0.02));
        const Mode drift{Complex(-200.0, 0.0), Complex(0.1, 0.0)};
        const auto shape = shapeOf(modelOf({ringing, drift}, 0.9, 1e-6), kFLow_Hz);
        QVERIFY(shape.has_value());
        QCOMPARE(shape->s_rad_s.size(), Index(2));
        QVERIFY(isNear(shape->level, 1.0, 1e-8));
        const double f = 20e3; // far above the drift's 32 Hz both are the same
        QVERIFY(std::abs(shape->at(f) - responseOf({ringing, drift}, 0.9, f)) < 2e-4);
        const auto fast
            = shapeOf(modelOf({ringing, {Complex(-5000.0, 0.0), 0.1}}, 0.9, 1e-6), kFLow_Hz);
        QCOMPARE(fast->s_rad_s.size(), Index(3)); // 796 Hz: above
        QVERIFY(isNear(fast->level, 0.9, 1e-8));
    }

    void modelsThatCarryNothing_areRefused()
    {
        const MadeResults results;
        QVERIFY(whyNoShape(Json()).find("no model") != std::string::npos);
        Json model = results.model();
        model["A"][0][0] = nullptr;
        QVERIFY(whyNoShape(model).find("no model") != std::string::npos);
        model = results.model();
        model["A"][1] = Json::array({1.0});
        QVERIFY(whyNoShape(model).find("no model") != std::string::npos);
        model = results.model();
        model["B"] = Json::array({Json::array({1.0})});
        QVERIFY(whyNoShape(model).find("no model") != std::string::npos);
        model = results.model();
        model["dt_s"] = 0.0;
        QVERIFY(whyNoShape(model).find("no model") != std::string::npos);
        model = results.model();
        model["A"] = "none";
        QVERIFY(whyNoShape(model).find("no model") != std::string::npos);
    }

    void polesThatAreNoSensors_areRefused()
    {
        const MadeResults results;
        Json model = results.model();
        model["poles"].erase(1);
        QVERIFY(whyNoShape(model).find("not as many poles") != std::string::npos);
        model = results.model();
        model["poles"][0]["re"] = nullptr;
        QVERIFY(whyNoShape(model).find("not as many poles") != std::string::npos);
        model = results.model();
        model["poles"][0]["re"] = 1.0;
        model["poles"][0]["im"] = 0.1;
        QVERIFY(whyNoShape(model).find("not stable") != std::string::npos);
        model = results.model();
        model["poles"][0]["re"] = -0.4;
        model["poles"][0]["im"] = 0.0;
        QVERIFY(whyNoShape(model).find("half its rate") != std::string::npos);
        model = results.model();
        model["poles"][0] = model["poles"][1];
        QVERIFY(whyNoShape(model).find("same pole twice") != std::string::npos);
    }

    /// f0 alone and damping alone, both of a pair together: by differences of the closed form.
    void poleErrors_moveThePairBySize()
    {
        MadeResults results;
        const PoleShape shape = shapeOf(results.model(), kFLow_Hz).value();
        const auto errors = poleErrors(results.model(), shape, 27);
        QVERIFY(errors.has_value());
        QCOMPARE(errors->size(), std::size_t(2));
        TrueSensor faster = results.sensor;
        faster.f0_Hz *= 1.0 + 1e-4;
        TrueSensor damped = results.sensor;
        damped.zeta += 1e-4;
        const Complex by[]{faster.pole_rad_s() - results.sensor.pole_rad_s(),
            damped.pole_rad_s() - results.sensor.pole_rad_s()};
        const bool isUpperFirst = shape.s_rad_s[0].imag() > 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            const Eigen::VectorXcd &moved = (*errors)[i].polesMoved_rad_s;
            const Complex upper = moved[isUpperFirst ? 0 : 1];
            QVERIFY(std::abs(upper - by[i]) < 1e-3 * std::abs(by[i]));
            QVERIFY(
                std::abs(moved[isUpperFirst ? 1 : 0] - std::conj(upper)) < 1e-9 * std::abs(upper));
            QVERIFY((*errors)[i].atKnots.isZero(0.0));
            QCOMPARE((*errors)[i].atKnots.size(), Index(27));
        }
    }

    void poleErrors_ofARealPole_areOfItsRate()
    {
        const std::vector<Mode> modes{{Complex(-1e5, 0.0), Complex(-1.0, 0.0)}};
        const Json model = modelOf(modes, 1.0, 1e-6);
        const PoleShape shape = shapeOf(model, kFLow_Hz).value();
        const auto errors = poleErrors(model, shape, 5);
        QVERIFY(errors.has_value());
        QCOMPARE(errors->size(), std::size_t(1));
        QVERIFY(std::abs(errors->front().polesMoved_rad_s[0] - Complex(-10.0, 0.0)) < 1e-6);
    }

    void polesWithoutUncertainty_areRefused()
    {
        MadeResults results;
        const PoleShape shape = shapeOf(results.model(), kFLow_Hz).value();
        for (const char *key : {"u_frequency_hz", "u_damping_ratio"}) {
            Json model = results.model();
            for (Json &pole : model["poles"])
                pole[key] = nullptr;
            const auto errors = poleErrors(model, shape, 5);
            QVERIFY(!errors && errors.error().kind == ErrorKind::DataBlocked);
            QVERIFY(english(errors.error().message).find("not refined") != std::string::npos);
        }
    }
};

DYNCAL_TEST(TestResultsModel)
#include "tst_results_model.moc"
