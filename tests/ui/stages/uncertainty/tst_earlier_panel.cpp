// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An earlier result laid over S(f), by the controls of the page, over the example's real results.

#include "core/base/number_text.h"
#include "core/results/results_json.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/made_dcc.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/uncertainty/uncertainty_page.h"

#include <QLabel>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using Bench = test::PageBench<test::ScriptedPage<UncertaintyPage>>;

class TestEarlierPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;
    testing::ScratchFolder m_scratch;

    QString note() const { return m_bench->control<QLabel>("earlierNote")->text(); }
    const PlotContent &drawn() const
    {
        return m_bench->control<PlotWidget>("uncertaintyPlot")->content();
    }
    bool isDrawn(const QString &name) const
    {
        return std::ranges::any_of(
            drawn().curves, [&](const PlotCurve &one) { return one.name == name; });
    }
    void layOver(const std::string &path) const
    {
        test::scripted().setNextFile(QString::fromStdString(path));
        const QString before = note();
        m_bench->press("earlierChoose");
        QTRY_VERIFY(note() != before);
    }
    /// Results with the page's own rows, all of them times `factor`.
    std::string written(double factor, const std::string &unit) const
    {
        const ResponseResult &response = *m_bench->session.resultsOnShow().response;
        testing::EarlierJson root = testing::earlierResults();
        root["recipe"]["certificate"]["fields"]
            = {{"sensor_serial", "4711"}, {"date_performed", "2024-05-06"}};
        testing::EarlierJson &rows = root["response"];
        rows = {{"u_contains_step", true}, {"unit", unit}};
        for (Index row = 0; row < response.magnitude.size(); ++row) {
            rows["frequency_hz"].push_back(response.frequency_Hz[row]);
            rows["magnitude"].push_back(factor * response.magnitude[row]);
            rows["u_magnitude"].push_back(0.01 * response.magnitude[row]);
            rows["k_magnitude"].push_back(2.0);
        }
        return testing::put(m_scratch, "earlier.json", root.dump());
    }

    /// The page's own rows times `factor` in the unit, and something that is not understood.
    std::string certificate(const std::string &unit, double factor) const
    {
        const ResponseResult &response = *m_bench->session.resultsOnShow().response;
        std::string f_Hz, magnitude, U;
        for (Index row = 0; row < response.magnitude.size(); ++row) {
            if (!std::isfinite(response.magnitude[row]))
                continue;
            f_Hz += exactNumber(response.frequency_Hz[row]) + ' ';
            magnitude += exactNumber(factor * response.magnitude[row]) + ' ';
            U += exactNumber(0.02 * factor * response.magnitude[row]) + ' ';
        }
        // By its name it is none of the response, so the response is read all the same.
        const std::string unknown = testing::dccMarked(
            testing::dccQuantity("1", "\\furlong"), "", "Deviation of the place");
        return testing::dccOf(testing::dccList(testing::dccQuantity(f_Hz, "\\hertz")
            + testing::dccQuantity(magnitude, unit, U) + unknown));
    }

private slots:
    void initTestCase()
    {
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
    }
    void cleanup()
    {
        if (m_bench->isEnabled("earlierRemove"))
            m_bench->press("earlierRemove");
    }

    void agreeing_isDrawnAndSaid()
    {
        const int steps = m_bench->steps();
        const auto curves = drawn().curves.size();
        const std::string unit = m_bench->session.resultsOnShow().response->unit;
        layOver(written(1.001, unit));
        QVERIFY2(note().startsWith("Sensor 4711, 2024-05-06: "), qPrintable(note()));
        QVERIFY(isDrawn("Sensor 4711, 2024-05-06"));
        QCOMPARE(drawn().curves.size(), curves + 2);
        QCOMPARE(m_bench->steps(), steps); // it is only looked at
        m_bench->press("earlierRemove");
        QCOMPARE(drawn().curves.size(), curves);
        QVERIFY(!m_bench->isEnabled("earlierRemove"));
    }

    void differing_isSaidByItsE_n()
    {
        layOver(written(2.0, m_bench->session.resultsOnShow().response->unit));
        QVERIFY2(note().contains(": 0 of "), qPrintable(note()));
    }

    void otherUnit_isNotDrawn()
    {
        layOver(written(1.0, "m/s2"));
        QVERIFY2(note().contains("in m/s2"), qPrintable(note()));
        QVERIFY(!isDrawn("Sensor 4711, 2024-05-06"));
    }

    /// A certificate in another prefix: drawn in the page's unit; what it has besides is named.
    void certificate_isDrawn_andItsRestNamed()
    {
        const std::string curve = certificate("\\kilo\\volt\\pascal\\tothe{-1}", 1.001e-3);
        layOver(testing::put(m_scratch, "dcc.xml", curve));
        QVERIFY2(note().startsWith("Sensor 4711, 2025-03-04: "), qPrintable(note()));
        QVERIFY(note().contains("rows agree within U"));
        QVERIFY2(note().contains("Not taken from the certificate:\nLine "), qPrintable(note()));
        QVERIFY(isDrawn("Sensor 4711, 2025-03-04"));
    }

    void certificateOfAForceSensor_isNotDrawn()
    {
        layOver(
            testing::put(m_scratch, "force.xml", certificate("\\volt\\newton\\tothe{-1}", 1.0)));
        QVERIFY2(note().contains("in V/N"), qPrintable(note()));
        QVERIFY(!isDrawn("Sensor 4711, 2025-03-04"));
    }

    void damagedCertificate_isSaid()
    {
        layOver(testing::put(m_scratch, "cut.xml", "<dcc:digitalCalibrationCertificate>"));
        QVERIFY2(note().contains("malformed"), qPrintable(note()));
        QVERIFY(!m_bench->isEnabled("earlierRemove"));
    }

    void whatIsNone_isSaid()
    {
        layOver(testing::put(m_scratch, "none.json", "[]"));
        QVERIFY2(note().endsWith('.') && note().contains("none.json"), qPrintable(note()));
        QVERIFY(!m_bench->isEnabled("earlierRemove"));
    }
};

DYNCAL_TEST(TestEarlierPanel)
#include "tst_earlier_panel.moc"
