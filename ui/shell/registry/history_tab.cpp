// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/history_tab.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/history_rows.h"
#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/rows_view.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr int kPlotShare = 3, kTableShare = 2;

QJsonObject objectOf(const ProgramAnswer &answer)
{
    return QJsonDocument::fromJson(answer.out).object();
}

/// As the command takes them: "1000,1e4", typed with blanks or semicolons between, and the decimal
/// mark of either language.
QString frequenciesOf(QString typed)
{
    return typed.replace(',', '.')
        .split(QRegularExpression(QStringLiteral("[;\\s]+")), Qt::SkipEmptyParts)
        .join(',');
}

} // namespace

HistoryTab::HistoryTab(
    RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QWidget(parent)
    , m_caller(caller)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_folderLabel(new QLabel(this))
    , m_folder(new QLineEdit(preferences.issuing(Preferences::Issuing::Folder), this))
    , m_choose(new QPushButton(this))
    , m_sensorLabel(new QLabel(this))
    , m_sensor(new QComboBox(this))
    , m_frequenciesLabel(new QLabel(this))
    , m_frequencies(new QLineEdit(this))
    , m_seriesLabel(new QLabel(this))
    , m_series(new QComboBox(this))
    , m_save(new QPushButton(this))
    , m_plot(new PlotWidget(this))
    , m_table(new RowsView("historyTable", this))
    , m_summary(new QLabel(this))
{
    const std::initializer_list<std::tuple<QLabel *, QWidget *, const char *>> named{
        {m_folderLabel, m_folder, "historyFolder"}, {m_sensorLabel, m_sensor, "historySensor"},
        {m_frequenciesLabel, m_frequencies, "historyFrequencies"},
        {m_seriesLabel, m_series, "historySeries"}};
    for (const auto &[label, field, name] : named) {
        field->setObjectName(QLatin1String(name));
        label->setBuddy(field);
    }
    m_choose->setObjectName("historyChoose");
    m_save->setObjectName("historySave");
    m_plot->setObjectName("historyPlot");
    m_summary->setObjectName("historySummary");
    m_summary->setWordWrap(true);
    for (QComboBox *combo : {m_sensor, m_series})
        combo->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto *sources = new QHBoxLayout;
    for (QWidget *field : std::initializer_list<QWidget *>{
             m_folderLabel, m_folder, m_choose, m_sensorLabel, m_sensor})
        sources->addWidget(field, field == m_folder ? 1 : 0);
    auto *choices = new QHBoxLayout;
    for (QWidget *field : std::initializer_list<QWidget *>{
             m_seriesLabel, m_series, m_frequenciesLabel, m_frequencies, m_save})
        choices->addWidget(field, field == m_frequencies ? 1 : 0);
    auto *column = new QVBoxLayout(this);
    column->addLayout(sources);
    column->addLayout(choices);
    column->addWidget(m_plot, kPlotShare);
    column->addWidget(m_table, kTableShare);
    column->addWidget(m_summary);
    for (QPushButton *button : {m_choose, m_save})
        button->setAutoDefault(false); // Return ends the typing of the folder
    connect(m_folder, &QLineEdit::editingFinished, this, &HistoryTab::refresh);
    connect(m_choose, &QPushButton::clicked, this, &HistoryTab::askForFolder);
    connect(m_sensor, &QComboBox::activated, this, &HistoryTab::read);
    connect(m_frequencies, &QLineEdit::editingFinished, this, &HistoryTab::read);
    connect(m_series, &QComboBox::activated, this, &HistoryTab::showSeries);
    connect(m_save, &QPushButton::clicked, this, &HistoryTab::save);
    connect(m_plot, &PlotWidget::exportRequested, this, [this] { emit plotExport(m_plot); });
    show({});
}

void HistoryTab::showWords()
{
    m_folderLabel->setText(tr("&Results in"));
    m_folder->setToolTip(
        tr("The folder of issued certificates, of results, or any folder above such"));
    m_choose->setText(tr("C&hoose..."));
    m_sensorLabel->setText(tr("&Sensor"));
    m_sensor->setToolTip(tr("Serial number"));
    m_seriesLabel->setText(tr("&Quantity"));
    m_frequenciesLabel->setText(tr("S(f) &at, in Hz"));
    m_frequencies->setPlaceholderText(tr("1000; 10000"));
    m_frequencies->setToolTip(tr(
        "Frequencies of which magnitude and phase are followed; the nearest row within 3 % serves"));
    m_save->setText(tr("Sa&ve table..."));
    m_table->setTitles({tr("Day"), tr("Certificate"), tr("Value"), tr("U"), tr("k"), tr("Eₙ"),
                           tr("Control chart"), tr("Remark")},
        tr("Calibrations of the sensor"));
    show(m_history);
}

void HistoryTab::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (!m_isRead)
        refresh();
}

