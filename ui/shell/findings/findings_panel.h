// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/project/recipe.h"
#include "ui/shell/findings/finding_corrections.h"
#include "ui/text/finding_group.h"

#include <QListWidget>

#include <functional>
#include <map>
#include <set>

namespace dyncal {

class ButtonFlow;

/// All findings of the job, most severe first: sign, word, id and sentence; what several shots have
/// in common is one row, which opens. What is only good to know is folded under one row. Below
/// whatever needs somebody stand the buttons that mend it, lead to its place or take a reason; a
/// click on a row (or Enter) leads there too. Ctrl+C copies the lines selected, or all.
class FindingsPanel : public QListWidget
{
    Q_OBJECT

public:
    explicit FindingsPanel(QWidget *parent = nullptr);

    /// `captures`: the recordings on show, which say what corrections there are.
    void setFindings(const Findings &findings, const std::vector<Acknowledgement> &acknowledged,
        const CaptureSet &captures);
    void setNotesOpen(bool open); ///< without a signal

signals:
    void placeRequested(const dyncal::Finding &finding);
    void reasonRequested(const dyncal::Findings &findings); ///< the operator wants to accept them
    void correctionRequested(const dyncal::OfferedCorrection &correction);
    void notesOpened(bool open); ///< by the operator

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    /// What a click on a row is about.
    struct Row
    {
        enum class Kind { Finding, Notes, Buttons } kind = Kind::Finding;
        Findings findings = {}; ///< a group, or one of it
    };

    void request(const QListWidgetItem *item);
    void fill();
    void addGroup(const FindingGroup &group);
    void addMember(const Finding &finding);
    void addNotes(const std::vector<FindingGroup> &notes);
    void addButtons(const FindingGroup &group, bool isOpened);
    void addCorrections(const Findings &findings, ButtonFlow &flow);
    void addRow(const QString &text, Row row);
    QString nextName(const QString &kind, const std::string &id);
    void toggle(const FindingGroup &group);
    void arrangeButtons();
    bool isOpen(const FindingGroup &group) const;
    QString acceptedText(const Finding &finding) const;
    QString lineOf(const FindingGroup &group) const;
    /// Asks for what the panel is filled anew by: not within the click.
    void later(const std::function<void()> &what);

    Findings m_shown; ///< as they came
    std::vector<Acknowledgement> m_acknowledged;
    std::vector<std::vector<OfferedCorrection>> m_corrections; ///< of each of m_shown
    QStringList m_words; ///< of the rows: while they are the same, nothing is filled anew
    std::vector<Row> m_rows;
    std::set<std::string> m_opened; ///< sentences of the groups that the operator opened
    bool m_notesOpen = false;
    std::map<QString, int> m_names; ///< how many buttons of a name there are
};

} // namespace dyncal
