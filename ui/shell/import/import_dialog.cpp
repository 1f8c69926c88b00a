// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_dialog.h"

#include "core/capture/opening/format_registry.h"
#include "ui/session/example.h"
#include "ui/session/file_import.h"
#include "ui/shell/import/import_channel_table.h"
#include "ui/shell/import/import_dataset_tree.h"
#include "ui/shell/import/import_rate_row.h"
#include "ui/shell/import/import_text_box.h"
#include "ui/shell/import/import_verdict.h"
#include "ui/shell/import/named_control.h"
#include "ui/stages/frame/within_screen.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kTypingPause_ms = 150; ///< what is typed is not read letter by letter
constexpr QSize kFirstSize_chars(210, 45);

} // namespace

ImportDialog::ImportDialog(const QString &path, const ImportSettings &settings, int files,
    const QString &profiles, QWidget *parent)
    : QDialog(parent)
    , m_path(path)
    , m_job(settings)
    , m_settings(settingsOfFile(settings, path.toStdString()))
    , m_profiles(profiles)
    , m_jobs(this)
{
    m_settings.files.clear(); // merged into the other settings already
    setObjectName("importDialog");
    setWindowTitle(tr("Import %1").arg(asTitle(QFileInfo(path).fileName())));
    auto *column = new QVBoxLayout(this);
    auto *form = new QFormLayout;
    buildFileRow(form);
    column->addLayout(form);
    column->addWidget(buildText(), 3);
    column->addWidget(buildRate());
    m_datasets = new ImportDatasetTree(this);
    connect(m_datasets, &ImportDatasetTree::roleChosen, this, &ImportDialog::chooseDataset);
    column->addWidget(m_datasets, 3);
    m_channels = new ImportChannelTable(this);
    m_channels->setMinimumHeight(120);
    connect(m_channels, &ImportChannelTable::roleChosen, this, &ImportDialog::chooseRole);
    connect(m_channels, &ImportChannelTable::detailsChanged, this,
        [this](int channel, const ChannelImport &details) {
            const std::string &name = m_view.channels[static_cast<std::size_t>(channel)].name;
            m_settings.channelDetails[name] = details;
            if (details == ChannelImport{})
                m_settings.channelDetails.erase(name);
            showChannels(); // what is said of a unit
        });
    column->addWidget(m_channels, 2);
    m_propose = named(new QPushButton(tr("Take the proposed roles"), this), "importPropose",
        tr("Take the proposed roles"));
    m_propose->setToolTip(tr("Proposed from step and noise of the records: look at the traces"));
    connect(m_propose, &QPushButton::clicked, this, &ImportDialog::takeProposal);
    column->addWidget(m_propose, 0, Qt::AlignLeft);
    column->addWidget(buildFoot(files));
    m_later.setSingleShot(true);
    m_later.setInterval(kTypingPause_ms);
    connect(&m_later, &QTimer::timeout, this, &ImportDialog::lookNow);
    const QSize letters(fontMetrics().averageCharWidth(), fontMetrics().height());
    resize(withinScreen(*this,
        {kFirstSize_chars.width() * letters.width(),
            kFirstSize_chars.height() * letters.height()}));
    showSettings();
    lookNow();
}

void ImportDialog::buildFileRow(QFormLayout *form)
{
    m_format = named(new QComboBox(this), "importFormat", tr("Format"));
    m_format->addItem(tr("automatic"), "auto");
    for (const CaptureFormat &format : captureFormats())
        m_format->addItem(rawText(format.title), rawText(format.id));
    connect(m_format, &QComboBox::activated, this, [this] {
        m_settings.format = m_format->currentData().toString().toStdString();
        look();
    });
    m_profile = named(new QComboBox(this), "importProfile", tr("Profile"));
    m_profile->addItem(tr("none"));
    m_profile->addItems(m_profiles.names());
    m_profile->setEnabled(m_profile->count() > 1);
    connect(m_profile, &QComboBox::activated, this, [this](int choice) {
        if (choice > 0)
            useProfile(m_profile->itemText(choice));
    });
    auto *row = new QHBoxLayout;
    auto *profile = new QLabel(tr("Profile"), this);
    auto *format = new QLabel(tr("Format"), this);
    row->addWidget(m_format, 1);
    row->addSpacing(16);
    row->addWidget(profile);
    row->addWidget(m_profile, 1);
    form->addRow(format, row);
    m_fileRow = {format, m_format, profile, m_profile};
}

