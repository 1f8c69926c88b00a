// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/version.h"
#include "core/selftest/selftest.h"
#include "core/selftest/step_words.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

SelfTestReport madeReport()
{
    SelfTestReport report;
    for (const char *step : {"window", "model", "shock"})
        report.checks.push_back({step, {"name of %1", {step}}, {"source", {}}, 1.0, 1.0, 0.1, 0.0});
    return report;
}

} // namespace

class TestSelftest : public QObject
{
    Q_OBJECT

private slots:
    void verdict_allHold()
    {
        const SelfTestReport report = madeReport();
        QCOMPARE(report.deviations(), Index(0));
        QVERIFY(!report.firstDeviation());
        QCOMPARE(english(report.verdict()),
            std::string("All 3 checks hold: this installation computes what is known."));
    }

    void verdict_namesTheFirstStep()
    {
        SelfTestReport report = madeReport();
        report.checks[1].found = 1.5;
        report.checks[2].found = 0.0;
        QCOMPARE(report.deviations(), Index(2));
        QCOMPARE(report.firstDeviation()->step, std::string("model"));
        const std::string words = english(report.verdict());
        QVERIFY(words.starts_with("2 of 3 checks deviate"));
        QVERIFY(words.find("\"model\" (name of model: expected 1, found 1.5)") != words.npos);
    }

    void everyStep_hasWords()
    {
        std::vector<std::string> steps{kCoverageStep};
        for (const CheckSpec &spec : allChecks())
            steps.emplace_back(spec.step);
        for (const auto &[step, version] : methodVersions())
            steps.push_back(step);
        for (const std::string &step : steps)
            QVERIFY2(stepWords(step).arguments.empty(), step.c_str());
        QCOMPARE(english(stepWords("monte_carlo")), std::string("Monte Carlo"));
        QCOMPARE(english(stepWords("of another version")), std::string("of another version"));
    }

    void withoutStudy_checksAlone()
    {
        double last = 0.0;
        JobControl control;
        control.progress = [&](double fraction) {
            QVERIFY(fraction >= last);
            last = fraction;
        };
        const auto report = runSelfTest({0, {{"Made", "1.2"}}}, control);
        QVERIFY(report.has_value());
        QCOMPARE(last, 1.0);
        QCOMPARE(report->checks.size(), allChecks().size());
        QCOMPARE(report->methods, methodVersions());
        QCOMPARE(report->installation.libraries.back().name, std::string("Made"));
    }

    /// Byte for byte: found values and sensitivities.
    void twice_theSame()
    {
        const auto one = runSelfTest({6, {}}), again = runSelfTest({6, {}});
        QVERIFY(one && again);
        QCOMPARE(one->checks.size(), allChecks().size() + 8);
        for (std::size_t i = 0; i < one->checks.size(); ++i)
            QCOMPARE(one->checks[i].found, again->checks[i].found);
    }

    void impossibleCount_isRefused()
    {
        for (const Index count : {Index(-1), Index(10001)}) {
            const auto report = runSelfTest({count, {}});
            QVERIFY(!report && report.error().kind == ErrorKind::Usage);
            QVERIFY(
                english(report.error().message).find(std::to_string(count)) != std::string::npos);
        }
    }

    /// With fewer no error could be small enough to deviate: 3.29/sqrt(2 n) < 1 needs n = 6.
    void studyThatCannotFail_isRefused()
    {
        for (const Index count : {1, 2, 5}) {
            const auto report = runSelfTest({count, {}});
            QVERIFY(!report && report.error().kind == ErrorKind::Usage);
            const std::string words = english(report.error().message);
            QVERIFY2(
                words.find("with less than 6 it cannot fail") != std::string::npos, words.c_str());
        }
    }

    void stopped_isCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto report = runSelfTest({}, {stop.get_token(), {}});
        QVERIFY(!report && report.error().kind == ErrorKind::Cancelled);
    }

    /// Asked for behind the checks, within the study.
    void stoppedInTheStudy_isCancelled()
    {
        std::stop_source stop;
        JobControl control{stop.get_token(), [&](double fraction) {
                               if (fraction > 0.25)
                                   stop.request_stop();
                           }};
        const auto report = runSelfTest({20, {}}, control);
        QVERIFY(!report && report.error().kind == ErrorKind::Cancelled);
    }

    void installation_isNamed()
    {
        const Installation here = thisInstallation({{"Qt", "6"}});
        QCOMPARE(here.version, std::string(versionText()));
        QCOMPARE(here.build, std::string(buildText()));
        for (const std::string &text : {here.compiler, here.processor, here.system})
            QVERIFY(!text.empty());
        QVERIFY(here.compiler.find_first_of("0123456789") != std::string::npos);
        for (const char *name : {"Eigen", "FFTW", "HDF5", "libcrypto", "zlib", "glibc", "Qt"})
            QVERIFY2(std::ranges::count(here.libraries, name, &UsedLibrary::name) == 1, name);
        for (const UsedLibrary &library : here.libraries)
            QVERIFY(library.version.find_first_of("0123456789") != std::string::npos);
    }
};

DYNCAL_TEST(TestSelftest)
#include "tst_selftest.moc"
