// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/echo_search.h"

#include "core/realization/input/whitening.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kPointsPerPeriod = 6.0; ///< of the highest resonance
constexpr double kQuietPeriods = 3.0; ///< of the lowest one, before the first echo that can be told
constexpr double kQuietRiseTimes
    = 15.0; ///< the same without one: e^-7 is left of a damping ratio of 0.3
constexpr Index kParabola = 3; ///< columns of the background that are no resonance
constexpr Index kFewest = 20; ///< points on each side of an echo
constexpr Index kReach = 200; ///< points on each side that are looked at
constexpr Index kStride = 8; ///< points from one look to the next
constexpr Index kMostLooks = 4000; ///< over 5000 periods: 2.3 ms at 2.33 MHz, 17 ms at 318 kHz
constexpr Index kFewestNoisePoints = 100;
constexpr double kGone = 1e-4; ///< of the ringing
constexpr double kCandidate = 12.0; ///< chi square
constexpr double kLeftOver = 0.1; ///< of what an echo explains: the rest of another shape is more
constexpr double kByChance = 3.0; ///< standard deviations of what noise leaves
constexpr double kPointsPerRise = 4.0;

struct Ringing
{
    double omega = 0.0; ///< per point
    double decay = 0.0;
};

/// What fits a stretch leaves, in units of the noise.
struct Remainder
{
    double before = 0.0; ///< without the echo
    double gain = 0.0; ///< what the echo takes off
    double size = 0.0; ///< of a single template
    double u_size = 0.0;
};

/// A sixth of the shortest period, a quarter of the rise time without a resonance.
double pointLength_s(const SensorTraits &traits)
{
    double shortest_s = HUGE_VAL;
    for (const RingingTraits &one : traits.ringing)
        shortest_s = std::min(shortest_s, 1.0 / one.frequency_Hz);
    return traits.ringing.empty() ? *traits.riseTime_s / kPointsPerRise
                                  : shortest_s / kPointsPerPeriod;
}

/// Before it an echo cannot be told from the response.
double quietTime_s(const SensorTraits &traits)
{
    double longest_s = traits.riseTime_s.value_or(0.0);
    for (const RingingTraits &one : traits.ringing)
        longest_s = std::max(longest_s, 1.0 / one.frequency_Hz);
    return (traits.ringing.empty() ? kQuietRiseTimes : kQuietPeriods) * longest_s;
}

/// How many values of a row are larger than its largest less 1: one standard deviation to each
/// side chi square is larger by 1.
double nearTheTop(const std::vector<Remainder> &row, double largest)
{
    return static_cast<double>(std::ranges::count_if(
        row, [largest](const Remainder &one) { return one.gain > largest - 1.0; }));
}

/// One response as means of so many samples that the ringing is just resolved.
class EchoScan
{
public:
    EchoScan(const WindowedResponse &response, const SensorTraits &traits)
        : m_rate_Hz(response.sampleRate_Hz)
        , m_samples(std::max<Index>(1, static_cast<Index>(pointLength_s(traits) * m_rate_Hz)))
        , m_first(std::max(kFewest, static_cast<Index>(std::ceil(quietTime_s(traits) / point_s()))))
        , m_sums(runningSums(response.window()))
    {
        for (const RingingTraits &one : traits.ringing)
            m_ringing.push_back({2.0 * std::numbers::pi * one.frequency_Hz * point_s(),
                one.ringTime_s ? point_s() / *one.ringTime_s : 0.0});
        describeNoise(response.noise);
        if (canLook())
            sharpenRinging();
    }

    bool canLook() const
    {
        return m_noise.innovationVariance > 0.0 && points() >= m_first + 2 * kFewest;
    }

    std::optional<Echo> find(const JobControl &control) const
    {
        double most = kCandidate;
        Index place = 0;
        std::optional<Look> known;
        const Index first = m_first + kFewest;
        const Index end = std::min(points() - kFewest + 1, first + kMostLooks * kStride);
        for (Index at = first; at < end; at += kStride) {
            if (control.stopRequested())
                return std::nullopt;
            if (const double gain = lookAt(at, known).gain; gain > most) {
                most = gain;
                place = at;
            }
        }
        return place > 0 ? refined(place) : std::nullopt;
    }

private:
    double point_s() const { return static_cast<double>(m_samples) / m_rate_Hz; }
    Index points() const { return (m_sums.size() - 1) / m_samples; }

    static Eigen::VectorXd runningSums(const Eigen::Ref<const Eigen::VectorXd> &values)
    {
        Eigen::VectorXd sums(values.size() + 1);
        sums[0] = 0.0;
        for (Index k = 0; k < values.size(); ++k)
            sums[k + 1] = sums[k] + values[k];
        return sums;
    }

    static double sumUpTo(const Eigen::VectorXd &sums, double sample)
    {
        if (sample <= 0.0)
            return 0.0;
        const auto k = std::min(static_cast<Index>(sample), sums.size() - 2);
        return sums[k] + (sample - static_cast<double>(k)) * (sums[k + 1] - sums[k]);
    }

