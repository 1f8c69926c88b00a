// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/candidates/candidate_cards.h"

#include "ui/plot/curves/candidate_curves.h"
#include "ui/plot/values/theme.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QScrollBar>
#include <QToolButton>

#include <algorithm>

namespace dyncal {

namespace {

constexpr QSize kSample(30, 12);

/// The line as the plots draw it.
QIcon styleIcon(CurveRole role, const QPalette &palette)
{
    const RoleStyle style = screenTheme(palette, {}).style(role);
    QPixmap pixmap(kSample);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setPen(QPen(style.color, style.width, style.dash));
    painter.drawLine(0, kSample.height() / 2, kSample.width(), kSample.height() / 2);
    return pixmap;
}

/// Keeps the keys typed here from the page, where Enter would adopt the order.
class RemarkEdit : public QLineEdit
{
public:
    using QLineEdit::QLineEdit;

protected:
    void keyPressEvent(QKeyEvent *event) override
    {
        QLineEdit::keyPressEvent(event);
        event->accept();
    }
};

} // namespace

CandidateCard::CandidateCard(QWidget *parent)
    : QFrame(parent)
    , m_remark(new RemarkEdit(this))
    , m_heading(new QToolButton(this))
    , m_unpin(new QToolButton(this))
    , m_overlay(new QCheckBox(this))
    , m_text(new QLabel(this))
{
    setObjectName("candidateCard");
    setFrameShape(QFrame::StyledPanel);
    m_heading->setObjectName("candidateHeading");
    m_heading->setAutoRaise(true);
    m_heading->setToolTip(tr("Choose this order"));
    m_unpin->setObjectName("candidateUnpin");
    m_unpin->setText(QStringLiteral("✕"));
    m_unpin->setAutoRaise(true);
    m_overlay->setObjectName("candidateOverlay");
    m_overlay->setIconSize(kSample);
    m_text->setObjectName("candidateText");
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);

    auto *head = new QHBoxLayout;
    head->addWidget(m_heading);
    head->addWidget(m_overlay);
    head->addStretch(1);
    head->addWidget(m_unpin);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 2, 4, 4);
    layout->setSpacing(1);
    layout->addLayout(head);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_remark);
    m_remark->setObjectName("candidateRemark");
    m_remark->setPlaceholderText(tr("Note"));
    m_remark->setToolTip(tr("Kept with the order in the project; shown in the comparison"));
    connect(m_heading, &QToolButton::clicked, this, [this] { emit chosen(m_order); });
    connect(m_unpin, &QToolButton::clicked, this, [this] { emit unpinned(m_order); });
    connect(m_remark, &QLineEdit::editingFinished, this, [this] {
        if (m_remark->isModified())
            emit remarked(m_order, m_remark->text().trimmed());
    });
    connect(m_overlay, &QCheckBox::clicked, this,
        [this](bool on) { emit overlayToggled(m_order, on); });
}

void CandidateCard::set(const CandidateRow &row, bool mayOverlay)
{
    if (m_order != row.order)
        m_remark->setModified(false); // the text being typed was for another order
    m_order = row.order;
    QString heading = tr("n = %1").arg(row.order);
    if (row.isAdopted)
        heading += tr(", adopted");
    else if (row.isChosen)
        heading += tr(", chosen");
    QFont bold = font();
    bold.setBold(row.isChosen || row.isAdopted);
    m_heading->setFont(bold);
    m_heading->setText(heading);
    m_heading->setAccessibleName(tr("Choose order %1").arg(row.order));
    m_unpin->setAccessibleName(tr("Take order %1 out of the comparison").arg(row.order));
    m_unpin->setToolTip(m_unpin->accessibleName());
    m_overlay->setAccessibleName(tr("Draw order %1 in the plots").arg(row.order));
    m_overlay->setChecked(row.overlaid.has_value());
    m_overlay->setIcon(row.overlaid ? styleIcon(*row.overlaid, palette()) : QIcon());
    m_overlay->setText(row.overlaid ? QString() : tr("draw"));
    m_overlay->setEnabled(row.isKnown && (row.overlaid || mayOverlay));
    m_overlay->setToolTip(m_overlay->isEnabled()
            ? m_overlay->accessibleName()
            : tr("At most %1 are drawn at once.").arg(kMostOverlaid));
    m_remark->setAccessibleName(tr("Note on order %1").arg(row.order));
    if (!m_remark->hasFocus() || !m_remark->isModified())
        m_remark->setText(row.remark);
    const QString text = cardLines(row).join('\n');
    m_text->setText(text);
    setAccessibleName(heading);
    setAccessibleDescription(row.remark.isEmpty() ? text : text + '\n' + shownText(row.remark));
    layout()->activate();
    updateGeometry(); // else the row still knows the height of the text before
}

CandidateCards::CandidateCards(QWidget *parent)
    : QScrollArea(parent)
    , m_row(new QWidget)
    , m_hint(new QLabel(m_row))
{
    setObjectName("candidateCards");
    setAccessibleName(tr("Pinned orders"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_hint->setObjectName("candidateHint");
    m_hint->setText(
        tr("Space pins the order on show, to compare it with others; Enter adopts it."));
    auto *layout = new QHBoxLayout(m_row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_hint);
    layout->addStretch(1);
    setWidget(m_row);
}

void CandidateCards::setRows(const std::vector<CandidateRow> &rows)
{
    auto *layout = static_cast<QHBoxLayout *>(m_row->layout());
    while (m_cards.size() < rows.size()) {
        auto *card = new CandidateCard(m_row);
        connect(card, &CandidateCard::chosen, this, &CandidateCards::chosen);
        connect(card, &CandidateCard::unpinned, this, &CandidateCards::unpinned);
        connect(card, &CandidateCard::remarked, this, &CandidateCards::remarked);
        connect(card, &CandidateCard::overlayToggled, this, &CandidateCards::overlayToggled);
        layout->insertWidget(static_cast<int>(m_cards.size()) + 1, card);
        m_cards.push_back(card);
    }
    while (m_cards.size() > rows.size()) {
        m_cards.back()->deleteLater(); // later: the click may come from it
        m_cards.back()->hide();
        m_cards.pop_back();
    }
    const auto overlaid = std::ranges::count_if(
        rows, [](const CandidateRow &row) { return row.overlaid.has_value(); });
    for (std::size_t i = 0; i < rows.size(); ++i)
        m_cards[i]->set(rows[i], static_cast<std::size_t>(overlaid) < kMostOverlaid);
    m_hint->setVisible(rows.empty());
    m_row->layout()->activate();
    setFixedHeight(m_row->sizeHint().height() + horizontalScrollBar()->sizeHint().height());
}

} // namespace dyncal
