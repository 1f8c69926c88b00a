// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/fit_residual.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <complex>

using namespace dyncal;

class TestFitResidual : public QObject
{
    Q_OBJECT

private slots:
    /// Against its definition, with a nuisance term and a stretch left out.
    void residual_isWhatTheFitLeaves()
    {
        const double rate_Hz = 1e6;
        const std::complex<double> s(-2e4, 3e5);
        const std::complex<double> c(0.3, -0.2);
        ExponentialSum sum{1.5, Eigen::VectorXcd(2), Eigen::VectorXcd(2)};
        sum.poles_rad_s << s, std::conj(s);
        sum.amplitudes << c, std::conj(c);
        const NuisanceTerm term{0, false, {-1e3, 5e4}, {0.05, 0.02}};
        RefinementRecord record;
        record.rate_Hz = rate_Hz;
        record.y = Eigen::VectorXd::LinSpaced(1000, 0.0, 1.0);
        record.used = {{0, 100}, {400, 1000}};
        const Eigen::VectorXd residual = fitResidual(record, sum, {term});
        QCOMPARE(residual.size(), Index(700));
        for (Index i = 0; i < residual.size(); ++i) {
            const Index k = i < 100 ? i : i + 300;
            const double t_s = static_cast<double>(k) / rate_Hz;
            const double model = 1.5 + 2.0 * (c * std::exp(s * t_s)).real()
                + (term.amplitude * std::exp(term.pole_rad_s * t_s)).real();
            QVERIFY(std::abs(residual[i] - (record.y[k] - model)) < 1e-12);
        }
    }

    void withoutStretches_allSamplesCount()
    {
        RefinementRecord record;
        record.rate_Hz = 1e6;
        record.y = Eigen::VectorXd::Ones(10);
        QCOMPARE(usedRanges(record).size(), std::size_t(1));
        QCOMPARE(fitResidual(record, {1.0, {}, {}}, {}).size(), Index(10));
        QCOMPARE(fitResidual(record, {1.0, {}, {}}, {}).norm(), 0.0);
    }
};

DYNCAL_TEST(TestFitResidual)
#include "tst_fit_residual.moc"
