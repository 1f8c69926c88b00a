// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What no analysis of a record may know: its unit, its sign, its offset, its axis, how its samples
// are kept and in which order the shots come. And the same numbers by scipy.

#include "core/signal/fft.h"
#include "core/signal/level_statistics.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/resampler.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"
#include "core/signal/start_detection.h"
#include "core/signal/window_checks.h"
#include "core/signal/window_cutting.h"
#include "tests/support/python_answer.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstring>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr double kFirst_s = -4e-4;
const double kNan = std::nan("");
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// 40 000 samples, arrival at sample 4000, ringing at 300 kHz, a little noise.
Eigen::VectorXd stepValues()
{
    StepRecord record;
    record.sensor = {300e3, 0.1};
    record.baseline = 0.25;
    record.step = 2.5;
    record.noiseSd = 0.0025;
    return record.values();
}

WindowedResponse cut(const Channel &channel)
{
    const auto result = cutWindows(captureSetOf({channel}), {}, {});
    if (!result)
        qWarning("%s", english(result.error().message).c_str());
    return result ? result->responses.at(0) : WindowedResponse();
}

bool isNear(double found, double expected, double relative)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

/// Samples that are read from elsewhere whenever they are asked for.
class DistantSamples : public SampleSource
{
public:
    explicit DistantSamples(std::vector<double> values)
        : m_values(std::move(values))
    {
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        std::memcpy(
            target, m_values.data() + begin, static_cast<std::size_t>(count) * sizeof(double));
        return true;
    }

private:
    std::vector<double> m_values;
};

/// A signal that Python makes of the same words.
Eigen::VectorXd known(Index count)
{
    return Eigen::VectorXd::NullaryExpr(count, [](Index i) {
        const auto k = static_cast<double>(i);
        return std::sin(0.37 * k) + 0.3 * std::cos(1.9 * k) + 0.01 * k
            + static_cast<double>(i * i % 101) / 101.0;
    });
}

const char *const kKnown
    = "import numpy as np\nfrom scipy import signal\n"
      "def known(n):\n"
      "    k = np.arange(n)\n"
      "    return np.sin(0.37*k) + 0.3*np.cos(1.9*k) + 0.01*k + (k*k%101)/101\n"
      "def say(x):\n"
      "    print(*(float(v).hex() for v in np.ravel(x)))\n";

/// Each line that Python says, as numbers.
QList<Eigen::VectorXd> answers(const char *script)
{
    const auto answer = python({"-c", QString(kKnown) + script});
    QList<Eigen::VectorXd> lists;
    for (const QByteArray &line : answer.out.trimmed().split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        lists << Eigen::VectorXd::NullaryExpr(words.size(), [&](Index i) {
            return std::strtod(words[i].constData(), nullptr);
        }).eval();
    }
    return answer.ran ? lists : QList<Eigen::VectorXd>();
}

} // namespace

class TestSignalProperties : public QObject
{
    Q_OBJECT

private slots:
    void window_unitIsAPowerOfTwo_sameBits_data();
    void window_unitIsAPowerOfTwo_sameBits();
    void window_offsetAndPolynomial_sameResponse();
    void window_slowerClock_sameSamples();
    void window_shotsPermuted_responsesPermuted();
    void start_samplesKeptElsewhere_sameBits();
    void start_recordBegunLater_sameInstant();
    void start_recordBackwardsOrConstant_isNotInvented();
    void spectrum_againstScipy();
    void spectrum_scalesAsDensity();
    void resonances_unitAndOrder_doNotMatter();
    void filter_againstScipy();
    void decimate_isLinearAndMovesWithItsInput();
    void reduction_ofNonsense_isNone();
    void statistics_againstNumpy();
    void noise_isThatOfTheUnitAndNotOfTheLine();
    void runAtExtreme_isTheSameUpsideDown();
    void fftLength_ofAnything_isDefined();
};

