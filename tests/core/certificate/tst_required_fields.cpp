// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/calendar_date.h"
#include "core/certificate/certificate.h"
#include "core/certificate/required_fields.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

Recipe filled(const std::string &date)
{
    Recipe recipe;
    for (const CertificateField &field : unfilledFields({}, {}))
        recipe.certificate.fields[field.id] = field.id.starts_with("date_") ? date : "given";
    return recipe;
}

} // namespace

class TestRequiredFields : public QObject
{
    Q_OBJECT

private slots:
    void dates_data();
    void dates();
    void date_thatIsNone_isNotFilledIn();
    void unfilled_areThoseThatThePageNames();
};

void TestRequiredFields::dates_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isDate");
    for (const char *text : {"2026-01-31", "2024-02-29", " 2026-12-01 ", "2000-02-29"})
        QTest::newRow(text) << text << true;
    for (const char *text : {"banana", "2026-02-30", "2026-02-29", "1900-02-29", "2026-13-01",
             "2026-00-10", "2026-01-00", "2026-1-31", "31/12/2026", "2026-01-31T12:00", "20260131",
             "2026-01-3x", "2026/01/31", "", " ", "-026-01-31", "yesterday 2026-01-31"})
        QTest::newRow(text) << text << false;
}

void TestRequiredFields::dates()
{
    QFETCH(QString, text);
    QFETCH(bool, isDate);
    QCOMPARE(isCalendarDate(text.toStdString()), isDate);
}

void TestRequiredFields::date_thatIsNone_isNotFilledIn()
{
    QVERIFY(unfilledFields({}, filled("2026-01-31")).empty());
    const std::vector<CertificateField> unfilled = unfilledFields({}, filled("banana"));
    QCOMPARE(unfilled.size(), std::size_t(3));
    for (const CertificateField &field : unfilled) {
        QVERIFY(field.wrong && field.missing);
        QCOMPARE(english(field.value), std::string("banana (not a date; write it as 2026-01-31)"));
    }
    QVERIFY(!unfilledFields({}, {}).front().wrong); // an empty one is no wrong one
}

void TestRequiredFields::unfilled_areThoseThatThePageNames()
{
    for (const Recipe &recipe : {Recipe(), filled("2026-01-31"), filled("2026-02-30")}) {
        std::vector<Message> labels;
        for (const CertificateField &field : unfilledFields({}, recipe))
            labels.push_back(field.label);
        QVERIFY(labels == makeCertificate({}, recipe, {}).missingFields());
    }
}

DYNCAL_TEST(TestRequiredFields)
#include "tst_required_fields.moc"
