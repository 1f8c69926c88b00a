// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/next_bar.h"

#include "ui/session/session.h"
#include "ui/text/shown_text.h"

#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kGap = 6;
constexpr int kEdge = 3;
constexpr double kMostForResults = 0.6; ///< of the width, beside the steps; else a line of its own

int widthOf(const QWidget &widget)
{
    return widget.sizeHint().width();
}

} // namespace

NextBar::NextBar(QWidget *parent)
    : QWidget(parent)
    , m_heading(new QLabel(this))
    , m_more(new QToolButton(this))
    , m_menu(new QMenu(this))
{
    setObjectName("nextBar");
    setAccessibleName(tr("What next, and key results"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_heading->setObjectName("nextHeading");
    QFont bold = m_heading->font();
    bold.setBold(true);
    m_heading->setFont(bold);
    m_more->setObjectName("nextMore");
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setMenu(m_menu);
    m_more->setToolTip(tr("Everything else that a certificate still lacks"));
    m_menu->setObjectName("nextMenu");
}

void NextBar::addLink()
{
    auto *link = new QToolButton(this);
    const std::size_t position = m_links.size();
    link->setObjectName(QString("nextStep%1").arg(position + 1));
    link->setAutoRaise(true);
    link->setFocusPolicy(Qt::StrongFocus);
    link->setToolTip(tr("Go to where this is settled"));
    QFont underlined = link->font();
    underlined.setUnderline(true);
    link->setFont(underlined);
    connect(link, &QToolButton::clicked, this, [this, position] {
        // The field that the click left may have been the last that was missing.
        if (position < m_steps.size())
            emit stepRequested(NextStep(m_steps[position]));
    });
    m_links.push_back(link);
}

void NextBar::showWork(const WorkState &work, const Session &session)
{
    const bool isOpen = session.state().hasShots();
    std::vector<NextStep> steps;
    if (isOpen) // before that there is one thing to do
        steps = nextSteps(work);
    showSteps(steps, isOpen);
    showResults(keyResults(session.results(), session.recipe()), session.isUpToDate());
}

void NextBar::showSteps(const std::vector<NextStep> &steps, bool isOpen)
{
    const bool isSame = std::ranges::equal(steps, m_steps, {}, &NextStep::text, &NextStep::text);
    QString heading = tr("What next:");
    if (steps.empty())
        heading = isOpen ? tr("Nothing is missing: the certificate can be exported.")
                         : tr("What next: open captures.");
    if (isSame && heading == m_heading->text())
        return;
    m_heading->setText(heading);
    m_steps = steps;
    while (m_links.size() < m_steps.size())
        addLink();
    for (std::size_t i = 0; i < m_steps.size(); ++i)
        m_links[i]->setText(withoutMnemonic(m_steps[i].text));
    arrange();
}

void NextBar::showResults(const std::vector<KeyResult> &results, bool areCurrent)
{
    bool isSame = m_results.size() == results.size();
    while (m_results.size() < results.size()) {
        m_results.push_back(new QLabel(this));
        m_results.back()->setTextInteractionFlags(Qt::TextSelectableByMouse);
        m_results.back()->show();
    }
    for (; m_results.size() > results.size(); m_results.pop_back())
        delete m_results.back();
    for (std::size_t i = 0; i < results.size(); ++i) {
        QLabel *label = m_results[i];
        isSame = isSame && label->text() == results[i].text;
        label->setObjectName(results[i].name);
        label->setText(results[i].text);
        label->setToolTip(
            areCurrent ? results[i].meaning : results[i].meaning + "\n" + tr("Out of date."));
        label->setEnabled(areCurrent);
    }
    if (!isSame)
        arrange();
}

/// From the right where they leave room for the steps, else in lines of their own above them.
/// Returns the width that is left on the line of the steps.
int NextBar::placeResults()
{
    const int line = std::max(m_heading->sizeHint().height(), m_more->sizeHint().height());
    int all = 0;
    for (const QLabel *label : m_results)
        all += widthOf(*label) + 2 * kGap;
    if (all < kMostForResults * width()) {
        int x = width() - all;
        for (QLabel *label : m_results) {
            label->setGeometry(x, kEdge, widthOf(*label), line);
            x += widthOf(*label) + 2 * kGap;
        }
        m_height = line + 2 * kEdge;
        return width() - all - kGap;
    }
    int x = kGap;
    int y = kEdge;
    for (QLabel *label : m_results) {
        if (x > kGap && x + widthOf(*label) > width()) {
            x = kGap;
            y += line;
        }
        label->setGeometry(x, y, widthOf(*label), line);
        x += widthOf(*label) + 2 * kGap;
    }
    m_height = y + 2 * line + kEdge;
    return width();
}

void NextBar::placeSteps(int width)
{
    const int line = std::max(m_heading->sizeHint().height(), m_more->sizeHint().height());
    const int y = m_height - kEdge - line;
    m_heading->setGeometry(kGap, y, widthOf(*m_heading), line);
    int x = kGap + widthOf(*m_heading) + kGap;
    m_more->setText(tr("%n more", nullptr, static_cast<int>(m_steps.size())));
    const int room = width - widthOf(*m_more) - 2 * kGap;
    std::size_t shown = 0;
    for (; shown < m_steps.size(); ++shown) {
        const bool isLast = shown + 1 == m_steps.size();
        if (x + widthOf(*m_links[shown]) > (isLast ? width - kGap : room))
            break;
        m_links[shown]->setGeometry(x, y, widthOf(*m_links[shown]), line);
        x += widthOf(*m_links[shown]) + kGap;
    }
    m_menu->clear();
    for (std::size_t i = 0; i < m_links.size(); ++i) {
        m_links[i]->setVisible(i < shown);
        if (i >= shown && i < m_steps.size())
            m_menu->addAction(
                m_links[i]->text(), this, [this, step = m_steps[i]] { emit stepRequested(step); });
    }
    m_more->setVisible(shown < m_steps.size());
    m_more->setText(tr("%n more", nullptr, static_cast<int>(m_steps.size() - shown)));
    m_more->setGeometry(x, y, widthOf(*m_more), line);
}

void NextBar::arrange()
{
    const int before = m_height;
    placeSteps(placeResults());
    if (m_height != before)
        updateGeometry();
}

QSize NextBar::sizeHint() const
{
    return {1, std::max(m_height, m_more->sizeHint().height() + 2 * kEdge)};
}

void NextBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

/// Words are wider in another font.
void NextBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        arrange();
}

} // namespace dyncal
