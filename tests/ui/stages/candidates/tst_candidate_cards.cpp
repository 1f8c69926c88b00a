// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/plot/curves/candidate_curves.h"
#include "ui/stages/candidates/candidate_cards.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

using namespace dyncal;

namespace {

CandidateRow known(Index order)
{
    CandidateRow row;
    row.order = order;
    row.isKnown = true;
    row.fit_percent = 53.16;
    row.attainable_percent = 55.0;
    row.f0_Hz = 2.33e6;
    row.zeta = 0.02;
    row.whiteness_p = 0.4;
    return row;
}

std::vector<CandidateCard *> cardsOf(const CandidateCards &cards)
{
    std::vector<CandidateCard *> shown;
    for (CandidateCard *card : cards.findChildren<CandidateCard *>())
        if (!card->isHidden())
            shown.push_back(card);
    return shown;
}

template <typename T>
T *part(const CandidateCard *card, const char *name)
{
    T *found = card->findChild<T *>(name);
    if (!found)
        qFatal("no %s", name);
    return found;
}

ComparedOrder compared(Index order, double fit_percent)
{
    auto model = std::make_shared<SensorModel>();
    model->order = order;
    model->fit_percent = fit_percent;
    model->fitAttainable_percent = 55.0;
    ComparedOrder made;
    made.order = order;
    made.model = model;
    return made;
}

} // namespace

/// The pinned orders as cards, and the words on them.
class TestCandidateCards : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void halfTypedRemark_survivesAModelThatComesIn();
    void halfTypedRemark_doesNotGoToAnotherOrder();
    void remark_unchanged_isNotHandedOn();
    void cross_takesOutItsOwnOrder();
    void overlay_isOfferedWhileThereIsAStyle();
    void noCards_showTheHint();
    void words_ofPoorAndUnknownModels();
    void words_inSwedish();
    void row_ofAModel_hasItsNumbers();
    void row_ofAnError_saysIt();
    void reason_isTrueOfTheOrder();
};

void TestCandidateCards::halfTypedRemark_survivesAModelThatComesIn()
{
    CandidateCards cards;
    CandidateRow computing;
    computing.order = 3;
    cards.setRows({known(2), computing});
    cards.show();
    cards.activateWindow();
    auto *remark = part<QLineEdit>(cardsOf(cards)[1], "candidateRemark");
    remark->setFocus();
    QTRY_VERIFY(remark->hasFocus());
    QTest::keyClicks(remark, "damp");
    cards.setRows({known(2), known(3)});
    QVERIFY(remark->hasFocus());
    QCOMPARE(remark->text(), QString("damp"));
    QSignalSpy remarked(&cards, &CandidateCards::remarked);
    QTest::keyClicks(remark, "ing odd ");
    QTest::keyClick(remark, Qt::Key_Return);
    QCOMPARE(remarked.count(), 1);
    QCOMPARE(remarked.at(0).at(0).value<Index>(), Index(3));
    QCOMPARE(remarked.at(0).at(1).toString(), QString("damping odd"));
}

void TestCandidateCards::halfTypedRemark_doesNotGoToAnotherOrder()
{
    CandidateCards cards;
    cards.setRows({known(2), known(3)});
    cards.show();
    auto *remark = part<QLineEdit>(cardsOf(cards)[0], "candidateRemark");
    QTest::keyClicks(remark, "of order two");
    QSignalSpy remarked(&cards, &CandidateCards::remarked);
    cards.setRows({known(3)}); // order 2 is unpinned meanwhile: the first card is of order 3 now
    QTest::keyClick(remark, Qt::Key_Return);
    QCOMPARE(remarked.count(), 0);
    QVERIFY(remark->text().isEmpty());
}

void TestCandidateCards::remark_unchanged_isNotHandedOn()
{
    CandidateCards cards;
    CandidateRow row = known(2);
    row.remark = "kept";
    cards.setRows({row});
    cards.show();
    QSignalSpy remarked(&cards, &CandidateCards::remarked);
    QTest::keyClick(part<QLineEdit>(cardsOf(cards)[0], "candidateRemark"), Qt::Key_Return);
    QCOMPARE(remarked.count(), 0);
    QVERIFY(cardsOf(cards)[0]->accessibleDescription().contains("kept"));
}

void TestCandidateCards::cross_takesOutItsOwnOrder()
{
    CandidateCards cards;
    cards.setRows({known(2), known(3), known(7)});
    cards.show();
    QSignalSpy unpinned(&cards, &CandidateCards::unpinned);
    QSignalSpy chosen(&cards, &CandidateCards::chosen);
    part<QToolButton>(cardsOf(cards)[1], "candidateUnpin")->click();
    cards.setRows({known(2), known(7)});
    part<QToolButton>(cardsOf(cards)[1], "candidateHeading")->click();
    QCOMPARE(unpinned.at(0).at(0).value<Index>(), Index(3));
    QCOMPARE(chosen.at(0).at(0).value<Index>(), Index(7));
    QCOMPARE(cardsOf(cards).size(), std::size_t(2));
}

