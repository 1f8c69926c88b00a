// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/spectrum/nuisance_list.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace dyncal;

namespace {

/// Two shots with windows of 1.5 ms; candidates of the first: 229 Hz and 7541 Hz.
CalibrationResults resultsWithCandidates()
{
    auto window = std::make_shared<WindowResult>();
    auto expected = std::make_shared<ExpectedShock>();
    for (const Index shot : {Index(2), Index(3)}) {
        WindowedResponse response;
        response.shot = shot;
        response.sampleRate_Hz = 1e6;
        response.length = 1500;
        window->responses.push_back(response);
        ShockConditions conditions;
        conditions.shot = shot;
        TubeResonance cavity;
        cavity.kind = ResonanceKind::CavityShocked;
        cavity.frequency_Hz = 229.0;
        TubeResonance transverse;
        transverse.kind = ResonanceKind::Transverse;
        transverse.m = 1;
        transverse.n = 1;
        transverse.frequency_Hz = 7541.0;
        conditions.resonances = {cavity, transverse};
        expected->conditions.shots.push_back(conditions);
    }
    auto spectrum = std::make_shared<SpectrumResult>();
    spectrum->resonances = {{30e3, 20.0, 10.0, {30.1e3, 29.9e3}}};
    CalibrationResults results;
    results.window = window;
    results.expected = expected;
    results.spectrum = spectrum;
    return results;
}

NuisanceMode added(const QSignalSpy &spy)
{
    return spy.last().at(0).value<NuisanceMode>();
}

} // namespace

class TestNuisanceList : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_list = std::make_unique<NuisanceList>();
        m_list->showCandidates(resultsWithCandidates());
        m_candidates = m_list->findChild<QComboBox *>("nuisanceCandidates");
        m_reason = m_list->findChild<QLineEdit *>("nuisanceReason");
        m_add = m_list->findChild<QPushButton *>("nuisanceAdd");
        m_frequency = m_list->findChild<QuantityEdit *>("nuisanceFrequency");
        QVERIFY(m_candidates && m_reason && m_add && m_frequency);
    }

    void candidates_areThoseThatCanBeSeparated()
    {
        // "marked or typed", the transverse mode, the peak; 229 Hz has a third of a period.
        QCOMPARE(m_candidates->count(), 3);
        QVERIFY(m_candidates->itemText(1).contains("7.541"));
        QVERIFY(m_candidates->itemText(2).contains("30.1"));
    }

    void candidate_isAddedWithItsReasonOnly()
    {
        QSignalSpy spy(m_list.get(), &NuisanceList::addRequested);
        m_candidates->setCurrentIndex(1);
        emit m_candidates->activated(1);
        QVERIFY(!m_add->isEnabled());
        m_reason->setText("  moves with the gas ");
        QVERIFY(m_add->isEnabled());
        m_add->click();
        QCOMPARE(spy.count(), 1);
        const NuisanceMode mode = added(spy);
        QCOMPARE(mode.frequency_Hz, std::vector<double>{7541.0});
        QCOMPARE(mode.shot, Index(2));
        QVERIFY(mode.isTube);
        QCOMPARE(mode.label, TubeResonance(transverse()).label());
        QCOMPARE(mode.reason, std::string("moves with the gas"));
        QVERIFY(m_reason->text().isEmpty() && !m_add->isEnabled());
    }

    void markedPeak_isOfTheShotChosen()
    {
        QSignalSpy spy(m_list.get(), &NuisanceList::addRequested);
        m_candidates->setCurrentIndex(2);
        m_list->mark(6812.0);
        QCOMPARE(m_candidates->currentIndex(), 0);
        m_list->findChild<QComboBox *>("nuisanceShot")->setCurrentIndex(1);
        m_list->findChild<QComboBox *>("nuisanceKind")->setCurrentIndex(1);
        m_reason->setText("mount");
        m_add->click();
        const NuisanceMode mode = added(spy);
        QCOMPARE(mode.frequency_Hz, std::vector<double>{6812.0});
        QCOMPARE(mode.shot, Index(3));
        QVERIFY(!mode.isTube);
        QVERIFY(mode.label.empty());
        // The choice of the shot stays when results come anew.
        m_list->showCandidates(resultsWithCandidates());
        QCOMPARE(m_list->findChild<QComboBox *>("nuisanceShot")->currentIndex(), 1);
    }

    void modes_areShownWithWhatBecameOfThem_andCanBeTakenBack()
    {
        const NuisanceMode mode{{6.8e3}, 2, true, "transverse", "moves with the gas"};
        auto model = std::make_shared<SensorModel>();
        NuisanceOfShot shot;
        shot.shot = 3;
        shot.term.pole_rad_s = {-10.0, 2.0 * M_PI * 6.4e3};
        model->nuisance = {{mode, {shot}}};
        CalibrationResults results = resultsWithCandidates();
        results.model = model;
        m_list->showModes({mode}, results);
        auto *modes = m_list->findChild<QListWidget *>("nuisanceModes");
        QCOMPARE(modes->count(), 1);
        QVERIFY(modes->item(0)->text().contains("6.4"));
        QCOMPARE(modes->item(0)->toolTip(), QString("moves with the gas"));
        auto *remove = m_list->findChild<QPushButton *>("nuisanceRemove");
        QVERIFY(!remove->isEnabled());
        modes->setCurrentRow(0);
        QSignalSpy spy(m_list.get(), &NuisanceList::removeRequested);
        remove->click();
        QCOMPARE(spy.count(), 1);
        QCOMPARE(spy.last().at(0).toInt(), 0);
        m_list->showModes({}, results);
        QVERIFY(!remove->isEnabled());
    }

private:
    static TubeResonance transverse()
    {
        TubeResonance mode;
        mode.kind = ResonanceKind::Transverse;
        mode.m = 1;
        mode.n = 1;
        return mode;
    }

    std::unique_ptr<NuisanceList> m_list;
    QComboBox *m_candidates = nullptr;
    QLineEdit *m_reason = nullptr;
    QPushButton *m_add = nullptr;
    QuantityEdit *m_frequency = nullptr;
};

DYNCAL_TEST(TestNuisanceList)
#include "tst_nuisance_list.moc"
