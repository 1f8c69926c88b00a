// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a certificate says of oscillations and stretches that are not in the model.

#include "core/certificate/certificate_nuisance.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

const char *const kDash = "\xE2\x80\x93";

/// A mode of 10 kHz (|s|/2 pi) and damping ratio 0.01, `amplitude` of the plateau.
NuisanceOfShot modeOfShot(Index shot, double amplitude)
{
    NuisanceOfShot found;
    found.shot = shot;
    const double w = 2.0 * M_PI * 10e3;
    found.term.pole_rad_s = w * std::complex<double>(-0.01, std::sqrt(1.0 - 1e-4));
    found.u_frequency_Hz = 3.21;
    found.u_dampingRatio = 0.00034;
    found.relativeAmplitude = amplitude;
    return found;
}

SensorModel modelOf(double plateau)
{
    SensorModel model;
    model.plateauGain = plateau;
    NuisanceResult tube;
    tube.mode.reason = "seen in every shot";
    tube.perShot = {modeOfShot(1, 0.0312), modeOfShot(4, 0.5)};
    NuisanceResult named;
    named.mode.isTube = false;
    named.mode.label = "stand";
    named.perShot = {modeOfShot(2, 0.01)};
    model.nuisance = {tube, named};
    return model;
}

NuisanceEffect::Side sideOf(double residualRms, double plateau)
{
    NuisanceEffect::Side side;
    side.residualRms = residualRms;
    side.fit_percent = 87.654;
    side.f0_Hz = 30123.4;
    side.u_f0_Hz = 5.0;
    side.zeta = 0.05;
    side.u_zeta = 0.0002;
    side.plateauGain = plateau;
    return side;
}

CertificateSection sectionOf(const SensorModel &model)
{
    CertificateSection section;
    addNuisance(model, nullptr, "1", section); // not assessed
    return section;
}

CertificateSection sectionOf(
    const SensorModel &model, const NuisanceEffect &effect, const std::string &unit = "1")
{
    ModelAssessment assessment;
    assessment.nuisanceEffect = effect;
    CertificateSection section;
    addNuisance(model, &assessment, unit, section);
    return section;
}

std::string cellOf(const CertificateTable &table, std::size_t row, std::size_t column)
{
    return english(table.rows.at(row).at(column));
}

} // namespace

class TestCertificateNuisance : public QObject
{
    Q_OBJECT

private slots:
    void everyModeOfEveryShot_isARow()
    {
        const CertificateSection section = sectionOf(modelOf(1.0));
        QCOMPARE(section.tables.size(), std::size_t(1));
        const CertificateTable &table = section.tables[0];
        QCOMPARE(table.id, std::string("nuisance-modes"));
        QCOMPARE(table.rows.size(), std::size_t(3));
        for (const auto &row : table.rows)
            QCOMPARE(row.size(), table.columns.size());
        QCOMPARE(cellOf(table, 0, 0), std::string("gas in the tube"));
        QCOMPARE(cellOf(table, 1, 1), std::string("4"));
        // U = 2 x 3.21 Hz and 2 x 0.00034, each to two digits and the value to the same place.
        QCOMPARE(cellOf(table, 0, 2), std::string("10.0000 kHz \xC2\xB1 0.0064 kHz (k = 2)"));
        QCOMPARE(cellOf(table, 0, 3), std::string("0.01000 \xC2\xB1 0.00068 (k = 2)"));
        QCOMPARE(cellOf(table, 0, 4), std::string("3.12 %"));
        QCOMPARE(cellOf(table, 1, 4), std::string("50.0 %"));
        QCOMPARE(cellOf(table, 0, 5), std::string("seen in every shot"));
        QCOMPARE(cellOf(table, 2, 0), std::string("stand"));
        QCOMPARE(section.notes.size(), std::size_t(1));
    }

    void effect_residualIsOfThePlateauInWhateverUnit()
    {
        // The same calibration remapped to 0..1, in volts, and of a sensor that reads backwards.
        for (const double plateau : {1.0, 0.0523, -0.0523}) {
            const CertificateSection section = sectionOf(modelOf(plateau),
                {sideOf(0.04 * std::abs(plateau), plateau),
                    sideOf(0.0125 * std::abs(plateau), plateau)});
            QCOMPARE(section.tables.size(), std::size_t(2));
            const CertificateTable &table = section.tables[1];
            QCOMPARE(cellOf(table, 0, 0), std::string("left in"));
            QCOMPARE(cellOf(table, 0, 1), std::string("4.00 %"));
            QCOMPARE(cellOf(table, 1, 1), std::string("1.25 %"));
            QCOMPARE(cellOf(table, 1, 2), std::string("87.65 %"));
            QCOMPARE(cellOf(table, 1, 3), std::string("30.123 kHz \xC2\xB1 0.010 kHz (k = 2)"));
            QCOMPARE(cellOf(table, 1, 4), std::string("0.05000 \xC2\xB1 0.00040 (k = 2)"));
        }
    }

