// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/report/certificate_blocks.h"
#include "ui/report/page_flow.h"

#include <QPainter>
#include <QtTest>

#include <numeric>
#include <random>

using dyncal::columnWidths;
using dyncal::FlowBlock;
using dyncal::FlowText;
using dyncal::placeBlocks;
using dyncal::PlacedBlock;

namespace {

FlowBlock block(double height, bool keepWithNext = false, double spaceBefore = 0.0)
{
    FlowBlock made;
    made.height = height;
    made.keepWithNext = keepWithNext;
    made.spaceBefore = spaceBefore;
    return made;
}

} // namespace

class TestPageFlow : public QObject
{
    Q_OBJECT

private slots:
    void place_whatFits_staysOnOnePage();
    void place_headingAtBottom_movesWithItsText();
    void place_tableOverPages_repeatsHeader();
    void place_spaceBefore_vanishesAtTop();
    void place_chainLongerThanPage_isBrokenUp();
    void place_blockTallerThanPage_standsAlone();
    void endOfTheDocument_neverStandsAlone();
    void place_randomBlocks_neverOverlapNorLeaveThePage();
    void widths_anyInput_sumToTotal();
    void softHyphen_endsALine_andTakesNoRoomElse();
};

void TestPageFlow::place_whatFits_staysOnOnePage()
{
    const auto placed = placeBlocks({block(40), block(30, false, 10), block(20)}, 100.0);
    QCOMPARE(dyncal::pageCount(placed), 1);
    QCOMPARE(placed[1].top, 50.0);
    QCOMPARE(placed[2].top, 80.0);
    QCOMPARE(dyncal::pageCount({}), 1);
}

void TestPageFlow::place_headingAtBottom_movesWithItsText()
{
    const auto placed = placeBlocks({block(70), block(20, true), block(20)}, 100.0);
    QCOMPARE(placed[1].page, 1);
    QCOMPARE(placed[1].top, 0.0);
    QCOMPARE(placed[2].page, 1);
}

void TestPageFlow::place_tableOverPages_repeatsHeader()
{
    const auto header = std::make_shared<const FlowBlock>(block(10));
    std::vector<FlowBlock> blocks{*header};
    blocks[0].keepWithNext = true;
    for (int i = 0; i < 12; ++i) {
        blocks.push_back(block(15));
        blocks.back().repeatedHeader = header;
    }
    const auto placed = placeBlocks(blocks, 100.0);
    QCOMPARE(dyncal::pageCount(placed), 2);
    QVERIFY(!placed[1].withHeader); // right below the table's own heading
    QCOMPARE(placed[7].page, 1);
    QVERIFY(placed[7].withHeader);
    QCOMPARE(placed[7].top, 10.0);
    QVERIFY(!placed[8].withHeader);
}

void TestPageFlow::place_spaceBefore_vanishesAtTop()
{
    const auto placed = placeBlocks({block(95, false, 20), block(10, false, 20)}, 100.0);
    QCOMPARE(placed[0].top, 0.0);
    QCOMPARE(placed[1].page, 1);
    QCOMPARE(placed[1].top, 0.0);
}

void TestPageFlow::place_chainLongerThanPage_isBrokenUp()
{
    std::vector<FlowBlock> blocks(30, block(10, true));
    const auto placed = placeBlocks(blocks, 100.0);
    QCOMPARE(dyncal::pageCount(placed), 3);
}

void TestPageFlow::place_blockTallerThanPage_standsAlone()
{
    const auto placed = placeBlocks({block(10), block(250), block(10)}, 100.0);
    QCOMPARE(placed[1].page, 1);
    QCOMPARE(placed[1].top, 0.0);
    QCOMPARE(placed[2].page, 2);
}