void TestSignalProperties::window_unitIsAPowerOfTwo_sameBits_data()
{
    QTest::addColumn<double>("factor");
    for (const int exponent : {-60, -20, -3, 10, 60}) {
        QTest::addRow("2^%d", exponent) << std::ldexp(1.0, exponent);
        QTest::addRow("-2^%d", exponent) << -std::ldexp(1.0, exponent);
    }
}

/// Nothing rounds differently, so any difference is a threshold in some unit.
void TestSignalProperties::window_unitIsAPowerOfTwo_sameBits()
{
    QFETCH(double, factor);
    const Eigen::VectorXd values = stepValues();
    const WindowedResponse one = cut(doubleChannel(values, kRate_Hz, kFirst_s));
    const WindowedResponse other = cut(doubleChannel(factor * values, kRate_Hz, kFirst_s));
    QVERIFY(one.length > 1000);
    QCOMPARE(other.startSample, one.startSample);
    QCOMPARE(other.length, one.length);
    QVERIFY(other.values == one.values);
    QVERIFY(other.step == factor * one.step);
    QVERIFY(other.baseline == factor * one.baseline);
    QVERIFY(other.noiseSd == std::abs(factor) * one.noiseSd);
    QVERIFY(other.riseTime_s == one.riseTime_s && one.riseTime_s);
    QVERIFY(other.overshoot_percent == one.overshoot_percent && one.overshoot_percent);
    QVERIFY(other.settlingTime_s == one.settlingTime_s && one.settlingTime_s);
}

void TestSignalProperties::window_offsetAndPolynomial_sameResponse()
{
    const Eigen::VectorXd values = stepValues();
    const WindowedResponse one = cut(doubleChannel(values, kRate_Hz, kFirst_s));
    const WindowedResponse lifted = cut(doubleChannel(values.array() + 1000.0, kRate_Hz, kFirst_s));
    Channel scaled = doubleChannel(values, kRate_Hz, kFirst_s);
    scaled.polynomial = {-7.0, 3.0};
    scaled.polarity = -1.0;
    scaled.userScale = 0.5;
    const WindowedResponse turned = cut(scaled);
    constexpr double kRounded = 1e-11; // of values about 1000, over a step of 2.5
    for (const WindowedResponse &other : {lifted, turned}) {
        QCOMPARE(other.startSample, one.startSample);
        QCOMPARE(other.length, one.length);
        QVERIFY((other.values - one.values).cwiseAbs().maxCoeff() < kRounded);
    }
    QVERIFY(isNear(lifted.step, one.step, kRounded));
    QVERIFY(isNear(turned.step, -1.5 * one.step, kRounded));
    QVERIFY(isNear(lifted.baseline, one.baseline + 1000.0, kRounded));
}

void TestSignalProperties::window_slowerClock_sameSamples()
{
    const Eigen::VectorXd values = stepValues();
    const WindowedResponse fast = cut(doubleChannel(values, kRate_Hz, kFirst_s));
    const WindowedResponse slow = cut(doubleChannel(values, kRate_Hz / 1024.0, kFirst_s * 1024.0));
    QCOMPARE(slow.startSample, fast.startSample);
    QCOMPARE(slow.length, fast.length);
    QVERIFY(slow.values == fast.values);
    QVERIFY(isNear(*slow.riseTime_s, 1024.0 * *fast.riseTime_s, 1e-14));
    QVERIFY(isNear(*slow.settlingTime_s, 1024.0 * *fast.settlingTime_s, 1e-14));
    QVERIFY(isNear(slow.end_s, 1024.0 * fast.end_s, 1e-14));
    QVERIFY(isNear(slow.start_s, 1024.0 * fast.start_s, 1e-10)); // near 0: the axis cancels
}