    /// Mean of the record over point `at`, `delay` (in points) later.
    double delayed(Index at, double delay) const
    {
        const auto samples = static_cast<double>(m_samples);
        const double begin = (static_cast<double>(at) - delay) * samples;
        return (sumUpTo(m_sums, begin + samples) - sumUpTo(m_sums, begin)) / samples;
    }

    void describeNoise(const Eigen::VectorXd &noise)
    {
        const Eigen::VectorXd sums = runningSums(noise);
        const Index count = noise.size() / m_samples;
        if (count < kFewestNoisePoints)
            return;
        Eigen::VectorXd means(count);
        for (Index j = 0; j < count; ++j)
            means[j] = (sums[(j + 1) * m_samples] - sums[j * m_samples])
                / static_cast<double>(m_samples);
        m_noiseCount = static_cast<double>(count);
        m_noise = chooseAutoregressiveModels(
            {noiseCovariance(means, kLargestNoiseModel)}, kLargestNoiseModel)
                      .front();
    }

    /// The spectrum knows frequency and decay roughly. (a + b t) e^(s t) is a e^((s + b/a) t) to
    /// first order: Gauss-Newton on the stretch where it rings.
    void sharpenRinging()
    {
        constexpr int kRounds = 4;
        const Index to = std::min(points(), m_first + 2 * kReach);
        for (int round = 0; round < kRounds && !m_ringing.empty(); ++round) {
            const Eigen::MatrixXd basis = background(m_first, to);
            if (basis.cols() < kParabola + 4 * std::ssize(m_ringing))
                return; // one is gone already
            const Eigen::VectorXd c = basis.householderQr().solve(record(m_first, to, 0.0));
            for (std::size_t i = 0; i < m_ringing.size(); ++i) {
                const Eigen::Vector4d one = c.segment<4>(kParabola + 4 * static_cast<Index>(i));
                const std::complex<double> change = std::complex<double>(one[2], -one[3])
                    / std::complex<double>(one[0], -one[1]) / static_cast<double>(2 * kReach);
                Ringing &ringing = m_ringing[i];
                if (!(std::abs(change) < 0.1 * ringing.omega))
                    continue;
                ringing.omega += change.imag();
                ringing.decay = std::max(0.3 * ringing.decay, ringing.decay - change.real());
            }
        }
    }

    Index begin(Index at) const { return std::max(m_first / 2, at - kReach); }
    /// The beginning of the record that is the template must end before the echo itself.
    Index end(Index at) const { return std::min({points(), at + kReach, 2 * at}); }

    static bool isGone(const Ringing &one, Index points)
    {
        return one.decay * static_cast<double>(points) > -std::log(kGone);
    }
    /// Whether something of the step's own ringing is left at a point.
    bool rings(Index at) const
    {
        return std::ranges::any_of(
            m_ringing, [at](const Ringing &one) { return !isGone(one, at); });
    }

    void addRinging(Eigen::MatrixXd &basis, Index &column, Index from, Index origin, bool drifts,
        Index begin) const
    {
        for (const Ringing &one : m_ringing) {
            if (isGone(one, from - origin))
                continue;
            const Index width = drifts ? 4 : 2;
            for (Index row = from - begin; row < basis.rows(); ++row) {
                const auto t = static_cast<double>(begin + row - from);
                const double size = std::exp(-one.decay * t);
                const double share = t / static_cast<double>(2 * kReach);
                basis(row, column) = size * std::cos(one.omega * t);
                basis(row, column + 1) = size * std::sin(one.omega * t);
                if (drifts)
                    basis.row(row).segment(column + 2, 2)
                        = share * basis.row(row).segment(column, 2);
            }
            column += width;
        }
    }

    /// A parabola and the resonances, whose frequency and decay may be a little off.
    Eigen::MatrixXd background(Index begin, Index end) const
    {
        Eigen::MatrixXd basis
            = Eigen::MatrixXd::Zero(end - begin, kParabola + 4 * std::ssize(m_ringing));
        for (Index row = 0; row < basis.rows(); ++row) {
            const double t
                = 2.0 * static_cast<double>(row) / static_cast<double>(basis.rows()) - 1.0;
            basis.row(row).head(kParabola) << 1.0, t, t * t;
        }
        Index column = kParabola;
        addRinging(basis, column, begin, 0, true, begin);
        return basis.leftCols(column);
    }

    Eigen::VectorXd record(Index begin, Index end, double delay) const
    {
        Eigen::VectorXd y(end - begin);
        for (Index j = begin; j < end; ++j)
            y[j - begin] = delayed(j, delay);
        return y;
    }

    /// The background of a stretch of points, whitened, under which it keeps its span.
    using Background = Eigen::HouseholderQR<Eigen::MatrixXd>;

    Background backgroundOf(Index begin, Index end) const
    {
        return Background(background(begin + m_noise.order(), end));
    }

    /// What the background leaves of values, whitened.
    Eigen::VectorXd without(const Background &background, const Eigen::VectorXd &values) const
    {
        Eigen::VectorXd rest = whitened(values, m_noise.coefficients);
        rest.applyOnTheLeft(background.householderQ().adjoint());
        return rest.tail(rest.size() - background.cols());
    }

