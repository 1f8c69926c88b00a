// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/window/marked_stretch.h"

#include <QString>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace dyncal {

class QuantityEdit;

/// One line of the list, and what is to be said about it ("not used", "not applied: ...").
struct StretchRow
{
    MarkedStretch stretch;
    QString remark;
};

/// A choice of shots: one, or all.
struct ShotChoice
{
    QString text;
    std::vector<Index> shots;
    bool operator==(const ShotChoice &) const = default;
};

/// The stretches of the records that are left out of the fit: a list, and fields with the numbers
/// of the selected one. It decides nothing: what is typed is handed on, and comes back by show().
class StretchList : public QWidget
{
    Q_OBJECT

public:
    explicit StretchList(QWidget *parent = nullptr);

    void show(const std::vector<StretchRow> &rows, const std::vector<ShotChoice> &shots);
    void select(int row); ///< -1 = none: what is typed next is a new one
    int selected() const;
    /// The shots that the fields name.
    std::vector<Index> chosenShots() const;
    void chooseShots(const std::vector<Index> &shots); ///< for a new one: nothing is selected
    void askForReason(); ///< puts the keyboard there
    void setMarking(bool on);

signals:
    void markingRequested(bool on);
    /// Row -1: a new one.
    void edited(int row, const dyncal::MarkedStretch &stretch);
    void removeRequested(int row);
    void reasonWanted(); ///< before the keyboard goes there: what hides the field must open

private:
    void build();
    void connectControls();
    void showFields();
    void offerShots(const std::vector<Index> &needed);
    /// The selected stretch as it is, or a new one from the fields; the caller puts in what was
    /// typed.
    MarkedStretch typed() const;
    void hand(const MarkedStretch &stretch);

    std::vector<StretchRow> m_rows;
    std::vector<ShotChoice> m_shots; ///< what may be chosen
    std::vector<ShotChoice> m_offered; ///< these, and the shots of the selected stretch
    QPushButton *m_mark;
    QListWidget *m_list;
    QuantityEdit *m_begin;
    QuantityEdit *m_end;
    QComboBox *m_shot;
    QLineEdit *m_reason;
    QLabel *m_note;
    QPushButton *m_remove;
};

} // namespace dyncal
