// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/results_rows.h"
#include "tests/support/made_results.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;
using Json = MadeJson;

namespace {

MeasuredRows rowsOf(const Json &root)
{
    return measuredRows(root["response"]).value();
}

/// The errors of that name.
std::vector<ResponseError> named(const std::vector<ResponseError> &errors, const std::string &name)
{
    std::vector<ResponseError> found;
    for (const ResponseError &error : errors)
        if (error.quantity == name)
            found.push_back(error);
    return found;
}

std::vector<ResponseError> errorsOf(const Json &root)
{
    return rowErrors(root["budget"], rowsOf(root), root["sensitivity"]["value"]).value();
}

void setRow(Json &root, std::size_t row, const char *key, const Json &value)
{
    root["response"][key][row] = value;
}

} // namespace

class TestResultsRows : public QObject
{
    Q_OBJECT

private slots:
    void rows_areThoseOfTheFile()
    {
        const MadeResults results;
        const MeasuredRows rows = rowsOf(results.json());
        QCOMPARE(rows.frequency_Hz.size(), Index(26));
        QCOMPARE(rows.number.back(), std::size_t(25));
        for (Index i = 0; i < 26; ++i) {
            QVERIFY(std::abs(rows.S[i] / results.sensor.at(rows.frequency_Hz[i]) - 1.0) < 1e-12);
            QVERIFY(isNear(rows.u_magnitude[i], std::abs(rows.S[i]) * std::hypot(1e-3, 5e-3)));
        }
    }

    /// A withheld row is passed over; its neighbours are close enough.
    void incompleteRow_isLeftOut()
    {
        for (const char *key : {"magnitude", "phase_rad", "u_magnitude", "u_phase_rad"}) {
            Json root = MadeResults().json();
            setRow(root, 4, key, nullptr);
            const MeasuredRows rows = rowsOf(root);
            QCOMPARE(rows.frequency_Hz.size(), Index(25));
            QCOMPARE(rows.number[4], std::size_t(5));
        }
        Json root = MadeResults().json();
        setRow(root, 0, "magnitude", 0.0); // no response, no inverse
        QCOMPARE(rowsOf(root).number.front(), std::size_t(1));
    }

    /// Four rows in a row: more than an octave of nothing. What lies behind is not used.
    void wideGap_endsTheRows()
    {
        Json root = MadeResults().json();
        for (std::size_t i = 10; i < 14; ++i)
            setRow(root, i, "u_phase_rad", nullptr);
        QCOMPARE(rowsOf(root).frequency_Hz.size(), Index(10));
    }

    void rowsThatContradict_areRefused()
    {
        Json root = MadeResults().json();
        root["response"]["phase_rad"].erase(3);
        QVERIFY(measuredRows(root["response"]).error().kind == ErrorKind::Usage);
        root = MadeResults().json();
        setRow(root, 5, "frequency_hz", 1000.0);
        QVERIFY(measuredRows(root["response"]).error().kind == ErrorKind::Usage);
        root = MadeResults().json();
        setRow(root, 0, "frequency_hz", -1000.0);
        QVERIFY(!measuredRows(root["response"]));
        root = MadeResults().json();
        setRow(root, 0, "frequency_hz", "1000");
        QVERIFY(!measuredRows(root["response"]));
    }

    void noCompleteRow_isRefused()
    {
        for (const char *key : {"magnitude", "phase_rad", "u_magnitude", "u_phase_rad"}) {
            Json root = MadeResults().json();
            root["response"][key] = nullptr;
            const auto rows = measuredRows(root["response"]);
            QVERIFY(!rows && rows.error().kind == ErrorKind::DataBlocked);
        }
        QVERIFY(!measuredRows(Json()));
        QVERIFY(!measuredRows(Json::array({1, 2})));
    }

    /// Noise is of each row alone, with its degrees of freedom; the gain of all rows and the level.
    void lines_areGatheredByInput()
    {
        const MadeResults results;
        const auto errors = errorsOf(results.json());
        const auto noise = named(errors, "noise");
        QCOMPARE(noise.size(), std::size_t(52)); // magnitude and phase of 26 rows
        for (const ResponseError &error : noise) {
            QCOMPARE((error.atKnots.array().abs() > 0.0).count(), Index(1));
            QCOMPARE(error.dof, 30.0);
            QVERIFY(isNear(error.atKnots.norm(), 1e-3));
            QVERIFY(error.atKnots[0] == 0.0);
        }
        const auto gain = named(errors, "gain_relative");
        QCOMPARE(gain.size(), std::size_t(1));
        QVERIFY((gain[0].atKnots - Eigen::VectorXcd::Constant(27, 5e-3)).norm() < 1e-12);
        QVERIFY(std::isinf(gain[0].dof));
        const auto level = named(errors, "level_relative");
        QCOMPARE(level.size(), std::size_t(1));
        QVERIFY(isNear(level[0].atKnots[0].real(), 1e-4) && level[0].atKnots.tail(26).isZero(0.0));
    }