void TestSignalProperties::window_shotsPermuted_responsesPermuted()
{
    std::vector<Channel> channels;
    for (int shot = 0; shot < 3; ++shot)
        channels.push_back(doubleChannel(
            (1.0 + 0.5 * shot) * stepValues().array() + 0.1 * shot, kRate_Hz, kFirst_s));
    const auto forward = cutWindows(captureSetOf(channels), {}, {});
    const std::vector<std::size_t> order{2, 0, 1};
    const auto permuted = cutWindows(
        captureSetOf({channels[order[0]], channels[order[1]], channels[order[2]]}), {}, {});
    for (std::size_t i = 0; i < 3; ++i) {
        const WindowedResponse &a = forward->responses[order[i]], &b = permuted->responses[i];
        QCOMPARE(b.shot, static_cast<Index>(i) + 1);
        QVERIFY(a.values == b.values && a.step == b.step && a.noise == b.noise);
    }
}

/// Longer than what is visited at a time, and not a multiple of it.
void TestSignalProperties::start_samplesKeptElsewhere_sameBits()
{
    StepRecord record;
    record.sensor = {300e3, 0.1};
    record.rate_Hz = kRate_Hz;
    record.duration_s = (2.0 * RawSamples::kBlock + 12345.0) / kRate_Hz;
    record.arrival_s = (RawSamples::kBlock + 0.3) / kRate_Hz; // beside the seam
    record.noiseSd = 0.002;
    const Eigen::VectorXd values = record.values();
    const Channel near = doubleChannel(values, kRate_Hz, kFirst_s);
    Channel distant = near;
    distant.samples = RawSamples(
        std::make_shared<const DistantSamples>(std::vector<double>(values.begin(), values.end())),
        SampleType::Float64, values.size());
    const auto here = detectStart(near), there = detectStart(distant);
    QVERIFY(here.has_value() && there.has_value());
    QCOMPARE(there->sample, here->sample);
    QVERIFY(there->baseline == here->baseline && there->noiseSd == here->noiseSd);
    QVERIFY(there->threshold == here->threshold && there->stepToNoise == here->stepToNoise);
    QVERIFY(std::abs(here->sample - RawSamples::kBlock) < 20);
    QVERIFY(crossingTime_s(distant, 0.5, 0) == crossingTime_s(near, 0.5, 0));
}

void TestSignalProperties::start_recordBegunLater_sameInstant()
{
    const Eigen::VectorXd values = stepValues();
    const Index whole = detectStart(doubleChannel(values, kRate_Hz, kFirst_s))->sample;
    for (const Index dropped : {1, 7, 100, 999, 2500}) {
        const auto later
            = detectStart(doubleChannel(values.tail(values.size() - dropped), kRate_Hz, 0.0));
        QVERIFY2(later && std::abs(later->sample + dropped - whole) <= 1,
            qPrintable(QString("%1 samples dropped").arg(dropped)));
    }
    for (const Index cutOff : {1, 3000, 20000}) {
        const auto shorter
            = detectStart(doubleChannel(values.head(values.size() - cutOff), kRate_Hz, 0.0));
        QVERIFY(shorter && std::abs(shorter->sample - whole) <= 1);
    }
}

void TestSignalProperties::start_recordBackwardsOrConstant_isNotInvented()
{
    const auto hasStart = [](const Eigen::VectorXd &values) {
        return detectStart(doubleChannel(values, kRate_Hz, 0.0)).has_value();
    };
    for (const Index size : {0, 1, 2, 63, 64, 65, 1000}) {
        QVERIFY(!hasStart(Eigen::VectorXd::Zero(size)));
        QVERIFY(!hasStart(Eigen::VectorXd::Constant(size, -1e300)));
        QVERIFY(!hasStart(Eigen::VectorXd::Constant(size, kNan)));
        QVERIFY(!hasStart(Eigen::VectorXd::Constant(size, kInfinity)));
    }
    Eigen::VectorXd lone = Eigen::VectorXd::Zero(1000);
    lone[500] = 1e300;
    QVERIFY(!hasStart(lone));
    Eigen::VectorXd huge = stepValues() * 1e300; // levels whose squares are no numbers
    const auto found = detectStart(doubleChannel(huge, kRate_Hz, 0.0));
    QVERIFY(!found || std::abs(found->sample - 4000) < 20);
}

