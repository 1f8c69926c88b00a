// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_monte_carlo.h"
#include "tests/support/made_monte_carlo.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

using namespace dyncal;

namespace {

CalibrationResults with(const ChainMonteCarlo &drawn)
{
    CalibrationResults results;
    results.chainMonteCarlo = std::make_shared<const ChainMonteCarlo>(drawn);
    return results;
}

ResultQuantity quantity(const char *of, double value, double u, const char *unit)
{
    ResultQuantity one;
    one.label = {"%1", {of}};
    one.value = value;
    one.u = u;
    one.k = 2.0;
    one.unit = unit;
    one.of = of;
    return one;
}

} // namespace

class TestCertificateMonteCarlo : public QObject
{
    Q_OBJECT

private slots:
    /// Of five values three, of two rows both magnitudes.
    void count_isOfValuesAndRows()
    {
        const ValidatedCount count = testing::madeMonteCarlo().count();
        QCOMPARE(count.compared, Index(9));
        QCOMPARE(count.validated, Index(5));
    }

    void field_saysHowMany()
    {
        const auto field = monteCarloField(with(testing::madeMonteCarlo()));
        QVERIFY(field.has_value());
        QCOMPARE(field->id, std::string("monte_carlo"));
        QCOMPARE(
            english(field->label), std::string("Comparison of GUM and Monte Carlo (JCGM 101)"));
        QCOMPARE(english(field->value),
            std::string(
                "10000 trials: both agree for 5 of 9 values and rows; the draws of the model agree with 50 full refits"));
    }

    void refitsThatDisagree_areNotClaimed()
    {
        ChainMonteCarlo drawn = testing::madeMonteCarlo();
        drawn.refits.values[0].agrees = false;
        QCOMPARE(english(monteCarloField(with(drawn))->value),
            std::string("10000 trials: both agree for 5 of 9 values and rows"));
    }

    /// Only those that are stated and do not agree, a digit more than U has: the 5 %
    /// edge is 20000 Hz +- 580 Hz by trials.
    void results_thatDisagree_areListed()
    {
        const std::vector<ResultQuantity> stated{quantity("f0_hz", 1e5, 100.0, "Hz"),
            quantity("within_5_percent_hz", 2e4, 240.0, "Hz"),
            quantity("settling_time_s", 1e-5, 1e-8, "s"), quantity("q", 25.0, 0.1, "")};
        const auto table = monteCarloTable(with(testing::madeMonteCarlo()), stated);
        QVERIFY(table.has_value());
        QCOMPARE(english(table->caption),
            std::string(
                "Results whose interval of 95 % by Monte Carlo reaches beyond the one that U gives; it is the one to use"));
        QCOMPARE(table->rows.size(), std::size_t(1));
        QCOMPARE(english(table->rows[0][0]), std::string("within_5_percent_hz"));
        QCOMPARE(english(table->rows[0][1]), std::string("19.420 kHz"));
        QCOMPARE(english(table->rows[0][2]), std::string("20.580 kHz"));
    }

    /// Half of 1160 Hz by trials: U of 500 Hz does not hold it, of 600 Hz it does.
    void resultsThatAreStatedSafely_areNotListed()
    {
        const CalibrationResults drawn = with(testing::madeMonteCarlo());
        const auto listed = [&](double u_Hz, double value_Hz) {
            return monteCarloTable(drawn, {quantity("within_5_percent_hz", value_Hz, u_Hz, "Hz")})
                .has_value();
        };
        QVERIFY(listed(250.0, 2e4));
        QVERIFY(!listed(300.0, 2e4));
        QVERIFY(listed(300.0, 2e4 + 100.0)); // at one end
        QVERIFY(listed(300.0, 2e4 - 100.0));
    }

    void results_withoutU_areNotListed()
    {
        const std::vector<ResultQuantity> none{
            quantity("within_5_percent_hz", 2e4, kUnknown, "Hz")};
        QVERIFY(!monteCarloTable(with(testing::madeMonteCarlo()), none));
        QVERIFY(!monteCarloTable(with(testing::madeMonteCarlo()), {}));
        QVERIFY(!monteCarloTable({}, none));
    }

    /// A level goes by its own name, the magnitude at the resonance by its row.
    void levelsAndTheResonance_areFound()
    {
        ChainMonteCarlo drawn = testing::madeMonteCarlo();
        drawn.values[1].gum.validated = false;
        DrawnRow row;
        row.withMagnitude = true;
        row.magnitude = testing::drawnAround(2e-6, 3e-7);
        row.gumMagnitude.tolerance = 5e-9;
        drawn.rowsAtMarks = {DrawnRow(), row};
        CalibrationResults results = with(drawn);
        auto response = std::make_shared<ResponseResult>();
        auto marked = std::make_shared<ResponseResult>();
        marked->marks = {RowMark::LowEnd, RowMark::Resonance};
        response->atMarks = marked;
        results.response = response;
        ResultQuantity level = quantity("sensitivity", 5.1e-6, 4e-8, "V/Pa");
        level.drawnAs = "sensitivity.per_level[0]";
        const auto table = monteCarloTable(
            results, {level, quantity("magnitude_at_resonance", 2e-6, 1e-7, "V/Pa")});
        QVERIFY(table && table->rows.size() == 2);
        QCOMPARE(english(table->rows[0][1]), std::string("5.000 \xC2\xB5V/Pa"));
        QCOMPARE(english(table->rows[1][2]), std::string("2.300 \xC2\xB5V/Pa"));
    }

    void withoutAllTrials_thereIsNoField()
    {
        QVERIFY(!monteCarloField({}));
        QVERIFY(!monteCarloField(with({})));
    }
};

DYNCAL_TEST(TestCertificateMonteCarlo)
#include "tst_certificate_monte_carlo.moc"