void TestCandidateCards::overlay_isOfferedWhileThereIsAStyle()
{
    std::vector<CandidateRow> rows;
    for (Index order = 1; order <= 6; ++order)
        rows.push_back(known(order));
    for (std::size_t i = 0; i < kMostOverlaid; ++i)
        rows[i].overlaid = candidateRole(i);
    CandidateCards cards;
    cards.setRows(rows);
    cards.show();
    const auto box
        = [&](std::size_t i) { return part<QCheckBox>(cardsOf(cards)[i], "candidateOverlay"); };
    QVERIFY(box(0)->isEnabled() && box(0)->isChecked()); // can be taken off
    QVERIFY(!box(5)->isEnabled());
    QVERIFY(box(5)->toolTip().contains(QString::number(kMostOverlaid)));
    rows[0].overlaid.reset();
    cards.setRows(rows);
    QVERIFY(box(0)->isEnabled() && box(5)->isEnabled());
    QSignalSpy toggled(&cards, &CandidateCards::overlayToggled);
    box(5)->click();
    QCOMPARE(toggled.at(0).at(0).value<Index>(), Index(6));
    QCOMPARE(toggled.at(0).at(1).toBool(), true);
}

void TestCandidateCards::noCards_showTheHint()
{
    CandidateCards cards;
    cards.setRows({known(2)});
    cards.show();
    auto *hint = cards.findChild<QLabel *>("candidateHint");
    QVERIFY(!hint->isVisible());
    const int height = cards.height();
    cards.setRows({});
    QVERIFY(hint->isVisible());
    QVERIFY(cardsOf(cards).empty());
    QVERIFY(cards.height() < height); // the plots get the room
}

void TestCandidateCards::words_ofPoorAndUnknownModels()
{
    CandidateRow row;
    row.order = 3;
    QCOMPARE(cardLines(row), QStringList{"computing..."});
    row.note = "waits for all singular values";
    QCOMPARE(cardLines(row), QStringList{"waits for all singular values"});
    row = known(3);
    row.fit_percent = -1e53; // the number itself says nothing
    QCOMPARE(cardLines(row).at(0), QString("FIT < 0 of 55 %"));
    row.diverges = true;
    row.fit_percent.reset();
    row.f0_Hz.reset();
    row.whiteness_p.reset();
    row.unstable = 2;
    QCOMPARE(
        cardLines(row), (QStringList{"diverges", "no resonance", "unstable 2, Nyquist 0, p –"}));
}

void TestCandidateCards::words_inSwedish()
{
    const test::InSwedish swedish;
    CandidateRow row = known(3);
    row.whiteness_p = 1e-9;
    QCOMPARE(cardLines(row),
        (QStringList{
            "FIT 53,2 av 55 %", "2,3300 MHz, ζ 0,020000", "instabila 0, Nyquist 0, p < 0,001"}));
}

void TestCandidateCards::row_ofAModel_hasItsNumbers()
{
    CalibrationResults results;
    auto decomposition = std::make_shared<DecompositionResult>();
    decomposition->suggestion.order = 2;
    results.decomposition = decomposition;
    ComparedOrder order = compared(2, 53.0);
    order.whiteness_p = 0.25;
    order.bic = -12.5;
    const CandidateRow row = candidateRow(2, &order, results);
    QVERIFY(row.isKnown);
    QCOMPARE(*row.fit_percent, 53.0);
    QCOMPARE(*row.bic, -12.5);
    QCOMPARE(row.note, QString("suggested"));
    QVERIFY(!row.f0_Hz); // nothing oscillates in it
    QVERIFY(!candidateRow(3, nullptr, results).isKnown);
    QVERIFY(candidateRow(3, nullptr, results).note.isEmpty());
}

void TestCandidateCards::row_ofAnError_saysIt()
{
    ComparedOrder failed;
    failed.order = 900;
    failed.error = Error{ErrorKind::Usage, {"Order %1 is too high.", {"900"}}, {}, 0};
    const CandidateRow row = candidateRow(900, &failed, {});
    QVERIFY(!row.isKnown);
    QCOMPARE(cardLines(row), QStringList{"Order 900 is too high."});
}

void TestCandidateCards::reason_isTrueOfTheOrder()
{
    CalibrationResults results;
    auto decomposition = std::make_shared<DecompositionResult>();
    decomposition->suggestion.order = 2;
    results.decomposition = decomposition;
    const SensorModel suggested = *compared(2, 53.0).model;
    const SensorModel other = *compared(5, 54.0).model;
    QVERIFY(proposedReason(suggested, results).contains("information criterion"));
    QVERIFY(!proposedReason(other, results).contains("information criterion"));
    QVERIFY(proposedReason(other, results).contains("FIT 54 % of attainable 55 %"));
}

DYNCAL_TEST(TestCandidateCards)
#include "tst_candidate_cards.moc"
