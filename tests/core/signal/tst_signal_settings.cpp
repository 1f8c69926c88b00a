// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/signal_settings.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestSignalSettings : public QObject
{
    Q_OBJECT

private slots:
    void treatmentNames_areThoseOfTheRecipe();
    void effectiveCombine_followsTreatment();
};

void TestSignalSettings::treatmentNames_areThoseOfTheRecipe()
{
    const std::vector<std::pair<ResponseTreatment, const char *>> names{
        {ResponseTreatment::StepDeflated, "step-deflated"},
        {ResponseTreatment::StepAsImpulse, "step-as-impulse"},
        {ResponseTreatment::Differenced, "differenced"}, {ResponseTreatment::Impulse, "impulse"}};
    for (const auto &[treatment, name] : names) {
        QCOMPARE(responseTreatmentName(treatment), name);
        QCOMPARE(isStepTreatment(treatment), std::string(name) != "impulse");
    }
}

void TestSignalSettings::effectiveCombine_followsTreatment()
{
    InputSettings settings;
    QVERIFY(settings.effectiveCombine() == CombineMethod::Stacked);
    settings.treatment = ResponseTreatment::StepAsImpulse;
    QVERIFY(settings.effectiveCombine() == CombineMethod::PcaAverage);
    settings.combine = CombineMethod::Stacked;
    QVERIFY(settings.effectiveCombine() == CombineMethod::Stacked);
}

DYNCAL_TEST(TestSignalSettings)
#include "tst_signal_settings.moc"
