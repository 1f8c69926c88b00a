// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"

using namespace dyncal;
using namespace dyncal::test;

/// A sensor that reads pressures in psi under another unit's name. The sensor card that would say
/// so comes with the certificate.
class TestUnits : public QObject
{
    Q_OBJECT

private slots:
    void s14_psiUnderTheNameBar_isProposedAndTaken();
    void s14_gaugeOrAbsolute_isOneChoice();
};

void TestUnits::s14_psiUnderTheNameBar_isProposedAndTaken()
{
    const ScenarioBench bench;
    const SimulatedCapture simulated = simulateShots(threeShots({{DefectKind::Psi, 0}})).value();
    bench.open({bench.write(simulated.set, "psi.h5")});
    DYNCAL_SAYS(bench.finding("CAP-013"), "Is the unit psi?");
    bench.clickOffer("correction", "CAP-013", "The unit is psi");
    QVERIFY2(bench.finding("CAP-013").isEmpty(), qPrintable(bench.finding("CAP-013")));
    bench.show(Page::Captures);
    QCOMPARE(bench.find<QLineEdit>("dutUnit")->text(), QString("psi"));
    // 1 psi = 6.894757 kPa: what the sensor reads is the pressure that the shock makes.
    bench.show(Page::Shock);
    for (int row = 0; row < 3; ++row) {
        const double sensitivity
            = number(bench.find<QTableWidget>("sensitivityTable")->item(row, 1)->text());
        QVERIFY2(std::abs(sensitivity - 1.0) < 0.02, qPrintable(QString::number(sensitivity)));
    }
    bench.undo();
    DYNCAL_SAYS(bench.finding("CAP-013"), "Is the unit psi?");
}

void TestUnits::s14_gaugeOrAbsolute_isOneChoice()
{
    const ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::Psi, 0}}))});
    bench.show(Page::Captures);
    bench.choose("dutReference", 1);
    QCOMPARE(bench.recipe().import.reference, std::string("gauge"));
    QCOMPARE(bench.session().undoStack().count(), 1);
}

DYNCAL_TEST(TestUnits)
#include "tst_units.moc"