void TestSignalProperties::spectrum_againstScipy()
{
    const auto said = answers(R"py(
x = known(1000)
for window in ('boxcar', 'hann'):
    for detrend in (False, 'constant', 'linear'):
        say(signal.periodogram(x, 5e6, window=window, detrend=detrend)[1])
        say(signal.welch(x, 5e6, window=window, nperseg=128, noverlap=64, detrend=detrend)[1])
        say(signal.periodogram(x[:999], 5e6, window=window, detrend=detrend)[1])
)py");
    if (said.isEmpty())
        QSKIP("python3 with scipy is missing: the spectra are not compared");
    const Eigen::VectorXd x = known(1000);
    qsizetype line = 0;
    for (const Taper taper : {Taper::Rectangular, Taper::Hann}) {
        for (const Detrend detrend : {Detrend::None, Detrend::Mean, Detrend::Linear}) {
            SpectrumSettings settings;
            settings.taper = taper;
            settings.detrend = detrend;
            const auto compare = [&](const Eigen::VectorXd &values) {
                const auto psd = computePowerSpectrum(values, 5e6, settings)->psd;
                const Eigen::VectorXd &expected = said.at(line++);
                QCOMPARE(psd.size(), expected.size());
                QVERIFY2((psd - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.maxCoeff(),
                    qPrintable(QString("line %1").arg(line)));
            };
            compare(x);
            settings.method = SpectrumMethod::Welch;
            settings.segment = 128;
            compare(x);
            settings.method = SpectrumMethod::Periodogram;
            compare(x.head(999));
        }
    }
}

void TestSignalProperties::spectrum_scalesAsDensity()
{
    const Eigen::VectorXd x = known(512);
    for (const SpectrumMethod method : {SpectrumMethod::Periodogram, SpectrumMethod::Welch}) {
        SpectrumSettings settings;
        settings.method = method;
        settings.detrend = Detrend::Linear;
        const auto one = computePowerSpectrum(x, 1e6, settings);
        const auto louder = computePowerSpectrum(-8.0 * x, 1e6, settings);
        QVERIFY(louder->psd == 64.0 * one->psd);
        const auto faster = computePowerSpectrum(x, 4e6, settings);
        QVERIFY((faster->psd - 0.25 * one->psd).norm() < 1e-14 * one->psd.norm());
        QVERIFY((faster->frequency_Hz - 4.0 * one->frequency_Hz).norm()
            < 1e-14 * faster->frequency_Hz.norm());
        // Time has no direction in a power spectrum: whole segments turn round too.
        const auto backwards = computePowerSpectrum(x.reverse(), 1e6, settings);
        QVERIFY((backwards->psd - one->psd).norm() < 1e-12 * one->psd.norm());
    }
}

void TestSignalProperties::resonances_unitAndOrder_doNotMatter()
{
    std::vector<WindowedResponse> responses(3);
    for (std::size_t shot = 0; shot < 3; ++shot) {
        responses[shot].shot = static_cast<Index>(shot) + 1;
        responses[shot].sampleRate_Hz = kRate_Hz;
        Gaussian noise(shot + 1);
        const SecondOrder sensor{(1.0 + 0.001 * static_cast<double>(shot)) * 300e3, 0.02};
        responses[shot].values = Eigen::VectorXd::NullaryExpr(4000, [&](Index i) {
            return sensor.step(static_cast<double>(i) / kRate_Hz) + 0.002 * noise();
        });
        responses[shot].length = 4000;
    }
    const SpectrumResult one = analyseSpectra(responses, {}).value();
    QCOMPARE(one.resonances.size(), std::size_t(1));
    for (const double factor : {0x1p-40, -0x1p30}) {
        std::vector<WindowedResponse> other = responses;
        std::swap(other[0], other[2]);
        for (WindowedResponse &response : other)
            response.values *= factor;
        const SpectrumResult scaled = analyseSpectra(other, {}).value();
        QCOMPARE(scaled.resonances.size(), one.resonances.size());
        const Resonance &a = one.resonances[0], &b = scaled.resonances[0];
        QVERIFY(isNear(b.frequency_Hz, a.frequency_Hz, 1e-12));
        QVERIFY(isNear(b.q, a.q, 1e-9) && isNear(b.prominence_dB, a.prominence_dB, 1e-9));
        for (std::size_t shot = 0; shot < 3; ++shot)
            QVERIFY(isNear(*b.perShot_Hz[2 - shot], *a.perShot_Hz[shot], 1e-12));
    }
}

void TestSignalProperties::filter_againstScipy()
{
    const auto said = answers(R"py(
for factor in (2, 5, 10, 50):
    taps = signal.firwin(12 * factor + 1, 1 / factor, window=('kaiser', 0.1102 * (70 - 8.7)))
    say(taps)
    x = known(40 * factor)
    say(np.convolve(x, taps, 'valid')[::factor])
)py");
    if (said.isEmpty())
        QSKIP("python3 with scipy is missing: the filter is not compared");
    qsizetype line = 0;
    for (const Index factor : {2, 5, 10, 50}) {
        const AntiAliasFilter filter = designAntiAliasFilter(static_cast<double>(factor), kRate_Hz);
        const Eigen::VectorXd taps = said.at(line++), outputs = said.at(line++);
        QCOMPARE(filter.taps.size(), taps.size());
        QVERIFY((filter.taps - taps).cwiseAbs().maxCoeff() < 1e-14);
        const Eigen::VectorXd x = known(40 * factor);
        const Index count = outputCount(filter, filter.halfLength(), x.size() - 1);
        QCOMPARE(count, outputs.size());
        const Eigen::VectorXd found = decimate(x, filter, filter.halfLength(), count);
        QVERIFY((found - outputs).cwiseAbs().maxCoeff() < 1e-12);
    }
}

void TestSignalProperties::decimate_isLinearAndMovesWithItsInput()
{
    const Eigen::VectorXd x = known(2000), y = Gaussian(3).vector(2000, 1.0);
    for (const double factor : {1.0, 2.0, 3.5, 7.0, 10.0 / 3.0}) {
        const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz);
        const Index first = filter.halfLength(), count = outputCount(filter, first, 1899);
        const auto reduced = [&](const Eigen::VectorXd &values, Index at) {
            return decimate(values, filter, at, count);
        };
        const Eigen::VectorXd both = reduced(3.0 * x - 2.0 * y, first);
        QVERIFY((both - 3.0 * reduced(x, first) + 2.0 * reduced(y, first)).cwiseAbs().maxCoeff()
            < 1e-11);
        QVERIFY(reduced(x.tail(1900), first) == reduced(x, first + 100));
        QVERIFY(
            (reduced(Eigen::VectorXd::Constant(2000, 7.5), first).array() - 7.5).abs().maxCoeff()
            < 1e-13);
        // Input that the filter must not touch: the outputs do not know it.
        Eigen::VectorXd guarded = x;
        guarded.head(first - filter.halfLength()).setConstant(kNan);
        guarded.tail(100).setConstant(kNan);
        QVERIFY(reduced(guarded, first).allFinite());
        QCOMPARE(outputCount(filter, first, first - 1), Index(0));
    }
}

