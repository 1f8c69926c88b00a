// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/fault_isolation.h"

#include "core/base/distributions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace dyncal {
namespace {

constexpr double kLeastChance = 1e-3;
constexpr double kShareLeft = 0.02;
/// Relative: what no budget holds, so that no difference counts as exact.
constexpr double kLeftOut = 5e-4;

/// A fault as something to take back from one shot's point; false where it cannot be.
struct Fault
{
    FindingCause cause;
    double usual; ///< size that is not surprising, in its own unit
    double largest; ///< beyond, it is not believed
    bool perShot;
    std::function<bool(const ShotEvidence &, double, CheckPoint &)> takeBack;
};

bool changeMolarMass(const ShotEvidence &evidence, double size, CheckPoint &point)
{
    point.step.molarMassShift_kg_mol += evidence.molarMass_kg_mol * (std::exp(-2.0 * size) - 1.0);
    return std::isfinite(evidence.molarMass_kg_mol);
}

bool changeHumidity(const ShotEvidence &evidence, double size, CheckPoint &point)
{
    if (!evidence.measurement)
        return false;
    const std::string &gas = evidence.measurement->gas.substance;
    const double humidity = point.step.state.relativeHumidity + size;
    if ((gas != "humid-air" && gas != kMoistAir) || humidity < 0.0 || humidity > 1.0)
        return false;
    point.step.state.relativeHumidity = humidity;
    return true;
}

/// A typed step is used as it is, a typed velocity makes the states.
bool changeTyped(const ShotEvidence &evidence, double size, CheckPoint &point)
{
    const bool velocity = evidence.measurement && !evidence.measurement->velocity.fit;
    if (evidence.typedStep_Pa)
        point.step.stepFactor *= std::exp(size);
    else if (velocity)
        point.step.velocityShift_m_s
            += *evidence.measurement->velocity.velocity_m_s * (std::exp(size) - 1.0);
    return evidence.typedStep_Pa || velocity;
}

bool changeDelays(const ShotEvidence &evidence, double size_s, CheckPoint &point)
{
    for (Index i = 0; i < point.step.delay_s.size(); ++i)
        if (!evidence.readings[static_cast<std::size_t>(i)].isDut)
            point.step.delay_s[i] += size_s;
    return point.step.delay_s.size() > 0;
}

Fault distanceOf(Index place)
{
    return {FindingCause::Distance, 0.02, 0.5, false,
        [place](const ShotEvidence &evidence, double size_m, CheckPoint &point) {
            if (place >= point.step.distance_m.size()
                || evidence.readings[static_cast<std::size_t>(place)].isDut)
                return false;
            point.step.distance_m[place] += size_m;
            return point.step.distance_m[place] > 0.0;
        }};
}

std::vector<Fault> faults(Index places)
{
    using C = FindingCause;
    const auto plain = [](const std::function<void(double, CheckPoint &)> &change) {
        return [change](const ShotEvidence &, double size, CheckPoint &point) {
            change(size, point);
            return true;
        };
    };
    std::vector<Fault> list{
        {C::Typed, 1.0, 4.0, true, changeTyped},
        {C::Rate, 1.0, 7.0, false,
            plain([](double s, CheckPoint &p) { p.timeFactor *= std::exp(s); })},
        {C::Gas, 0.3, 2.0, false, changeMolarMass},
        {C::Temperature, 10.0, 60.0, false,
            plain([](double s, CheckPoint &p) { p.step.state.temperature_K += s; })},
        {C::Humidity, 0.5, 1.0, false, changeHumidity},
        {C::Pressure, 0.1, 4.0, false,
            plain([](double s, CheckPoint &p) { p.step.state.pressure_Pa *= std::exp(s); })},
        {C::Scale, 1.0, 12.0, false,
            plain([](double s, CheckPoint &p) { p.level *= std::exp(s); })},
        {C::Scale, 0.1, 12.0, false, plain([](double s, CheckPoint &p) { p.gain *= std::exp(s); })},
        {C::Attenuation, 0.005, 0.05, false,
            plain([](double s, CheckPoint &p) { p.step.attenuation_per_m += s; })},
        {C::Delay, 2e-6, 2e-5, false, changeDelays},
    };
    for (Index i = 0; i < places; ++i)
        list.push_back(distanceOf(i));
    return list;
}

/// Least squares over the sizes of one fault.
class Isolation
{
public:
    Isolation(const ComparedShots &shots, const Fault &fault)
        : m_shots(shots)
        , m_fault(fault)
        , m_solver(shots.covariance())
    {
    }

