// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/correction_filter.h"
#include "core/signal/fft.h"
#include "tests/support/measured_data.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <sstream>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 500e6;
constexpr double kBandOfTable_Hz[]{1e6, 60e6}; ///< that the published results take from the table

/// Numbers of one column of a file with columns split by `separator`.
Eigen::VectorXd columnOf(const std::filesystem::path &file, std::size_t column, char separator)
{
    std::ifstream stream(file);
    std::vector<double> values;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream cells(line);
        std::string cell;
        for (std::size_t i = 0; i <= column; ++i)
            std::getline(cells, cell, separator);
        std::erase_if(cell, [](char c) { return c == ' ' || c == '\r'; });
        if (const auto number = parseNumber(cell))
            values.push_back(*number);
    }
    return Eigen::Map<Eigen::VectorXd>(values.data(), std::ssize(values));
}

/// The phase that belongs to magnitudes on the grid k rate/n of a response without zeros in the
/// right half plane (Bode's equation, as the transform of the logarithm).
Eigen::VectorXd bodePhase(const Eigen::VectorXd &magnitude)
{
    const Index n = 2 * (magnitude.size() - 1);
    const RealFft fft(n);
    Eigen::VectorXd cepstrum = fft.inverse(
        Eigen::VectorXcd(magnitude.array().log().matrix().cast<std::complex<double>>()));
    cepstrum.segment(1, n / 2 - 1) *= 2.0;
    cepstrum.tail(n / 2 - 1).setZero();
    return fft.forward(cepstrum).imag();
}

/// The table's magnitudes within its band, held beyond, with Bode's phase; a knot each 0.1 MHz.
KnownResponse hydrophone(const std::filesystem::path &table)
{
    const Eigen::VectorXd frequency_Hz = 1e6 * columnOf(table, 0, ',');
    const Eigen::VectorXd magnitude = columnOf(table, 7, ',');
    const double step_Hz = 0.1e6;
    const Eigen::VectorXd grid_Hz = Eigen::VectorXd::LinSpaced(2501, 0.0, 0.5 * kRate_Hz);
    Eigen::VectorXd onGrid(grid_Hz.size());
    for (Index i = 0; i < grid_Hz.size(); ++i) {
        const double at_Hz = std::clamp(grid_Hz[i], kBandOfTable_Hz[0], kBandOfTable_Hz[1]);
        onGrid[i] = magnitude[static_cast<Index>(std::lround(at_Hz / step_Hz)) - 1];
    }
    const Eigen::VectorXd phase_rad = bodePhase(onGrid);
    KnownResponse response;
    response.knot_Hz = grid_Hz.segment(1, 2499);
    response.atKnots.resize(2499);
    for (Index i = 0; i < 2499; ++i)
        response.atKnots[i] = std::polar(onGrid[i + 1], phase_rad[i + 1]);
    response.validTo_Hz = 0.5 * kRate_Hz;
    response.unit = "V/Pa";
    return response;
}

} // namespace

/// A tutorial on the deconvolution of hydrophone signals publishes the pulse of a diagnostic
/// ultrasound machine as recorded and as corrected: an independent implementation on real data.
class TestHydrophonePulses : public QObject
{
    Q_OBJECT

private slots:
    void pulse_isThePublishedOne()
    {
        const auto folder = dataFolder() / "ptb_hydrophone";
        if (!std::filesystem::exists(folder))
            DYNCAL_SKIP_WITHOUT_DATA("pulses of hydrophones");
        const Eigen::VectorXd record
            = columnOf(folder / "MeasuredSignals" / "M-Mode_3_MHz" / "M3_MH44.DAT", 0, ',')
                  .tail(2500);
        const Eigen::VectorXd published
            = columnOf(folder / "Results" / "M-Mode3MHz_GAMPTMH44_Bode_LowPass100MHz.dat", 3, ';');
        QCOMPARE(published.size(), record.size());
        const Eigen::VectorXcd inverse
            = inverseOf(hydrophone(folder / "HydrophoneCalibrationData" / "MW_MH44ReIm.csv"),
                {LowPassKind::TwoPole, 100e6, 150e6}, kRate_Hz, record.size());
        const RealFft fft(record.size());
        const Eigen::VectorXd found = fft.inverse(fft.forward(record).cwiseProduct(inverse));
        const double rms = std::sqrt((found - published).squaredNorm() / double(found.size()));
        const double share = rms / published.cwiseAbs().maxCoeff();
        qInfo("rms of the difference %.3f %% of the peak", 100.0 * share);
        QVERIFY(share < 0.01);
    }
};

DYNCAL_TEST(TestHydrophonePulses)
#include "tst_hydrophone_pulses.moc"
