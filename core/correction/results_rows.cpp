// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/results_rows.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/correction/results_model.h"

#include <cmath>
#include <map>
#include <set>

namespace dyncal {
namespace {

using Json = nlohmann::json;

constexpr double kSameU = 1e-3; ///< relative, between a u and its lines

/// Of several lines that are one input: what it does to each knot.
struct InputEffect
{
    Eigen::VectorXd relative;
    double dof = std::numeric_limits<double>::infinity();
};

enum class Part { Magnitude, Phase };

/// Lines of a budget gathered by input: a row's own under the row's number.
class GatheredLines
{
public:
    explicit GatheredLines(const MeasuredRows &rows)
        : m_knots(rows.frequency_Hz.size() + 1)
        , m_variance{Eigen::VectorXd::Zero(m_knots), Eigen::VectorXd::Zero(m_knots)}
    {
    }

    void add(const Json &line, Part part, Index knot, double unit)
    {
        const double effect = numberAt(line, "contribution") / unit;
        const std::string quantity = textAt(line, "quantity");
        const double shot = numberAt(line, "shot");
        std::string key = quantity + "|" + (std::isnan(shot) ? "" : numberText(shot));
        if (ofOneRow().contains(quantity))
            key.append("|").append(std::to_string(knot));
        InputEffect &input = m_inputs[static_cast<std::size_t>(part)]
                                 .try_emplace(key, InputEffect{Eigen::VectorXd::Zero(m_knots)})
                                 .first->second;
        input.relative[knot] += effect;
        if (const double dof = numberAt(line, "dof"); dof > 0.0)
            input.dof = std::min(input.dof, dof);
        m_variance[static_cast<std::size_t>(part)][knot] += effect * effect;
    }

    double u(Part part, Index knot) const
    {
        return std::sqrt(m_variance[static_cast<std::size_t>(part)][knot]);
    }

    std::vector<ResponseError> errors() const
    {
        std::vector<ResponseError> list;
        for (const Part part : {Part::Magnitude, Part::Phase})
            for (const auto &[key, input] : m_inputs[static_cast<std::size_t>(part)])
                if (!input.relative.isZero(0.0))
                    list.push_back(
                        {key.substr(0, key.find('|')), asComplex(input.relative, part), input.dof});
        return list;
    }

private:
    /// What each row has of its own; every other line stands for one input of all rows.
    static const std::set<std::string> &ofOneRow()
    {
        static const std::set<std::string> names{"noise", "end_of_record", "aliasing"};
        return names;
    }

    static Eigen::VectorXcd asComplex(const Eigen::VectorXd &relative, Part part)
    {
        return relative
            * (part == Part::Magnitude ? std::complex<double>(1.0)
                                       : std::complex<double>(0.0, 1.0));
    }

    Index m_knots;
    std::array<std::map<std::string, InputEffect>, 2> m_inputs;
    std::array<Eigen::VectorXd, 2> m_variance;
};

/// Knots by the name that a budget's line has in `of`.
struct KnotOfLine
{
    Part part = Part::Magnitude;
    Index knot = 0;
    double unit = 1.0; ///< that contributions are in
};

std::map<std::string, KnotOfLine> knotsOfLines(const MeasuredRows &rows, double sensitivity)
{
    std::map<std::string, KnotOfLine> knots;
    knots["sensitivity"] = {Part::Magnitude, 0, sensitivity};
    for (std::size_t i = 0; i < rows.number.size(); ++i) {
        const std::string place = "[" + std::to_string(rows.number[i]) + "]";
        const auto at = static_cast<Index>(i);
        knots["response.magnitude" + place] = {Part::Magnitude, at + 1, std::abs(rows.S[at])};
        knots["response.phase_rad" + place] = {Part::Phase, at + 1, 1.0};
    }
    return knots;
}

bool isSame(double stated, double found)
{
    return std::abs(stated - found) <= kSameU * stated;
}

Result<void> checkLines(const GatheredLines &lines, const MeasuredRows &rows)
{
    for (Index i = 0; i < rows.frequency_Hz.size(); ++i) {
        const double relative = rows.u_magnitude[i] / std::abs(rows.S[i]);
        const double magnitude = lines.u(Part::Magnitude, i + 1);
        const double phase_rad = lines.u(Part::Phase, i + 1);
        if (magnitude == 0.0 && phase_rad == 0.0 && relative > 0.0)
            return fail(ErrorKind::DataBlocked,
                {DYNCAL_TEXT("core",
                     "The results have no budget of the single frequencies (they are left out of more than 200); calibrate at fewer of them (response.frequencies_hz)."),
                    {}});
        if (!isSame(relative, magnitude) || !isSame(rows.u_phase_rad[i], phase_rad))
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "At %1 the lines of the budget do not make the stated uncertainty: the results contradict themselves, or inputs are correlated (uncertainty.correlations), which a correction cannot take; repeat the calibration without."),
                    {numberWithUnit(rows.frequency_Hz[i], "Hz")}});
    }
    return {};
}

