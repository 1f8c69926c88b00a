// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_settings.h"
#include "ui/session/import_view.h"

#include <QGroupBox>

#include <optional>
#include <string>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace dyncal {

class ImportPreviewTable;

/// How a text table is split into cells, what its columns are, and its first rows read that way.
/// "automatic" says what it found.
class ImportTextBox : public QGroupBox
{
    Q_OBJECT

public:
    explicit ImportTextBox(QWidget *parent = nullptr);

    void showSettings(const ImportSettings &settings);
    void showView(const ImportView &view, const ImportSettings &settings);

signals:
    void separatorChosen(const std::string &separator);
    void decimalChosen(const std::string &decimal);
    void headerChosen(std::optional<dyncal::Index> rows); ///< none = automatic
    void timesChosen(int choice); ///< TimeChoice
    void shotColumnsChosen(bool each); ///< whether each column is a shot

private:
    void showTimes(const TextPreview &text, const ImportSettings &settings);

    QComboBox *m_separator;
    QComboBox *m_decimal;
    QSpinBox *m_header;
    QComboBox *m_time;
    QCheckBox *m_shots; ///< each column is one
    ImportPreviewTable *m_preview;
    QLabel *m_counts;
};

} // namespace dyncal
