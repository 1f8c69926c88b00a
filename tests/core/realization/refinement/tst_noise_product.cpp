// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/noise_product.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;
constexpr double kAgree = 1e-7; // the filter's end is cut at 1e-8 of its largest output

/// A pair, a real pole and a constant, pole and amplitude of each.
Sensitivities someSensitivities()
{
    const Complex i(0.0, 1.0);
    const Complex pair(0.3, -0.9);
    Sensitivities result;
    result.dt_s = 1e-6;
    result.exponents = {{-0.004, 0.21}, {-0.03, 0.0}, {0.0, 0.0}};
    result.columns = {{pair, 0, 1}, {i * pair, 0, 1}, {-0.4, 1, 1}, {1.0, 0, 0}, {i, 0, 0},
        {1.0, 1, 0}, {1.0, 2, 0}};
    return result;
}

/// As large as one another: what "in units of the uncertainties" means for the product.
Eigen::VectorXd someUnits()
{
    Eigen::VectorXd unit(7);
    unit << 4e3, 4e3, 3e4, 1.0, 1.1, 0.9, 0.05;
    return unit;
}

double valueOf(const Sensitivities &modes, const ExponentialColumn &column, Index k)
{
    const auto at = static_cast<double>(k);
    const double value = (column.factor * std::exp(modes.exponents[column.mode] * at)).real();
    return column.order == 0 ? value : at * modes.dt_s * value;
}

Eigen::MatrixXd transposedJacobian(const Sensitivities &modes, const Eigen::VectorXd &unit,
    const std::vector<SampleRange> &used, Index samples)
{
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(unit.size(), samples);
    for (const SampleRange &range : used) {
        for (Index k = range.begin; k < range.end; ++k) {
            for (Index i = 0; i < unit.size(); ++i)
                J(i, k) = unit[i] * valueOf(modes, modes.columns[static_cast<std::size_t>(i)], k);
        }
    }
    return J;
}

/// The definition, sample by sample: v sum u u^T on into the time before the record.
Eigen::MatrixXd filteredProduct(const Eigen::MatrixXd &J, const AutoregressiveModel &noise)
{
    constexpr Index kBefore = 20000;
    const Index p = noise.order();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(J.rows(), J.rows());
    Eigen::MatrixXd u = Eigen::MatrixXd::Zero(J.rows(), J.cols() + kBefore + p);
    for (Index k = J.cols() + kBefore - 1; k >= 0; --k) {
        if (k >= kBefore)
            u.col(k) = J.col(k - kBefore);
        for (Index i = 1; i <= p; ++i)
            u.col(k) -= noise.coefficients[i - 1] * u.col(k + i);
        sum += u.col(k) * u.col(k).transpose();
    }
    return noise.innovationVariance * sum;
}

/// Independent of any filter: S from its autocovariance, which is the noise's impulse response with
/// itself.
Eigen::MatrixXd denseProduct(const Eigen::MatrixXd &J, const AutoregressiveModel &noise)
{
    constexpr Index kMemory = 20000;
    Eigen::VectorXd h = Eigen::VectorXd::Zero(kMemory);
    h[0] = 1.0;
    for (Index k = 1; k < kMemory; ++k) {
        for (Index i = 1; i <= std::min(k, noise.order()); ++i)
            h[k] -= noise.coefficients[i - 1] * h[k - i];
    }
    const Index n = J.cols();
    Eigen::MatrixXd S(n, n);
    for (Index lag = 0; lag < n; ++lag) {
        const double r
            = noise.innovationVariance * h.head(kMemory - lag).dot(h.tail(kMemory - lag));
        S.diagonal(lag).setConstant(r);
        S.diagonal(-lag).setConstant(r);
    }
    return J * S * J.transpose();
}

/// Poles of a stable model: from its reflection coefficients, all of them below 1.
AutoregressiveModel modelOf(const std::vector<double> &reflections, double variance)
{
    AutoregressiveModel model;
    model.innovationVariance = variance;
    for (const double reflection : reflections) {
        Eigen::VectorXd next(model.order() + 1);
        next.head(model.order()) = model.coefficients + reflection * model.coefficients.reverse();
        next[model.order()] = reflection;
        model.coefficients = next;
    }
    return model;
}

