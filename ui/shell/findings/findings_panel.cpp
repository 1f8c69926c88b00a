// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/findings_panel.h"

#include "ui/session/page_standing.h"
#include "ui/shell/findings/button_flow.h"
#include "ui/shell/findings/finding_places.h"
#include "ui/stages/frame/status_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/kept_together.h"
#include "ui/text/shown_text.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPushButton>
#include <QStyledItemDelegate>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kButtonIndent = 18; ///< below the sentence, not below its sign
constexpr std::size_t kMostCorrections = 4; ///< of a group; opened, every shot has its own

std::string keyOf(const Finding &finding)
{
    return finding.id + '\n' + finding.message.text;
}

bool isNote(const FindingGroup &group)
{
    return group.front().severity == Severity::Info;
}

/// Draws a sentence without parting numbers from their units; its text stays what it is.
class SentenceDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QString displayText(const QVariant &value, const QLocale &) const override
    {
        return withUnitsKept(value.toString());
    }
};

} // namespace

FindingsPanel::FindingsPanel(QWidget *parent)
    : QListWidget(parent)
{
    constexpr int kLeastLines = 6;
    setMinimumHeight(kLeastLines * fontMetrics().lineSpacing());
    setObjectName("findingsPanel");
    setItemDelegate(new SentenceDelegate(this));
    setAccessibleName(tr("Findings"));
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    setResizeMode(QListView::Adjust);
    setSelectionMode(ExtendedSelection);
    connect(this, &QListWidget::itemClicked, this, &FindingsPanel::request);
    connect(this, &QListWidget::itemActivated, this, &FindingsPanel::request);
}

void FindingsPanel::setFindings(const Findings &findings,
    const std::vector<Acknowledgement> &acknowledged, const CaptureSet &captures)
{
    m_shown = findings;
    m_acknowledged = acknowledged;
    m_corrections.clear();
    m_corrections.reserve(findings.size());
    QStringList words;
    for (const Finding &finding : findings) {
        m_corrections.push_back(correctionsOf(finding, captures, findings));
        words << findingLine(finding) + acceptedText(finding);
        for (const OfferedCorrection &correction : m_corrections.back())
            words << correction.label;
    }
    // While an order is dragged the same sentences come many times a second.
    if (m_words == words && count() > 0)
        return;
    m_words = words;
    fill();
}

void FindingsPanel::setNotesOpen(bool open)
{
    m_notesOpen = open;
    fill();
}

void FindingsPanel::fill()
{
    clear();
    m_rows.clear();
    m_names.clear();
    std::vector<FindingGroup> notes;
    for (const FindingGroup &group : grouped(m_shown)) {
        if (isNote(group))
            notes.push_back(group);
        else
            addGroup(group);
    }
    if (!notes.empty())
        addNotes(notes);
    if (m_shown.empty()) {
        addRow(tr("No findings."), {Row::Kind::Buttons});
        item(0)->setFlags(Qt::NoItemFlags);
    }
    arrangeButtons();
}

void FindingsPanel::addRow(const QString &text, Row row)
{
    addItem(text);
    m_rows.push_back(std::move(row));
}

void FindingsPanel::addGroup(const FindingGroup &group)
{
    addRow(lineOf(group), {Row::Kind::Finding, group});
    item(count() - 1)->setToolTip(tr("Click, or press Enter, to go to where it is settled"));
    const bool isOpened = isOpen(group);
    addButtons(group, isOpened);
    if (isOpened)
        for (const Finding &finding : group)
            addMember(finding);
}

/// One shot of a group that is opened.
void FindingsPanel::addMember(const Finding &finding)
{
    addRow(QStringLiteral("      ") + findingLine(finding) + acceptedText(finding),
        {Row::Kind::Finding, {finding}});
    auto *flow = new ButtonFlow(2 * kButtonIndent, this);
    addCorrections({finding}, *flow);
    if (flow->isEmpty()) {
        delete flow;
        return;
    }
    addRow({}, {Row::Kind::Buttons, {finding}});
    item(count() - 1)->setFlags(Qt::NoItemFlags);
    setItemWidget(item(count() - 1), flow);
}

void FindingsPanel::addNotes(const std::vector<FindingGroup> &notes)
{
    int findings = 0;
    for (const FindingGroup &group : notes)
        findings += static_cast<int>(group.size());
    addRow((m_notesOpen ? QStringLiteral("▾ ") : QStringLiteral("▸ "))
            + tr("%n note(s)", nullptr, findings),
        {Row::Kind::Notes});
    item(count() - 1)
        ->setToolTip(tr("Click, or press Enter, to open or fold what is only good to know"));
    if (!m_notesOpen)
        return;
    for (const FindingGroup &group : notes)
        addRow(lineOf(group), {Row::Kind::Finding, group});
}

