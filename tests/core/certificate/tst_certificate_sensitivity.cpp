// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a certificate states as sensitivity, from results that are written down: one mean, or a
// value for each level where the shots do not agree, and never a number without its u.

#include "core/certificate/certificate_sensitivity.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::writable;

namespace {

ReportedValue reported(double value, std::optional<double> u, double k = 2.0)
{
    ReportedValue made;
    made.value = value;
    made.u = u;
    made.k = k;
    if (!u)
        made.missing = {"T1 has no u", {}};
    return made;
}

/// Three shots, one at each level, whose mean is 2e-6 V/Pa with u of 1 %.
CalibrationResults threeLevels(bool agree)
{
    CalibrationResults results;
    ResponseResult &response = writable(results.response);
    response.sensitivity = 2e-6;
    response.sensitivityUnit = "V/Pa";
    response.summary.shotsAgree = agree;
    UncertaintyReport &report = writable(results.uncertainty);
    report.sensitivity = reported(2e-6, 2e-8);
    for (const auto &[level, value] : {std::pair(ShotLevel::Low, 1.8e-6),
             {ShotLevel::Medium, 2.0e-6}, {ShotLevel::High, 2.2e-6}}) {
        ShotSensitivity shot;
        shot.shot = std::ssize(response.shots) + 2; // 2, 3, 4: the first is left out
        shot.sensitivity = value;
        shot.unit = "V/Pa";
        shot.step_Pa = 1e5;
        response.shots.push_back(shot);
        SensitivityMean mean;
        mean.level = level;
        mean.value = value;
        response.summary.perLevel.push_back(mean);
        report.perLevel.push_back(reported(value, 0.01 * value));
        report.ofShots.push_back(reported(value, 0.02 * value));
    }
    return results;
}

std::vector<std::string> labelsOf(const std::vector<ResultQuantity> &quantities)
{
    std::vector<std::string> labels;
    for (const ResultQuantity &one : quantities)
        labels.push_back(english(one.label));
    return labels;
}

std::string fieldsOf(const CalibrationResults &results)
{
    CertificateSection section;
    addSensitivityDetails(results, section);
    std::string text;
    for (const Message &one : section.paragraphs)
        text += english(one) + "\n";
    for (const CertificateField &field : section.fields)
        text += english(field.label) + ": " + english(field.value) + "\n";
    return text;
}

} // namespace

class TestCertificateSensitivity : public QObject
{
    Q_OBJECT

private slots:
    void shotsThatAgree_haveOneMean()
    {
        const auto quantities = sensitivityQuantities(threeLevels(true));
        QCOMPARE(labelsOf(quantities),
            (std::vector<std::string>{"Sensitivity at the onset of the step, mean of the shots"}));
        QCOMPARE(quantities[0].value, 2e-6);
        QCOMPARE(quantities[0].u, 2e-8);
        QCOMPARE(quantities[0].unit, std::string("V/Pa"));
        QVERIFY(quantities[0].isResult());
        QVERIFY(fieldsOf(threeLevels(true)).empty());
    }