void HistoryTab::refresh()
{
    m_isRead = isVisible();
    if (!m_isRead)
        return;
    const QString folder = m_folder->text().trimmed();
    if (folder.isEmpty() || !QDir(folder).exists()) {
        takeSensors({});
        return;
    }
    m_caller.read(*this, {"history", folder, "--sensors", "--json"},
        [this](const ProgramAnswer &answer) { takeSensors(objectOf(answer)); });
}

void HistoryTab::takeSensors(const QJsonObject &answer)
{
    const QString before = m_sensor->currentData().toString();
    const QSignalBlocker quiet(m_sensor);
    m_sensor->clear();
    for (const QJsonValue one : answer["sensors"].toArray()) {
        const QString serial = one["serial"].toString();
        m_sensor->addItem(
            tr("%1 (%2)").arg(shownText(serial), QString::number(one["calibrations"].toInteger())),
            serial);
    }
    m_sensor->setCurrentIndex(std::max(0, m_sensor->findData(before)));
    if (m_sensor->count() > 0)
        read();
    else
        show({});
}

QStringList HistoryTab::command() const
{
    QStringList arguments{"history", m_folder->text().trimmed(), "--in-force",
        "--sensor=" + m_sensor->currentData().toString()};
    if (const QString at = frequenciesOf(m_frequencies->text()); !at.isEmpty())
        arguments << "--at=" + at;
    return arguments;
}

void HistoryTab::read()
{
    if (m_sensor->count() > 0)
        m_caller.read(*this, command() << "--json",
            [this](const ProgramAnswer &answer) { show(objectOf(answer)); });
}

void HistoryTab::show(const QJsonObject &history)
{
    m_history = history;
    const int before = std::max(0, m_series->currentIndex());
    const QSignalBlocker quiet(m_series);
    m_series->clear();
    for (const QJsonValue one : m_history["series"].toArray())
        m_series->addItem(seriesTitle(one));
    m_series->setCurrentIndex(before < m_series->count() ? before : 0);
    m_save->setEnabled(m_series->count() > 0);
    showSeries();
}

void HistoryTab::showSeries()
{
    const int series = m_series->currentIndex();
    if (series < 0) {
        m_plot->setContent({});
        m_plot->setNotice(
            tr("Choose a folder with results of calibrations that state the serial number of the sensor."),
            false);
        m_table->setRows({});
        m_summary->clear();
        return;
    }
    m_plot->setNotice({}, false);
    m_plot->setContent(historyContent(m_history, series));
    m_plot->fit(); // another quantity has another range
    m_table->setRows(historyRows(m_history, series));
    m_summary->setText(historySummary(m_history, series));
}

void HistoryTab::askForFolder()
{
    const QString path
        = m_prompts.folder(this, tr("Folder with results"), m_preferences.lastFolder());
    if (path.isEmpty())
        return;
    m_folder->setText(path);
    refresh();
}

void HistoryTab::save()
{
    const QString path = m_prompts.saveFile(this, tr("Save table"), tr("Tables (*.csv)"),
        QDir(m_preferences.lastFolder()).filePath("history.csv"), "csv");
    if (path.isEmpty())
        return;
    m_caller.call(command() << "-o" << path, [this, path](const ProgramAnswer &) {
        emit written(tr("The history is in %1.").arg(shownText(path)));
    });
}

} // namespace dyncal