void TestSignalProperties::reduction_ofNonsense_isNone()
{
    for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity}) {
        QVERIFY(!reductionFactor(bad, 1e6));
        if (!std::isinf(bad) || bad < 0.0)
            QVERIFY(!reductionFactor(1e6, bad));
        QVERIFY(!computePowerSpectrum(known(64), bad, {}));
    }
    QVERIFY(!reductionFactor(1e6, kInfinity));
    QVERIFY(!reductionFactor(1e6, 1.1e6)); // up is no reduction
    for (const double rate_Hz : {1.0, 48e3, 100e6, 62.5e6}) {
        for (const double factor : {1.0, 2.0, 3.0, 12.5, 1000.0})
            QVERIFY(isNear(*reductionFactor(rate_Hz, rate_Hz / factor), factor, 1e-15));
    }
    for (const double bad : {kNan, kInfinity}) {
        Eigen::VectorXd values = known(64);
        values[17] = bad;
        QVERIFY(!computePowerSpectrum(values, 1e6, {}));
    }
    QVERIFY(!computePowerSpectrum(1e200 * known(64), 1e6, {})); // squares beyond all numbers
    QVERIFY(!computePowerSpectrum(Eigen::VectorXd(), 1e6, {}));
}

void TestSignalProperties::statistics_againstNumpy()
{
    const auto said = answers(R"py(
for n in (3, 10, 257):
    x = known(n)
    slope = np.polyfit(np.arange(n) - (n - 1) / 2, x, 1)[0]
    rest = signal.detrend(x)
    say([np.median(x), x.mean(), slope, (np.sum(rest**2) / (n - 2))**0.5])
    say(rest)
)py");
    if (said.isEmpty())
        QSKIP("python3 with scipy is missing: the statistics are not compared");
    qsizetype line = 0;
    for (const Index n : {3, 10, 257}) {
        const Eigen::VectorXd x = known(n);
        const LineFit fit = fitLine(x);
        const Eigen::VectorXd expected = said.at(line++), rest = said.at(line++);
        const Eigen::Vector4d found(median(x), fit.mean, fit.slope, fit.sd);
        QVERIFY((found - expected).cwiseAbs().maxCoeff() < 1e-13);
        QVERIFY((withoutLine(x) - rest).cwiseAbs().maxCoeff() < 1e-12);
    }
}

