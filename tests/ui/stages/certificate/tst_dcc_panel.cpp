// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/report/certificate_dcc.h"
#include "ui/stages/certificate/certificate_page.h"
#include "ui/stages/certificate/dcc_panel.h"
#include "ui/stages/certificate/dcc_remarks.h"

#include <QtTest>

using namespace dyncal;

namespace {

using Bench = test::PageBench<test::DatedPage<CertificatePage>>;

QString noteOf(Bench &bench)
{
    return bench.control<QLabel>("dccNote")->text();
}

void waitChecked(Bench &bench)
{
    const auto *panel = bench.page.findChild<DccPanel *>();
    QTRY_VERIFY_WITH_TIMEOUT(panel->isCurrent(), 30000);
}

bool isOffered(Bench &bench, const char *field)
{
    return bench.control<QPushButton>(QString("dccGoTo_%1").arg(field))->isVisible();
}

/// What a draft of the example would miss.
std::vector<DccRemark> remarksOf(const std::map<std::string, std::string> &fields)
{
    Recipe recipe;
    recipe.certificate.fields = fields;
    const Result<DccCheck> check
        = draftDccCheck(example::calibration(), recipe, "2026-05-04T12:00:00Z", {});
    return check ? dccRemarks(*check) : std::vector<DccRemark>{{"no DCC", ""}};
}

} // namespace

/// What a reader of the DCC would miss, beside the certificate's form.
class TestDccPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void draftOfEverything_missesOnlyWhatWasLeftOut()
    {
        auto fields = example::certificateFields();
        fields["laboratory_country"] = "SE";
        fields["customer_country"] = "DE";
        QVERIFY(remarksOf(fields).empty());
        fields.erase("customer_country");
        fields["customer_address"] = "2 Test Street";
        const auto remarks = remarksOf(fields);
        QCOMPARE(remarks.size(), std::size_t(1));
        QCOMPARE(remarks.front().field, std::string("customer_country"));
    }

    void countries_areAskedFor_untilTheyAreTyped()
    {
        Bench bench;
        waitChecked(bench);
        QVERIFY2(noteOf(bench).contains("▲ Country of the laboratory"), qPrintable(noteOf(bench)));
        QVERIFY(isOffered(bench, "laboratory_country") && isOffered(bench, "customer_country"));
        bench.type("field_laboratory_country", "SE");
        QVERIFY(!bench.isEnabled("dccNote")); // of something older
        waitChecked(bench);
        QVERIFY(bench.isEnabled("dccNote"));
        QVERIFY(!noteOf(bench).contains("laboratory"));
        QVERIFY(!isOffered(bench, "laboratory_country") && isOffered(bench, "customer_country"));
        bench.type("field_customer_country", "DE");
        waitChecked(bench);
        QVERIFY2(noteOf(bench).startsWith("● Nothing"), qPrintable(noteOf(bench)));
        QVERIFY(!isOffered(bench, "customer_country"));
        bench.session.undoStack().undo();
        waitChecked(bench);
        QVERIFY(isOffered(bench, "customer_country"));
    }

    void button_leadsToItsField()
    {
        Bench bench;
        waitChecked(bench);
        bench.page.activateWindow();
        bench.control<QPushButton>("dccGoTo_customer_country")->click();
        QCOMPARE(bench.page.focusWidget(), bench.control<QLineEdit>("field_customer_country"));
    }

    void countryThatIsNone_isSaidBesideItsField()
    {
        Bench bench;
        const auto *note = bench.control<QLabel>("note_customer_country");
        QVERIFY(!note->isVisible()); // it need not be there
        for (const char *none : {"Sweden", "se", "ZZ"}) {
            bench.type("field_customer_country", none);
            QVERIFY2(note->isVisible(), none);
        }
        bench.type("field_customer_country", "SE");
        QVERIFY(!note->isVisible());
    }

    void swedish_words()
    {
        const test::InSwedish swedish;
        Bench bench;
        waitChecked(bench);
        QVERIFY2(noteOf(bench).contains("▲ Laboratoriets land"), qPrintable(noteOf(bench)));
    }
};

DYNCAL_TEST(TestDccPanel)
#include "tst_dcc_panel.moc"
