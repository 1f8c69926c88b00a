// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/cards_tab.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/rows_view.h"
#include "ui/stages/certificate/field_labels.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QTemporaryFile>
#include <QVBoxLayout>

#include <array>

namespace dyncal {

namespace {

struct CardKind
{
    const char *key;
    const char *text;
    QStringList fields; ///< those that fill something in (docs/registry.md)
};

const std::array<CardKind, 4> &cardKinds()
{
    static const std::array<CardKind, 4> kinds{{
        {"laboratory", QT_TRANSLATE_NOOP("dyncal::CardsTab", "Laboratories"),
            {"laboratory_address", "laboratory_country", "place"}},
        {"customer", QT_TRANSLATE_NOOP("dyncal::CardsTab", "Customers"),
            {"customer_address", "customer_country"}},
        {"sensor", QT_TRANSLATE_NOOP("dyncal::CardsTab", "Sensors"),
            {"sensor_serial", "sensor_manufacturer", "sensor_model", "sensor_description"}},
        {"reference", QT_TRANSLATE_NOOP("dyncal::CardsTab", "Reference instruments"),
            {"quantity", "certificate", "due"}},
    }};
    return kinds;
}

} // namespace

CardsTab::CardsTab(
    RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QWidget(parent)
    , m_caller(caller)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_kind(new QComboBox(this))
    , m_text(new QLineEdit(this))
    , m_table(new QTableWidget(this))
    , m_add(addButton("cardAdd", &CardsTab::addCard))
    , m_keep(addButton("cardKeep", &CardsTab::keep))
    , m_import(addButton("cardImport", &CardsTab::importTable))
    , m_export(addButton("cardExport", &CardsTab::exportTable))
{
    m_kind->setObjectName("cardKind");
    m_text->setObjectName("cardText");
    m_text->setClearButtonEnabled(true);
    m_table->setObjectName("cardTable");
    m_table->setAlternatingRowColors(true);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setMaximumSectionSize(
        kWidestColumn_chars * fontMetrics().averageCharWidth());
    auto *line = new QHBoxLayout;
    line->addWidget(m_kind);
    line->addWidget(m_text, 1);
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {m_add, m_keep, m_import, m_export})
        buttons->addWidget(button);
    buttons->addStretch();
    auto *column = new QVBoxLayout(this);
    column->addLayout(line);
    column->addWidget(m_table, 1);
    column->addLayout(buttons);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &CardsTab::showKind);
    connect(m_text, &QLineEdit::textChanged, this, &CardsTab::filter);
    connect(m_table, &QTableWidget::cellChanged, this, &CardsTab::showButtons);
    connect(&m_caller, &RegistryCaller::busyChanged, this, &CardsTab::showButtons);
}

QPushButton *CardsTab::addButton(const char *name, void (CardsTab::*act)())
{
    auto *button = new QPushButton(this);
    button->setObjectName(name);
    button->setAutoDefault(false); // Return ends the typing in a cell
    connect(button, &QPushButton::clicked, this, act);
    return button;
}

void CardsTab::showWords()
{
    const QSignalBlocker quiet(m_kind);
    m_kind->clear();
    for (const CardKind &kind : cardKinds())
        m_kind->addItem(tr(kind.text), QString(kind.key));
    m_kind->setCurrentIndex(m_shownKind);
    m_kind->setAccessibleName(tr("Which cards"));
    m_text->setPlaceholderText(tr("Search"));
    m_text->setAccessibleName(tr("Show only cards that hold this text"));
    m_table->setAccessibleName(tr("Cards"));
    m_add->setText(tr("&Add card"));
    m_keep->setText(tr("&Keep changes..."));
    m_keep->setToolTip(tr("Put what was typed into the registry, with a reason"));
    m_import->setText(tr("&Import..."));
    m_import->setToolTip(tr("Take cards from a CSV file with a column \"name\""));
    m_export->setText(tr("&Export..."));
    m_export->setToolTip(tr("Write these cards as CSV"));
    if (m_table->columnCount() > 0)
        showTitles();
    showButtons();
}

QString CardsTab::kind() const
{
    return m_kind->itemData(m_shownKind).toString();
}

/// Another kind, once what is typed is kept or dropped.
void CardsTab::showKind()
{
    const int next = m_kind->currentIndex();
    const Answer answer = isChanged() ? m_prompts.saveChanges(this, m_kind->itemText(m_shownKind))
                                      : Answer::Discard;
    if (answer == Answer::Discard) {
        m_shownKind = next;
        read();
        return;
    }
    const QSignalBlocker quiet(m_kind);
    m_kind->setCurrentIndex(m_shownKind);
    if (answer == Answer::Save)
        keep();
}

void CardsTab::refresh()
{
    if (!isChanged())
        read();
}

void CardsTab::read()
{
    m_caller.read(
        *this, {"registry", "cards", kind(), "--json"}, [this](const ProgramAnswer &answer) {
            m_cards = listOf(answer.out);
            showCards();
        });
}

