// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_channel_table.h"

#include "core/capture/channel_units.h"
#include "ui/shell/import/fixed_item.h"
#include "ui/shell/import/offered_roles.h"
#include "ui/shell/import/trace_cell.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/position_in.h"
#include "ui/text/level_text.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

enum Column {
    Name,
    Role,
    Trace,
    Looks,
    Unit,
    Factor,
    Gain,
    Sensitivity,
    Inverted,
    Pressure,
    Samples,
    Count
};

const std::array<std::string, 3> kReferences{"", "gauge", "absolute"};
constexpr int kMostChars = 45; ///< of a column
constexpr int kUnitChars = 14;
constexpr int kNumberChars = 14;
constexpr int kSensitivityChars = 26; ///< with its unit
constexpr double kMillivoltPerKilopascal = 1e-6; ///< in V/Pa
constexpr double kSmallest = 1e-30;
constexpr double kLargest = 1e30;

/// "1" is what readers say where a file has nothing.
bool isStated(const std::string &unit)
{
    return !unit.empty() && unit != "1";
}

/// What the record shows, what it may be, and what is not known of its unit.
QString looksText(const ImportChannel &channel, const ChannelImport &details)
{
    const std::string unit = details.unit.value_or(channel.unit);
    QStringList lines{glanceText(channel.glance, isStated(unit) ? shownText(unit) : QString())};
    if (channel.proposed != ChannelRole::Other)
        lines << ImportChannelTable::tr("may be: %1").arg(roleText(channel.proposed));
    if (!isStated(unit))
        lines << ImportChannelTable::tr("unit not known");
    else if (!siUnitOf(unit))
        lines << ImportChannelTable::tr("unit %1 is not converted").arg(shownText(unit));
    lines.removeAll(QString());
    return lines.join(QStringLiteral("; "));
}

/// What the row is called: shots that are columns of one sensor share the channel's name.
const std::string &titleOf(const ImportChannel &channel)
{
    return channel.shot > 0 ? channel.title : channel.name;
}

} // namespace

ImportChannelTable::ImportChannelTable(QWidget *parent)
    : QTableWidget(0, Count, parent)
{
    setObjectName("importChannels");
    setAccessibleName(tr("Channels of the file"));
    setHorizontalHeaderLabels({tr("Channel"), tr("Role"), tr("Trace"), tr("Looks like"), tr("Unit"),
        tr("Factor"), tr("Gain"), tr("Sensitivity / (mV/kPa)"), tr("Inverted"), tr("Pressure"),
        tr("Samples")});
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setTabKeyNavigation(false); // Tab goes through the controls
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setMaximumSectionSize(kMostChars * fontMetrics().averageCharWidth());
}

void ImportChannelTable::setChannels(
    const std::vector<ImportChannel> &channels, const std::map<std::string, ChannelImport> &details)
{
    std::vector<std::pair<std::string, bool>> rows;
    m_details.clear();
    for (const ImportChannel &channel : channels) {
        rows.emplace_back(titleOf(channel), channel.shot > 0);
        const auto known = details.find(channel.name);
        m_details.push_back(known == details.end() ? ChannelImport{} : known->second);
    }
    if (rows != m_rows) { // only then: what is being typed stays
        setRowCount(0);
        setRowCount(static_cast<int>(channels.size()));
        for (int row = 0; row < rowCount(); ++row)
            makeRow(row, channels[static_cast<std::size_t>(row)]);
        m_rows = std::move(rows);
    }
    bool counted = false;
    for (int row = 0; row < rowCount(); ++row) {
        fillRow(row, channels[static_cast<std::size_t>(row)]);
        counted = counted || channels[static_cast<std::size_t>(row)].samples > 0;
    }
    setColumnHidden(Samples, !counted);
    resizeColumnsToContents(); // before the rows, whose height follows from them
    resizeRowsToContents();
}

void ImportChannelTable::put(
    int row, int column, QWidget *control, const char *id, const QString &accessible)
{
    const QString objectName = QString("%1%2").arg(id).arg(row + 1);
    if (auto *number = qobject_cast<OptionalEdit *>(control))
        number->setNames(objectName, accessible);
    else
        control->setObjectName(objectName);
    control->setAccessibleName(accessible);
    setCellWidget(row, column, control);
}