tl::unexpected<Error> contradicting()
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The results contradict themselves: the lists of the response differ in length, or its frequencies do not ascend; repeat the calibration."),
            {}});
}

/// The lists of the section, as they stand.
struct RowLists
{
    Eigen::VectorXd frequency_Hz, magnitude, phase_rad, u_magnitude, u_phase_rad;

    explicit RowLists(const Json &response)
        : frequency_Hz(numbersAt(response, "frequency_hz"))
        , magnitude(numbersAt(response, "magnitude"))
        , phase_rad(numbersAt(response, "phase_rad"))
        , u_magnitude(numbersAt(response, "u_magnitude"))
        , u_phase_rad(numbersAt(response, "u_phase_rad"))
    {
    }

    bool fitTogether() const
    {
        for (const Eigen::VectorXd *list : {&magnitude, &phase_rad, &u_magnitude, &u_phase_rad})
            if (list->size() != frequency_Hz.size() && list->size() != 0)
                return false;
        for (Index i = 0; i < frequency_Hz.size(); ++i)
            if (!(frequency_Hz[i] > (i > 0 ? frequency_Hz[i - 1] : 0.0)))
                return false;
        return true;
    }

    bool areThere() const
    {
        return magnitude.size() > 0 && phase_rad.size() > 0 && u_magnitude.size() > 0
            && u_phase_rad.size() > 0;
    }

    bool isComplete(Index i) const
    {
        return magnitude[i] > 0.0 && std::isfinite(magnitude[i]) && std::isfinite(phase_rad[i])
            && u_magnitude[i] >= 0.0 && u_phase_rad[i] >= 0.0;
    }
};

std::vector<std::size_t> usedRows(const RowLists &lists)
{
    std::vector<std::size_t> rows;
    double last_Hz = 0.0;
    for (Index i = 0; lists.areThere() && i < lists.frequency_Hz.size(); ++i) {
        if (!lists.isComplete(i))
            continue;
        if (!rows.empty() && lists.frequency_Hz[i] > kWidestGap * last_Hz)
            break;
        last_Hz = lists.frequency_Hz[i];
        rows.push_back(static_cast<std::size_t>(i));
    }
    return rows;
}

MeasuredRows taken(const RowLists &lists, std::vector<std::size_t> numbers)
{
    Eigen::VectorXcd S(std::ssize(numbers));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto number = static_cast<Index>(numbers[i]);
        S[static_cast<Index>(i)] = std::polar(lists.magnitude[number], lists.phase_rad[number]);
    }
    return {numbers, lists.frequency_Hz(numbers), std::move(S), lists.u_magnitude(numbers),
        lists.u_phase_rad(numbers)};
}

} // namespace

Result<MeasuredRows> measuredRows(const Json &response)
{
    const RowLists lists(response);
    if (!lists.fitTogether())
        return contradicting();
    std::vector<std::size_t> numbers = usedRows(lists);
    if (numbers.empty())
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The results have no frequency with magnitude, phase and their complete uncertainties, so no correction follows from them; the findings of the calibration say what is missing (a known pressure step, a refined model)."),
                {}});
    return taken(lists, std::move(numbers));
}

Result<std::vector<ResponseError>> rowErrors(
    const Json &budget, const MeasuredRows &rows, double sensitivity)
{
    const std::map<std::string, KnotOfLine> knots = knotsOfLines(rows, sensitivity);
    GatheredLines lines(rows);
    for (std::size_t i = 0; budget.is_array() && i < budget.size(); ++i) {
        const auto found = knots.find(textAt(budget[i], "of"));
        if (found != knots.end())
            lines.add(budget[i], found->second.part, found->second.knot, found->second.unit);
    }
    return checkLines(lines, rows).map([&] { return lines.errors(); });
}

Eigen::VectorXd uOfKnotsAlone(const std::vector<ResponseError> &errors, Index knots)
{
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(knots);
    for (const ResponseError &error : errors) {
        const Eigen::VectorXd squares = error.atKnots.cwiseAbs2();
        Index at = 0;
        const double largest = squares.maxCoeff(&at);
        if (squares.sum() == largest)
            variance[at] += at > 0 ? 0.5 * largest : largest;
    }
    return variance.cwiseSqrt();
}

} // namespace dyncal