ImportTextBox *ImportDialog::buildText()
{
    m_text = new ImportTextBox(this);
    connect(m_text, &ImportTextBox::separatorChosen, this, [this](const std::string &separator) {
        m_settings.separator = separator;
        look();
    });
    connect(m_text, &ImportTextBox::decimalChosen, this, [this](const std::string &decimal) {
        m_settings.decimal = decimal;
        look();
    });
    connect(m_text, &ImportTextBox::headerChosen, this, [this](std::optional<Index> rows) {
        m_settings.skipRows = rows;
        look();
    });
    connect(m_text, &ImportTextBox::timesChosen, this, &ImportDialog::chooseTime);
    connect(m_text, &ImportTextBox::shotColumnsChosen, this, [this](bool each) {
        chooseShotColumns(m_settings, m_view, each);
        look();
    });
    return m_text;
}

ImportRateRow *ImportDialog::buildRate()
{
    m_rate = new ImportRateRow(this);
    connect(m_rate, &ImportRateRow::rateTyped, this, [this](std::optional<double> rate_Hz) {
        m_settings.sampleRate_Hz = rate_Hz;
        look();
    });
    connect(m_rate, &ImportRateRow::reasonTyped, this, [this](const QString &reason) {
        m_settings.sampleRateReason = reason.toStdString();
        showVerdict();
    });
    connect(m_rate, &ImportRateRow::timesPreferred, this, [this](const QString &reason) {
        useRate(m_view.timesRate_Hz.value_or(0.0), TimeAuto, reason);
    });
    connect(m_rate, &ImportRateRow::headerPreferred, this, [this](const QString &reason) {
        useRate(m_view.headerRate_Hz.value_or(0.0), TimeNone, reason);
    });
    return m_rate;
}

QWidget *ImportDialog::buildFoot(int files)
{
    auto *box = new QWidget(this);
    m_verdict = new QLabel(box);
    m_verdict->setObjectName("importVerdict");
    m_verdict->setWordWrap(true);
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_keep = new QCheckBox(tr("Remember as profile"), box);
    m_keep->setObjectName("keepProfile");
    m_keepName = named(new QLineEdit(box), "profileName", tr("Name of the profile"));
    m_keepName->setEnabled(false);
    connect(m_keep, &QCheckBox::toggled, m_keepName, &QLineEdit::setEnabled);
    connect(m_keep, &QCheckBox::toggled, this, &ImportDialog::showVerdict);
    connect(m_keepName, &QLineEdit::textChanged, this, &ImportDialog::showVerdict);
    auto *buttons = new QDialogButtonBox(box);
    m_import = buttons->addButton(
        tr("Import %n file(s)", nullptr, std::max(files, 1)), QDialogButtonBox::AcceptRole);
    m_import->setObjectName("importButton");
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
    m_forAll = new QRadioButton(tr("for all files"), box);
    m_forAll->setObjectName("importForAll");
    m_forFile = new QRadioButton(tr("for this file"), box);
    m_forFile->setObjectName("importForFile");
    const bool own = m_job.files.contains(QFileInfo(m_path).fileName().toStdString());
    (own ? m_forFile : m_forAll)->setChecked(true);
    auto *row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("These settings hold"), box));
    row->addWidget(m_forAll);
    row->addWidget(m_forFile);
    row->addSpacing(24);
    row->addWidget(m_keep);
    row->addWidget(m_keepName, 1);
    row->addStretch(1);
    row->addWidget(buttons);
    auto *column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_verdict);
    column->addLayout(row);
    return box;
}

void ImportDialog::look()
{
    m_looked = false;
    m_later.start();
    showVerdict();
}

void ImportDialog::lookNow()
{
    m_looked = false;
    m_jobs.start<ImportView>(
        [path = m_path.toStdString(), settings = m_settings](const JobControl &control) {
            return Result<ImportView>(lookAtFile(path, settings, control));
        },
        [this](const Result<ImportView> &view) {
            if (view)
                showView(*view);
        });
    showVerdict();
}

