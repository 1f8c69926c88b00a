// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_settings.h"
#include "ui/session/import_view.h"

#include <QWidget>

#include <optional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace dyncal {

class OptionalEdit;

/// The sample rate of a file: what it says of itself, what is typed instead and why, and the choice
/// between two rates that contradict each other.
class ImportRateRow : public QWidget
{
    Q_OBJECT

public:
    explicit ImportRateRow(QWidget *parent = nullptr);

    void showSettings(const ImportSettings &settings);
    void showView(const ImportView &view, const ImportSettings &settings);

signals:
    void rateTyped(std::optional<double> rate_Hz);
    void reasonTyped(const QString &reason);
    void timesPreferred(const QString &reason); ///< over the header
    void headerPreferred(const QString &reason); ///< over the column of times

private:
    OptionalEdit *m_rate;
    QLineEdit *m_reason;
    QLabel *m_source;
    QPushButton *m_useTimes;
    QPushButton *m_useHeader;
};

} // namespace dyncal
