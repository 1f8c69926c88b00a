// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/correlation_checks.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

UncertaintySettings threeStated(std::vector<CorrelationEntry> correlations)
{
    UncertaintySettings settings;
    settings.budget = {{"p1_pa", 50.0}, {"t1_k", 0.3}, {"relative_humidity", 0.02}};
    settings.correlations = std::move(correlations);
    return settings;
}

std::string refusalOf(std::vector<CorrelationEntry> correlations)
{
    const auto checked = checkCorrelations(threeStated(std::move(correlations)));
    return checked ? "" : english(checked.error().message);
}

} // namespace

class TestCorrelationChecks : public QObject
{
    Q_OBJECT

private slots:
    void possible_isTaken()
    {
        QVERIFY(checkCorrelations(threeStated({})));
        QVERIFY(checkCorrelations(threeStated({{"p1_pa", "t1_k", 1.0}})));
        QVERIFY(checkCorrelations(
            threeStated({{"p1_pa", "t1_k", 0.9}, {"t1_k", "relative_humidity", -0.4}})));
        QVERIFY(checkCorrelations(threeStated({{"p1_pa", "t1_k", 1.0},
            {"t1_k", "relative_humidity", 1.0}, {"p1_pa", "relative_humidity", 1.0}})));
    }

    void twice_isRefused()
    {
        QVERIFY(refusalOf({{"p1_pa", "t1_k", 0.5}, {"t1_k", "p1_pa", 0.5}}).find("twice")
            != std::string::npos);
    }

    /// One temperature cannot go along with three velocities that know nothing of each other by
    /// more than 1/sqrt(3) each.
    void velocitiesOfShots_areIndependent()
    {
        const auto with = [](double r, Index velocities) {
            return checkCorrelations(threeStated({{"velocity_m_s", "t1_k", r}}), velocities)
                .has_value();
        };
        QVERIFY(with(1.0, 1) && with(0.57, 3) && with(-0.57, 3) && with(0.7, 2));
        QVERIFY(!with(0.58, 3) && !with(-0.58, 3) && !with(1.0, 2) && !with(0.72, 2));
    }

    /// What goes along with t1 cannot go against what goes along with it.
    void contradiction_isRefused()
    {
        const std::string said = refusalOf({{"p1_pa", "t1_k", 0.9},
            {"t1_k", "relative_humidity", 0.9}, {"p1_pa", "relative_humidity", -0.9}});
        QVERIFY2(said.find("contradict") != said.npos, said.c_str());
    }
};

DYNCAL_TEST(TestCorrelationChecks)
#include "tst_correlation_checks.moc"