    /// A late onset turns all phases together, as a delay does.
    void onset_isADelayOfAllRows()
    {
        const MadeResults results;
        const auto onset = named(errorsOf(results.json()), "onset_s");
        QCOMPARE(onset.size(), std::size_t(1));
        const MeasuredRows rows = rowsOf(results.json());
        for (Index i = 0; i < 26; ++i) {
            QCOMPARE(onset[0].atKnots[i + 1].real(), 0.0);
            QVERIFY(
                isNear(onset[0].atKnots[i + 1].imag(), -1e-8 * 2.0 * M_PI * rows.frequency_Hz[i]));
        }
    }

    /// Lines of one name but of different shots are different inputs.
    void linesOfShots_areApart()
    {
        MadeResults results;
        Json root = results.json();
        const std::string row = "response.magnitude[3]";
        const double S = std::abs(rowsOf(root).S[3]);
        for (const int shot : {1, 2})
            root["budget"].push_back(results.line(row, "arrival_s[DUT]", S * 1e-3, nullptr, shot));
        setRow(root, 3, "u_magnitude", S * std::sqrt(1e-6 + 25e-6 + 2e-6));
        const auto arrivals = named(errorsOf(root), "arrival_s[DUT]");
        QCOMPARE(arrivals.size(), std::size_t(2));
        QVERIFY(isNear(arrivals[0].atKnots.norm(), 1e-3));
    }

    /// What a sensor of negative sensitivity has is relative to it, signs and all.
    void negativeSensitivity_givesTheSameRelativeErrors()
    {
        MadeResults results;
        results.sensor.S0 = -results.sensor.S0;
        const auto gain = named(errorsOf(results.json()), "gain_relative");
        QVERIFY((gain[0].atKnots - Eigen::VectorXcd::Constant(27, 5e-3)).norm() < 1e-12);
    }

    void errorsMakeTheStatedU()
    {
        const Json root = MadeResults().json();
        const MeasuredRows rows = rowsOf(root);
        Eigen::VectorXd magnitude = Eigen::VectorXd::Zero(27), phase = magnitude;
        for (const ResponseError &error : errorsOf(root)) {
            magnitude += error.atKnots.real().cwiseAbs2();
            phase += error.atKnots.imag().cwiseAbs2();
        }
        for (Index i = 0; i < 26; ++i) {
            QVERIFY(isNear(std::sqrt(magnitude[i + 1]) * std::abs(rows.S[i]), rows.u_magnitude[i]));
            QVERIFY(isNear(std::sqrt(phase[i + 1]), rows.u_phase_rad[i]));
        }
    }

    void missingBudget_isRefused()
    {
        Json root = MadeResults().json();
        root["budget"] = nullptr;
        const auto none = rowErrors(root["budget"], rowsOf(root), 2e-9);
        QVERIFY(!none && none.error().kind == ErrorKind::DataBlocked);
        QVERIFY(english(none.error().message).find("more than 200") != std::string::npos);
    }

    void budgetThatDoesNotMakeU_isRefused()
    {
        Json root = MadeResults().json();
        setRow(root, 7, "u_magnitude", 1e-12);
        const auto errors = rowErrors(root["budget"], rowsOf(root), 2e-9);
        QVERIFY(!errors && errors.error().kind == ErrorKind::Usage);
        QVERIFY(english(errors.error().message).find("5.012 kHz") != std::string::npos);
        root = MadeResults().json();
        root["budget"][3]["contribution"] = "much";
        QVERIFY(!rowErrors(root["budget"], rowsOf(root), 2e-9));
    }

    void uOfKnotsAlone_leavesOutWhatTheyShare()
    {
        const Json root = MadeResults().json();
        const Eigen::VectorXd u = uOfKnotsAlone(errorsOf(root), 27);
        QVERIFY(isNear(u[0], 1e-4));
        for (Index k = 1; k < 27; ++k)
            QVERIFY(isNear(u[k], 1e-3));
        QVERIFY(uOfKnotsAlone({}, 3).isZero(0.0));
    }
};

DYNCAL_TEST(TestResultsRows)
#include "tst_results_rows.moc"
