// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_dataset_tree.h"

#include "ui/shell/import/offered_roles.h"
#include "ui/text/core_text.h"
#include "ui/text/level_text.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QHeaderView>

#include <algorithm>

namespace dyncal {

namespace {

enum TreeColumn { NameColumn, ReadAsColumn, ExtentsColumn, TypeColumn, AboutColumn, ColumnCount };

QString shapeText(const std::vector<std::uint64_t> &shape)
{
    QStringList extents;
    for (const std::uint64_t extent : shape)
        extents << QString::number(extent);
    return extents.isEmpty() ? ImportDatasetTree::tr("one value")
                             : extents.join(QStringLiteral(" × "));
}

QString attributesText(const Attributes &attributes)
{
    QStringList lines;
    for (const auto &[name, value] : attributes)
        lines << QStringLiteral("%1 = %2").arg(shownText(name), shownText(value));
    return lines.join(QStringLiteral("; "));
}

bool sameEntry(const DatasetEntry &a, const DatasetEntry &b)
{
    return a.path == b.path && a.shape == b.shape && a.channels == b.channels;
}

} // namespace

ImportDatasetTree::ImportDatasetTree(QWidget *parent)
    : QTreeWidget(parent)
{
    setObjectName("importDatasets");
    setAccessibleName(tr("Datasets of the file"));
    setColumnCount(ColumnCount);
    setHeaderLabels({tr("Dataset"), tr("Read as"), tr("Shape"), tr("Type"), tr("Attributes")});
    setSelectionMode(QAbstractItemView::NoSelection);
    setMinimumHeight(140);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setStretchLastSection(true);
    hide();
}

void ImportDatasetTree::setDatasets(
    const std::vector<DatasetEntry> &datasets, const std::vector<ImportChannel> &channels)
{
    if (!std::ranges::equal(datasets, m_datasets, sameEntry)) { // only then: open groups stay open
        clear();
        for (const DatasetEntry &dataset : datasets)
            addDataset(dataset);
        expandAll();
        m_datasets = datasets;
    }
    setVisible(!datasets.empty());
    for (QComboBox *choice : findChildren<QComboBox *>()) {
        const auto read = std::ranges::find(channels, choice->property("channel").toString(),
            [](const ImportChannel &channel) { return rawText(channel.name); });
        const auto role = read == channels.end() ? kOfferedRoles.end()
                                                 : std::ranges::find(kOfferedRoles, read->role);
        choice->setCurrentIndex(
            role == kOfferedRoles.end() ? 0 : 1 + static_cast<int>(role - kOfferedRoles.begin()));
    }
}

void ImportDatasetTree::addDataset(const DatasetEntry &dataset)
{
    const QString path = rawText(dataset.path);
    const qsizetype slash = path.lastIndexOf('/');
    QTreeWidgetItem *group = groupOf(path.left(std::max<qsizetype>(slash, 0)));
    auto *item = new QTreeWidgetItem(group);
    item->setText(NameColumn, shownText(path.mid(slash + 1)));
    item->setText(ExtentsColumn, shapeText(dataset.shape));
    item->setText(TypeColumn, shownText(dataset.type));
    const QString attributes = attributesText(dataset.attributes);
    const QString about = dataset.channels.empty() ? translated(dataset.whyNot) : attributes;
    item->setText(AboutColumn, about);
    item->setToolTip(AboutColumn, attributes.isEmpty() ? about : attributes);
    if (dataset.channels.size() == 1)
        addChoice(item, rawText(dataset.channels.front()));
    for (const std::string &channel : dataset.channels) {
        if (dataset.channels.size() == 1)
            break;
        auto *column = new QTreeWidgetItem(item);
        column->setText(NameColumn, shownText(channel));
        addChoice(column, rawText(channel));
    }
}

/// The row of a group, made where it is not there yet; the root is the tree itself.
QTreeWidgetItem *ImportDatasetTree::groupOf(const QString &path)
{
    QTreeWidgetItem *group = invisibleRootItem();
    for (const QString &name : path.split('/', Qt::SkipEmptyParts)) {
        QTreeWidgetItem *next = nullptr;
        for (int i = 0; i < group->childCount() && next == nullptr; ++i) {
            QTreeWidgetItem *child = group->child(i);
            next = child->text(NameColumn) == shownText(name) && child->text(TypeColumn).isEmpty()
                ? child
                : nullptr;
        }
        if (next == nullptr) {
            next = new QTreeWidgetItem(group);
            next->setText(NameColumn, shownText(name));
            next->setText(ExtentsColumn, tr("group"));
        }
        group = next;
    }
    return group;
}

void ImportDatasetTree::addChoice(QTreeWidgetItem *item, const QString &channel)
{
    auto *choice = new QComboBox(this);
    choice->setObjectName("readAs:" + channel);
    choice->setAccessibleName(tr("What %1 is read as").arg(shownText(channel)));
    choice->setProperty("channel", channel);
    choice->addItem(tr("not read"));
    for (const ChannelRole role : kOfferedRoles)
        choice->addItem(roleText(role));
    connect(choice, &QComboBox::activated, this, [this, channel](int picked) {
        emit roleChosen(channel,
            picked == 0 ? std::nullopt
                        : std::optional(kOfferedRoles[static_cast<std::size_t>(picked - 1)]));
    });
    setItemWidget(item, ReadAsColumn, choice);
}

} // namespace dyncal
