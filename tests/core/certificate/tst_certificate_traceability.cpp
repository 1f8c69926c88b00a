// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a certificate says of profile, chain and the references of the budget.

#include "core/certificate/certificate_traceability.h"
#include "core/certificate/required_fields.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

const CertificateField *fieldOf(const std::vector<CertificateField> &fields, const std::string &id)
{
    const auto found = std::ranges::find(fields, id, &CertificateField::id);
    return found == fields.end() ? nullptr : &*found;
}

std::string textOf(const CertificateField *field)
{
    return field ? english(field->value) : "";
}

Recipe recipe()
{
    Recipe made;
    made.profile = {"Tube 2", "7", "abc", R"({"shock":{"driven_length_m":0.97}})"};
    made.shock.drivenLength_m = 0.97;
    made.uncertainty.budget = {{"t1_k", 0.3, "normal", {}, "T-0815", "2026-05-31"}, {"p1_pa", 9.0}};
    return made;
}

} // namespace

class TestCertificateTraceability : public QObject
{
    Q_OBJECT

private slots:
    void nothing_saysNothing() { QVERIFY(traceabilityFields({}, {}).empty()); }

    void profile_isNamedWithItsVersion()
    {
        Recipe made = recipe();
        QCOMPARE(textOf(fieldOf(traceabilityFields({}, made), "profile")),
            "Tube 2, version 7 (SHA-256 abc)");
        QVERIFY(!fieldOf(traceabilityFields({}, made), "profile_changed"));
        made.shock.drivenLength_m = 1.0;
        QCOMPARE(textOf(fieldOf(traceabilityFields({}, made), "profile_changed")),
            "shock.driven_length_m");
    }

    void chain_isNamedByItsFile()
    {
        auto stage = std::make_shared<ReferenceStageResult>();
        stage->chain = {ReferenceSensitivity::fromTable({{1e3, 1.0, 0.0}}).value(), "beef", {}};
        CalibrationResults results;
        results.reference = stage;
        QVERIFY(!fieldOf(traceabilityFields(results, {}), "chain")); // nothing was divided
        auto response = std::make_shared<ResponseResult>();
        response->magnitude = Eigen::VectorXd::Ones(1);
        results.response = response;
        const auto fields = traceabilityFields(results, {});
        QVERIFY(textOf(fieldOf(fields, "chain")).find("beef") != std::string::npos);
    }

    void capability_isListed()
    {
        Recipe made;
        made.uncertainty.cmc = {{"sensitivity", 0.015}, {"phase_rad", 0.02}, {"f0_hz", 50.0, false},
            {"magnitude", 0.025, true, 1e3, 1e5}, {"magnitude", 0.05, true, 1e5}};
        const auto fields = traceabilityFields({}, made);
        QCOMPARE(QString::fromStdString(textOf(fieldOf(fields, "cmc"))),
            QString::fromUtf8("sensitivity 1.5 %, phase_rad 0.02 rad, f0_hz 50, magnitude 2.5 % "
                              "(1 kHz ... 100 kHz), magnitude 5 % (100 kHz ... )"));
    }

    void reference_thatEndedBeforeTheMeasurement_isMissing_data()
    {
        QTest::addColumn<QByteArray>("day");
        QTest::addColumn<bool>("isOver");
        QTest::newRow("before") << QByteArray("2026-05-30") << false;
        QTest::newRow("last day") << QByteArray(" 2026-05-31 ") << false;
        QTest::newRow("after") << QByteArray(" 2026-06-01") << true;
        QTest::newRow("no day") << QByteArray("banana") << false;
        QTest::newRow("none") << QByteArray() << false;
    }
    void reference_thatEndedBeforeTheMeasurement_isMissing()
    {
        QFETCH(QByteArray, day);
        QFETCH(bool, isOver);
        Recipe made = recipe();
        made.certificate.fields["date_performed"] = day.toStdString();
        const auto fields = traceabilityFields({}, made);
        const CertificateField *field = fieldOf(fields, "reference_t1_k");
        QVERIFY(textOf(field).find("T-0815") != std::string::npos);
        QCOMPARE(field->missing, isOver);
        QVERIFY(!fieldOf(fields, "reference_p1_pa"));
        made.uncertainty.budget[0].certificate.clear(); // a day alone counts too
        QCOMPARE(fieldOf(traceabilityFields({}, made), "reference_t1_k")->missing, isOver);
        QCOMPARE(fieldOf(unfilledFields({}, made), "reference_t1_k") != nullptr, isOver);
    }
};

DYNCAL_TEST(TestCertificateTraceability)
#include "tst_certificate_traceability.moc"
