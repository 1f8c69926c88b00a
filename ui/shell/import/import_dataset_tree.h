// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/preview/foreign_datasets.h"
#include "ui/session/import_view.h"

#include <QTreeWidget>

#include <optional>
#include <vector>

namespace dyncal {

/// What an HDF5 file of another program holds, as a tree: shape, type and attributes of every
/// dataset, and the role of those that can be channels.
class ImportDatasetTree : public QTreeWidget
{
    Q_OBJECT

public:
    explicit ImportDatasetTree(QWidget *parent = nullptr);

    /// `channels`: those that are read now. Hidden without datasets.
    void setDatasets(
        const std::vector<DatasetEntry> &datasets, const std::vector<ImportChannel> &channels);

signals:
    /// The channel's name; no role: it shall not be read.
    void roleChosen(const QString &channel, std::optional<dyncal::ChannelRole> role);

private:
    void addDataset(const DatasetEntry &dataset);
    QTreeWidgetItem *groupOf(const QString &path);
    void addChoice(QTreeWidgetItem *item, const QString &channel);

    std::vector<DatasetEntry> m_datasets; ///< of the rows made
};

} // namespace dyncal
