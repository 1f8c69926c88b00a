// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a quantity is by its name and refTypes, in three languages.

#include "core/dcc_reading/quantity_names.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestQuantityNames : public QObject
{
    Q_OBJECT

private slots:
    void namesAboutAValue_areKnown()
    {
        for (const char *name : {"Deviation from reference", "Measurement error", "U", "U (k=2)",
                 "u(phase)", "U95", "Expanded uncertainty", "Sensitivity (uncertainty)",
                 "nominal sensitivity", "Transverse sensitivity", "Cross-axis sensitivity",
                 "temperature coefficient", "Drift", "lower limit", "Reference value",
                 "relative change per pressure", "Messunsicherheit", "Erweiterte Unsicherheit U",
                 "Abweichung vom Nennwert", "Querempfindlichkeit", "\xC3\x84nderung", "Grenzwert",
                 "Temperaturkoeffizient", "M\xC3\xA4tos\xC3\xA4kerhet", "avvikelse",
                 "Tv\xC3\xA4rk\xC3\xA4nslighet", "\xC3\x84ndring", "gr\xC3\xA4nsv\xC3\xA4rde"})
            QVERIFY2(isAboutAValue(name, {}), name);
        for (const char *name :
            {"", "Sensitivity", "S", "Sensitivity (k = 2)", "Charge sensitivity",
                "Sensitivity with expanded uncertainty", "Sensitivity at nominal pressure",
                "Reference sensitivity", "Empfindlichkeit", "Empfindlichkeit mit Messunsicherheit",
                "Betrag", "K\xC3\xA4nslighet", "Phase", "Phasenverschiebung", "Static sensitivity",
                "Frequency response", "Magnitude for the reference value"})
            QVERIFY2(!isAboutAValue(name, {}), name);
    }

    void refTypes_goBeforeNames()
    {
        for (const char *type : {"basic_measurementError", "basic_nominalValue",
                 "basic_referenceValue", "basic_lowerLimit", "basic_expandedUncertainty"}) {
            QVERIFY2(isAboutAValue("Sensitivity", {"basic_measuredValue", type}), type);
            QVERIFY2(!isAboutAValue("Sensitivity", {"dyncal_magnitude", type}), type);
        }
        QVERIFY(!isAboutAValue("Sensitivity", {"basic_measuredValue"}));
        QVERIFY(isAboutAValue("Deviation", {"basic_measuredValue"}));
        QVERIFY(!isAboutAValue("Magnitude, uncertainty beside it", {"vib_magnitude"}));
    }

    void frequencies_mayBeNominal_butNoWidths()
    {
        QVERIFY(!isAboutAFrequency("Nominal frequency", {"basic_nominalValue"}));
        QVERIFY(!isAboutAFrequency("Frequency", {}) && !isAboutAFrequency("", {"x"}));
        for (const char *name :
            {"Resolution bandwidth", "Uncertainty of frequency", "Bandbreite"}) {
            QVERIFY2(isAboutAFrequency(name, {}), name);
            QVERIFY2(!isAboutAFrequency(name, {"basic_tableIndex0"}), name);
            QVERIFY2(!isAboutAFrequency(name, {"dyncal_frequency"}), name);
        }
        QVERIFY(isAboutAFrequency("Frequency", {"vib_frequency", "basic_measurementError"}));
    }

    void calledIs_whatItEndsWith()
    {
        const std::vector<std::string_view> words{"natural frequency", "eigenfrequenz"};
        for (const char *name :
            {"Natural frequency", "natural frequency of the sensor", "First natural frequency f0",
                "Eigenfrequenz", "Eigenfrequenz des Aufnehmers", "Natural frequency (k=2)",
                "Undamped natural frequency at 23 \xC2\xB0"
                "C"})
            QVERIFY2(isCalled(name, words), name);
        for (const char *name : {"", "Frequency", "Uncertainty of the natural frequency",
                 "Deviation of natural frequency", "Natural frequency (uncertainty)",
                 "highest frequency below a third of the natural frequency",
                 "Natural frequency, change", "Nominal natural frequency",
                 "Eigenfrequenz Abweichung", "Natural frequency region"})
            QVERIFY2(!isCalled(name, words), name);
    }

    void surroundings_areKnown()
    {
        QVERIFY(isOfSurroundings("Temperatur", {}) && isOfSurroundings("Relative humidity", {}));
        QVERIFY(isOfSurroundings("", {"basic_temperature"}) && !isOfSurroundings("Pressure", {}));
    }
};

DYNCAL_TEST(TestQuantityNames)
#include "tst_quantity_names.moc"