AutoregressiveModel longModel()
{
    std::vector<double> reflections;
    for (int i = 0; i < 20; ++i)
        reflections.push_back(0.5 * std::cos(1.7 * i) / (1.0 + 0.2 * i));
    return modelOf(reflections, 0.3);
}

double largestDifference(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
{
    const Eigen::VectorXd unit = b.diagonal().cwiseSqrt().cwiseInverse();
    return (unit.asDiagonal() * (a - b) * unit.asDiagonal()).cwiseAbs().maxCoeff();
}

} // namespace

class TestNoiseProduct : public QObject
{
    Q_OBJECT

private slots:
    void product_isThatOfTheFilterOverEverySample_data();
    void product_isThatOfTheFilterOverEverySample();
    void product_isThatOfTheNoiseCovarianceAsAMatrix();
    void whiteNoise_isTheGramMatrix();
    void noSamples_noProduct();
    void samplesFarBehindTheDecay_changeNothing();
    void resonanceOfTheNoiseAtThePole_isStillRight();
    void sensitivities_areTheDerivativesOfTheModel();
};

void TestNoiseProduct::product_isThatOfTheFilterOverEverySample_data()
{
    QTest::addColumn<AutoregressiveModel>("noise");
    QTest::addColumn<std::vector<SampleRange>>("used");
    const std::vector<SampleRange> whole{{0, 5000}};
    const std::vector<SampleRange> gaps{{0, 40}, {55, 700}, {702, 703}, {1900, 5000}};
    const std::vector<SampleRange> late{{2000, 3000}};
    for (const auto &[name, used] : {std::pair("whole", whole), {"gaps", gaps}, {"late", late}}) {
        const auto row
            = [name = name, used = used](const char *noise, const AutoregressiveModel &model) {
                  QTest::addRow("%s, %s", noise, name) << model << used;
              };
        row("slow", modelOf({-0.9}, 2.0));
        row("fast", modelOf({0.7}, 2.0));
        row("long memory", modelOf({-0.995}, 1e-3));
        row("resonant", modelOf({-0.6, 0.98}, 0.1));
        row("order 20", longModel());
    }
}

void TestNoiseProduct::product_isThatOfTheFilterOverEverySample()
{
    QFETCH(AutoregressiveModel, noise);
    QFETCH(std::vector<SampleRange>, used);
    const Sensitivities modes = someSensitivities();
    const Eigen::MatrixXd J = transposedJacobian(modes, someUnits(), used, used.back().end);
    const Eigen::MatrixXd found = noiseProduct(modes, someUnits(), used, noise);
    const double difference = largestDifference(found, filteredProduct(J, noise));
    QVERIFY2(difference < kAgree, qPrintable(QString::number(difference)));
    QVERIFY(found == found.transpose());
}

void TestNoiseProduct::product_isThatOfTheNoiseCovarianceAsAMatrix()
{
    const Sensitivities modes = someSensitivities();
    const std::vector<SampleRange> used{{0, 300}, {350, 900}};
    const Eigen::MatrixXd J = transposedJacobian(modes, someUnits(), used, 900);
    for (const AutoregressiveModel &noise :
        {modelOf({-0.9}, 2.0), modelOf({-0.6, 0.9}, 0.1), longModel()}) {
        const Eigen::MatrixXd found = noiseProduct(modes, someUnits(), used, noise);
        QVERIFY(largestDifference(found, denseProduct(J, noise)) < kAgree);
    }
}

void TestNoiseProduct::whiteNoise_isTheGramMatrix()
{
    const Sensitivities modes = someSensitivities();
    const std::vector<SampleRange> used{{0, 300}, {350, 2000}};
    const Eigen::MatrixXd J = transposedJacobian(modes, someUnits(), used, 2000);
    const Eigen::MatrixXd found = noiseProduct(modes, someUnits(), used, {{}, 0.25});
    QVERIFY(largestDifference(found, 0.25 * J * J.transpose()) < 1e-11);
}

void TestNoiseProduct::noSamples_noProduct()
{
    const Sensitivities modes = someSensitivities();
    for (const AutoregressiveModel &noise : {modelOf({-0.9}, 2.0), AutoregressiveModel{{}, 1.0}}) {
        QVERIFY(noiseProduct(modes, someUnits(), {}, noise).isZero(0.0));
        QVERIFY(noiseProduct(modes, someUnits(), {{0, 0}}, noise).isZero(0.0));
    }
}