    std::optional<ExplainedBy> find()
    {
        const Index count = m_fault.perShot ? std::ssize(m_shots.ways()) : 1;
        Eigen::VectorXd size = Eigen::VectorXd::Zero(count);
        Eigen::VectorXd left = differencesAt(size);
        if (left.size() == 0)
            return std::nullopt;
        double chiSquare = squares(left);
        Eigen::MatrixXd J;
        for (int i = 0; i < 40; ++i) {
            auto slope = jacobian(size, left);
            if (!slope)
                break;
            J = std::move(*slope);
            if (!step(J, size, left, chiSquare))
                break;
        }
        if (J.size() == 0 || size.cwiseAbs().maxCoeff() > m_fault.largest)
            return std::nullopt;
        return explained(J, size, chiSquare);
    }

private:
    Eigen::VectorXd differencesAt(const Eigen::VectorXd &size) const
    {
        std::vector<CheckPoint> points;
        for (std::size_t i = 0; i < m_shots.ways().size(); ++i) {
            const ShotWays &ways = *m_shots.ways()[i];
            points.push_back(ways.nominal());
            const double s = size[m_fault.perShot ? static_cast<Index>(i) : 0];
            if (!m_fault.takeBack(ways.evidence(), s, points.back()))
                return {};
        }
        return m_shots.differencesAt(points);
    }

    double squares(const Eigen::VectorXd &d) const { return d.dot(m_solver.solve(d)); }

    std::optional<Eigen::MatrixXd> jacobian(
        const Eigen::VectorXd &size, const Eigen::VectorXd &at) const
    {
        const double h = 1e-3 * m_fault.usual;
        Eigen::MatrixXd J(at.size(), size.size());
        for (Index k = 0; k < size.size(); ++k) {
            Eigen::VectorXd moved = size;
            moved[k] += h;
            Eigen::VectorXd there = differencesAt(moved);
            double width = h;
            if (there.size() == 0) { // at the end of its range
                moved[k] -= 2.0 * h;
                there = differencesAt(moved);
                width = -h;
            }
            if (there.size() == 0)
                return std::nullopt;
            J.col(k) = (there - at) / width;
        }
        return J;
    }

    /// A damped Gauss-Newton step; false where nothing is gained any more.
    bool step(const Eigen::MatrixXd &J, Eigen::VectorXd &size, Eigen::VectorXd &left,
        double &chiSquare) const
    {
        Eigen::MatrixXd normal = J.transpose() * m_solver.solve(J);
        normal.diagonal().array() += 1e-30;
        Eigen::VectorXd change = -normal.ldlt().solve(J.transpose() * m_solver.solve(left));
        const double longest = change.cwiseAbs().maxCoeff();
        if (!(longest > 0.0) || !std::isfinite(longest))
            return false;
        change *= std::min(1.0, m_fault.usual / longest);
        for (int half = 0; half < 12; ++half, change *= 0.5) {
            const Eigen::VectorXd there = differencesAt(size + change);
            if (there.size() == 0 || !there.allFinite())
                continue;
            const double smaller = squares(there);
            if (!(smaller < chiSquare))
                continue;
            const bool worthwhile = chiSquare - smaller > 1e-6 * chiSquare;
            size += change;
            left = there;
            chiSquare = smaller;
            return worthwhile;
        }
        return false;
    }

    ExplainedBy explained(
        const Eigen::MatrixXd &J, const Eigen::VectorXd &size, double chiSquare) const
    {
        ExplainedBy result{m_fault.cause, chiSquare, {}};
        const Eigen::VectorXd u = m_shots.covariance().diagonal().cwiseSqrt();
        for (Index row = 0; row < J.rows(); ++row)
            result.moves.push_back(
                (J.row(row).transpose().cwiseProduct(size)).cwiseAbs().maxCoeff() > 0.5 * u[row]);
        // A surprising size counts against it, so that the likeliest comes first.
        result.chiSquare += (size / m_fault.usual).squaredNorm();
        return result;
    }

    const ComparedShots &m_shots;
    const Fault &m_fault;
    Eigen::LDLT<Eigen::MatrixXd> m_solver;
};

double degreesLeft(const ComparedShots &shots, bool perShot)
{
    const Index used = perShot ? std::ssize(shots.ways()) : 1;
    return static_cast<double>(std::max<Index>(shots.differences().size() - used, 1));
}

/// Several places or sensors may give the same cause: the one that leaves least stands for it.
void keepBest(std::vector<ExplainedBy> &list)
{
    std::ranges::stable_sort(list, {}, &ExplainedBy::chiSquare);
    std::vector<ExplainedBy> best;
    for (ExplainedBy &candidate : list)
        if (std::ranges::find(best, candidate.cause, &ExplainedBy::cause) == best.end())
            best.push_back(std::move(candidate));
    list = std::move(best);
}

} // namespace

ComparedShots::ComparedShots(const std::vector<std::unique_ptr<ShotWays>> &shots)
{
    for (const auto &shot : shots)
        addShot(*shot);
    finish();
}