void CardsTab::showCards()
{
    m_fields = cardKinds()[static_cast<std::size_t>(m_shownKind)].fields;
    for (const QJsonValue card : std::as_const(m_cards))
        for (const QString &field : card["fields"].toObject().keys())
            if (!m_fields.contains(field))
                m_fields << field;
    m_table->setRowCount(0);
    m_table->setColumnCount(static_cast<int>(m_fields.size()) + 1);
    showTitles();
    for (const QJsonValue card : std::as_const(m_cards))
        addRow(card["name"].toString(), card["fields"]);
    m_table->resizeColumnsToContents();
    filter();
    showButtons();
}

/// The name of a card is what its entries in the trail are found by, so it stays.
void CardsTab::addRow(const QString &name, const QJsonValue &fields)
{
    const QSignalBlocker quiet(m_table); // until the row is whole
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    auto *head = new QTableWidgetItem(name);
    if (!name.isEmpty())
        head->setFlags(head->flags() & ~Qt::ItemIsEditable);
    m_table->setItem(row, 0, head);
    for (int column = 1; column < m_table->columnCount(); ++column)
        m_table->setItem(
            row, column, new QTableWidgetItem(fields[m_fields[column - 1]].toString()));
}

void CardsTab::showTitles()
{
    QStringList titles{tr("Name")};
    for (const QString &field : std::as_const(m_fields))
        titles << titleOf(field);
    m_table->setHorizontalHeaderLabels(titles);
}

/// What the form of the certificate calls it; a field that is the laboratory's own, as it is.
QString CardsTab::titleOf(const QString &field)
{
    if (field == QLatin1String("quantity"))
        return tr("Quantity of the budget");
    if (field == QLatin1String("certificate"))
        return tr("Its certificate");
    if (field == QLatin1String("due"))
        return tr("Due for calibration");
    const QString label = fieldLabel(field.toStdString());
    return label.isEmpty() ? shownText(field) : label;
}

void CardsTab::addCard()
{
    m_text->clear(); // which would hide it
    addRow({}, {});
    const int row = m_table->rowCount() - 1;
    m_table->setCurrentCell(row, 0);
    m_table->editItem(m_table->item(row, 0));
}

QJsonArray CardsTab::typed() const
{
    QJsonArray cards;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QJsonObject fields;
        for (int column = 1; column < m_table->columnCount(); ++column)
            if (const QString text = m_table->item(row, column)->text(); !text.isEmpty())
                fields[m_fields[column - 1]] = text;
        const QString name = m_table->item(row, 0)->text();
        if (!name.isEmpty() || !fields.isEmpty())
            cards.append(QJsonObject{{"name", name}, {"fields", fields}});
    }
    return cards;
}

bool CardsTab::isChanged() const
{
    return m_table->columnCount() > 0 && typed() != m_cards;
}

void CardsTab::keep()
{
    const auto file = std::make_shared<QTemporaryFile>();
    file->setFileTemplate(file->fileTemplate() + ".json");
    if (!file->open() || file->write(QJsonDocument(typed()).toJson()) < 0 || !file->flush()) {
        m_prompts.showProblem(this,
            tr("The changes could not be written to a temporary file: %1.")
                .arg(file->errorString()));
        return;
    }
    putIn(file->fileName(), file);
}

void CardsTab::importTable()
{
    const QString path = m_prompts.openFile(
        this, tr("Cards to take"), tr("Tables (*.csv)"), m_preferences.lastFolder());
    if (!path.isEmpty())
        putIn(path);
}

/// A file of ours is there until it was read.
void CardsTab::putIn(const QString &file, const std::shared_ptr<QTemporaryFile> &ours)
{
    const auto reason
        = m_prompts.sentence(this, tr("Change cards"), tr("Why, for the audit trail:"));
    if (!reason)
        return;
    m_caller.call({"registry", "import", kind(), file, "--reason=" + *reason},
        [this, ours](const ProgramAnswer &) {
            read();
            emit changed(tr("The cards are kept."));
        });
}

void CardsTab::exportTable()
{
    const QString path = m_prompts.saveFile(this, tr("Cards to write"), tr("CSV (*.csv)"),
        m_preferences.lastFolder() + '/' + kind() + ".csv", "csv");
    if (path.isEmpty())
        return;
    m_caller.call({"registry", "cards", kind()}, [this, path](const ProgramAnswer &answer) {
        QSaveFile file(path);
        const bool isWritten = file.open(QIODevice::WriteOnly)
            && file.write(answer.out) == answer.out.size() && file.commit();
        if (isWritten)
            emit changed(tr("Written: %1").arg(shownText(QFileInfo(path).fileName())));
        else
            m_prompts.showProblem(
                this, tr("%1 could not be written: %2.").arg(shownText(path), file.errorString()));
    });
}

void CardsTab::filter()
{
    for (int row = 0; row < m_table->rowCount(); ++row) {
        bool holds = m_text->text().isEmpty();
        for (int column = 0; column < m_table->columnCount() && !holds; ++column)
            holds
                = m_table->item(row, column)->text().contains(m_text->text(), Qt::CaseInsensitive);
        m_table->setRowHidden(row, !holds);
    }
}

void CardsTab::showButtons()
{
    const bool isFree = !m_caller.isBusy();
    const bool isRead = m_table->columnCount() > 0;
    m_kind->setEnabled(isFree);
    m_add->setEnabled(isFree && isRead);
    m_keep->setEnabled(isFree && isChanged());
    m_import->setEnabled(isFree);
    m_export->setEnabled(isFree && !m_cards.isEmpty());
}

} // namespace dyncal
