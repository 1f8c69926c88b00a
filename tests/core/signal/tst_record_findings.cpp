// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the samples of a response tell of how it was recorded and cut.

#include "core/signal/record_findings.h"
#include "tests/core/signal/window_records.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <utility>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr Index kStart = 4000; ///< of stepRecord()

Eigen::VectorXd with(const std::function<double(double)> &more)
{
    StepRecord record = stepRecord();
    Eigen::VectorXd values = record.values();
    for (Index i = 0; i < values.size(); ++i)
        values[i] += record.step * more(static_cast<double>(i));
    return values;
}

/// The findings about the record of one shot with such values.
std::string said(const Eigen::VectorXd &values, const WindowSettings &settings = {})
{
    std::string all;
    const auto result = cut(doubleChannel(values, kRate_Hz), settings);
    if (!result)
        return english(result.error().message);
    for (const Finding &finding : result->findings)
        if (finding.id == "WIN-010" || finding.id == "WIN-011" || finding.id == "CAP-034")
            all.append(all.empty() ? "" : " ").append(finding.id);
    return all;
}

WindowSettings startAt(double sample)
{
    WindowSettings settings;
    settings.start_s = {sample / kRate_Hz};
    settings.end_s = 2e-3;
    return settings;
}

} // namespace

class TestRecordFindings : public QObject
{
    Q_OBJECT

private slots:
    void goodRecord_saysNothing()
    {
        const auto nothing = [](double) { return 0.0; };
        QCOMPARE(said(with(nothing)), std::string());
        for (const double early : {0.0, 3.0})
            QCOMPARE(said(with(nothing), startAt(kStart - early)), std::string());
    }

    void waveBeforeTheStep_isTold()
    {
        const auto wave = [](double t) {
            return t < kStart - 600 ? 0.0 : 0.02 * std::sin(2.0 * M_PI * (t - kStart) / 300.0);
        };
        QCOMPARE(said(with(wave)), std::string("WIN-010"));
    }

    void everySecondSampleMadeUp_isTold()
    {
        Eigen::VectorXd values = with([](double) { return 0.0; });
        for (Index i = 1; i + 1 < values.size(); i += 2)
            values[i] = 0.5 * (values[i - 1] + values[i + 1]);
        QCOMPARE(said(values), std::string("CAP-034"));
    }

    /// Half a period of the sensor (33 samples) late, or more.
    void typedStartBehindTheResponse_isTold()
    {
        const auto nothing = [](double) { return 0.0; };
        for (const double late : {12.0, 17.0, 50.0}) {
            const std::string found = said(with(nothing), startAt(kStart + late));
            QVERIFY2(found.find("WIN-011") != std::string::npos, found.c_str());
        }
    }

    /// A quarter of the sensor's period early: f0 of a model is then off by some of its U.
    void typedStartBeforeTheResponse_isTold()
    {
        const auto nothing = [](double) { return 0.0; };
        for (const double early : {8.0, 20.0, 300.0}) {
            const std::string found = said(with(nothing), startAt(kStart - early));
            QVERIFY2(found.find("WIN-011") != std::string::npos, found.c_str());
        }
    }

    /// However softly a response begins, its own onset is no early start: a lag, critical damping,
    /// eight equal poles in series (of n, the sum of the first n terms of e^x is still missing).
    void softResponseFromItsOnset_saysNothing()
    {
        for (const int poles : {1, 2, 4, 8}) {
            StepRecord record = stepRecord();
            const double step = std::exchange(record.step, 0.0);
            Eigen::VectorXd values = record.values(); // noise
            for (Index i = kStart; i < values.size(); ++i) {
                const double x = static_cast<double>(i - kStart) / 60.0;
                double term = std::exp(-x), missing = 0.0;
                for (int n = 0; n < poles; ++n, term *= x / n)
                    missing += term;
                values[i] += step * (1.0 - missing);
            }
            const std::string found = said(values, startAt(kStart));
            QVERIFY2(found.empty(), qPrintable(QString("%1: %2").arg(poles).arg(found.c_str())));
        }
    }

    void baselineElsewhere_isTold()
    {
        const auto nothing = [](double) { return 0.0; };
        WindowSettings settings;
        settings.subtractBaseline = false; // the record lies at 0.2 V, 8 % of its step
        QCOMPARE(said(with(nothing), settings), std::string("WIN-011"));
        settings = startAt(kStart);
        settings.baseline_s = Interval{2.2e-3, 2.6e-3}; // behind the step, which is gone by then
        const auto falls = [](double t) { return t > kStart + 21000 ? -0.5 : 0.0; };
        const std::string found = said(with(falls), settings);
        QVERIFY2(found.find("WIN-011") != std::string::npos, found.c_str());
    }
};

DYNCAL_TEST(TestRecordFindings)
#include "tst_record_findings.moc"