    /// Templates of an echo without their background, and their normal equations.
    struct Templates
    {
        Eigen::MatrixXd h;
        double first = 0.0; ///< square of the first one's length
        Eigen::LDLT<Eigen::MatrixXd> gram;
    };

    Templates without(const Background &background, const Eigen::MatrixXd &templates) const
    {
        Eigen::MatrixXd h(templates.rows() - m_noise.order() - background.cols(), templates.cols());
        for (Index i = 0; i < templates.cols(); ++i)
            h.col(i) = without(background, Eigen::VectorXd(templates.col(i)));
        const Eigen::MatrixXd gram = h.transpose() * h;
        return {std::move(h), gram(0, 0), gram.ldlt()};
    }

    /// `rest`: the record without its background.
    Remainder compare(const Eigen::VectorXd &rest, const Templates &templates) const
    {
        const Eigen::VectorXd inner = templates.h.transpose() * rest;
        const Eigen::VectorXd size = templates.gram.solve(inner);
        const double v = m_noise.innovationVariance;
        return {
            rest.squaredNorm() / v, inner.dot(size) / v, size[0], std::sqrt(v / templates.first)};
    }

    /// What a look has besides the record. Where the record does not ring any more, all looks of
    /// one shape have the same.
    struct Look
    {
        Index before = 0; ///< points
        Index behind = 0;
        Background background;
        Templates templates;
    };

    /// A level and resonances of any phase from point `at` on; `known`: of the look before.
    Remainder lookAt(Index at, std::optional<Look> &known) const
    {
        const Index from = begin(at);
        const Index to = end(at);
        const bool isKnown = known && known->before == at - from && known->behind == to - at
            && known->background.cols() == kParabola && !rings(from + m_noise.order());
        if (!isKnown) {
            Eigen::MatrixXd level = Eigen::MatrixXd::Zero(to - from, 1 + 2 * std::ssize(m_ringing));
            level.col(0).tail(to - at).setOnes();
            Index column = 1;
            addRinging(level, column, at, at, false, from);
            Background behind = backgroundOf(from, to);
            Templates templates = without(behind, level);
            known = Look{at - from, to - at, std::move(behind), std::move(templates)};
        }
        return compare(without(known->background, record(from, to, 0.0)), known->templates);
    }

    double freedom(Index count) const
    {
        return static_cast<double>(count) - 3.0 - 4.0 * static_cast<double>(m_ringing.size());
    }

    /// Whether what the echo leaves of so many points is noise; the noise itself is known from so
    /// many points only.
    bool explains(const Remainder &found, Index count) const
    {
        const double left = found.before - found.gain;
        const double n = freedom(count);
        const double chance = std::sqrt(2.0 * n + 2.0 * n * n / m_noiseCount);
        return found.gain >= kCandidate * std::max(1.0, left / n)
            && left - n <= kLeftOver * found.gain + kByChance * chance;
    }

    /// The beginning of the record in place of the looks, at any delay near that point.
    std::optional<Echo> refined(Index place) const
    {
        constexpr double kFine = 0.1; // points
        constexpr Index kNear = 2 * kStride;
        const Index from = begin(place);
        const Index to = end(std::max(m_first, place - kNear));
        const Background one = backgroundOf(from, to); // for all delays
        const Eigen::VectorXd rest = without(one, record(from, to, 0.0));
        std::vector<double> delays;
        std::vector<Remainder> found;
        const auto last = static_cast<double>(std::min(to - kFewest / 2, place + kNear));
        for (auto delay = static_cast<double>(std::max(m_first, place - kNear)); delay <= last;
             delay += kFine) {
            delays.push_back(delay);
            found.push_back(compare(rest, without(one, Eigen::MatrixXd(record(from, to, delay)))));
        }
        const auto best = std::ranges::max_element(found, {}, &Remainder::gain);
        if (best == found.end() || !explains(*best, to - from))
            return std::nullopt;
        const double u_points = 0.5 * kFine * nearTheTop(found, best->gain);
        const double sample = 1.0 / static_cast<double>(m_samples) / std::sqrt(12.0);
        const double delay = delays[static_cast<std::size_t>(best - found.begin())];
        return Echo{0, delay * point_s(), std::hypot(u_points, sample) * point_s(), best->size,
            best->u_size};
    }

    double m_rate_Hz = 0.0;
    Index m_samples = 1; ///< per point
    Index m_first = 0; ///< point behind which an echo can be told
    std::vector<Ringing> m_ringing;
    Eigen::VectorXd m_sums; ///< of the record up to each sample
    AutoregressiveModel m_noise; ///< of points
    double m_noiseCount = 0.0; ///< points it is known from
};

} // namespace

std::optional<Echo> findEcho(
    const WindowedResponse &response, const SensorTraits &traits, const JobControl &control)
{
    if (traits.ringing.empty() && !traits.riseTime_s)
        return std::nullopt;
    const EchoScan scan(response, traits);
    auto echo = scan.canLook() ? scan.find(control) : std::nullopt;
    if (echo)
        echo->shot = response.shot;
    return echo;
}

} // namespace dyncal
