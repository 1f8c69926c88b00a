// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_settings.h"
#include "ui/session/import_view.h"

#include <QTableWidget>

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The channels of a file: the role of each, and what its values are. Columns that are shots of one
/// sensor have a row each; what is said of one is said of all.
class ImportChannelTable : public QTableWidget
{
    Q_OBJECT

public:
    explicit ImportChannelTable(QWidget *parent = nullptr);
    /// `details`: what the settings say of each channel, by name.
    void setChannels(const std::vector<ImportChannel> &channels,
        const std::map<std::string, ChannelImport> &details);

signals:
    void roleChosen(int channel, dyncal::ChannelRole role); ///< position in the list
    void detailsChanged(int channel, const dyncal::ChannelImport &details);

private:
    void makeRow(int row, const ImportChannel &channel);
    void makeNumbers(int row, const QString &name);
    void makeSense(int row, const QString &name);
    void put(int row, int column, QWidget *control, const char *id, const QString &accessible);
    void fillRow(int row, const ImportChannel &channel);
    void change(int row, const std::function<void(ChannelImport &)> &edit);

    std::vector<std::pair<std::string, bool>> m_rows; ///< made: title, and whether it is a shot
    std::vector<ChannelImport> m_details; ///< one per row
};

} // namespace dyncal
