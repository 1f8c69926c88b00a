// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/gas_choice.h"
#include "core/shock/moist_air.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

/// What a capture and a recipe say.
struct Said
{
    ShockSettings settings;
    CaptureSet set;
    Environment around;

    std::vector<GasWay> ways() const { return waysToDrivenGas(settings, set, around); }
    GasWay used() const { return ways().front(); }
};

double soundSpeed_m_s(const GasWay &way, double p_Pa, double T_K)
{
    const GasModel gas
        = gasModel(way.settings, {p_Pa, T_K, way.humidity.value, kUsualCarbonDioxide}).value();
    return std::sqrt(
        gas.constants.gamma * kGasConstant_J_molK * T_K / gas.constants.molarMass_kg_mol);
}

} // namespace

class TestGasChoice : public QObject
{
    Q_OBJECT

private slots:
    void nothingKnown_isAirOfAnyHumidity()
    {
        const GasWay used = Said().used();
        QCOMPARE(used.source, GasSource::Assumed);
        QCOMPARE(used.settings.substance, std::string(kMoistAir));
        QCOMPARE(used.humidity.value, 0.5);
        QVERIFY(std::abs(used.humidity.u - 0.5 / std::sqrt(3.0)) < 1e-15);
        QCOMPARE(used.humidity.distribution, Distribution::Rectangular);
    }

    void ranks_recipeConstantsNameAssumed()
    {
        Said said;
        said.around.relativeHumidity = 0.4;
        QCOMPARE(said.used().source, GasSource::RecordedName);
        QCOMPARE(said.used().humidity.value, 0.4);
        said.set.tube["driven_gas"] = "Nitrogen";
        QCOMPARE(said.used().settings.substance, std::string("n2"));
        QCOMPARE(said.used().settings.gamma, 1.4);
        said.set.tube["gamma1"] = "1.5";
        QCOMPARE(said.used().source, GasSource::RecordedName); // half a pair is none
        said.set.tube["M1"] = "0.03";
        QCOMPARE(said.used().source, GasSource::RecordedConstants);
        QCOMPARE(said.used().settings.gamma, 1.5);
        said.settings.drivenGas = GasSettings();
        QCOMPARE(said.used().source, GasSource::Recipe);
        QCOMPARE(said.used().settings.substance, std::string("air"));
        QCOMPARE(said.ways().size(), std::size_t(3));
    }

    void recipeHumidity_winsOverTheRecordedOne()
    {
        Said said;
        said.around.relativeHumidity = 0.4;
        said.settings.relativeHumidity = 0.7;
        QCOMPARE(said.used().humidity.value, 0.7);
        QCOMPARE(said.used().humidity.distribution, Distribution::Normal);
    }

    void driver_followsItsOwnAttributes()
    {
        Said said;
        QCOMPARE(chosenDriverGas(said.settings, said.set), GasSettings());
        said.set.tube["driver_gas"] = "He";
        QCOMPARE(chosenDriverGas(said.settings, said.set).substance, std::string("he"));
        said.set.tube["gamma4"] = "1.66";
        said.set.tube["M4"] = "0.004";
        QCOMPARE(chosenDriverGas(said.settings, said.set).gamma, 1.66);
        said.settings.driverGas.substance = "n2";
        QCOMPARE(chosenDriverGas(said.settings, said.set).substance, std::string("n2"));
    }

    void words_areReadInAnyCase_othersAreNone()
    {
        QCOMPARE(recordedSubstance(" N2 "), std::string("n2"));
        QCOMPARE(recordedSubstance("ARGON"), std::string("ar"));
        QCOMPARE(recordedSubstance("carbon dioxide"), std::string("co2"));
        QVERIFY(recordedSubstance("mixture").empty());
        QVERIFY(recordedSubstance("").empty());
    }

