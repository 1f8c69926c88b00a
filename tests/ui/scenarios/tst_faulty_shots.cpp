// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"

#include <QCryptographicHash>

using namespace dyncal;
using namespace dyncal::test;

namespace {

QList<QByteArray> hashes(const QStringList &paths)
{
    QList<QByteArray> all;
    for (const QString &path : paths) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            qFatal("cannot read %s", qPrintable(path));
        all << QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256);
    }
    return all;
}

} // namespace

/// One shot of three is bad: what is said of it, and what is done about it with a click.
class TestFaultyShots : public QObject
{
    Q_OBJECT

private slots:
    void s08_channelsSwapped_areSwappedBackInThatShot();
    void s08_oneShotOfAFileSwapped_isSwappedBackAlone();
    void s09_shotWithoutStep_isExcludedWithAReason();
    void s10_saturatedShot_isBlocked();
    void s10_saturatedBehindTheWindow_isACaution();
    void s13_invalidSamples_areInterpolated();
};

void TestFaultyShots::s08_channelsSwapped_areSwappedBackInThatShot()
{
    ScenarioBench bench;
    const SimulationSettings settings = threeShots({{DefectKind::Swap, 2}});
    const SimulatedCapture simulated = simulateShots(settings).value();
    const QStringList paths = bench.recordEach(settings);
    const auto before = hashes(paths);
    bench.open(paths);
    DYNCAL_SAYS(bench.finding("CAP-010"), "Shot 2");
    DYNCAL_SAYS(bench.finding("CAP-010"), " ms before");
    DYNCAL_SAYS(bench.finding("CAP-010"), "look swapped");
    const Recipe asOpened = bench.recipe();
    bench.clickOffer("correction", "CAP-010", "Swap in shot2.h5");
    QVERIFY2(bench.finding("CAP-010").isEmpty(), qPrintable(bench.findings().join('\n')));
    QVERIFY(!bench.session().error());
    bench.show(Page::Shock);
    // Each shot has a level of its own, so each velocity is held against what was simulated.
    const QStringList velocities = bench.row("stateTable", "Velocity");
    QCOMPARE(velocities.size(), 4);
    for (int shot = 1; shot <= 3; ++shot) {
        const ShotTruth &truth = simulated.truth[static_cast<std::size_t>(shot - 1)];
        QVERIFY2(std::abs(number(velocities[shot]) / truth.at("velocity_m_s") - 1.0) < 0.005,
            qPrintable(velocities.join('|')));
    }
    bench.undo();
    QVERIFY(bench.recipe() == asOpened);
    DYNCAL_SAYS(bench.finding("CAP-010"), "Shot 2");
    QCOMPARE(hashes(paths), before);
}

void TestFaultyShots::s08_oneShotOfAFileSwapped_isSwappedBackAlone()
{
    ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::Swap, 2}}))});
    DYNCAL_SAYS(bench.finding("CAP-010"), "Shot 2");
    bench.show(Page::Captures);
    auto *others = bench.find<QLabel>("otherRoles");
    DYNCAL_SAYS(others->text(), "In shot 2:");
    const Recipe asOpened = bench.recipe();
    bench.clickOffer("correction", "CAP-010", "Swap in shot 2");
    QVERIFY2(bench.finding("CAP-010").isEmpty(), qPrintable(bench.findings().join('\n')));
    QVERIFY(!bench.session().error());
    QCOMPARE(bench.recipe().import.shots.size(), std::size_t(1));
    QCOMPARE(bench.recipe().import.shots[0].shot, Index(2));
    bench.show(Page::Captures);
    QVERIFY2(others->isHidden(), qPrintable(others->text())); // all shots agree now
    bench.undo();
    QVERIFY(bench.recipe() == asOpened);
    DYNCAL_SAYS(bench.finding("CAP-010"), "Shot 2");
}