    /// Each level with its own value and u, and no mean beside them.
    void shotsThatDisagree_haveAValueForEachLevel()
    {
        const auto quantities = sensitivityQuantities(threeLevels(false));
        QCOMPARE(quantities.size(), std::size_t(3));
        const char *words[]{"low level", "medium level", "high level"};
        const double values[]{1.8e-6, 2.0e-6, 2.2e-6};
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(english(quantities[i].label).ends_with(words[i]));
            QCOMPARE(quantities[i].value, values[i]);
            QVERIFY(std::abs(quantities[i].u - 0.01 * values[i]) < 1e-15);
        }
        QVERIFY(fieldsOf(threeLevels(false)).find("no mean of all shots") != std::string::npos);
    }

    /// With one level there is nothing to tell apart: the mean stands, and says what it is.
    void disagreeingShotsOfOneLevel_haveAMeanThatSaysSo()
    {
        CalibrationResults results = threeLevels(false);
        writable(results.response).summary.perLevel.resize(1);
        const auto quantities = sensitivityQuantities(results);
        QCOMPARE(quantities.size(), std::size_t(1));
        QVERIFY(english(quantities[0].label).ends_with("which do not agree"));
    }

    /// The CMC comes along, so that it holds in print too.
    void capability_comesAlong()
    {
        CalibrationResults results = threeLevels(true);
        writable(results.uncertainty).sensitivity->leastExpanded = 5e-8;
        writable(results.uncertainty).sensitivity->k = 4.3;
        const ResultQuantity one = sensitivityQuantities(results).front();
        QCOMPARE(one.leastExpanded, 5e-8);
        QCOMPARE(one.k, 4.3);
    }

    /// Which of the two is missing, the pressure step or the level.
    void notDetermined_saysWhatIsMissing()
    {
        QCOMPARE(english(sensitivityQuantities({})[0].otherwise),
            std::string("not determined (no pressure step)"));
        for (const double none : {kUnknown, std::numeric_limits<double>::infinity()}) {
            CalibrationResults results = threeLevels(true);
            writable(results.response).sensitivity = none;
            const ResultQuantity one = sensitivityQuantities(results).front();
            QVERIFY(!one.isResult());
            QCOMPARE(english(one.otherwise), std::string("not determined (no level at the onset)"));
        }
    }

    void oneShot_isNoMean()
    {
        CalibrationResults results = threeLevels(true);
        writable(results.response).shots.resize(1);
        QCOMPARE(labelsOf(sensitivityQuantities(results)),
            (std::vector<std::string>{"Sensitivity at the onset of the step"}));
    }

    /// 1e-8 of the sensitivity for each pascal is 1 % for each megapascal.
    void trend_isPercentForEachMegapascal()
    {
        CalibrationResults results = threeLevels(true);
        SensitivitySummary &summary = writable(results.response).summary;
        summary.linearity_per_Pa = -1e-8;
        QVERIFY(fieldsOf(results).empty()); // without its u it is not stated
        summary.uLinearity_per_Pa = 2e-9;
        const std::string said = fieldsOf(results);
        QVERIFY2(said.find("-1.00 %/MPa \u00b1 0.40 %/MPa (k = 2)") != said.npos, said.c_str());
    }

    void drift_isSaidForEachShot()
    {
        CalibrationResults results = threeLevels(true);
        ShotDrift drift;
        drift.shot = 3;
        drift.relative = -0.012;
        drift.u = 0.001;
        drift.at_s = 2.5e-3;
        writable(results.response).drift.shots = {drift, drift};
        const std::string said = fieldsOf(results);
        QVERIFY2(said.find("Drift of shot 3") != said.npos, said.c_str());
        QVERIFY2(said.find("-1.20 % \u00b1 0.20 % (k = 2)") != said.npos, said.c_str());
        QVERIFY2(said.find("2.5 ms") != said.npos, said.c_str());
    }

    /// By its number, not by its place.
    void shot_isFoundByItsNumber()
    {
        const CalibrationResults results = threeLevels(true);
        const auto textOf = [&](Index shot) { return english(shotSensitivityText(results, shot)); };
        QVERIFY2(
            textOf(2).starts_with("1.800") && textOf(4).starts_with("2.200"), textOf(2).c_str());
        QVERIFY(textOf(2).find("\u00b1 0.072") != std::string::npos);
        QCOMPARE(textOf(1), std::string("not determined"));
        QCOMPARE(textOf(5), std::string("not determined"));
        QCOMPARE(english(shotSensitivityText({}, 1)), std::string("not determined"));
    }

    void shotWithoutU_hasThreeDigits()
    {
        CalibrationResults results = threeLevels(true);
        results.uncertainty.reset();
        writable(results.response).shots[0].sensitivity = 1.23456e-6;
        const std::string said = english(shotSensitivityText(results, 2));
        QVERIFY2(said.find("1.23") != said.npos && said.find("1.234") == said.npos, said.c_str());
        writable(results.response).shots[0].sensitivity.reset();
        QCOMPARE(english(shotSensitivityText(results, 2)), std::string("not determined"));
    }
};

DYNCAL_TEST(TestCertificateSensitivity)
#include "tst_certificate_sensitivity.moc"
