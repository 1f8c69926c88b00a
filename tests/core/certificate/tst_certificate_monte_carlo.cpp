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
        QCOMPARE(english(field->label), std::string("GUM validated by Monte Carlo (JCGM 101)"));
        QCOMPARE(english(field->value),
            std::string(
                "10000 trials: 5 of 9 values and rows; the draws of the model agree with 50 full refits"));
    }

    void refitsThatDisagree_areNotClaimed()
    {
        ChainMonteCarlo drawn = testing::madeMonteCarlo();
        drawn.refits.values[0].agrees = false;
        QCOMPARE(english(monteCarloField(with(drawn))->value),
            std::string("10000 trials: 5 of 9 values and rows"));
    }

    void withoutAllTrials_thereIsNoField()
    {
        QVERIFY(!monteCarloField({}));
        QVERIFY(!monteCarloField(with({})));
    }
};

DYNCAL_TEST(TestCertificateMonteCarlo)
#include "tst_certificate_monte_carlo.moc"
