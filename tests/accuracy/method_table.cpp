// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the tables "Methods" and "Several shots" of docs/accuracy.md:
//     method_table [TRIALS [FOLDER]]
// Three shots (0.33, 0.6 and 0.9 of the range, 14 bits, 400 samples from the step on): bias and
// standard deviation of fn, zeta and the plateau, in per cent of the truth, by method. Into FOLDER
// go the records and the estimates from the stacked shots, for `reference_methods.py paired
// FOLDER`.

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/model/sensor_model.h"
#include "tests/support/model_inputs.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>

using namespace dyncal;

namespace {

constexpr std::array<double, 3> kSteps{0.33, 0.6, 0.9};
constexpr Index kSamples = 400;

struct Case
{
    const char *name;
    double f0_Hz, zeta, rate_Hz, snr_dB;
};

struct Estimate
{
    double frequency_Hz = 0.0;
    double zeta = 0.0;
    double plateau = kUnknown; ///< over the true one
};

/// Bias and standard deviation over the trials, and how many gave no oscillating pole.
class Statistics
{
public:
    void add(const std::optional<Estimate> &estimate, const Case &c)
    {
        if (!estimate) {
            ++m_failed;
            return;
        }
        ++m_count;
        const std::array<double, 3> errors{100.0 * (estimate->frequency_Hz / c.f0_Hz - 1.0),
            100.0 * (estimate->zeta / c.zeta - 1.0), 100.0 * (estimate->plateau - 1.0)};
        for (std::size_t i = 0; i < 3; ++i) {
            m_sums[i] += errors[i];
            m_squares[i] += errors[i] * errors[i];
        }
    }
    std::string cells() const
    {
        if (m_count == 0)
            return " no oscillating pole | | |";
        std::string text;
        for (std::size_t i = 0; i < 3; ++i) {
            const double mean = m_sums[i] / m_count;
            const double sd = std::sqrt(std::max(0.0, m_squares[i] / m_count - mean * mean));
            char cell[64];
            std::snprintf(cell, sizeof cell, " %+.4f +- %.4f |", mean, sd);
            text += std::isnan(mean) ? " |" : cell;
        }
        return m_failed > 0 ? text + " none in " + std::to_string(m_failed) : text;
    }

private:
    std::array<double, 3> m_sums{};
    std::array<double, 3> m_squares{};
    int m_count = 0;
    int m_failed = 0;
};

/// The records of a case, and what was made of them, for another program to judge.
class PairedRecords
{
public:
    /// Writes nothing where `folder` is empty.
    PairedRecords(const std::string &folder, const std::string &name, const std::string &title,
        const Case &c, double first, const std::array<double, 3> &noise)
    {
        if (folder.empty())
            return;
        m_records.open(folder + '/' + name + ".f64", std::ios::binary);
        m_estimates.open(folder + '/' + name + ".txt");
        m_estimates.precision(17);
        m_estimates << title << '\n'
                    << c.f0_Hz << ' ' << c.zeta << ' ' << c.rate_Hz << ' ' << first << '\n'
                    << noise[0] << ' ' << noise[1] << ' ' << noise[2] << '\n';
    }
    void add(const std::vector<ModelSeries> &shots, const std::optional<Estimate> &deflated,
        const std::optional<Estimate> &refined)
    {
        if (!m_estimates.is_open())
            return;
        for (const ModelSeries &shot : shots) {
            m_records.write(reinterpret_cast<const char *>(shot.y.data()),
                static_cast<std::streamsize>(sizeof(double)) * shot.y.size());
        }
        for (const auto &estimate : {deflated, refined}) {
            const Estimate values = estimate.value_or(Estimate{kUnknown, kUnknown, kUnknown});
            m_estimates << values.frequency_Hz << ' ' << values.zeta << ' ';
        }
        m_estimates << '\n';
    }

private:
    std::ofstream m_records, m_estimates;
};

/// Shots in units of the range, rounded to 14 bits, each with its pre-trigger noise.
std::vector<ModelSeries> simulate(const Case &c, const std::array<double, 3> &noise,
    const std::array<double, 3> &start, std::uint64_t seed)
{
    testing::Noise source(seed);
    std::vector<ModelSeries> shots;
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
        const auto rounded = [](const Eigen::VectorXd &x) {
            return ((x * 8192.0).array().round() / 8192.0).eval();
        };
        const Eigen::VectorXd y = rounded(
            testing::sampledStep(c.f0_Hz, c.zeta, c.rate_Hz, kSamples, start[i]) * kSteps[i]
            + source.series(kSamples, noise[i]));
        shots.push_back(testing::makeSeries(
            static_cast<Index>(i) + 1, y, c.rate_Hz, rounded(source.series(1000, noise[i]))));
    }
    return shots;
}

