// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The checks themselves: all hold, every stage of the method has one, and no tolerance is tighter
// than rounding allows or so wide that it says nothing.

#include "core/selftest/checks_in_noise.h"
#include "core/selftest/checks_of_correction.h"
#include "core/selftest/checks_of_division.h"
#include "core/selftest/checks_of_draws.h"
#include "core/selftest/checks_of_realization.h"
#include "core/selftest/checks_of_records.h"
#include "core/selftest/checks_of_response.h"
#include "core/selftest/checks_of_shock.h"
#include "core/selftest/checks_of_signals.h"
#include "core/selftest/checks_of_uncertainty.h"
#include "core/selftest/checks_of_ways.h"
#include "core/selftest/selftest.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <set>

using namespace dyncal;

namespace {

using Steps = std::set<std::string>;

Steps stepsOf(const std::vector<CheckSpec> &checks)
{
    Steps steps;
    for (const CheckSpec &check : checks)
        steps.insert(check.step);
    return steps;
}

} // namespace

class TestAllChecks : public QObject
{
    Q_OBJECT

private:
    std::vector<SelfCheck> m_checks;

private slots:
    void initTestCase()
    {
        for (const CheckSpec &spec : allChecks())
            m_checks.push_back(carriedOut(spec));
    }

    void all_hold()
    {
        for (const SelfCheck &check : m_checks)
            QVERIFY2(check.holds(), (check.step + ": " + english(check.name)).c_str());
    }

    void everyStageOfTheMethod_hasOne()
    {
        const Steps steps = stepsOf(allChecks());
        for (const auto &[stage, version] : methodVersions())
            QVERIFY2(steps.contains(stage), stage.c_str());
    }

    /// Each file has the steps that its header names, and all of them are asked.
    void files_haveTheirSteps()
    {
        using Make = std::vector<CheckSpec> (*)();
        const std::vector<std::pair<Make, Steps>> files{
            {checksOfRecords, {"captures", "arrivals", "reading"}},
            {checksOfSignals, {"window", "spectrum", "components", "model_input"}},
            {checksOfRealization, {"decomposition", "model"}},
            {checksInNoise, {"evidence", "model_assessment"}},
            {checksOfShock, {"expected_shock", "shock"}},
            {checksOfResponse, {"response"}},
            {checksOfDivision, {"response", "reference_transducer"}},
            {checksOfUncertainty, {"uncertainty"}},
            {checksOfWays, {"checks", "comparison", "monte_carlo"}},
            {checksOfDraws, {"monte_carlo_of_the_chain"}},
            {checksOfCorrection, {"correction", "certificate"}},
        };
        std::size_t count = 0;
        for (const auto &[make, steps] : files) {
            QCOMPARE(stepsOf(make()), steps);
            count += make().size();
        }
        QCOMPARE(allChecks().size(), count);
    }

    /// In one piece each, as the report has a table for each.
    void steps_standTogether()
    {
        Steps closed;
        for (std::size_t i = 1; i < m_checks.size(); ++i) {
            if (m_checks[i].step == m_checks[i - 1].step)
                continue;
            QVERIFY2(closed.insert(m_checks[i - 1].step).second, m_checks[i].step.c_str());
        }
        QCOMPARE(m_checks.front().step, std::string("captures"));
    }

    void names_areUniqueInTheirStep()
    {
        Steps names;
        for (const SelfCheck &check : m_checks) {
            QVERIFY2(names.insert(check.step + "/" + english(check.name)).second,
                english(check.name).c_str());
            QVERIFY(!english(check.source).empty());
        }
    }

    /// Condition times rounding unit times 10 at least: another compiler does not fail it.
    void tolerances_allowForRounding()
    {
        const double unit = std::numeric_limits<double>::epsilon() / kDataChange;
        for (const SelfCheck &check : m_checks)
            QVERIFY2(
                check.tolerance >= 10.0 * check.sensitivity * unit, english(check.name).c_str());
    }

    /// A thousandth of the value but for counts, scatter of random numbers, and what a count of
    /// draws bounds; a tenth of any of these would still be noticed.
    void tolerances_sayAtenthOrLess()
    {
        int tight = 0;
        for (const SelfCheck &check : m_checks) {
            const double size = check.expected == 0.0 ? 1.0 : std::abs(check.expected);
            QVERIFY2(check.tolerance <= 0.1 * size, english(check.name).c_str());
            tight += check.tolerance <= 1e-3 * size ? 1 : 0;
        }
        QVERIFY(tight > 70);
    }
};

DYNCAL_TEST(TestAllChecks)
#include "tst_all_checks.moc"
