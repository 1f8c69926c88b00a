// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/earlier_response.h"
#include "tests/core/history/made_history.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

/// S(f) of earlier results, and how it agrees with another.
class TestEarlierResponse : public QObject
{
    Q_OBJECT

private slots:
    void rows_areThoseOfTheResults()
    {
        const EarlierResponse response
            = earlierResponse(madeCalibration({.day = "2025-03-01"}, "a.json")).value();
        QCOMPARE(response.file + ' ' + response.serial + ' ' + response.time,
            std::string("a.json 17 2025-03-01"));
        QCOMPARE(response.unit, std::string("V/Pa"));
        QCOMPARE(response.rows.size(), std::size_t(3));
        QCOMPARE(response.rows[1].frequency_Hz, 1e4);
        QCOMPARE(response.rows[1].magnitude, 5.1e-6);
        QCOMPARE(response.rows[1].U, 2.0 * 5e-8);
        QCOMPARE(response.rows[2].U, 2.5 * 6e-8); // Student's
    }

    void withheldRows_areLeftOut_andIncompleteUIsNone()
    {
        EarlierCalibration one = madeCalibration({.day = "2025-03-01"});
        one.results["response"]["magnitude"][0] = nullptr;
        one.results["response"]["u_magnitude"][1] = nullptr;
        const EarlierResponse response = earlierResponse(one).value();
        QCOMPARE(response.rows.size(), std::size_t(2));
        QVERIFY(std::isnan(response.rows[0].U));
        one.results["response"]["u_contains_step"] = false; // noise alone
        QVERIFY(std::isnan(earlierResponse(one)->rows[1].U));
    }

    void none_isRefused()
    {
        EarlierCalibration one = madeCalibration({.day = "2025-03-01"}, "a.json");
        for (const EarlierJson &odd : {EarlierJson(), EarlierJson(7), EarlierJson::array(),
                 EarlierJson({{"frequency_hz", "many"}}),
                 EarlierJson({{"frequency_hz", {1.0, 2.0}}, {"magnitude", {1.0}}, {"unit", 3}})}) {
            one.results["response"] = odd;
            const auto response = earlierResponse(one);
            QVERIFY(odd.is_object() || !response);
            if (!response)
                QVERIFY(english(response.error().message).find("a.json") != std::string::npos);
        }
    }

    void file_isRead()
    {
        const ScratchFolder scratch;
        const std::string path
            = put(scratch, "run/results.json", madeResults({.day = "2025-03-01"}).dump());
        QCOMPARE(readEarlierResponse(path)->rows.size(), std::size_t(3));
        QVERIFY(!readEarlierResponse(scratch.file("none.json")));
        QVERIFY(!readEarlierResponse(put(scratch, "other.json", "[]")));
    }

    /// E_n = (5.1 - 5.0)/sqrt(0.1^2 + 0.1^2) at 10 Hz: 0.707; at 100 Hz 5 times that.
    void agreement_isByE_n()
    {
        const std::vector<ResponseRow> present{
            {10.0, 5.1, 0.1}, {100.0, 5.5, 0.1}, {1e3, 5.0, 0.1}, {2e3, 5.0, kUnknown}},
            earlier{{1e3, 5.0, 0.1}, {10.0 * (1.0 + 1e-9), 5.0, 0.1}, {100.0, 5.0, 0.1},
                {2e3, 5.0, 0.1}, {3e3, 9.0, 0.1}};
        const ResponseAgreement agreement = agreementOf(present, earlier);
        QCOMPARE(agreement.compared, Index(3));
        QCOMPARE(agreement.agreeing, Index(2));
        QVERIFY(std::abs(agreement.largestEn - 0.5 / std::sqrt(0.02)) < 1e-12);
        QCOMPARE(agreement.at_Hz, 100.0);
        const ResponseAgreement back = agreementOf(earlier, present);
        QCOMPARE(back.compared, Index(3));
        QVERIFY(std::abs(back.largestEn + agreement.largestEn) < 1e-12);
    }

    void nothingInCommon_comparesNothing()
    {
        const ResponseAgreement none = agreementOf({{10.0, 5.0, 0.1}}, {{11.0, 5.0, 0.1}});
        QCOMPARE(none.compared, Index(0));
        QVERIFY(std::isnan(none.largestEn));
        QCOMPARE(agreementOf({}, {}).agreeing, Index(0));
    }
};

DYNCAL_TEST(TestEarlierResponse)
#include "tst_earlier_response.moc"