void ImportChannelTable::makeRow(int row, const ImportChannel &channel)
{
    const QString name = shownText(titleOf(channel));
    put(row, Trace, new TraceCell(this), "importTrace", tr("Trace of channel %1").arg(name));
    if (channel.shot == 0) {
        auto *role = new QComboBox(this);
        for (const ChannelRole choice : kOfferedRoles)
            role->addItem(roleText(choice));
        connect(role, &QComboBox::activated, this, [this, row](int choice) {
            emit roleChosen(row, kOfferedRoles[static_cast<std::size_t>(choice)]);
        });
        put(row, Role, role, "importRole", tr("Role of channel %1").arg(name));
    }

    auto *unit = new QLineEdit(this);
    unit->setMaximumWidth(kUnitChars * fontMetrics().averageCharWidth());
    connect(unit, &QLineEdit::editingFinished, this, [this, row, unit] {
        const std::string text = unit->text().trimmed().toStdString();
        change(row, [&](ChannelImport &details) {
            details.unit = text.empty() ? std::nullopt : std::optional(text);
        });
    });
    put(row, Unit, unit, "importUnit", tr("Unit of channel %1").arg(name));
    makeNumbers(row, name);
    makeSense(row, name);
}

void ImportChannelTable::makeNumbers(int row, const QString &name)
{
    const auto number = [&](int column, const char *id, const QString &accessible, double si,
                            std::optional<double> ChannelImport::*member) {
        auto *edit
            = new OptionalEdit({column == Sensitivity ? QStringLiteral("mV/kPa") : QString(), si},
                kSmallest, kLargest, this);
        edit->setEmptyText(column == Sensitivity ? QString() : QStringLiteral("1"));
        edit->setMaximumWidth((column == Sensitivity ? kSensitivityChars : kNumberChars)
            * fontMetrics().averageCharWidth());
        connect(edit, &OptionalEdit::edited, this,
            [this, row, member](const std::optional<double> &value) {
                change(row, [&](ChannelImport &details) { details.*member = value; });
            });
        put(row, column, edit, id, accessible);
    };
    number(
        Factor, "importFactor", tr("Factor on channel %1").arg(name), 1.0, &ChannelImport::scale);
    number(Gain, "importGain", tr("Gain of channel %1").arg(name), 1.0, &ChannelImport::gain);
    number(Sensitivity, "importSensitivity", tr("Sensitivity of channel %1").arg(name),
        kMillivoltPerKilopascal, &ChannelImport::sensitivity);
}

/// Which way the values count, and from where.
void ImportChannelTable::makeSense(int row, const QString &name)
{
    auto *inverted = new QCheckBox(this);
    connect(inverted, &QCheckBox::clicked, this, [this, row](bool on) {
        change(row, [&](ChannelImport &details) { details.polarity = on ? -1 : 1; });
    });
    put(row, Inverted, inverted, "importInverted", tr("Inverted polarity of channel %1").arg(name));

    auto *pressure = new QComboBox(this);
    pressure->addItems({tr("as recorded"), tr("gauge"), tr("absolute")});
    connect(pressure, &QComboBox::activated, this, [this, row](int choice) {
        change(row, [&](ChannelImport &details) {
            details.reference = kReferences[static_cast<std::size_t>(choice)];
        });
    });
    put(row, Pressure, pressure, "importPressure", tr("Gauge or absolute, channel %1").arg(name));
}

void ImportChannelTable::fillRow(int row, const ImportChannel &channel)
{
    const ChannelImport &details = m_details[static_cast<std::size_t>(row)];
    setItem(row, Name, fixedItem(shownText(titleOf(channel))));
    static_cast<TraceCell *>(cellWidget(row, Trace))->setGlance(channel.glance);
    setItem(row, Looks, fixedItem(looksText(channel, details)));
    setItem(row, Samples,
        fixedItem(channel.samples > 0 ? QString::number(channel.samples) : QString()));
    if (channel.shot > 0)
        setItem(
            row, Role, fixedItem(tr("%1, shot %2").arg(roleText(channel.role)).arg(channel.shot)));
    else
        static_cast<QComboBox *>(cellWidget(row, Role))
            ->setCurrentIndex(positionIn(kOfferedRoles, channel.role));
    auto *unit = static_cast<QLineEdit *>(cellWidget(row, Unit));
    const bool stated = isStated(channel.unit);
    unit->setPlaceholderText(stated ? shownText(channel.unit) : tr("not stated"));
    if (!unit->hasFocus())
        unit->setText(rawText(details.unit.value_or("")));
    static_cast<OptionalEdit *>(cellWidget(row, Factor))->set(details.scale);
    static_cast<OptionalEdit *>(cellWidget(row, Gain))->set(details.gain);
    static_cast<OptionalEdit *>(cellWidget(row, Sensitivity))->set(details.sensitivity);
    static_cast<QCheckBox *>(cellWidget(row, Inverted))
        ->setChecked(details.polarity.value_or(1) < 0);
    static_cast<QComboBox *>(cellWidget(row, Pressure))
        ->setCurrentIndex(positionIn(kReferences, details.reference));
}

void ImportChannelTable::change(int row, const std::function<void(ChannelImport &)> &edit)
{
    ChannelImport &details = m_details[static_cast<std::size_t>(row)];
    const ChannelImport before = details;
    edit(details);
    if (!(details == before))
        emit detailsChanged(row, details);
}

} // namespace dyncal