/// A row of its own, so that the sentence above keeps its width, its menu and its place in the
/// copy.
void FindingsPanel::addButtons(const FindingGroup &group, bool isOpened)
{
    const Finding &first = group.front();
    auto *flow = new ButtonFlow(kButtonIndent, this);
    if (!isOpened)
        addCorrections(group, *flow);
    const auto add = [&](const QString &kind, const QString &text, const QString &tip) {
        QPushButton *button = flow->add(nextName(kind, first.id), text);
        button->setAccessibleDescription(groupLine(group));
        button->setToolTip(tip);
        return button;
    };
    if (const auto place = placeOfFinding(first.id))
        connect(add("show", tr("Show"),
                    tr("Go to %1, where this is settled").arg(pageTitle(place->page))),
            &QPushButton::clicked, this,
            [this, first] { later([this, first] { emit placeRequested(first); }); });
    if (first.severity == Severity::Caution)
        connect(add("reason", tr("Give a reason..."),
                    tr("Use the result in spite of this; the certificate prints the reason")),
            &QPushButton::clicked, this,
            [this, group] { later([this, group] { emit reasonRequested(group); }); });
    if (group.size() > 1)
        connect(add("each", isOpened ? tr("Fold") : tr("Each shot"),
                    tr("Show what is said of every shot, or fold it")),
            &QPushButton::clicked, this,
            [this, group] { later([this, group] { toggle(group); }); });
    if (flow->isEmpty()) {
        delete flow;
        return;
    }
    addRow({}, {Row::Kind::Buttons, group});
    item(count() - 1)->setFlags(Qt::NoItemFlags);
    setItemWidget(item(count() - 1), flow);
}

/// What mends any of these, each offer once.
void FindingsPanel::addCorrections(const Findings &findings, ButtonFlow &flow)
{
    std::vector<QString> told;
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        if (std::ranges::find(findings, m_shown[i]) == findings.end())
            continue;
        for (const OfferedCorrection &correction : m_corrections[i]) {
            if (told.size() == kMostCorrections && findings.size() > 1)
                return;
            if (std::ranges::find(told, correction.label) != told.end())
                continue;
            told.push_back(correction.label);
            QPushButton *button = flow.add(
                nextName("correction", m_shown[i].id), withoutMnemonic(correction.label));
            button->setAccessibleDescription(findingLine(m_shown[i]));
            button->setToolTip(correction.step);
            connect(button, &QPushButton::clicked, this, [this, correction] {
                later([this, correction] { emit correctionRequested(correction); });
            });
        }
    }
}

QString FindingsPanel::nextName(const QString &kind, const std::string &id)
{
    const QString name = kind + '_' + rawText(id);
    return QString("%1_%2").arg(name).arg(++m_names[name]);
}

void FindingsPanel::later(const std::function<void()> &what)
{
    QMetaObject::invokeMethod(this, what, Qt::QueuedConnection);
}

bool FindingsPanel::isOpen(const FindingGroup &group) const
{
    return group.size() > 1 && m_opened.contains(keyOf(group.front()));
}

void FindingsPanel::toggle(const FindingGroup &group)
{
    const std::string key = keyOf(group.front());
    if (m_opened.erase(key) == 0)
        m_opened.insert(key);
    fill();
}

QString FindingsPanel::acceptedText(const Finding &finding) const
{
    QString text;
    for (const Acknowledgement &entry : m_acknowledged)
        if (isAccepted(finding, {entry}))
            text += " " + tr("Accepted: %1").arg(shownText(entry.reason));
    return text;
}

/// With the reason, where all of them have the same.
QString FindingsPanel::lineOf(const FindingGroup &group) const
{
    const QString accepted = acceptedText(group.front());
    const bool isCommon = std::ranges::all_of(
        group, [&](const Finding &finding) { return acceptedText(finding) == accepted; });
    return groupLine(group) + (isCommon ? accepted : QString());
}

/// Rows of buttons are as high as their lines at this width.
void FindingsPanel::arrangeButtons()
{
    for (int row = 0; row < count(); ++row)
        if (auto *flow = qobject_cast<ButtonFlow *>(itemWidget(item(row))))
            item(row)->setSizeHint({0, flow->arrange(viewport()->width())});
}

void FindingsPanel::resizeEvent(QResizeEvent *event)
{
    QListWidget::resizeEvent(event);
    arrangeButtons();
}

void FindingsPanel::request(const QListWidgetItem *item)
{
    const int at = row(item);
    if (at < 0 || static_cast<std::size_t>(at) >= m_rows.size())
        return;
    const Row &chosen = m_rows[static_cast<std::size_t>(at)];
    if (chosen.kind == Row::Kind::Notes) {
        // A double click comes as two requests: both ask for the same.
        later([this, open = !m_notesOpen] {
            setNotesOpen(open);
            emit notesOpened(open);
        });
    } else if (chosen.kind == Row::Kind::Finding) {
        emit placeRequested(chosen.findings.front());
    }
}

void FindingsPanel::contextMenuEvent(QContextMenuEvent *event)
{
    const auto at = static_cast<std::size_t>(std::max(0, row(itemAt(event->pos()))));
    if (at >= m_rows.size() || m_rows[at].findings.empty())
        return;
    const Findings findings = m_rows[at].findings;
    if (findings.front().severity != Severity::Caution)
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(
        tr("Give a reason..."), this, [this, findings] { emit reasonRequested(findings); });
    menu->popup(event->globalPos());
}

/// Folded ones too: what is copied is what was found.
void FindingsPanel::keyPressEvent(QKeyEvent *event)
{
    if (!event->matches(QKeySequence::Copy)) {
        QListWidget::keyPressEvent(event);
        return;
    }
    QStringList lines;
    for (const QListWidgetItem *chosen : selectedItems())
        lines << pasted(chosen->text().trimmed());
    if (lines.isEmpty())
        for (const FindingGroup &group : grouped(m_shown))
            for (const Finding &finding : group)
                lines << pasted(findingLine(finding) + acceptedText(finding));
    if (lines.isEmpty())
        lines << tr("No findings.");
    QApplication::clipboard()->setText(lines.join('\n'));
}

/// Words are wider in another font.
void FindingsPanel::changeEvent(QEvent *event)
{
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        arrangeButtons();
}

} // namespace dyncal
