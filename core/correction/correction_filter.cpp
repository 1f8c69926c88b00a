// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/correction_filter.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/signal/fft.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kShortestGrid = 4096;
constexpr Index kLongestGrid = 1 << 20;
constexpr double kGridPerEdge = 32.0; ///< first length of the grid, in rate over the transition

Eigen::VectorXd gridOf(double rate_Hz, Index n)
{
    return Eigen::VectorXd::LinSpaced(n / 2 + 1, 0.0, 0.5 * rate_Hz);
}

Eigen::VectorXcd lowPassOn(const LowPass &lowPass, const Eigen::VectorXd &frequency_Hz)
{
    Eigen::VectorXcd values(frequency_Hz.size());
    for (Index i = 0; i < values.size(); ++i)
        values[i] = lowPass.at(frequency_Hz[i]);
    return values;
}

/// How many samples of the impulse response before and behind 0 are kept.
struct Extent
{
    Index before = 0;
    Index behind = 0;
};

/// The impulse response on the grid (circular, 0 first), and what cutting it costs.
class CircularInverse
{
public:
    CircularInverse(const KnownResponse &response, const LowPass &lowPass, double rate_Hz, Index n)
        : m_fft(n)
        , m_S(response.at(gridOf(rate_Hz, n)))
        , m_impulse(m_fft.inverse(lowPassOn(lowPass, gridOf(rate_Hz, n)).cwiseQuotient(m_S).eval()))
        , m_inBand(1 + static_cast<Index>(lowPass.band_Hz / rate_Hz * static_cast<double>(n)))
    {
    }

    Index half() const { return m_impulse.size() / 2 - 1; }
    const RealFft &fft() const { return m_fft; }
    const Eigen::VectorXd &impulse() const { return m_impulse; }

    double passError(Extent extent) const
    {
        Eigen::VectorXd cut = m_impulse;
        cut.head(extent.behind + 1).setZero();
        cut.tail(extent.before).setZero();
        const Eigen::VectorXcd lost = m_fft.forward(cut);
        return lost.cwiseProduct(m_S).head(std::min(m_inBand, m_S.size())).cwiseAbs().maxCoeff();
    }

    /// The shortest stretch, found on either side alone with half of the error each.
    Extent shortest() const
    {
        const Index before = fewest([this](Index n) {
            return passError({n, half()}) <= 0.5 * kLargestPassError;
        });
        const Index behind = fewest([this](Index n) {
            return passError({half(), n}) <= 0.5 * kLargestPassError;
        });
        return {before, behind};
    }

private:
    /// The smallest number up to half() that is enough; half() where none is.
    template <typename IsEnough>
    Index fewest(const IsEnough &isEnough) const
    {
        Index low = 0;
        Index high = half();
        while (low < high) {
            const Index middle = low + (high - low) / 2;
            if (isEnough(middle))
                high = middle;
            else
                low = middle + 1;
        }
        return high;
    }

    RealFft m_fft;
    Eigen::VectorXcd m_S;
    Eigen::VectorXd m_impulse;
    Index m_inBand;
};

/// The kept stretch of a circular impulse response, earliest sample first.
Eigen::VectorXd stretchOf(const Eigen::VectorXd &circular, Extent extent)
{
    Eigen::VectorXd taps(extent.before + extent.behind + 1);
    taps << circular.tail(extent.before), circular.head(extent.behind + 1);
    return taps;
}

Index firstGrid(const LowPass &lowPass, double rate_Hz)
{
    const double transition_Hz = lowPass.kind == LowPassKind::Gaussian
        ? lowPass.edge_Hz - lowPass.band_Hz
        : lowPass.band_Hz;
    Index n = kShortestGrid;
    while (n < kLongestGrid && static_cast<double>(n) * transition_Hz < kGridPerEdge * rate_Hz)
        n *= 2;
    return n;
}

/// Of the grid on which the kept stretch fills less than half.
struct FoundInverse
{
    CircularInverse inverse;
    Extent extent;
};

Result<FoundInverse> findInverse(
    const KnownResponse &response, const LowPass &lowPass, double rate_Hz)
{
    for (Index n = firstGrid(lowPass, rate_Hz); n <= kLongestGrid; n *= 2) {
        CircularInverse inverse(response, lowPass, rate_Hz, n);
        const Extent extent = inverse.shortest();
        if (extent.before + extent.behind < inverse.half()
            && inverse.passError(extent) <= kLargestPassError)
            return FoundInverse{std::move(inverse), extent};
    }
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "The inverse of the response up to %1 does not die away within %2 samples at %3; ask for another band (--band, --edge)."),
            {numberWithUnit(lowPass.band_Hz, "Hz"), std::to_string(kLongestGrid / 2),
                numberWithUnit(rate_Hz, "Hz")}});
}

/// The delay asked for, where it is enough.
Result<Extent> withDelay(FoundInverse &found, double rate_Hz, std::optional<double> delay_s)
{
    if (!delay_s)
        return found.extent;
    const double samples = std::round(*delay_s * rate_Hz);
    const double needed_s = static_cast<double>(found.extent.before) / rate_Hz;
    if (samples >= 0.0 && samples <= static_cast<double>(found.inverse.half())) {
        const Extent asked{static_cast<Index>(samples), found.extent.behind};
        if (found.inverse.passError(asked) <= kLargestPassError)
            return asked;
    }
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The delay %1 (--delay) is not possible for this band: the filter needs at least %2 and takes at most %3."),
            {numberWithUnit(*delay_s, "s"), numberWithUnit(needed_s, "s"),
                numberWithUnit(static_cast<double>(found.inverse.half()) / rate_Hz, "s")}});
}

