// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/gas_names.h"
#include "core/shock/gas_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace dyncal;

namespace {

constexpr double kGasConstant = 8.314462618; ///< J/(mol K), CODATA 2018

const GasSettings *named(const std::string &name)
{
    for (const auto &[word, gas] : namedGases()) {
        if (word == name)
            return &gas;
    }
    return nullptr;
}

} // namespace

class TestGasNames : public QObject
{
    Q_OBJECT

private slots:
    void everyName_isOneSubstanceThatTheModelKnows()
    {
        std::set<std::string> seen;
        const SectionState room{101325.0, 293.15, 0.5, 4e-4};
        for (const auto &[name, gas] : namedGases()) {
            QVERIFY2(seen.insert(name).second, name.c_str());
            QCOMPARE(gas.substance, name);
            const auto model = gasModel(gas, room);
            QVERIFY2(model.has_value(), name.c_str());
            QVERIFY(model->constants.gamma > 1.0 && model->constants.molarMass_kg_mol > 0.0);
        }
        for (const char *name : {"air", "n2", "he", "ar", "co2", "humid-air"})
            QVERIFY2(named(name) != nullptr, name);
        QCOMPARE(namedGases().size(), std::size_t(6));
    }

    void constants_areThoseOfTheTables_data()
    {
        // Molar masses: IUPAC 2021 standard atomic weights (N 14.007, He 4.0026, Ar 39.95,
        // C 12.011, O 15.999), dry air: ISO 2533 and thesis table 4.1. Speed of sound at 0 degC and
        // one atmosphere: CRC Handbook of Chemistry and Physics, section 14 (m/s).
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("molarMass_g");
        QTest::addColumn<double>("sound_m_s");
        QTest::newRow("air") << "air" << 28.966 << 331.45;
        QTest::newRow("nitrogen") << "n2" << 28.014 << 337.0;
        QTest::newRow("helium") << "he" << 4.0026 << 973.0;
        QTest::newRow("argon") << "ar" << 39.948 << 307.8;
        QTest::newRow("carbon dioxide") << "co2" << 44.009 << 258.0;
    }
    void constants_areThoseOfTheTables()
    {
        QFETCH(QString, name);
        QFETCH(double, molarMass_g);
        QFETCH(double, sound_m_s);
        const GasSettings &gas = *named(name.toStdString());
        QVERIFY(std::abs(gas.molarMass_kg_mol * 1e3 / molarMass_g - 1.0) < 2e-4);
        const double sound = std::sqrt(gas.gamma * kGasConstant * 273.15 / gas.molarMass_kg_mol);
        // gamma at room temperature, ideal gas: half a percent; carbon dioxide vibrates, two.
        const double tolerance = name == "co2" ? 0.02 : 0.005;
        QVERIFY2(std::abs(sound / sound_m_s - 1.0) < tolerance,
            qPrintable(QString("%1 m/s").arg(sound)));
    }

    void monatomicGases_haveFiveThirds()
    {
        for (const char *name : {"he", "ar"})
            QVERIFY(std::abs(named(name)->gamma - 5.0 / 3.0) < 0.005);
    }

    void typicalAir_isTheThesis()
    {
        QCOMPARE(named("air")->gamma, 1.402);
        QCOMPARE(*named("air"), GasSettings{}); // the recipe's default is the named gas
    }
};

DYNCAL_TEST(TestGasNames)
#include "tst_gas_names.moc"
