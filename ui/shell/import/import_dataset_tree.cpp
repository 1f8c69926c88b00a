// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_dataset_tree.h"

#include "ui/text/core_text.h"
#include "ui/text/level_text.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QHeaderView>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

enum Column { Name, ReadAs, Extents, Type, About, Count };

constexpr std::array kRoles{ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver,
    ChannelRole::Trigger, ChannelRole::Reference, ChannelRole::Other};

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
    setColumnCount(Count);
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
        const auto role
            = read == channels.end() ? kRoles.end() : std::ranges::find(kRoles, read->role);
        choice->setCurrentIndex(
            role == kRoles.end() ? 0 : 1 + static_cast<int>(role - kRoles.begin()));
    }
}

void ImportDatasetTree::addDataset(const DatasetEntry &dataset)
{
    const QString path = rawText(dataset.path);
    const qsizetype slash = path.lastIndexOf('/');
    QTreeWidgetItem *group = groupOf(path.left(std::max<qsizetype>(slash, 0)));
    auto *item = new QTreeWidgetItem(group);
    item->setText(Name, shownText(path.mid(slash + 1)));
    item->setText(Extents, shapeText(dataset.shape));
    item->setText(Type, shownText(dataset.type));
    const QString attributes = attributesText(dataset.attributes);
    const QString about = dataset.channels.empty() ? translated(dataset.whyNot) : attributes;
    item->setText(About, about);
    item->setToolTip(About, attributes.isEmpty() ? about : attributes);
    if (dataset.channels.size() == 1)
        addChoice(item, rawText(dataset.channels.front()));
    for (const std::string &channel : dataset.channels) {
        if (dataset.channels.size() == 1)
            break;
        auto *column = new QTreeWidgetItem(item);
        column->setText(Name, shownText(channel));
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
            next = child->text(Name) == shownText(name) && child->text(Type).isEmpty() ? child
                                                                                       : nullptr;
        }
        if (next == nullptr) {
            next = new QTreeWidgetItem(group);
            next->setText(Name, shownText(name));
            next->setText(Extents, tr("group"));
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
    for (const ChannelRole role : kRoles)
        choice->addItem(roleText(role));
    connect(choice, &QComboBox::activated, this, [this, channel](int picked) {
        emit roleChosen(channel,
            picked == 0 ? std::nullopt
                        : std::optional(kRoles[static_cast<std::size_t>(picked - 1)]));
    });
    setItemWidget(item, ReadAs, choice);
}

} // namespace dyncal
