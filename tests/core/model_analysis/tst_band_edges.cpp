// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Band edges from a search that leaps over what cannot leave the band, against one that looks at
// every point of the same grid: to the last bit.

#include "core/base/constants.h"
#include "core/model_analysis/band_edges.h"
#include "core/model_analysis/bisection.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/unwrapped_phase.h"
#include "tests/support/cascade_model.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <numbers>

using namespace dyncal;
using testing::cascadeModel;
using testing::Gaussian;
using testing::modelOfPoles;
using Complex = std::complex<double>;
using Outside = std::function<double(double)>;

namespace {

constexpr ResponseTreatment kStep = ResponseTreatment::StepDeflated;

double ratioOf(const SensorModel &model, double f_Hz)
{
    return std::abs(modelResponse(model, kStep, f_Hz) / model.plateauGain);
}

std::vector<double> wholeGrid(const SensorModel &model)
{
    double slowest = 1e300;
    double fastest = 0.0;
    for (const Pole &pole : model.poles) {
        slowest = std::min(slowest, std::abs(pole.s_rad_s));
        fastest = std::max(fastest, std::abs(pole.s_rad_s));
    }
    const double from_Hz = 1e-3 * slowest / kTwoPi;
    const double to_Hz = 20.0 * fastest / kTwoPi;
    const int steps = static_cast<int>(std::ceil(std::log10(to_Hz / from_Hz) * 400));
    std::vector<double> grid = resonantFrequencies_Hz(model, from_Hz, to_Hz);
    for (int i = 0; i <= steps; ++i)
        grid.push_back(from_Hz * std::pow(to_Hz / from_Hz, static_cast<double>(i) / steps));
    std::ranges::sort(grid);
    return grid;
}

std::optional<double> firstOutside(
    const SensorModel &model, const std::vector<double> &grid, const Outside &outside)
{
    for (std::size_t i = 1; i < grid.size(); ++i)
        if (outside(ratioOf(model, grid[i])) > 0.0)
            return bisect(
                [&](double f_Hz) { return outside(ratioOf(model, f_Hz)); }, grid[i - 1], grid[i]);
    return std::nullopt;
}

StepCharacteristics byEveryPoint(const SensorModel &model)
{
    const std::vector<double> grid = wholeGrid(model);
    const auto first = [&](const Outside &outside) { return firstOutside(model, grid, outside); };
    StepCharacteristics result;
    result.within5percent_Hz = first([](double r) { return std::abs(r - 1.0) - 0.05; });
    result.within10percent_Hz = first([](double r) { return std::abs(r - 1.0) - 0.10; });
    result.minus3dB_Hz = first([](double r) { return std::numbers::sqrt2 / 2.0 - r; });
    return result;
}

StepCharacteristics byLeaps(const SensorModel &model)
{
    StepCharacteristics result;
    describeBands(model, kStep, result);
    return result;
}

void verifySame(const SensorModel &model)
{
    const StepCharacteristics found = byLeaps(model);
    const StepCharacteristics expected = byEveryPoint(model);
    QCOMPARE(found.within5percent_Hz, expected.within5percent_Hz);
    QCOMPARE(found.within10percent_Hz, expected.within10percent_Hz);
    QCOMPARE(found.minus3dB_Hz, expected.minus3dB_Hz);
}

/// A sensor and modes beside it from strong to hardly there, some of them very narrow.
SensorModel randomModel(Gaussian &random)
{
    const auto logUniform
        = [&](double from, double to) { return from * std::pow(to / from, random.uniform()); };
    const auto modes = static_cast<int>(1.0 + 3.0 * random.uniform());
    std::vector<std::pair<double, double>> all;
    for (int i = 0; i < modes; ++i)
        all.emplace_back(logUniform(1e3, 1e6), logUniform(1e-4, 0.95));
    SensorModel model = cascadeModel(all);
    for (Index i = 0; i + 1 < model.order; i += 2) {
        const double factor = logUniform(1e-3, 1.0);
        model.amplitudes.segment(i, 2) *= i == 0 ? 1.0 : factor;
    }
    return model;
}

} // namespace

class TestBandEdges : public QObject
{
    Q_OBJECT

private slots:
    void everySecondOrderSensor_isThatOfEveryPoint()
    {
        for (const double zeta : {1e-4, 1e-3, 0.01, 0.02, 0.1, 0.3, 0.6, 0.65, 0.7072, 0.8, 0.99})
            verifySame(cascadeModel({{3.18e5, zeta}}));
    }
    void lags_areThoseOfEveryPoint()
    {
        verifySame(modelOfPoles({-2e5}));
        verifySame(modelOfPoles({-1e5, -4e5, -9e5}));
        verifySame(modelOfPoles({-1e5, -1.001e5})); // amplitudes of a thousand
    }
    void modesOfEverySize_areThoseOfEveryPoint()
    {
        Gaussian random(20261);
        for (int trial = 0; trial < 400; ++trial) {
            verifySame(randomModel(random));
            if (QTest::currentTestFailed())
                QFAIL(qPrintable(QString("trial %1").arg(trial)));
        }
    }
    void nonsense_ends()
    {
        SensorModel broken = cascadeModel({{3.18e5, 0.02}});
        broken.amplitudes[0] = std::nan("");
        const StepCharacteristics found = byLeaps(broken);
        QVERIFY(!found.within5percent_Hz && !found.within10percent_Hz && !found.minus3dB_Hz);
    }
};

DYNCAL_TEST(TestBandEdges)
#include "tst_band_edges.moc"