/// The shots over their steps, averaged with equal weights: what the thesis decomposes.
std::vector<ModelSeries> averaged(const std::vector<ModelSeries> &shots, double rate_Hz)
{
    Eigen::VectorXd y = Eigen::VectorXd::Zero(kSamples);
    Eigen::VectorXd noise = Eigen::VectorXd::Zero(shots.front().noise.size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
        y += shots[i].y / (3.0 * kSteps[i]);
        noise += shots[i].noise / (3.0 * kSteps[i]);
    }
    return {testing::makeSeries(0, y, rate_Hz, noise)};
}

/// Series and their decomposition, which serves every order and the refinement.
struct Decomposed
{
    ModelInput input;
    HankelDecomposition hankel;
    double rate_Hz = 0.0;

    Decomposed(std::vector<ModelSeries> series, const Case &c, ResponseTreatment treatment)
        : input(testing::makeInput(treatment, c.rate_Hz, std::move(series)))
        , hankel(decomposeHankel(input, {}).value())
        , rate_Hz(c.rate_Hz)
    {
    }

    /// The oscillating pole of the raw realisation; the thesis has no plateau gain.
    std::optional<Estimate> pole(Index order) const
    {
        for (const std::complex<double> &z : realizedPoles(hankel, order)) {
            if (z.imag() <= 0.0)
                continue;
            const std::complex<double> s = std::log(z) * rate_Hz;
            return Estimate{
                std::abs(s) / (2.0 * std::numbers::pi), -s.real() / std::abs(s), kUnknown};
        }
        return std::nullopt;
    }

    /// The main resonance of the model of order 2.
    std::optional<Estimate> model(bool refine) const
    {
        RealizationSettings settings;
        settings.refine = refine;
        const auto model = fitModel(input, hankel, 2, settings, {});
        const Pole *main = model ? mainPole(model->poles, model->series) : nullptr;
        if (!main || main->z.imag() == 0.0)
            return std::nullopt;
        double plateau = 0.0;
        for (const SeriesFit &fit : model->series) {
            const double step = fit.shot > 0 ? kSteps[static_cast<std::size_t>(fit.shot) - 1] : 1.0;
            plateau += fit.plateauGain / step / static_cast<double>(model->series.size());
        }
        return Estimate{main->frequency_Hz, main->dampingRatio, plateau};
    }
};

void printRow(const std::string &name, const std::string &method, const Statistics &statistics)
{
    std::printf("| %s | %s |%s\n", name.c_str(), method.c_str(), statistics.cells().c_str());
    std::fflush(stdout);
}

