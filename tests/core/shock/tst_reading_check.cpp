// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/reading_check.h"
#include "tests/support/test_program.h"

#include "core/capture/channel_units.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kStep_Pa = 5.0e5; ///< 72.5 psi, 5 bar

/// What the window stage hands over of a shot that was recorded in `unit`.
WindowedResponse responseOf(const std::string &unit, double recorded)
{
    WindowedResponse response;
    response.shot = 1;
    response.channel = "DUT";
    const auto si = siUnitOf(unit);
    response.unit = si ? si->unit : unit;
    response.recordedUnit = si && si->unit != unit ? unit : std::string();
    response.step = recorded * (si ? si->factor : 1.0);
    return response;
}

ShockConditionsSet shockOf(std::optional<double> step_Pa)
{
    ShockConditions conditions;
    conditions.shot = 1;
    conditions.step_Pa = step_Pa;
    return {{conditions}, {}, {}};
}

} // namespace

class TestReadingCheck : public QObject
{
    Q_OBJECT

private slots:
    void reading_isHeldAgainstTheStep_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("step");
        QTest::addColumn<QString>("says"); ///< empty = nothing
        QTest::newRow("psi right") << "psi" << 72.5 << "";
        QTest::newRow("psi called bar")
            << "bar" << 72.5 << "reads 72.5 bar; 500 kPa is expected. Is the unit psi?";
        QTest::newRow("bar called psi") << "psi" << 5.0 << "reads 5 psi";
        QTest::newRow("psi called Pa") << "Pa" << 72.5 << "Is the unit psi?";
        QTest::newRow("MPa called Pa") << "Pa" << 0.5 << "Is the unit MPa?";
        QTest::newRow("negative") << "bar" << -72.5 << "Is the unit psi?";
        QTest::newRow("within a factor of 3") << "bar" << 14.9 << "";
        QTest::newRow("no unit fits") << "bar" << 19.0 << "Check the unit";
        QTest::newRow("no pressure") << "V" << 72.5 << "";
        QTest::newRow("no pressure, converted") << "mV" << 72.5 << "";
    }

    void reading_isHeldAgainstTheStep()
    {
        QFETCH(QString, unit);
        QFETCH(double, step);
        QFETCH(QString, says);
        const Findings findings
            = checkReadings({responseOf(unit.toStdString(), step)}, shockOf(kStep_Pa), {});
        QCOMPARE(findings.size(), std::size_t(says.isEmpty() ? 0 : 1));
        if (says.isEmpty())
            return;
        QCOMPARE(findings[0].id, std::string("CAP-013"));
        QCOMPARE(findings[0].severity, Severity::Caution);
        QCOMPARE(findings[0].shot, Index(1));
        const QString text = QString::fromStdString(english(findings[0].message));
        QVERIFY2(text.contains(says), qPrintable(text));
    }

    void factor_isALimit()
    {
        CheckSettings checks;
        checks.readingFactor = 2.5;
        QCOMPARE(checkReadings({responseOf("bar", 14.0)}, shockOf(kStep_Pa), checks).size(),
            std::size_t(1));
    }

    void unknownStep_saysNothing()
    {
        QVERIFY(checkReadings({responseOf("bar", 72.5)}, shockOf({}), {}).empty());
        QVERIFY(checkReadings({responseOf("bar", 72.5)}, {}, {}).empty());
    }
};

DYNCAL_TEST(TestReadingCheck)
#include "tst_reading_check.moc"