void TestSignalProperties::noise_isThatOfTheUnitAndNotOfTheLine()
{
    const Eigen::VectorXd noise = Gaussian(5).vector(5000, 1.0);
    const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(5000, -40.0, 90.0);
    const double sd = robustNoiseSd(noise, 100);
    QVERIFY(robustNoiseSd(0x1p-70 * noise, 100) == 0x1p-70 * sd);
    QVERIFY(robustNoiseSd(-noise, 100) == sd);
    QVERIFY(isNear(robustNoiseSd(noise + line, 100), sd, 1e-9));
    QVERIFY(isAtRest(noise, 100.0, sd) && isAtRest(-noise, -100.0, sd));
    QVERIFY(!isAtRest(noise + line, 100.0, sd) && !isAtRest(line - noise, -100.0, sd));
}

void TestSignalProperties::runAtExtreme_isTheSameUpsideDown()
{
    Eigen::VectorXd values = Gaussian(6).vector(400, 0.01);
    values.segment(200, 60) = Eigen::VectorXd::LinSpaced(60, 0.0, 10.0).cwiseMin(7.0);
    const auto up = runAtExtreme(values, 0.01, 0.0), down = runAtExtreme(-values, 0.01, 0.0);
    QVERIFY(up.has_value() && down.has_value());
    QCOMPARE(up->begin, down->begin);
    QCOMPARE(up->count, down->count);
    QCOMPARE(values[up->begin], 7.0);
    QVERIFY((values.segment(up->begin, up->count).array() == 7.0).all());
    for (const Index size : {0, 1, 2})
        QVERIFY(!runAtExtreme(Eigen::VectorXd::Ones(size), 0.01, 0.0));
    QVERIFY(!runAtExtreme(values.head(200), 0.01, 0.0));
}

void TestSignalProperties::fftLength_ofAnything_isDefined()
{
    QCOMPARE(fastFftLength(0), Index(1));
    QCOMPARE(fastFftLength(-5), Index(1));
    for (const Index n : {Index(1), Index(1) << 40, (Index(1) << 40) + 1, Index(99999999999)}) {
        const Index length = fastFftLength(n);
        QVERIFY(length >= n && length <= 2 * n);
        Index rest = length;
        for (const Index prime : {2, 3, 5}) {
            while (rest % prime == 0)
                rest /= prime;
        }
        QCOMPARE(rest, Index(1));
    }
}

DYNCAL_TEST(TestSignalProperties)
#include "tst_signal_properties.moc"
