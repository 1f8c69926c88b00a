// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// By what it was measured: methods, equipment and conditions.

#include "core/base/version.h"
#include "core/dcc/dcc_measurement.h"
#include "core/results/method_versions.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/hostile_text.h"
#include "tests/support/made_monte_carlo.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::ExampleSource;
using testing::quantityPath;
using testing::ReadXml;

namespace {

/// The air of shots 1, 2 and 3.
ExampleSource inAir(std::array<double, 3> pressure_Pa)
{
    ExampleSource example;
    auto captures = std::make_shared<PreparedCaptures>(*example.results.captures);
    for (std::size_t i = 0; i < pressure_Pa.size(); ++i)
        captures->set.shots[i].environment.ambientPressure_Pa = pressure_Pa[i];
    example.results.captures = captures;
    return example;
}

ReadXml conditions(ExampleSource example)
{
    return ReadXml(dccConditions(example.source()));
}

ReadXml methods(ExampleSource example)
{
    return ReadXml(dccMethods(example.source()));
}

/// A budget of one u that is taken from a reference.
ExampleSource withReference(const std::string &certificate)
{
    ExampleSource example;
    example.recipe.uncertainty.budget = {{"p1_pa", 30.0}};
    example.recipe.uncertainty.budget.front().certificate = certificate;
    return example;
}

ReadXml equipment(ExampleSource example)
{
    return ReadXml(dccEquipment(example.source()));
}

} // namespace

class TestDccMeasurement : public QObject
{
    Q_OBJECT

private slots:
    void methods_areOfTheDcc()
    {
        const ReadXml xml = methods({});
        QCOMPARE(xml.texts("//dcc:usedMethod/@refType"),
            QStringList({"basic_calibrationMethod", "basic_uncertainty", "dyncal_methodVersions"}));
        QCOMPARE(xml.text("//dcc:usedMethod[1]/dcc:name/dcc:content"),
            QString("DPL-07, dynamic calibration by shock tube"));
        QCOMPARE(xml.text("//dcc:usedMethod[2]/dcc:norm"), QString("JCGM 100:2008"));
    }

    void monteCarlo_isAMethodWhereItWasUsed()
    {
        ExampleSource example;
        example.results.chainMonteCarlo
            = std::make_shared<ChainMonteCarlo>(testing::madeMonteCarlo());
        const std::string path = "//dcc:usedMethod[@refType='dyncal_monteCarlo']";
        QCOMPARE(methods(example).text(path + "/dcc:norm"), QString("JCGM 101:2008"));
        QVERIFY(methods(example)
                    .text(path + "/dcc:description/dcc:content")
                    .startsWith("10000 trials"));
    }

    /// Each stage with its version, in one order.
    void versions_areThoseOfTheStages()
    {
        const ReadXml xml = methods({});
        QStringList stages, versions;
        for (const auto &[stage, version] : methodVersions()) {
            stages << QString::fromStdString(stage);
            versions << QString::number(version);
        }
        QCOMPARE(xml.texts("//*[@refType='dyncal_stage']/dcc:noQuantity/dcc:content"), stages);
        QCOMPARE(xml.list("//*[@refType='dyncal_methodVersion']//si:valueXMLList"), versions);
    }

    void software_isThisRelease()
    {
        ExampleSource example;
        QCOMPARE(ReadXml(dccUsedSoftware(example.source())).text("//dcc:release"),
            QString::fromStdString(std::string("v") + versionText()));
    }

    /// Least and largest of the shots, 99.9 and 101.2 kPa, whatever their order.
    void severalReadings_areLeastAndLargest()
    {
        const ReadXml xml = conditions(inAir({101200.0, 99900.0, 100000.0}));
        const auto part = [&](const char *which, const char *name) {
            return xml.text(
                quantityPath(std::string("dyncal_ambientPressure basic_") + which, "/si:real/")
                + name);
        };
        QCOMPARE(part("minimum", "si:value").toDouble(), 99.9);
        QCOMPARE(part("minimum", "si:unit"), QString("\\kilo\\pascal"));
        QCOMPARE(part("maximum", "si:value").toDouble(), 101.2);
        QCOMPARE(part("maximum", "si:unit"), QString("\\kilo\\pascal"));
    }

    void oneReading_isAQuantity()
    {
        const ReadXml xml = conditions(inAir({1e5, 1e5, 1e5}));
        const std::string path = quantityPath("dyncal_ambientPressure", "/si:real/si:value");
        QCOMPARE(xml.text(path).toDouble(), 100.0);
        QCOMPARE(xml.count("//*[contains(@refType, 'basic_minimum')]"), 0);
    }

    void nothingRecorded_isSaid()
    {
        ExampleSource bare;
        bare.results = {};
        const ReadXml xml = conditions(bare);
        QCOMPARE(xml.count("//dcc:influenceCondition"), 3);
        QCOMPARE(xml.texts("//dcc:noQuantity/dcc:content"),
            QStringList({"not determined (not recorded)", "not determined (not recorded)",
                "not determined (not recorded)"}));
        QCOMPARE(xml.count("//dcc:influenceCondition[not(dcc:name) or not(dcc:data)]"), 0);
    }

    void noReference_isNoEquipment()
    {
        ExampleSource example;
        QVERIFY(dccEquipment(example.source()).name.empty());
    }

    void referenceOfTheBudget_isKnownByItsNumber()
    {
        const ReadXml xml = equipment(withReference(" K\n17 "));
        QCOMPARE(xml.text("//dcc:measuringEquipment/dcc:name/dcc:content"), QString("p1_pa"));
        QCOMPARE(xml.text("//dcc:identification/dcc:value"), QString("K 17"));
        QCOMPARE(xml.count("//dcc:certificate"), 0);
    }

    /// The file that a transducer's sensitivity is from is told by its hash.
    void transducer_hasItsCertificate()
    {
        ExampleSource example;
        const auto sensitivity = ReferenceSensitivity::fromModel({1e-5, 0.0, 1e6, 0.0, 0.1, 0.0});
        QVERIFY(sensitivity.has_value());
        ReferenceRecords records{*sensitivity};
        records.channel = "ref0";
        records.certificate = "R-5";
        records.sourceSha256 = std::string(64, 'c');
        auto reference = std::make_shared<ReferenceStageResult>();
        reference->records = records;
        example.results.reference = reference;
        const ReadXml xml = equipment(example);
        QCOMPARE(xml.text("//dcc:measuringEquipment/dcc:name/dcc:content"), QString("ref0"));
        QCOMPARE(xml.text("//dcc:certificate/dcc:referralID"), QString("R-5"));
        QCOMPARE(xml.text("//dcc:certificate/dcc:value"), QString(64, 'c'));
        QCOMPARE(xml.count("//dcc:identification"), 0);
    }

    void hostileNumber_isText()
    {
        for (const std::string &hostile : test::hostileTexts()) {
            const ReadXml xml = equipment(withReference(hostile));
            QVERIFY2(xml.isWellFormed(), hostile.c_str());
            QCOMPARE(xml.count("//dcc:measuringEquipment"), 1);
            QVERIFY2(test::isFitToShow(xml.text("//dcc:identification/dcc:value").toStdString()),
                hostile.c_str());
        }
    }
};

DYNCAL_TEST(TestDccMeasurement)
#include "tst_dcc_measurement.moc"
