// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Constructed truth: records that went through a known amplifier, and the table of its response,
// give S(f) of the records that did not.

#include "core/base/constants.h"
#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/pipeline/pipeline.h"
#include "core/uncertainty/budgets.h"
#include "tests/support/near.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kRate_Hz = 2e7;
constexpr double kCorner_Hz = 4e6;

double feedback()
{
    return std::exp(-kTwoPi * kCorner_Hz / kRate_Hz);
}

/// y[n] = a y[n-1] + (1 - a) x[n], begun at rest on the first sample.
Eigen::VectorXd amplified(const Eigen::VectorXd &x)
{
    Eigen::VectorXd y = x;
    for (Index n = 1; n < x.size(); ++n)
        y[n] = feedback() * y[n - 1] + (1.0 - feedback()) * x[n];
    return y;
}

std::complex<double> responseAt(double f_Hz)
{
    return (1.0 - feedback()) / (1.0 - feedback() * std::polar(1.0, -kTwoPi * f_Hz / kRate_Hz));
}

/// Close enough that straight lines between its rows add nothing.
std::string table()
{
    std::string text = "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad\n";
    for (int k = 0; k <= 4000; ++k) {
        const double f_Hz = 100.0 * std::pow(8e4, k / 4000.0);
        const std::complex<double> H = responseAt(f_Hz);
        text += exactNumber(f_Hz) + "," + exactNumber(std::abs(H)) + ",0.001,"
            + exactNumber(std::arg(H)) + ",0.002\n";
    }
    return text;
}

std::shared_ptr<const CaptureSet> throughAmplifier(const CaptureSet &set)
{
    auto changed = std::make_shared<CaptureSet>(set);
    for (Shot &shot : changed->shots)
        for (Channel &channel : shot.channels) {
            if (channel.role != ChannelRole::Dut)
                continue;
            const Eigen::VectorXd y = amplified(physicalValues(channel, 0, channel.samples.size()));
            channel.samples = RawSamples(std::vector<double>(y.begin(), y.end()));
            channel.polynomial = {0.0, 1.0};
            channel.polarity = channel.userScale = 1.0;
        }
    return changed;
}

} // namespace

class TestChainTable : public QObject
{
    Q_OBJECT

private:
    CalibrationResults m_direct, m_corrected;
    Recipe m_recipe;

    static CalibrationResults run(std::shared_ptr<const CaptureSet> set, const Recipe &recipe)
    {
        ResultCache cache;
        return runPipeline(std::move(set), recipe, cache, StageId::Comparison).results;
    }

private slots:
    void initTestCase()
    {
        const auto set = testing::simulatedExample(kRate_Hz);
        const std::string content = table();
        m_recipe.realization.order.value = 3; // the sensor's two poles and the amplifier's
        m_recipe.chain.source = "amp.csv";
        m_recipe.chain.loaded
            = std::make_shared<const ReferenceSource>(ReferenceSource{sha256Hex(content), content});
        m_direct = run(set, {});
        m_corrected = run(throughAmplifier(*set), m_recipe);
        QVERIFY(m_corrected.uncertainty && m_direct.uncertainty);
    }

    /// The amplifier's delay moves the onset that is found, within what the phase's u allows for.
    void rows_areThoseWithoutTheAmplifier()
    {
        const ResponseResult &a = *m_direct.response, &b = *m_corrected.response;
        Index rows = 0;
        double largest = 0.0, turn = 0.0;
        for (Index i = 0; i < a.frequency_Hz.size(); ++i) {
            const double f_Hz = a.frequency_Hz[i];
            if (f_Hz > 2e6 || !std::isfinite(a.magnitude[i]))
                continue;
            const auto found = std::ranges::find_if(
                b.frequency_Hz, [&](double other) { return isNear(other, f_Hz, 1e-9); });
            QVERIFY(found != b.frequency_Hz.end());
            const Index k = found - b.frequency_Hz.begin();
            largest = std::max(largest, std::abs(b.magnitude[k] / a.magnitude[i] - 1.0));
            const double u = m_corrected.uncertainty->rows.u_phase_rad[k];
            QVERIFY(std::isfinite(u));
            turn = std::max(turn, std::abs(b.phase_rad[k] - a.phase_rad[i]) / u);
            ++rows;
        }
        qInfo("%d rows: %.2g of the magnitude, phase %.2g u", int(rows), largest, turn);
        QVERIFY(rows > 20);
        QVERIFY(largest < 2e-3);
        QVERIFY(turn < 2.0);
    }

    void uncorrected_theyAreNot()
    {
        const CalibrationResults raw
            = run(throughAmplifier(*testing::simulatedExample(kRate_Hz)), {});
        const ResponseResult &a = *m_direct.response, &b = *raw.response;
        const Index row = Index(std::ranges::find_if(a.frequency_Hz, [](double f_Hz) {
            return f_Hz > 1.9e6;
        }) - a.frequency_Hz.begin());
        QVERIFY(isNear(b.frequency_Hz[row], a.frequency_Hz[row]));
        QVERIFY(std::abs(b.magnitude[row] / a.magnitude[row] - 1.0) > 0.05);
    }

    void tableHasItsLines()
    {
        const UncertaintyReport &report = *m_corrected.uncertainty;
        const auto isChain
            = [](const UncertaintyLine &line) { return line.quantity == kChainResponse; };
        QVERIFY(std::ranges::any_of(report.sensitivity->lines,
            [](const UncertaintyLine &line) { return line.quantity == kChainLevel; }));
        const ResponseResult &response = *m_corrected.response;
        for (const Budget &budget : allBudgets(report, response)) {
            if (budget.kind != BudgetOf::Magnitude || !budget.reported.u)
                continue;
            QCOMPARE(std::ranges::count_if(budget.reported.lines, isChain), 1);
            const auto line = std::ranges::find_if(budget.reported.lines, isChain);
            const double H = std::abs(responseAt(budget.frequency_Hz));
            QVERIFY(isNear(line->contribution, budget.reported.value * 0.001 / H, 1e-4));
        }
    }

    void faultOfTheFile_stopsTheResponse()
    {
        Recipe recipe = m_recipe;
        recipe.chain.loaded.reset();
        const CalibrationResults none = run(testing::simulatedExample(kRate_Hz), recipe);
        QVERIFY(!none.response && none.model);
    }
};

DYNCAL_TEST(TestChainTable)
#include "tst_chain_table.moc"
