// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/import_choices.h"
#include "ui/session/import_profiles.h"
#include "ui/session/import_view.h"
#include "ui/session/job_runner.h"

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace dyncal {

class ImportChannelTable;
class ImportDatasetTree;
class ImportRateRow;
class ImportTextBox;

/// Asks how a file is read, and shows the result beside it: every change shows its effect at once.
/// Stays open until the file reads without an open question. Changes nothing by itself: the caller
/// takes settings() when it is accepted.
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /// `files`: how many are read with the same settings; `profiles`: the folder of profiles.
    ImportDialog(const QString &path, const ImportSettings &settings, int files,
        const QString &profiles, QWidget *parent);

    /// The import section of the job as the operator wants it.
    ImportSettings settings() const;
    const ImportView &view() const { return m_view; }
    bool isLooking() const { return m_jobs.isRunning() || m_later.isActive(); }

    void accept() override;

private:
    void buildFileRow(QFormLayout *form);
    ImportTextBox *buildText();
    ImportRateRow *buildRate();
    QWidget *buildFoot(int files);

    void look(); ///< soon: reads the file under the settings
    void lookNow();
    void showView(const ImportView &view);
    void showSettings();
    void showWhatApplies();
    void showChannels();
    void showVerdict();
    void chooseRole(int channel, ChannelRole role);
    void takeProposal();
    void chooseDataset(const QString &channel, std::optional<ChannelRole> role);
    void chooseTime(int choice);
    void useRate(double rate_Hz, TimeChoice times, const QString &reason);
    void useProfile(const QString &name);
    void offerProfile();

    QString m_path;
    ImportSettings m_job; ///< as it is
    ImportSettings m_settings; ///< for this file
    ImportProfiles m_profiles;
    ImportView m_view;
    bool m_looked = false; ///< m_view belongs to m_settings
    bool m_offered = false;

    QComboBox *m_profile = nullptr;
    QComboBox *m_format = nullptr;
    std::vector<QWidget *> m_fileRow; ///< which reader and which profile
    ImportTextBox *m_text = nullptr;
    ImportRateRow *m_rate = nullptr;
    ImportDatasetTree *m_datasets = nullptr;
    ImportChannelTable *m_channels = nullptr;
    QPushButton *m_propose = nullptr;
    QRadioButton *m_forAll = nullptr;
    QRadioButton *m_forFile = nullptr;
    QLabel *m_verdict = nullptr;
    QCheckBox *m_keep = nullptr;
    QLineEdit *m_keepName = nullptr;
    QPushButton *m_import = nullptr;

    QTimer m_later;
    JobRunner m_jobs;
};

} // namespace dyncal
