// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/stages/certificate/dcc_remarks.h"

#include <QtTest>

using namespace dyncal;

/// What the rules of the DCC found, as sentences for the operator.
class TestDccRemarks : public QObject
{
    Q_OBJECT

private:
    static DccFinding found(const char *rule, const char *where, const char *text = "ZZ")
    {
        return {rule, where, text, {"A sentence of the rule.", {}}};
    }
    static std::vector<DccRemark> remarks(std::vector<DccFinding> findings)
    {
        return dccRemarks({"3.3.0", "draft", false, std::move(findings)});
    }
    static constexpr const char *kLaboratory
        = "administrativeData/calibrationLaboratory/contact/location/countryCode";
    static constexpr const char *kCustomer = "administrativeData/customer/location/countryCode";
    static constexpr const char *kCore = "administrativeData/coreData/countryCodeISO3166_1";

private slots:
    void place_hasTheFieldThatSettlesIt()
    {
        QCOMPARE(fieldOfFinding(found("country", kCore)), std::string("laboratory_country"));
        QCOMPARE(fieldOfFinding(found("country", kLaboratory)), std::string("laboratory_country"));
        QCOMPARE(fieldOfFinding(found("country", kCustomer)), std::string("customer_country"));
        for (const auto &[name, field] :
            {std::pair{"receiptDate", "date_received"}, {"beginPerformanceDate", "date_performed"},
                {"endPerformanceDate", "date_performed"}, {"issueDate", "date_issued"}})
            QCOMPARE(fieldOfFinding(found(
                         "date", (std::string("administrativeData/coreData/") + name).c_str())),
                std::string(field));
        QCOMPARE(fieldOfFinding(found("unit", kCustomer)), std::string());
        QCOMPARE(fieldOfFinding(found("country", "somewhere/else")), std::string());
    }

    void field_isOneRemark_howeverOftenItIsStated()
    {
        const auto all = remarks(
            {found("country", kCore), found("country", kLaboratory), found("country", kCustomer)});
        QCOMPARE(all.size(), std::size_t(2));
        QVERIFY(all[0].text.startsWith("Country of the laboratory: "));
        QVERIFY(all[1].text.startsWith("Country of the customer: "));
        QCOMPARE(all[1].field, std::string("customer_country"));
    }

    void otherRule_saysWhatIsNeeded_andWhatWasFound()
    {
        const auto all = remarks({found("release", "software[1]/release", "1.2"),
            found("usedMethods", "measurementResults/measurementResult[1]", ""),
            found("usedMethods", "measurementResults/measurementResult[2]", "")});
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].text, QString("A sentence of the rule. Found: 1.2."));
        QCOMPARE(all[1].text, QString("A sentence of the rule."));
        QVERIFY(all[0].field.empty());
        QVERIFY(remarks({}).empty());
    }

    void hostileText_isFitToShow()
    {
        for (const std::string &text : test::hostileTexts())
            for (const DccRemark &remark :
                remarks({{"unit", text, text, {"A sentence of the rule.", {}}}}))
                QVERIFY2(test::isFitToShow(remark.text.toStdString()), text.c_str());
    }

    void swedish_words()
    {
        const test::InSwedish swedish;
        const auto all = remarks({found("country", kCustomer)});
        QVERIFY2(all[0].text.startsWith("Kundens land: "), qPrintable(all[0].text));
    }
};

DYNCAL_TEST(TestDccRemarks)
#include "tst_dcc_remarks.moc"