void TestFaultyShots::s09_shotWithoutStep_isExcludedWithAReason()
{
    ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::NoStep, 2}}))});
    DYNCAL_SAYS(bench.finding("CAP-009"), "Shot 2");
    DYNCAL_SAYS(bench.finding("CAP-009"), "no step found");
    bench.prompts.setNextSentence("diaphragm held");
    bench.clickOffer("correction", "CAP-009", "Exclude shot 2");
    QVERIFY(!bench.session().error());
    QVERIFY(bench.finding("CAP-009").isEmpty() && bench.finding("CAP-017").isEmpty());
    bench.show(Page::Components);
    QCOMPARE(bench.find<QTableWidget>("residualTable")->rowCount(), 2);
    bench.show(Page::Captures);
    DYNCAL_SAYS(bench.find<QTableWidget>("shotTable")->item(1, 0)->toolTip(), "diaphragm held");
    DYNCAL_SAYS(certificateText(bench), "Shot 2 was excluded. Reason: diaphragm held.");
}

void TestFaultyShots::s10_saturatedShot_isBlocked()
{
    ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::Clip, 3}}))});
    const QString said = bench.finding("CAP-007");
    QVERIFY2(said.startsWith("■"), qPrintable(said));
    for (const char *part : {"Shot 3", "150 ns", "3.18", " V", "inside the response window"})
        DYNCAL_SAYS(said, part);
    bench.show(Page::Captures);
    const auto &marks = bench.find<PlotWidget>("rawPlot_dut")->content().marks;
    QVERIFY(!marks.empty());
    QCOMPARE(marks.front().label, QString("shot 3: saturated"));
    // Nothing leaves the program while the shot takes part, and all does without it.
    bench.prompts.setNextFile(bench.folder.filePath("c"));
    bench.show(Page::Certificate);
    bench.click("exportCertificate");
    QCOMPARE(bench.prompts.shownProblems().size(), 1);
    QVERIFY(!QFile::exists(bench.folder.filePath("c.pdf")));
    bench.prompts.dropAnswers();
    bench.prompts.setNextSentence("range too small");
    bench.clickOffer("correction", "CAP-007", "Exclude shot 3");
    QVERIFY(!bench.session().error());
    QVERIFY(bench.finding("CAP-007").isEmpty());
}

/// The same limit reached after the window: the plateau is over, nothing of it is used.
void TestFaultyShots::s10_saturatedBehindTheWindow_isACaution()
{
    const ScenarioBench bench;
    CaptureSet set = simulateShots(threeShots()).value().set;
    Channel &dut = set.shots[2].channels[0];
    QCOMPARE(dut.role, ChannelRole::Dut);
    std::vector<std::int16_t> codes;
    for (Index k = 0; k < dut.samples.size(); ++k)
        codes.push_back(static_cast<std::int16_t>(dut.samples.at(k)));
    std::fill(codes.end() - 840, codes.end(), std::int16_t{8191}); // 42 µs at 20 MHz
    dut.samples = RawSamples(std::move(codes));
    bench.open({bench.write(set, "late.h5")});
    const QString said = bench.finding("CAP-007");
    QVERIFY2(said.startsWith("▲"), qPrintable(said));
    for (const char *part : {"Shot 3", "42 µs", "Inside the response window that blocks"})
        DYNCAL_SAYS(said, part);
    QVERIFY(!bench.session().error());
}

void TestFaultyShots::s13_invalidSamples_areInterpolated()
{
    const ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::Nan, 2}}))});
    for (const char *part : {"Shot 2", "DUT", "3, from sample 47081 to 47083", "1.75405 ms",
             "inside the response window"})
        DYNCAL_SAYS(bench.finding("CAP-006"), part);
    bench.show(Page::Spectrum);
    auto *plot = bench.find<PlotWidget>("spectrumPlot");
    DYNCAL_SAYS(plot->notice(), "Shot 2");
    DYNCAL_SAYS(plot->notice(), "invalid samples");
    QVERIFY(!bench.offer("correction", "CAP-006", "Interpolate gaps of up to 6"));
    bench.clickOffer("correction", "CAP-006", "Interpolate gaps of up to 5 samples");
    QVERIFY(!bench.session().error());
    DYNCAL_SAYS(bench.finding("CAP-022"), "Shot 2, DUT: 3 invalid samples were interpolated");
    QCOMPARE(plot->notice(), QString());
    QVERIFY(!plot->content().curves.empty());
    for (const PlotCurve &curve : plot->content().curves)
        QVERIFY(std::ranges::all_of(curve.y, [](double y) { return std::isfinite(y); }));
    DYNCAL_SAYS(certificateText(bench), "3 invalid samples were interpolated");
}

DYNCAL_TEST(TestFaultyShots)
#include "tst_faulty_shots.moc"