void ComparedShots::addShot(const ShotWays &shot)
{
    const auto value = shot.values(shot.nominal());
    std::vector<Index> known;
    for (Index way = 0; value && way < value->size() / 2; ++way)
        if (std::isfinite((*value)[2 * way]) && std::isfinite((*value)[2 * way + 1]))
            known.push_back(way);
    const auto measurement = [&](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
        const auto all = shot.values(shot.at(x));
        if (!all)
            return all;
        Eigen::VectorXd some(2 * std::ssize(known));
        for (Index i = 0; i < std::ssize(known); ++i)
            some.segment<2>(2 * i) = all->segment<2>(2 * known[static_cast<std::size_t>(i)]);
        return some;
    };
    const auto budget = value ? propagateGum(shot.inputs(), measurement)
                              : Result<GumBudget>(tl::unexpected(value.error()));
    if (budget && !known.empty())
        m_ways.push_back(&shot);
    const Message none{DYNCAL_TEXT("core", "One of the two ways gives no value here."), {}};
    for (std::size_t way = 0; way < shot.made().size(); ++way) {
        const auto found = std::ranges::find(known, static_cast<Index>(way));
        if (budget && found != known.end()) {
            addWay(shot, way, *value, *budget, found - known.begin());
            continue;
        }
        m_comparisons.push_back(shot.made()[way]);
        m_comparisons.back().missing = budget ? none : budget.error().message;
    }
    m_comparisons.insert(m_comparisons.end(), shot.missing().begin(), shot.missing().end());
}

void ComparedShots::addWay(const ShotWays &shot, std::size_t way, const Eigen::VectorXd &value,
    const GumBudget &budget, Index at)
{
    WayComparison comparison = shot.made()[way];
    comparison.value_a = value[static_cast<Index>(2 * way)];
    comparison.value_b = value[static_cast<Index>(2 * way + 1)];
    const double ratio = comparison.value_a / comparison.value_b;
    double variance = 0.0;
    for (const BudgetLine &line : budget.lines) {
        const double of_a = line.contribution[2 * at];
        const double of_b = line.contribution[2 * at + 1];
        variance += (of_a - of_b) * (of_a - of_b);
        const std::string name = line.input.common
            ? line.input.quantity
            : line.input.quantity + "#" + std::to_string(comparison.shot);
        if (ratio > 0.0)
            m_contributions[name].emplace_back(
                std::ssize(m_rows), of_a / comparison.value_a - of_b / comparison.value_b);
    }
    comparison.u = std::sqrt(variance);
    m_comparisons.push_back(std::move(comparison));
    if (!(ratio > 0.0))
        return;
    m_list.push_back(std::log(ratio));
    m_rows.push_back({m_ways.size() - 1, way});
}

void ComparedShots::finish()
{
    const Index count = std::ssize(m_rows);
    m_differences = Eigen::Map<const Eigen::VectorXd>(m_list.data(), count);
    m_covariance = Eigen::MatrixXd::Identity(count, count) * (kLeftOut * kLeftOut);
    for (const auto &[name, moved] : m_contributions)
        for (const auto &[row, by] : moved)
            for (const auto &[other, byOther] : moved)
                m_covariance(row, other) += by * byOther;
}

Eigen::VectorXd ComparedShots::differencesAt(const std::vector<CheckPoint> &points) const
{
    Eigen::VectorXd differences(std::ssize(m_rows));
    std::vector<Eigen::VectorXd> values;
    for (std::size_t i = 0; i < m_ways.size(); ++i) {
        auto there = m_ways[i]->values(points[i]);
        if (!there)
            return {};
        values.push_back(std::move(*there));
    }
    for (Index row = 0; row < differences.size(); ++row) {
        const auto [shot, way] = m_rows[static_cast<std::size_t>(row)];
        const auto at = static_cast<Index>(2 * way);
        const double ratio = values[shot][at] / values[shot][at + 1];
        if (!(ratio > 0.0 && std::isfinite(ratio)))
            return {};
        differences[row] = std::log(ratio);
    }
    return differences;
}

std::vector<ExplainedBy> explanations(const ComparedShots &shots)
{
    std::vector<ExplainedBy> likely, others;
    const Eigen::VectorXd &d = shots.differences();
    if (d.size() == 0)
        return likely;
    const double whole = d.dot(shots.covariance().ldlt().solve(d));
    Index places = 0;
    for (const ShotWays *ways : shots.ways())
        places = std::max(places, static_cast<Index>(ways->evidence().readings.size()));
    for (const Fault &fault : faults(places)) {
        auto found = Isolation(shots, fault).find();
        if (!found || found->chiSquare > 0.9 * whole)
            continue;
        const double chance
            = chiSquareSurvival(found->chiSquare, degreesLeft(shots, fault.perShot));
        const bool explains = chance > kLeastChance || found->chiSquare < kShareLeft * whole;
        (explains ? likely : others).push_back(std::move(*found));
    }
    keepBest(likely);
    keepBest(others);
    if (likely.empty() && !others.empty())
        likely.push_back(others.front());
    return likely;
}

} // namespace dyncal
