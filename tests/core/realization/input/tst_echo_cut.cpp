// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Echoes of several shots: what confirms one, where the records end, what is said.

#include "core/realization/input/echo_cut.h"
#include "tests/support/echo_records.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::echoRecord;
using testing::EchoRecord;

namespace {

SensorTraits traits()
{
    return testing::traitsOf(318e3, 0.02);
}

/// Shot 1, 2, ... with an echo of these sizes after these delays.
std::vector<WindowedResponse> shots(
    const std::vector<double> &relative, const std::vector<double> &delay_s)
{
    std::vector<WindowedResponse> list;
    for (std::size_t i = 0; i < relative.size(); ++i) {
        EchoRecord made{318e3, 0.02, relative[i], delay_s[i]};
        made.shot = static_cast<Index>(i) + 1;
        list.push_back(echoRecord(made));
    }
    return list;
}

} // namespace

class TestEchoCut : public QObject
{
    Q_OBJECT

private slots:
    void recordsEndBeforeTheEarliest()
    {
        const Echoes echoes
            = findEchoes(shots({0.03, 0.03, 0.03}, {100e-6, 104e-6, 96e-6}), traits(), true);
        QCOMPARE(echoes.ofShots.size(), std::size_t(3));
        QVERIFY(echoes.recordsEnd_s.has_value());
        QVERIFY(*echoes.recordsEnd_s < 96e-6 && *echoes.recordsEnd_s > 90e-6);
        const Findings findings = judgeEchoes(echoes);
        QCOMPARE(findings.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(findings[i].id, std::string("MIN-007"));
            QCOMPARE(findings[i].shot, static_cast<Index>(i) + 1);
            QVERIFY(findings[i].severity == Severity::Caution);
            QVERIFY(findings[i].causes == std::vector{FindingCause::Echo});
        }
    }

    /// 0.4 % is five or six of its u.
    void aWeakOne_needsOtherShots()
    {
        const auto found
            = [](const std::vector<double> &sizes, const std::vector<double> &delay_s) {
                  return findEchoes(shots(sizes, delay_s), traits(), true).ofShots.size();
              };
        QCOMPARE(found({0.004, 0.0, 0.0}, {100e-6, 0.0, 0.0}), std::size_t(0));
        QCOMPARE(found({0.004, -0.004, 0.0}, {100e-6, 102e-6, 0.0}), std::size_t(0));
        QCOMPARE(found({0.007, 0.007, 0.0}, {100e-6, 104e-6, 0.0}), std::size_t(2));
        QCOMPARE(found({0.03, 0.0, 0.0}, {100e-6, 0.0, 0.0}), std::size_t(1));
        QVERIFY(found({0.0035, 0.0035, 0.0035}, {100e-6, 100e-6, 100e-6}) >= 2); // together
        QCOMPARE(found({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), std::size_t(0));
    }

    /// Behind the stronger second echo the search goes on in what is left.
    void theEarliestCounts()
    {
        std::vector<WindowedResponse> list = shots({0.05, 0.05, 0.05}, {160e-6, 160e-6, 160e-6});
        const std::vector<WindowedResponse> earlier
            = shots({0.015, 0.015, 0.015}, {80e-6, 80e-6, 80e-6});
        const std::vector<WindowedResponse> none = shots({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
        for (std::size_t i = 0; i < list.size(); ++i)
            list[i].values += earlier[i].values - none[i].values;
        const Echoes echoes = findEchoes(list, traits(), true);
        QCOMPARE(echoes.ofShots.size(), std::size_t(3));
        for (const Echo &echo : echoes.ofShots)
            QVERIFY(std::abs(echo.delay_s - 80e-6) < 1e-6);
        QVERIFY(*echoes.recordsEnd_s < 80e-6);
    }

    void anEndThatWasSet_staysAndIsTold()
    {
        const Echoes echoes = findEchoes(shots({0.03}, {100e-6}), traits(), false);
        QCOMPARE(echoes.ofShots.size(), std::size_t(1));
        QVERIFY(!echoes.recordsEnd_s);
        const std::string words = english(judgeEchoes(echoes).front().message);
        QVERIFY2(words.find("end the window before it") != std::string::npos, words.c_str());
    }

    /// Size with its u, delay and the new end stand in the sentence, and the size as the value.
    void theSentence_hasItsNumbers()
    {
        Echoes echoes{{{2, 100e-6, 1e-7, 0.031, 0.001}}, 98e-6};
        const Finding shortened = judgeEchoes(echoes).front();
        const std::string words = english(shortened.message);
        for (const char *part : {"3.10 %", "u = 0.10 %", "100 ", "98 "})
            QVERIFY2(words.find(part) != std::string::npos, words.c_str());
        QCOMPARE(*shortened.value, 0.031);
        QCOMPARE(shortened.shot, Index(2));
        echoes.recordsEnd_s.reset();
        QVERIFY(english(judgeEchoes(echoes).front().message) != words);
        QVERIFY(judgeEchoes({}).empty());
    }

    /// The end is a time: records of any rate end there, each at its last sample before.
    void recordsOfOtherRates_endAtTheSameTime()
    {
        std::vector<WindowedResponse> list = shots({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
        list[1].sampleRate_Hz = 5e6;
        list[2].sampleRate_Hz = 3.3e6;
        const std::vector<WindowedResponse> ended = endingAt(list, 90.05e-6);
        QCOMPARE(ended[0].length, Index(900));
        QCOMPARE(ended[1].length, Index(450));
        QCOMPARE(ended[2].length, Index(297));
        for (const WindowedResponse &response : ended) {
            QCOMPARE(response.end_s, 90.05e-6);
            QCOMPARE(response.values.size(), response.lead + response.length);
            QVERIFY(static_cast<double>(response.length) / response.sampleRate_Hz <= 90.05e-6);
        }
    }

    void endingAt_leavesNothingBehind()
    {
        std::vector<WindowedResponse> list = shots({0.0}, {0.0});
        list.front().lead = 500; // a record from before the start on
        list.front().length -= 500;
        const Eigen::VectorXd values = list.front().values;
        const WindowedResponse cut = endingAt(list, 100e-6).front();
        QCOMPARE(cut.length, Index(1000));
        QCOMPARE(cut.values.size(), Index(1500));
        QCOMPARE(cut.end_s, 100e-6);
        QVERIFY(cut.values == values.head(1500));
        const WindowedResponse whole = endingAt(list, 1.0).front(); // shorter already
        QCOMPARE(whole.length, list.front().length);
        QCOMPARE(whole.values.size(), values.size());
    }
};

DYNCAL_TEST(TestEchoCut)
#include "tst_echo_cut.moc"