void printMethods(const Case &c, int trials, const std::string &folder, std::size_t number)
{
    using T = ResponseTreatment;
    std::array<Statistics, 6> methods;
    const double relative = std::pow(10.0, -c.snr_dB / 20.0);
    std::array<double, 3> noise{};
    for (std::size_t i = 0; i < 3; ++i)
        noise[i] = relative * kSteps[i];
    PairedRecords paired(folder, "methods-" + std::to_string(number), c.name, c, 0.0, noise);
    for (int trial = 1; trial <= trials; ++trial) {
        const auto shots = simulate(c, noise, {}, static_cast<std::uint64_t>(trial));
        const auto average = averaged(shots, c.rate_Hz);
        const Decomposed thesis(average, c, T::StepAsImpulse);
        methods[0].add(thesis.pole(2), c);
        methods[1].add(thesis.pole(3), c);
        methods[2].add(Decomposed(average, c, T::Differenced).model(false), c);
        methods[3].add(Decomposed(shots, c, T::Differenced).model(false), c);
        const Decomposed stacked(shots, c, T::StepDeflated);
        const auto deflated = stacked.model(false);
        const auto refined = stacked.model(true);
        methods[4].add(deflated, c);
        methods[5].add(refined, c);
        paired.add(shots, deflated, refined);
    }
    const std::array<const char *, 6> names{"(a) thesis, order 2", "(a+) thesis, order 3",
        "(b) differenced, average", "(b) differenced, stacked", "(c) step deflated",
        "(e) deflated, refined"};
    for (std::size_t i = 0; i < methods.size(); ++i)
        printRow(c.name, names[i], methods[i]);
}

/// Equal noise in all shots, so that the smallest has the worst record; the stated ratio is that
/// of the largest step.
void printShots(const Case &c, bool jitter, int trials, const std::string &folder)
{
    const std::string name = std::string(c.name) + (jitter ? ", starts within a sample" : "");
    Statistics equal, best, stacked, refined;
    const double noise = kSteps.back() * std::pow(10.0, -c.snr_dB / 20.0);
    PairedRecords paired(folder, jitter ? "shots-jitter" : "shots", "equal noise, " + name, c,
        jitter ? 0.5 : 0.0, {noise, noise, noise});
    for (int trial = 1; trial <= trials; ++trial) {
        const auto seed = static_cast<std::uint64_t>(trial);
        testing::Noise source(seed + 1'000'000);
        std::array<double, 3> start{};
        for (double &first : start) {
            const double uniform = 0.5 * std::erfc(-source.next() / std::numbers::sqrt2);
            first = jitter ? uniform : 0.0;
        }
        const auto shots = simulate(c, {noise, noise, noise}, start, seed);
        const auto deflated = ResponseTreatment::StepDeflated;
        equal.add(Decomposed(averaged(shots, c.rate_Hz), c, deflated).model(false), c);
        best.add(Decomposed({shots.back()}, c, deflated).pole(2), c);
        const Decomposed together(shots, c, deflated);
        const auto plain = together.model(false);
        const auto fitted = together.model(true);
        stacked.add(plain, c);
        refined.add(fitted, c);
        paired.add(shots, plain, fitted);
    }
    printRow(name, "average, equal weights", equal);
    printRow(name, "largest shot alone", best);
    printRow(name, "stacked", stacked);
    printRow(name, "stacked, refined", refined);
}

} // namespace

int main(int argc, char **argv)
{
    const int trials = argc > 1 ? std::atoi(argv[1]) : 400;
    const std::string folder = argc > 2 ? argv[2] : "";
    const Case cases[]{{"30 kHz, zeta 0.05, 1 MHz, 40 dB", 30e3, 0.05, 1e6, 40.0},
        {"318 kHz, zeta 0.02, 1 MHz, 40 dB", 318e3, 0.02, 1e6, 40.0},
        {"200 kHz, zeta 0.02, 10 MHz, 40 dB", 200e3, 0.02, 10e6, 40.0},
        {"30 kHz, zeta 0.05, 1 MHz, 20 dB", 30e3, 0.05, 1e6, 20.0},
        {"30 kHz, zeta 0.5, 1 MHz, 40 dB", 30e3, 0.5, 1e6, 40.0}};
    std::printf("| case | method | fn, %% | zeta, %% | plateau, %% |\n|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < std::size(cases); ++i)
        printMethods(cases[i], trials, folder, i);
    std::printf("\n| case | shots | fn, %% | zeta, %% | plateau, %% |\n|---|---|---|---|---|\n");
    printShots(cases[0], false, trials, folder);
    printShots(cases[1], true, trials, folder);
    return 0;
}
