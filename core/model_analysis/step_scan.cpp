// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/step_scan.h"

#include "core/model_analysis/bisection.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

/// A stretch of time with evenly spaced points.
struct TimeGrid
{
    double begin_s = 0.0;
    double length_s = 0.0;
    double rate_Hz = 0.0; ///< points per second, at least
};

/// Forty points per radian of the fastest remaining part; a part remains until it has decayed to
/// e^-8 and to 1e-4 of the plateau. So a slow part does not make the grid of a fast one coarse, and
/// nearly equal poles, whose amplitudes are huge, do not end it early.
std::vector<TimeGrid> timeGrids(const ExponentialSum &y)
{
    constexpr double kMostPoints = 1e6; ///< in all: 80 per period for a zeta of 1e-4
    constexpr double kLeft = 1e-4;
    const Index parts = y.poles_rad_s.size();
    Eigen::ArrayXd ends_s(parts);
    for (Index i = 0; i < parts; ++i) {
        const double size = std::abs(y.amplitudes[i]) / kLeft * static_cast<double>(parts);
        const double timeConstants = size > 0.0 ? std::max(8.0, std::log(size)) : 8.0;
        ends_s[i] = timeConstants / -y.poles_rad_s[i].real();
    }
    std::vector<TimeGrid> grids;
    double points = 0.0;
    for (double begin_s = 0.0; begin_s < ends_s.maxCoeff();) {
        double end_s = ends_s.maxCoeff();
        double fastest = 0.0;
        for (Index i = 0; i < parts; ++i) {
            if (ends_s[i] <= begin_s)
                continue;
            end_s = std::min(end_s, ends_s[i]);
            fastest = std::max(fastest, std::abs(y.poles_rad_s[i]));
        }
        grids.push_back({begin_s, end_s - begin_s, 40.0 * fastest});
        points += grids.back().length_s * grids.back().rate_Hz;
        begin_s = end_s;
    }
    for (TimeGrid &grid : grids)
        grid.rate_Hz *= std::min(1.0, kMostPoints / points);
    return grids;
}

/// Follows a step response from its start and keeps the values that the characteristics need.
class StepScan
{
public:
    /// `settled`: half width of the range about 1 that is settled.
    StepScan(const ExponentialSum &y, double settled)
        : m_y(y)
        , m_settled(settled)
        , m_value(y.value(0.0))
        , m_top(m_value)
    {
        if (m_value >= 0.1)
            m_t10 = 0.0;
        if (m_value >= 0.9)
            m_t90 = 0.0;
    }

    /// Whether what follows can still change something.
    bool follow(const TimeGrid &grid)
    {
        ExponentialSum later = m_y;
        later.amplitudes.array() *= (m_y.poles_rad_s.array() * grid.begin_s).exp();
        const double count = std::ceil(grid.length_s * grid.rate_Hz);
        const double step_s = grid.length_s / count;
        const ExponentialSampler sampler(later, step_s);
        Eigen::VectorXd values;
        for (Index k = 1; k <= static_cast<Index>(count); ++k) {
            const double t_s = grid.begin_s + static_cast<double>(k) * step_s;
            if (k == 1 || k % ExponentialSampler::kBlock == 0) {
                if (isSettledAfter(t_s - step_s))
                    return false;
                values = sampler.block(k / ExponentialSampler::kBlock);
            }
            step(t_s, step_s, values[k % ExponentialSampler::kBlock]);
        }
        return true;
    }

    void describe(StepCharacteristics &result) const
    {
        if (m_t10 && m_t90)
            result.riseTime_s = *m_t90 - *m_t10;
        if (m_lastPassage)
            result.settlingTime_s = crossing(*m_lastPassage);
        result.overshoot_percent = std::max(0.0, 100.0 * (top() - 1.0));
        result.top_s = m_topTime_s;
    }

private:
    /// Between two points in time the response passes a level.
    struct Passage
    {
        double from_s = 0.0;
        double to_s = 0.0;
        double level = 0.0;
    };

    /// No later value leaves the settled range or is above the highest.
    bool isSettledAfter(double t_s) const
    {
        return m_t90 && restAfter(m_y, t_s) < std::min(m_settled, m_top - 1.0);
    }

    double crossing(const Passage &passage) const
    {
        return bisect(
            [&](double x) { return m_y.value(x) - passage.level; }, passage.from_s, passage.to_s);
    }

    void step(double t_s, double step_s, double now)
    {
        if (!m_t10 && now >= 0.1)
            m_t10 = crossing({m_time_s, t_s, 0.1});
        if (!m_t90 && now >= 0.9)
            m_t90 = crossing({m_time_s, t_s, 0.9});
        if (now > m_top) {
            m_top = now;
            m_topTime_s = t_s;
            m_topStep_s = step_s;
        }
        if ((std::abs(m_value - 1.0) > m_settled) != (std::abs(now - 1.0) > m_settled)) {
            const double level = std::abs(m_value - 1.0) > m_settled ? m_value : now;
            m_lastPassage = {m_time_s, t_s, level > 1.0 ? 1.0 + m_settled : 1.0 - m_settled};
        }
        m_time_s = t_s;
        m_value = now;
    }

    /// Parabola through the highest grid point and its neighbours; at the onset there is no left
    /// one.
    double top() const
    {
        const double left = m_y.value(m_topTime_s - m_topStep_s);
        const double right = m_y.value(m_topTime_s + m_topStep_s);
        const double curvature = left - 2.0 * m_top + right;
        if (m_topTime_s == 0.0 || !(curvature < 0.0))
            return m_top;
        return m_top - (right - left) * (right - left) / (8.0 * curvature);
    }

    const ExponentialSum &m_y;
    double m_settled;
    double m_time_s = 0.0;
    double m_value;
    std::optional<double> m_t10;
    std::optional<double> m_t90;
    std::optional<Passage> m_lastPassage; ///< into the settled range or out of it
    double m_top;
    double m_topTime_s = 0.0;
    double m_topStep_s = 0.0;
};

} // namespace

double restAfter(const ExponentialSum &y, double t_s)
{
    return (y.amplitudes.array().abs() * (t_s * y.poles_rad_s.array().real()).exp()).sum();
}

StepCharacteristics describedStep(const ExponentialSum &y, double settled)
{
    StepScan scan(y, settled);
    for (const TimeGrid &grid : timeGrids(y))
        if (!scan.follow(grid))
            break;
    StepCharacteristics result;
    scan.describe(result);
    return result;
}

} // namespace dyncal