/// Column by column: all of them on a long grid would take gigabytes.
Eigen::MatrixXd tapErrorsOf(
    const KnownResponse &response, const CircularInverse &circular, double rate_Hz, Extent extent)
{
    const Eigen::VectorXcd inverse = circular.fft().forward(circular.impulse());
    Eigen::MatrixXd columns(
        extent.before + extent.behind + 1, static_cast<Index>(response.errors.size()));
    for (Index j = 0; j < columns.cols(); ++j) {
        const ResponseError &error = response.errors[static_cast<std::size_t>(j)];
        const Eigen::VectorXcd change = inverseChange(inverse, response, error, rate_Hz);
        columns.col(j) = stretchOf(circular.fft().inverse(change), extent);
    }
    return columns;
}

/// "Pa/V" of "V/Pa".
std::string inverted(const std::string &unit)
{
    const std::size_t slash = unit.find('/');
    return slash == std::string::npos ? "1/" + unit
                                      : unit.substr(slash + 1) + "/" + unit.substr(0, slash);
}

void addErrors(CorrectionFilter &filter, const KnownResponse &response)
{
    filter.errorDof.resize(static_cast<Index>(response.errors.size()));
    for (const ResponseError &error : response.errors) {
        filter.errorDof[static_cast<Index>(filter.errorNames.size())] = error.dof;
        filter.errorNames.push_back(error.quantity);
    }
}

/// The knots that matter, carried by the shape of the model where there is one.
Result<KnownResponse> usedResponse(const KnownResponse &response, const LowPass &lowPass)
{
    constexpr Index kFewestKnots = 4;
    KnownResponse part = response.upTo(lowPass.edge_Hz);
    const bool isTable = part.shape.s_rad_s.size() == 0 || part.knot_Hz.size() < kFewestKnots;
    return isTable ? part : carriedByShape(std::move(part));
}

CorrectionFilter filterOf(const KnownResponse &response, const LowPass &lowPass, double rate_Hz,
    const FoundInverse &found, Extent extent)
{
    CorrectionFilter filter;
    filter.rate_Hz = rate_Hz;
    filter.lowPass = lowPass;
    filter.delaySamples = extent.before;
    filter.taps = stretchOf(found.inverse.impulse(), extent);
    filter.tapErrors = tapErrorsOf(response, found.inverse, rate_Hz, extent);
    filter.passError = found.inverse.passError(extent);
    filter.unit = inverted(response.unit);
    addErrors(filter, response);
    return filter;
}

} // namespace

Eigen::VectorXcd inverseOf(
    const KnownResponse &response, const LowPass &lowPass, double rate_Hz, Index n)
{
    const Eigen::VectorXd frequency_Hz = gridOf(rate_Hz, n);
    return lowPassOn(lowPass, frequency_Hz).cwiseQuotient(response.at(frequency_Hz));
}

Eigen::VectorXcd inverseChange(const Eigen::VectorXcd &inverse, const KnownResponse &response,
    const ResponseError &error, double rate_Hz)
{
    const Eigen::VectorXd frequency_Hz = gridOf(rate_Hz, 2 * (inverse.size() - 1));
    return -inverse.cwiseProduct(response.changeBy(error, frequency_Hz));
}

Eigen::VectorXcd CorrectionFilter::at(const Eigen::VectorXd &frequency_Hz) const
{
    Eigen::VectorXcd values = Eigen::VectorXcd::Zero(frequency_Hz.size());
    for (Index i = 0; i < values.size(); ++i)
        for (Index k = 0; k < taps.size(); ++k)
            values[i] += taps[k]
                * std::polar(1.0,
                    -kTwoPi * frequency_Hz[i] / rate_Hz * static_cast<double>(k - delaySamples));
    return values;
}

double CorrectionFilter::noiseAmplification() const
{
    constexpr Index kGridOverTaps = 4;
    const RealFft fft(fastFftLength(std::max(kShortestGrid, kGridOverTaps * taps.size())));
    return fft.forward(taps).cwiseAbs().maxCoeff() / std::abs(gain());
}

Result<CorrectionFilter> designCorrection(
    const KnownResponse &response, double rate_Hz, const CorrectionSettings &settings)
{
    const Result<LowPass> lowPass = requestedLowPass(response, rate_Hz, settings);
    if (!lowPass)
        return tl::unexpected<Error>(lowPass.error());
    const Result<KnownResponse> used = usedResponse(response, *lowPass);
    if (!used)
        return tl::unexpected<Error>(used.error());
    Result<FoundInverse> found = findInverse(*used, *lowPass, rate_Hz);
    if (!found)
        return tl::unexpected<Error>(found.error());
    return withDelay(*found, rate_Hz, settings.delay_s).map([&](Extent extent) {
        return filterOf(*used, *lowPass, rate_Hz, *found, extent);
    });
}

} // namespace dyncal