void TestNoiseProduct::samplesFarBehindTheDecay_changeNothing()
{
    // Decaying modes alone: e^(-0.004 k) is gone after 10 000 samples, and below every double
    // after 200 000.
    Sensitivities modes = someSensitivities();
    modes.columns.pop_back();
    const Eigen::VectorXd unit = someUnits().head(6);
    for (const AutoregressiveModel &noise : {modelOf({-0.9}, 2.0), longModel()}) {
        const Eigen::MatrixXd shorter = noiseProduct(modes, unit, {{0, 10'000}}, noise);
        for (const Index samples : {Index(20'000), Index(300'000), Index(10'000'000)}) {
            const Eigen::MatrixXd longer = noiseProduct(modes, unit, {{0, samples}}, noise);
            QVERIFY(longer.allFinite());
            QVERIFY(largestDifference(longer, shorter) < kAgree);
        }
    }
}

void TestNoiseProduct::resonanceOfTheNoiseAtThePole_isStillRight()
{
    // The noise rings where the sensor does and for longer: |A| is small there, and filter and
    // exponentials die away together.
    const Sensitivities modes = someSensitivities();
    AutoregressiveModel noise;
    noise.innovationVariance = 1.0;
    const double radius = std::exp(-0.003);
    noise.coefficients.resize(2);
    noise.coefficients << -2.0 * radius * std::cos(0.21), radius * radius;
    const std::vector<SampleRange> used{{0, 4000}};
    const Eigen::MatrixXd J = transposedJacobian(modes, someUnits(), used, 4000);
    const Eigen::MatrixXd found = noiseProduct(modes, someUnits(), used, noise);
    QVERIFY(largestDifference(found, filteredProduct(J, noise)) < kAgree);
}

void TestNoiseProduct::sensitivities_areTheDerivativesOfTheModel()
{
    constexpr double kDifferences = 1e-6;
    Refinement fit;
    fit.poleParameters = 3;
    fit.withConstant = true;
    const Complex s(-6e3, 2e5);
    ExponentialSum sum;
    sum.constant = 1.2;
    sum.poles_rad_s.resize(3);
    sum.poles_rad_s << s, std::conj(s), -3e4;
    sum.amplitudes.resize(3);
    sum.amplitudes << Complex(-0.4, 0.1), Complex(-0.4, -0.1), -0.3;
    fit.poles_rad_s = {s, std::conj(s), -3e4};
    fit.records = {sum};
    fit.nuisance = {{{0, true, {-1e3, 4e4}, {0.1, 0.2}}}};
    RefinementRecord data;
    data.rate_Hz = 1e6;
    data.y = Eigen::VectorXd::Zero(200);
    const Sensitivities found = sensitivitiesOf(fit, 0, data);
    QCOMPARE(std::ssize(found.columns), std::ptrdiff_t(3 + 3 + 1 + 4));
    for (Index i = 0; i < 7; ++i) {
        const double step = 1e-4 * (i < 3 ? 1e4 : 1.0);
        const ExponentialSum up = perturbed(fit, 0, i, step);
        const ExponentialSum down = perturbed(fit, 0, i, -step);
        for (Index k = 0; k < 200; k += 7) {
            const double t_s = static_cast<double>(k) / data.rate_Hz;
            const double slope = (up.value(t_s) - down.value(t_s)) / (2.0 * step);
            const double value = valueOf(found, found.columns[static_cast<std::size_t>(i)], k);
            const double scale = i < 3 ? 1e-4 : 1.0;
            QVERIFY(std::abs(value - slope) < kDifferences * scale);
        }
    }
    const NuisanceTerm &term = fit.nuisance[0][0];
    for (Index k = 0; k < 200; k += 7) {
        const double t_s = static_cast<double>(k) / data.rate_Hz;
        const Complex e = std::exp(term.pole_rad_s * t_s);
        const auto value = [&](std::size_t i) { return valueOf(found, found.columns[7 + i], k); };
        QVERIFY(std::abs(value(0) - (t_s * term.amplitude * e).real()) < 1e-15);
        QVERIFY(std::abs(value(1) + (t_s * term.amplitude * e).imag()) < 1e-15);
        QVERIFY(std::abs(value(2) - e.real()) < 1e-12);
        QVERIFY(std::abs(value(3) + e.imag()) < 1e-12);
    }
}

DYNCAL_TEST(TestNoiseProduct)
#include "tst_noise_product.moc"
