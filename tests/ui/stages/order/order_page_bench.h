// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/support/quick_pipeline.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/session/example.h"
#include "ui/session/order_candidates.h"
#include "ui/stages/candidates/candidate_cards.h"
#include "ui/stages/order/order_page.h"

#include <QLineEdit>
#include <QtTest>

#include <algorithm>
#include <memory>

namespace dyncal::test {

/// Long enough for the plateau of every shot.
inline constexpr double kDuration_s = 0.006;
inline constexpr int kPatience_ms = 120'000;

template <typename T>
T *find(const QWidget &page, const QString &name)
{
    T *found = page.findChild<T *>(name);
    if (!found)
        qFatal("no %s", qPrintable(name));
    return found;
}

/// The order page over the real pipeline and the built-in example: what its tests begin with.
class OrderPageBench : public QObject
{
protected:
    void openExample()
    {
        const auto captures = exampleCaptures({}, kDuration_s);
        QVERIFY(captures);
        m_session.setFocus(StageId::Shock);
        m_session.reset({std::make_shared<const CaptureSet>(*captures), {}});
        waitComputed();
        QVERIFY2(!m_session.error(),
            m_session.error() ? english(m_session.error()->message).c_str() : "");
        m_page = std::make_unique<OrderPage>(m_session);
        m_inspector.reset(m_page->inspector());
        m_page->resize(1000, 800);
        m_page->show();
        m_inspector->show();
    }
    void startOver() ///< before each test: order 2, nothing pinned
    {
        choose(2);
        pin({});
    }
    template <typename T>
    T *control(const QString &name)
    {
        T *found = m_page->inspector()->findChild<T *>(name);
        return found ? found : find<T>(*m_page, name);
    }
    PlotWidget *plot(const QString &name) { return find<PlotWidget>(*m_page, name); }
    void choose(Index order)
    {
        Recipe recipe = m_session.recipe();
        recipe.realization.order = order;
        recipe.realization.adoptedReason.clear();
        m_session.apply(recipe, "order");
        waitComputed();
    }
    void pin(std::vector<Index> orders)
    {
        Recipe recipe = m_session.recipe();
        recipe.realization.candidates = std::move(orders);
        recipe.realization.candidateNotes.clear();
        m_session.apply(recipe, "pin");
        QTRY_VERIFY_WITH_TIMEOUT(!m_session.candidates().isComputing(), kPatience_ms);
    }
    void waitComputed() { QTRY_VERIFY_WITH_TIMEOUT(!m_session.isComputing(), kPatience_ms); }
    CandidateCard *cardOf(Index order)
    {
        for (CandidateCard *card : m_page->findChildren<CandidateCard *>())
            if (!card->isHidden() && card->order() == order)
                return card;
        qFatal("no card");
    }
    QLineEdit *remarkOf(Index order) { return find<QLineEdit>(*cardOf(order), "candidateRemark"); }
    std::size_t curvesOfRole(const QString &name, CurveRole role)
    {
        return static_cast<std::size_t>(
            std::ranges::count(plot(name)->content().curves, role, &PlotCurve::role));
    }

    Session m_session{quickPipeline()};
    std::unique_ptr<OrderPage> m_page;
    std::unique_ptr<InspectorForm> m_inspector;
};

} // namespace dyncal::test