void ImportDialog::showView(const ImportView &view)
{
    m_view = view;
    m_looked = true;
    showSettings();
    m_text->showView(m_view, m_settings);
    m_rate->showView(m_view, m_settings);
    showWhatApplies();
    showChannels();
    showVerdict();
    offerProfile();
}

/// A file that no reader takes has no rate; the example is no file, so no reader is chosen for it.
void ImportDialog::showWhatApplies()
{
    const bool isExample = m_path == QLatin1String(kExamplePath);
    for (QWidget *widget : m_fileRow)
        widget->setVisible(!isExample);
    m_rate->setVisible(!isExample && (m_view.text || !m_view.channels.empty()));
}

void ImportDialog::showSettings()
{
    m_format->setCurrentIndex(std::max(0, m_format->findData(rawText(m_settings.format))));
    m_text->showSettings(m_settings);
    m_rate->showSettings(m_settings);
}

void ImportDialog::showVerdict()
{
    const bool lacksName = m_keep->isChecked() && !isProfileName(m_keepName->text());
    ImportVerdict verdict = importVerdict(m_looked ? &m_view : nullptr, m_settings, lacksName);
    m_import->setEnabled(verdict.mayImport);
    // The title shows the name already; the full path would only make the sentence long.
    m_verdict->setText(
        verdict.sentence.replace(shownText(m_path), shownText(QFileInfo(m_path).fileName())));
}

void ImportDialog::showChannels()
{
    m_datasets->setDatasets(m_view.datasets, m_view.channels);
    m_channels->setChannels(m_view.channels, m_settings.channelDetails);
    m_channels->setVisible(!m_view.channels.empty());
    m_propose->setVisible(m_view.hasProposal());
}

void ImportDialog::takeProposal()
{
    const std::vector<ImportChannel> channels = m_view.channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].proposed != ChannelRole::Other)
            chooseRole(static_cast<int>(i), channels[i].proposed);
}

void ImportDialog::chooseDataset(const QString &channel, std::optional<ChannelRole> role)
{
    chooseDatasetRole(m_settings, m_view, channel.toStdString(), role);
    look();
}

void ImportDialog::chooseRole(int channel, ChannelRole role)
{
    const std::string name = m_view.channels[static_cast<std::size_t>(channel)].name;
    if (dyncal::chooseRole(m_settings, m_view, name, role))
        look();
    showChannels();
    showVerdict();
}

void ImportDialog::chooseTime(int choice)
{
    chooseTimes(m_settings, m_view, choice);
    look();
}

void ImportDialog::useRate(double rate_Hz, TimeChoice times, const QString &reason)
{
    m_settings.sampleRate_Hz = rate_Hz;
    m_settings.sampleRateReason = reason.toStdString();
    chooseTime(times);
}

void ImportDialog::useProfile(const QString &name)
{
    const Result<ImportSettings> profile = m_profiles.load(name);
    if (!profile) {
        m_verdict->setText(blockingSentence(translated(profile.error().message)));
        return;
    }
    m_settings = *profile;
    m_profile->setCurrentText(name);
    look();
}

/// A file with an open question gets the first profile that answers it: shown, not yet taken.
void ImportDialog::offerProfile()
{
    if (m_offered || m_view.isComplete(m_settings))
        return;
    m_offered = true;
    m_jobs.start<QString>(
        [path = m_path.toStdString(), profiles = m_profiles](const JobControl &control) {
            for (const QString &name : profiles.names()) {
                const Result<ImportSettings> profile = profiles.load(name);
                if (profile && lookAtFile(path, *profile, control).isComplete(*profile))
                    return Result<QString>(name);
            }
            return Result<QString>(QString());
        },
        [this](const Result<QString> &name) {
            if (name && !name->isEmpty())
                useProfile(*name);
        });
}

ImportSettings ImportDialog::settings() const
{
    const std::string path = m_path.toStdString();
    return m_forFile->isChecked() ? withOwnSettings(m_job, path, m_settings)
                                  : withSettingsForAll(m_job, path, m_settings);
}

void ImportDialog::accept()
{
    if (!m_import->isEnabled())
        return;
    if (m_keep->isChecked()) {
        const Result<void> saved = m_profiles.save(m_keepName->text(), m_settings);
        if (!saved) {
            m_verdict->setText(blockingSentence(translated(saved.error().message)));
            return;
        }
    }
    QDialog::accept();
}

} // namespace dyncal