    void anyState_isCramersInsideAndContinuousAtHisBorders()
    {
        const GasWay air = Said().used();
        const double inside = moistAir(95e3, 293.15, 0.5, kUsualCarbonDioxide)->soundSpeed_m_s;
        QVERIFY(std::abs(soundSpeed_m_s(air, 95e3, 293.15) / inside - 1.0) < 1e-12);
        for (const double p_Pa : {75e3, 102e3}) {
            const double step = soundSpeed_m_s(air, p_Pa * (1.0 + 1e-7), 293.15)
                / soundSpeed_m_s(air, p_Pa * (1.0 - 1e-7), 293.15);
            QVERIFY(std::abs(step - 1.0) < 1e-8);
        }
        for (const double T_K : {273.15, 303.15}) {
            const double step = soundSpeed_m_s(air, 1e5, T_K * (1.0 + 1e-7))
                / soundSpeed_m_s(air, 1e5, T_K * (1.0 - 1e-7));
            QVERIFY(std::abs(step - 1.0) < 1e-6);
        }
    }

    void farOutside_isNearTheIdealGas()
    {
        // Dry air at 20 kPa and 320 K: sqrt(gamma R T/M) with cp of N2, O2, Ar is 358.6 m/s.
        Said said;
        said.settings.relativeHumidity = 0.0;
        const double ideal = std::sqrt(1.3991 * kGasConstant_J_molK * 320.0 / 0.028966);
        QVERIFY(std::abs(soundSpeed_m_s(said.used(), 20e3, 320.0) / ideal - 1.0) < 1e-3);
    }

    void typedHumidity_isHeldAgainstTheRecordedOne()
    {
        const SectionState state{1e5, 294.15, 0.0, kUsualCarbonDioxide};
        Said said;
        said.around.relativeHumidity = 0.1;
        for (const double agrees : {0.1, 0.15, 0.2}) {
            said.settings.relativeHumidity = agrees;
            QVERIFY(!gasContradiction(said.ways(), state));
        }
        said.settings.relativeHumidity = 0.9;
        const auto humid = gasContradiction(said.ways(), state);
        QVERIFY(humid && humid->isHumidity && humid->isTypedHumidity);
        QCOMPARE(humid->other.humidity.value, 0.1);
        QVERIFY(humid->otherSpeed_m_s < humid->usedSpeed_m_s);
        said.set.tube["driven_gas"] = "n2"; // has none
        QVERIFY(!gasContradiction(said.ways(), state));
        said.set.tube.clear();
        said.around.relativeHumidity = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!gasContradiction(said.ways(), state));
    }

    void contradictions_areFoundAboveTheLimitOnly()
    {
        const SectionState state{1e5, 294.15, 0.0, kUsualCarbonDioxide};
        Said said;
        said.settings.drivenGas = GasSettings(); // dry air
        said.around.relativeHumidity = 0.0;
        QVERIFY(!gasContradiction(said.ways(), state)); // 0.03 %
        said.around.relativeHumidity = 0.5;
        const auto humid = gasContradiction(said.ways(), state);
        QVERIFY(humid && humid->isHumidity && humid->otherSpeed_m_s > humid->usedSpeed_m_s);
        said.set.tube["driven_gas"] = "n2";
        const auto other = gasContradiction(said.ways(), state);
        QVERIFY(other && !other->isHumidity);
        said.settings.drivenGas = recordedGas();
        QVERIFY(!gasContradiction(said.ways(), state)); // one way only
        said.set.tube["gamma1"] = "1.402";
        said.set.tube["M1"] = "0.028966";
        const auto constants = gasContradiction(said.ways(), state);
        QVERIFY(constants && constants->used.source == GasSource::RecordedConstants);
        QVERIFY(!constants->isHumidity);
    }

    void nonsense_isAnErrorOrAGas()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const GasSettings air = Said().used().settings;
        QVERIFY(!gasModel(air, {nan, 294.15, 0.5, 0.0}));
        QVERIFY(!gasModel(air, {1e5, nan, 0.5, 0.0}));
        for (const double T_K : {-5.0, 0.0, 1e9})
            (void)gasModel(air, {1e5, T_K, 0.5, 0.0}); // ends, whatever it says
    }
};

DYNCAL_TEST(TestGasChoice)
#include "tst_gas_choice.moc"
