// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_text_box.h"

#include "ui/session/import_choices.h"
#include "ui/shell/import/import_preview_table.h"
#include "ui/shell/import/named_control.h"
#include "ui/stages/frame/position_in.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

constexpr int kAutomatic = -1; ///< of the header rows

const std::array<std::string, 6> kSeparators{"auto", ",", ";", "tab", "space", "|"};
const std::array<std::string, 3> kDecimals{"auto", ".", ","};

QString decimalName(char decimal)
{
    return decimal == ',' ? ImportTextBox::tr("comma") : ImportTextBox::tr("point");
}

QString separatorName(char separator)
{
    switch (separator) {
    case '\t':
        return ImportTextBox::tr("tab");
    case ' ':
        return ImportTextBox::tr("blanks");
    default:
        return QChar::fromLatin1(separator);
    }
}

} // namespace

ImportTextBox::ImportTextBox(QWidget *parent)
    : QGroupBox(tr("Text table"), parent)
    , m_separator(named(new QComboBox(this), "importSeparator", tr("Separator")))
    , m_decimal(named(new QComboBox(this), "importDecimal", tr("Decimal mark")))
    , m_header(named(new QSpinBox(this), "importHeader", tr("Header rows")))
    , m_time(named(new QComboBox(this), "importTime", tr("Time from")))
    , m_shots(named(new QCheckBox(tr("Each column is a shot of one sensor"), this),
          "importShotColumns", tr("Each column is a shot of one sensor")))
    , m_preview(new ImportPreviewTable(this))
    , m_counts(new QLabel(this))
{
    m_separator->addItems(
        {{}, tr("comma ,"), tr("semicolon ;"), tr("tab"), tr("blanks"), tr("bar |")});
    connect(m_separator, &QComboBox::activated, this, [this](int choice) {
        emit separatorChosen(kSeparators[static_cast<std::size_t>(choice)]);
    });
    m_decimal->addItems({{}, tr("point ."), tr("comma ,")});
    connect(m_decimal, &QComboBox::activated, this,
        [this](int choice) { emit decimalChosen(kDecimals[static_cast<std::size_t>(choice)]); });
    m_header->setRange(kAutomatic, 1'000'000'000);
    connect(m_header, &QSpinBox::valueChanged, this, [this](int rows) {
        emit headerChosen(rows == kAutomatic ? std::nullopt : std::optional<Index>(rows));
    });
    connect(m_time, &QComboBox::activated, this, &ImportTextBox::timesChosen);
    m_shots->setToolTip(tr(
        "The columns are records of the same sensor, shot after shot; else they are channels that were recorded together"));
    connect(m_shots, &QCheckBox::clicked, this, &ImportTextBox::shotColumnsChosen);
    m_counts->setObjectName("importCounts");

    auto *settings = new QGridLayout;
    int place = 0;
    for (QWidget *control :
        std::initializer_list<QWidget *>{m_separator, m_decimal, m_header, m_time}) {
        const int row = place / 2, column = 2 * (place % 2);
        settings->addWidget(new QLabel(control->accessibleName(), this), row, column);
        settings->addWidget(control, row, column + 1);
        settings->setColumnStretch(column + 1, 1);
        ++place;
    }
    for (QComboBox *choice : {m_separator, m_decimal, m_time})
        choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto *column = new QVBoxLayout(this);
    column->addLayout(settings);
    column->addWidget(m_shots, 0, Qt::AlignLeft);
    column->addWidget(m_preview);
    column->addWidget(m_counts);
}

void ImportTextBox::showSettings(const ImportSettings &settings)
{
    m_separator->setCurrentIndex(positionIn(kSeparators, settings.separator));
    m_decimal->setCurrentIndex(positionIn(kDecimals, settings.decimal));
    m_shots->setChecked(settings.columnsAre == kColumnsAreShots);
    const QSignalBlocker quiet(m_header);
    m_header->setValue(static_cast<int>(settings.skipRows.value_or(kAutomatic)));
}

void ImportTextBox::showView(const ImportView &view, const ImportSettings &settings)
{
    setVisible(view.text || view.format == "text");
    m_preview->setVisible(view.text.has_value());
    m_counts->setVisible(view.text.has_value());
    if (!view.text)
        return;
    const TextPreview &text = *view.text;
    m_separator->setItemText(0, tr("automatic: %1").arg(separatorName(text.separator)));
    m_decimal->setItemText(0, tr("automatic: %1").arg(decimalName(text.decimal)));
    m_header->setSpecialValueText(tr("automatic: %1").arg(text.headerLines));
    showTimes(text, settings);
    m_preview->setPreview(text);
    m_counts->setText(tr("%1 rows looked at, unreadable cells: %2. Text: %3.")
                          .arg(text.dataRows)
                          .arg(text.unreadableCells)
                          .arg(shownText(text.encoding)));
}

void ImportTextBox::showTimes(const TextPreview &text, const ImportSettings &settings)
{
    m_time->clear();
    const auto titleOf = [&](Index column) {
        return shownText(text.columnTitles[static_cast<std::size_t>(column)]);
    };
    m_time->addItem(!leavesTimesOut(settings) && text.timeColumn
            ? tr("automatic: %1").arg(titleOf(*text.timeColumn))
            : tr("automatic"));
    m_time->addItem(tr("no column: the rate is given"));
    for (Index column = 0; column < static_cast<Index>(text.columnTitles.size()); ++column)
        m_time->addItem(tr("column %1: %2").arg(column + 1).arg(titleOf(column)));
    const auto time = settings.columns.find("time");
    m_time->setCurrentIndex(time != settings.columns.end()
            ? TimeFirstColumn + static_cast<int>(time->second)
            : (leavesTimesOut(settings) ? TimeNone : TimeAuto));
}

} // namespace dyncal