    void plateauGain_hasTheUnitOfTheResponses()
    {
        const NuisanceEffect effect{sideOf(0.001, 0.0523), sideOf(0.001, 0.0524)};
        const auto gainIn = [&](const std::string &unit, std::size_t row) {
            return cellOf(sectionOf(modelOf(0.0523), effect, unit).tables.at(1), row, 5);
        };
        QCOMPARE(gainIn("V", 0), std::string("52.3 mV"));
        QCOMPARE(gainIn("V", 1), std::string("52.4 mV"));
        QCOMPARE(gainIn("1", 0), std::string("0.0523")); // remapped: a pure number
        QCOMPARE(gainIn("", 0), std::string("0.0523")); // the recording states none
    }

    void freeDecay_hasNoPlateauToCompareWith()
    {
        const CertificateSection section
            = sectionOf(modelOf(0.0), {sideOf(0.04, 0.0), sideOf(0.01, 0.0)});
        for (const CertificateTable &table : section.tables) {
            for (const CertificateColumn &column : table.columns)
                QVERIFY(english(column.heading).find("lateau") == std::string::npos);
            for (const auto &row : table.rows)
                QCOMPARE(row.size(), table.columns.size());
        }
        QCOMPARE(cellOf(section.tables[0], 0, 4), std::string("seen in every shot"));
        QCOMPARE(cellOf(section.tables[1], 0, 1), std::string("87.65 %"));
    }

    void whatIsUnknown_isADash()
    {
        SensorModel model = modelOf(1.0);
        model.nuisance[0].perShot[0].u_frequency_Hz = kUnknown;
        model.nuisance[0].perShot[0].u_dampingRatio = kUnknown;
        const CertificateSection section = sectionOf(model, {{}, sideOf(0.01, 1.0)});
        QCOMPARE(cellOf(section.tables[0], 0, 2), std::string("10.0 kHz"));
        for (const std::size_t column : {1, 2, 3, 4, 5})
            QCOMPARE(cellOf(section.tables[1], 0, column), std::string(kDash));
        for (const CertificateTable &table : section.tables) {
            for (std::size_t r = 0; r < table.rows.size(); ++r) {
                for (std::size_t c = 0; c < table.columns.size(); ++c)
                    QVERIFY(cellOf(table, r, c).find("nan") == std::string::npos);
            }
        }
    }

    void nothingTakenOut_nothingIsSaid()
    {
        SensorModel model = modelOf(1.0);
        for (NuisanceResult &mode : model.nuisance)
            mode.perShot.clear(); // in the recipe, and found nowhere
        const CertificateSection section = sectionOf(model);
        QVERIFY(section.tables.empty() && section.notes.empty());
        CertificateSection other;
        addLeftOut({}, other);
        QVERIFY(other.tables.empty() && other.notes.empty());
    }

    void stretches_areListedWithTheirReasons()
    {
        ModelInput input;
        input.leftOut = {{2, 18e-6, 46.25e-6, "somebody knocked"}, {3, 0.0, 1e-3, "relay"}};
        CertificateSection section;
        addLeftOut(input, section);
        const CertificateTable &table = section.tables.at(0);
        QCOMPARE(table.rows.size(), std::size_t(2));
        QCOMPARE(cellOf(table, 0, 0), std::string("2"));
        QCOMPARE(cellOf(table, 0, 1), std::string("18 \xC2\xB5s"));
        QCOMPARE(cellOf(table, 0, 2), std::string("46.25 \xC2\xB5s"));
        QCOMPARE(cellOf(table, 0, 3), std::string("somebody knocked"));
        QCOMPARE(cellOf(table, 1, 1), std::string("0 s"));
        QCOMPARE(cellOf(table, 1, 2), std::string("1 ms"));
        QCOMPARE(section.notes.size(), std::size_t(1));
    }
};

DYNCAL_TEST(TestCertificateNuisance)
#include "tst_certificate_nuisance.moc"
