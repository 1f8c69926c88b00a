// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/model_input_page.h"
#include "ui/stages/order/order_page.h"

#include <QFormLayout>
#include <QLabel>

using namespace dyncal;

namespace {

/// A sensor with damping 0.7: its step response does not ring, its spectrum has no peak.
std::shared_ptr<const CaptureSet> wellDamped()
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic1").value();
    settings.sampleRate_Hz = 10e6;
    settings.duration_s = 0.006;
    settings.noise = 0.01;
    settings.seed = 1;
    auto set = std::make_shared<CaptureSet>(simulateShots(settings).value().set);
    set->inputs = {{"optic1", "optic1", "0123", "simulated"}};
    return set;
}

} // namespace

/// A sensor without a resonance has a natural frequency all the same: no page calls that a
/// resonance.
class TestNoResonance : public QObject
{
    Q_OBJECT

private slots:
    void pages_sayTheSame();
};

void TestNoResonance::pages_sayTheSame()
{
    const auto set = wellDamped();
    test::PageBench<ModelInputPage> input(set);
    QVERIFY(input.session.results().spectrum->resonances.empty());
    QVERIFY2(input.control<QLabel>("samplesPerPeriod")->text().contains("no resonance"),
        qPrintable(input.control<QLabel>("samplesPerPeriod")->text()));
    test::PageBench<OrderPage> order(set);
    QTRY_VERIFY(order.session.results().model);
    auto *readout = order.control<QLabel>("resonanceReadout");
    QVERIFY2(readout->text().endsWith("no resonance"), qPrintable(readout->text()));
    const auto *form = qobject_cast<QFormLayout *>(readout->parentWidget()->layout());
    QCOMPARE(
        qobject_cast<QLabel *>(form->labelForField(readout))->text(), QString("Natural frequency"));
}

DYNCAL_TEST(TestNoResonance)
#include "tst_no_resonance.moc"