/// Whatever the height of what is before it.
void TestPageFlow::endOfTheDocument_neverStandsAlone()
{
    QImage device(800, 1100, QImage::Format_ARGB32);
    const dyncal::CertificateStyle style;
    int lastPages = 0;
    for (int lines = 1; lines < 90; ++lines) {
        dyncal::CertificateData data;
        data.title = {"Report", {}};
        dyncal::CertificateSection section;
        section.id = "statements";
        section.title = {"Statements", {}};
        section.paragraphs.assign(static_cast<std::size_t>(lines), {"A sentence.", {}});
        data.sections = {section};
        const auto blocks = dyncal::certificateBlocks(data, {}, style, 680.0, &device);
        const std::vector<PlacedBlock> placed = placeBlocks(blocks, 953.0);
        QVERIFY2(placed.back().top > 0.0, qPrintable(QString::number(lines)));
        lastPages = placed.back().page;
    }
    QVERIFY(lastPages > 0);
}

void TestPageFlow::place_randomBlocks_neverOverlapNorLeaveThePage()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> height(1.0, 40.0);
    std::bernoulli_distribution keep(0.3);
    for (int trial = 0; trial < 200; ++trial) {
        const auto header = std::make_shared<const FlowBlock>(block(8.0));
        std::vector<FlowBlock> blocks;
        for (int i = 0; i < 60; ++i) {
            blocks.push_back(block(height(random), keep(random), 0.1 * height(random)));
            if (i > 20)
                blocks.back().repeatedHeader = header;
        }
        const auto placed = placeBlocks(blocks, 100.0);
        QCOMPARE(placed.size(), blocks.size());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            QVERIFY(placed[i].top >= 0.0);
            QVERIFY(placed[i].top + blocks[i].height <= 100.0 + 1e-9);
            if (i == 0)
                continue;
            QVERIFY(placed[i].page >= placed[i - 1].page);
            if (placed[i].page == placed[i - 1].page)
                QVERIFY(placed[i].top >= placed[i - 1].top + blocks[i - 1].height - 1e-9);
            else
                QVERIFY(placed[i].withHeader == (blocks[i].repeatedHeader != nullptr));
        }
    }
}

void TestPageFlow::widths_anyInput_sumToTotal()
{
    const auto sum = [](const std::vector<double> &widths) {
        return std::accumulate(widths.begin(), widths.end(), 0.0);
    };
    const std::vector<double> roomy = columnWidths({50, 100}, {20, 30}, 300.0);
    QCOMPARE(roomy, (std::vector<double>{100, 200}));
    const std::vector<double> tight = columnWidths({100, 300}, {50, 50}, 200.0);
    QVERIFY(std::abs(sum(tight) - 200.0) < 1e-9);
    QVERIFY(tight[0] >= 50.0 && tight[1] > tight[0]);
    const std::vector<double> hopeless = columnWidths({400, 400}, {300, 100}, 200.0);
    QCOMPARE(hopeless, (std::vector<double>{150, 50}));
}

void TestPageFlow::softHyphen_endsALine_andTakesNoRoomElse()
{
    const QFont font(QStringLiteral("DejaVu Sans"), 10);
    QImage device(1, 1, QImage::Format_RGB32);
    const auto longest = [&](const char *text) {
        return FlowText::longestWord(QString::fromUtf8(text), font, &device);
    };
    const auto natural = [&](const char *text) {
        return FlowText::naturalWidth(QString::fromUtf8(text), font, &device);
    };
    QCOMPARE(natural("Abtast\u00adrate"), natural("Abtastrate"));
    QCOMPARE(longest("Abtast\u00adrate"), natural("Abtast-"));
    QCOMPARE(longest("Ab\u00adtastrate"), natural("tastrate"));
    const double width = longest("Abtast\u00adrate") + 0.5;
    const FlowText set(QString::fromUtf8("Abtast\u00adrate"), font, width, &device);
    const FlowText two(QStringLiteral("Abtast-\nrate"), font, width, &device);
    QCOMPARE(set.height(), two.height());
}

DYNCAL_TEST(TestPageFlow)
#include "tst_page_flow.moc"
