// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QJsonArray>
#include <QWidget>

#include <memory>

class QComboBox;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QTemporaryFile;

namespace dyncal {

class Preferences;
class Prompts;
class RegistryCaller;

/// Cards of the registry as a table to search and edit. What was typed is kept in the registry
/// with a reason, and read again from it.
class CardsTab : public QWidget
{
    Q_OBJECT

public:
    CardsTab(RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent);

    /// Reads the cards again, unless there are changes that are not kept.
    void refresh();
    void showWords();
    bool isChanged() const; ///< whether something is typed that is not kept

signals:
    void changed(const QString &sentence); ///< the registry is another, as the sentence says

private:
    QPushButton *addButton(const char *name, void (CardsTab::*act)());
    QString kind() const;
    void showKind();
    void read(); ///< drops what is not kept
    void showCards();
    void showTitles();
    static QString titleOf(const QString &field);
    void addRow(const QString &name, const QJsonValue &fields);
    void addCard();
    void keep();
    void importTable();
    void exportTable();
    void filter();
    void showButtons();
    QJsonArray typed() const; ///< the cards as they stand in the table, named ones only
    void putIn(const QString &file, const std::shared_ptr<QTemporaryFile> &ours = {});

    RegistryCaller &m_caller;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QJsonArray m_cards; ///< as the registry has them
    QStringList m_fields; ///< of the columns behind the name
    int m_shownKind = 0;
    QComboBox *m_kind;
    QLineEdit *m_text;
    QTableWidget *m_table;
    QPushButton *m_add;
    QPushButton *m_keep;
    QPushButton *m_import;
    QPushButton *m_export;
};

} // namespace dyncal
