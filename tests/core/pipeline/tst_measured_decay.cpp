// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Real free decays (eleven impacts on one accelerometer) through the committed example recipe,
// against an independent ERA computation kept beside the data.

#include "core/capture/opening/capture_open.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_table.h"
#include "tests/support/measured_data.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace dyncal;

namespace {

constexpr double kFrequency = 0.002; ///< relative: another decimation than the reference's
constexpr double kDamping = 0.10;

std::filesystem::path shotsFolder()
{
    return testing::dataFolder()
        / "highrate_ds5_impact/data/dataset-1/data-1/PCB_repeated_shock_trials";
}

Recipe exampleRecipe()
{
    const auto root = std::filesystem::path(qgetenv("DYNCAL_SOURCE_DIR").toStdString());
    return *readRecipeFile((root / "resources/examples/free-decay.json").string());
}

std::vector<std::string> shots()
{
    std::vector<std::string> files;
    if (!std::filesystem::exists(shotsFolder()))
        return files;
    for (const auto &entry : std::filesystem::directory_iterator(shotsFolder())) {
        if (entry.path().filename().string().starts_with("acc_pcb_a"))
            files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

Result<Pole> calibrated(const std::vector<std::string> &files)
{
    const Recipe recipe = exampleRecipe();
    auto set = readCaptures(files, recipe.import);
    if (!set)
        return tl::unexpected(set.error());
    ResultCache cache;
    const PipelineOutcome outcome
        = runPipeline(std::make_shared<const CaptureSet>(std::move(*set)), recipe, cache);
    if (outcome.error)
        return tl::unexpected(*outcome.error);
    return outcome.results.model->poles.front();
}

} // namespace

class TestMeasuredDecay : public QObject
{
    Q_OBJECT

private slots:
    void eachShot_agreesWithTheIndependentComputation()
    {
        QFile file(
            QString::fromStdString((testing::dataFolder() / "expected/ds5_era.json").string()));
        const auto files = shots();
        if (files.empty() || !file.open(QIODevice::ReadOnly))
            DYNCAL_SKIP_WITHOUT_DATA("The folder of measured data is missing: 0 files covered.");
        const QJsonObject expected
            = QJsonDocument::fromJson(file.readAll()).object()["files"].toObject();
        int covered = 0;
        for (const std::string &shot : files) {
            const QString name
                = QString::fromStdString(std::filesystem::path(shot).filename().string());
            const QJsonObject truth = expected[name].toObject();
            if (truth.isEmpty())
                continue;
            const auto pole = calibrated({shot});
            QVERIFY2(pole.has_value(), qPrintable(name));
            QVERIFY(std::abs(pole->frequency_Hz / truth["f_Hz"].toDouble() - 1.0) < kFrequency);
            QVERIFY(std::abs(pole->dampingRatio / truth["zeta"].toDouble() - 1.0) < kDamping);
            ++covered;
        }
        qInfo("%d of %d files covered", covered, int(files.size()));
        QVERIFY(covered > 0);
    }

    void allShotsTogether()
    {
        const auto files = shots();
        if (files.empty())
            DYNCAL_SKIP_WITHOUT_DATA("The folder of measured data is missing: 0 files covered.");
        const auto pole = calibrated(files);
        QVERIFY(pole.has_value());
        qInfo("%.3f Hz, damping %.5f", pole->frequency_Hz, pole->dampingRatio);
        QVERIFY(std::abs(pole->frequency_Hz - 804.5) < 1.0);
        QVERIFY(std::abs(pole->dampingRatio - 0.0097) < 0.001);
    }

    void movingBaseline_isReportedAndNotUsed()
    {
        const auto folder = testing::dataFolder() / "highrate_ds5_impact/data/dataset-2/data-1";
        if (!std::filesystem::exists(folder / "Test_017.lvm"))
            DYNCAL_SKIP_WITHOUT_DATA("The folder of measured data is missing: 0 files covered.");
        Recipe recipe;
        recipe.import.channels = {{"Acceleration_0", "dut"}};
        recipe.shock.enabled = false;
        recipe.input.treatment = ResponseTreatment::Impulse;
        std::vector<std::string> files;
        for (const char *name : {"Test_001.lvm", "Test_002.lvm", "Test_004.lvm", "Test_017.lvm"})
            files.push_back((folder / name).string());
        auto set = readCaptures(files, recipe.import);
        QVERIFY(set.has_value());
        ResultCache cache;
        const PipelineOutcome outcome = runPipeline(
            std::make_shared<const CaptureSet>(std::move(*set)), recipe, cache, StageId::Window);
        QVERIFY(outcome.results.window);
        QCOMPARE(outcome.results.window->responses.size(), std::size_t(3));
        const Findings findings = allFindings(outcome.results);
        const auto found = std::find_if(
            findings.begin(), findings.end(), [](const Finding &f) { return f.id == "CAP-020"; });
        QVERIFY(found != findings.end());
        QCOMPARE(found->shot, Index(4));
        QCOMPARE(found->severity, Severity::Block);
    }
};

DYNCAL_TEST(TestMeasuredDecay)
#include "tst_measured_decay.moc"
