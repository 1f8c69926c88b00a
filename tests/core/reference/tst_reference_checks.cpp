// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a reference transducer's record cannot be trusted for, each fault made in a sound record.

#include "core/reference/reference_checks.h"
#include "core/signal/window_cutting.h"
#include "tests/support/reference_capture.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace dyncal;

namespace {

/// `value` of a sample by its time behind the response's start, in seconds.
using Change = std::function<double(double value, double time_s)>;

} // namespace

class TestReferenceChecks : public QObject
{
    Q_OBJECT

private:
    std::vector<WindowedResponse> m_duts;

    /// Findings with the reference's record of shot 2 changed, once per shot.
    Findings judged(const Change &change) const
    {
        const auto set = testing::referenceCapture();
        Shot &shot = set->shots[1];
        const auto channel
            = std::ranges::find(shot.channels, ChannelRole::Reference, &Channel::role);
        const Eigen::VectorXd values = physicalValues(*channel, 0, channel->samples.size());
        std::vector<double> changed;
        for (Index i = 0; i < values.size(); ++i)
            changed.push_back(change(
                values[i], static_cast<double>(i) / channel->sampleRate_Hz - m_duts[1].start_s));
        channel->samples = RawSamples(std::move(changed));
        channel->polynomial = {0.0, 1.0};
        channel->adcMin = channel->adcMax = {};
        return judgeReferenceRecords(
            referenceRecords(*set, m_duts, testing::referenceComparison(), {}).value());
    }

    WindowedResponse sound() const
    {
        const auto set = testing::referenceCapture();
        return referenceRecords(*set, m_duts, testing::referenceComparison(), {})
            .value()
            .responses[1];
    }
    double step() const { return sound().step; }

    static void verifyOnly(const Findings &findings, const std::string &id)
    {
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, id);
        QCOMPARE(findings[0].shot, Index(2));
        QCOMPARE(findings[0].severity, Severity::Caution);
        QVERIFY(english(findings[0].message).find("Reference") != std::string::npos);
    }

private slots:
    void initTestCase()
    {
        const auto set = testing::referenceCapture();
        m_duts = cutWindows(*set, {}, {}).value().responses;
    }

    void soundRecord_hasNone()
    {
        const Findings findings = judged([](double value, double) { return value; });
        QVERIFY2(
            findings.empty(), findings.empty() ? "" : english(findings.front().message).c_str());
    }

    /// A charge amplifier: what the step leaves falls by e in the time constant.
    void amplifierWithoutDirectCurrent_isFound()
    {
        const double size = step();
        const double length_s = m_duts[1].settle_s.length();
        verifyOnly(judged([&](double value, double t) {
            return t < 0.0 ? value : value - size * (1.0 - std::exp(-t / (20.0 * length_s)));
        }),
            "CMP-002");
    }

    void driftOfTheZero_isFound()
    {
        const double size = step();
        const double perSecond = 0.02 * size / m_duts[1].baseline_s.length();
        verifyOnly(
            judged([&](double value, double t) { return value + perSecond * t; }), "CMP-002");
    }

    void invertedRecord_isFound()
    {
        verifyOnly(judged([](double value, double) { return -value; }), "CMP-003");
    }

    void cutTop_isFound()
    {
        const WindowedResponse whole = sound();
        const double top
            = whole.step * 0.5 * (1.0 + whole.window().maxCoeff()); // half of what overshoots
        verifyOnly(judged([&](double value, double) { return std::min(value, top); }), "CMP-004");
    }

    /// The level of a step is known where the calibration begins below it; the same transducer's
    /// table from higher and higher frequencies on.
    void calibrationThatBeginsAboveTheLevel_isTold()
    {
        const WindowedResponse response = sound();
        const double level_Hz = response.sampleRate_Hz / static_cast<double>(response.length);
        const auto judgedFrom = [&](double lowest_Hz, Index rows) {
            const auto model
                = ReferenceSensitivity::fromModel({2e-8, 6e-11, 450e3, 1e3, 0.2, 0.002}).value();
            std::vector<ReferencePoint> table;
            for (Index i = 0; i < rows; ++i)
                table.push_back(
                    model.at(lowest_Hz * std::pow(2.0, static_cast<double>(i))).value());
            return judgeLevelOfReference(
                {ReferenceSensitivity::fromTable(table).value(), {response}});
        };
        QVERIFY(judgedFrom(0.5 * level_Hz, 4).empty());
        QVERIFY(judgedFrom(0.5 * level_Hz, 1).empty());
        QVERIFY(judgedFrom(2.0 * level_Hz, 4).empty()); // it changes by too little to matter
        for (const double lowest_Hz : {50e3, 100e3}) {
            const Findings findings = judgedFrom(lowest_Hz, 2);
            QCOMPARE(findings.size(), std::size_t(1));
            QCOMPARE(findings[0].id, std::string("CMP-006"));
            QCOMPARE(findings[0].severity, Severity::Caution);
        }
        const Findings ofOneRow = judgedFrom(2.0 * level_Hz, 1);
        QCOMPARE(ofOneRow.size(), std::size_t(1));
        QVERIFY(english(ofOneRow[0].message).find("not known") != std::string::npos);
    }
};

DYNCAL_TEST(TestReferenceChecks)
#include "tst_reference_checks.moc"
