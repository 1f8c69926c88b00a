// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import_dialog.h"

#include "core/capture/check_settings.h"
#include "core/capture/format_registry.h"
#include "ui/session/file_import.h"
#include "ui/shell/import_channel_table.h"
#include "ui/shell/import_dataset_tree.h"
#include "ui/shell/import_preview_table.h"
#include "ui/stages/quantity_edit.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kTypingPause_ms = 150; ///< what is typed is not read letter by letter
constexpr QSize kFirstSize(980, 760);
constexpr int kAutomatic = -1; ///< of the header rows

const std::array<std::string, 6> kSeparators{"auto", ",", ";", "tab", "space", "|"};
const std::array<std::string, 3> kDecimals{"auto", ".", ","};

/// Choices of "time from" before the columns.
enum TimeChoice { TimeAuto, TimeNone, TimeFirstColumn };

template <typename List, typename T>
int positionIn(const List &list, const T &value)
{
    const auto at = std::ranges::find(list, value);
    return at == std::end(list) ? 0 : static_cast<int>(at - std::begin(list));
}

template <typename Control>
Control *named(Control *control, const QString &name, const QString &accessible)
{
    control->setObjectName(name);
    control->setAccessibleName(accessible);
    return control;
}

bool leavesTimesOut(const ImportSettings &settings)
{
    return !settings.columns.empty() && !settings.columns.contains("time");
}

QString decimalName(char decimal)
{
    return decimal == ',' ? ImportDialog::tr("comma") : ImportDialog::tr("point");
}

QString separatorName(char separator)
{
    switch (separator) {
    case '\t':
        return ImportDialog::tr("tab");
    case ' ':
        return ImportDialog::tr("blanks");
    default:
        return QChar::fromLatin1(separator);
    }
}

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
    m_settings.files.clear(); // put over the others already
    setObjectName("importDialog");
    setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
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
        });
    column->addWidget(m_channels, 2);
    column->addWidget(buildFoot(files));
    m_later.setSingleShot(true);
    m_later.setInterval(kTypingPause_ms);
    connect(&m_later, &QTimer::timeout, this, &ImportDialog::lookNow);
    resize(kFirstSize);
    showSettings();
    lookNow();
}

void ImportDialog::buildFileRow(QFormLayout *form)
{
    m_format = named(new QComboBox(this), "importFormat", tr("Format"));
    m_format->addItem(tr("automatic"), "auto");
    for (const CaptureFormat &format : captureFormats())
        m_format->addItem(QString::fromStdString(format.title), QString::fromStdString(format.id));
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
    row->addWidget(m_format, 1);
    row->addSpacing(16);
    row->addWidget(new QLabel(tr("Profile"), this));
    row->addWidget(m_profile, 1);
    form->addRow(tr("Format"), row);
}

QGroupBox *ImportDialog::buildText()
{
    m_text = new QGroupBox(tr("Text table"), this);
    m_separator = named(new QComboBox(m_text), "importSeparator", tr("Separator"));
    m_separator->addItems(
        {{}, tr("comma ,"), tr("semicolon ;"), tr("tab"), tr("blanks"), tr("bar |")});
    connect(m_separator, &QComboBox::activated, this, [this](int choice) {
        m_settings.separator = kSeparators[static_cast<std::size_t>(choice)];
        look();
    });
    m_decimal = named(new QComboBox(m_text), "importDecimal", tr("Decimal mark"));
    m_decimal->addItems({{}, tr("point ."), tr("comma ,")});
    connect(m_decimal, &QComboBox::activated, this, [this](int choice) {
        m_settings.decimal = kDecimals[static_cast<std::size_t>(choice)];
        look();
    });
    m_header = named(new QSpinBox(m_text), "importHeader", tr("Header rows"));
    m_header->setRange(kAutomatic, 1'000'000'000);
    connect(m_header, &QSpinBox::valueChanged, this, [this](int rows) {
        m_settings.skipRows = rows == kAutomatic ? std::nullopt : std::optional<Index>(rows);
        look();
    });
    m_time = named(new QComboBox(m_text), "importTime", tr("Time from"));
    connect(m_time, &QComboBox::activated, this, &ImportDialog::chooseTime);
    m_preview = new ImportPreviewTable(m_text);
    m_counts = new QLabel(m_text);
    m_counts->setObjectName("importCounts");

    auto *row = new QHBoxLayout;
    const auto add = [&](QWidget *control) {
        row->addWidget(new QLabel(control->accessibleName(), m_text));
        row->addWidget(control, 1);
    };
    for (QWidget *control :
        std::initializer_list<QWidget *>{m_separator, m_decimal, m_header, m_time})
        add(control);
    auto *column = new QVBoxLayout(m_text);
    column->addLayout(row);
    column->addWidget(m_preview);
    column->addWidget(m_counts);
    return m_text;
}

QWidget *ImportDialog::buildRate()
{
    auto *box = new QWidget(this);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    m_rate = new OptionalEdit({"MHz", 1e6}, 1e-3, 1e12, box);
    m_rate->setNames("importRate", tr("Sample rate"));
    m_rate->setMaximumWidth(180);
    connect(m_rate, &OptionalEdit::edited, this, [this](const std::optional<double> &rate_Hz) {
        m_settings.sampleRate_Hz = rate_Hz;
        look();
    });
    m_reason = named(new QLineEdit(box), "importRateReason", tr("Why the file is wrong"));
    m_reason->setPlaceholderText(m_reason->accessibleName());
    connect(m_reason, &QLineEdit::textEdited, this, [this](const QString &text) {
        m_settings.sampleRateReason = text.trimmed().toStdString();
        showVerdict();
    });
    m_rateSource = new QLabel(box);
    m_rateSource->setObjectName("importRateSource");
    m_useTimes = named(new QPushButton(box), "useTimes", {});
    m_useHeader = named(new QPushButton(box), "useHeader", {});
    connect(m_useTimes, &QPushButton::clicked, this, [this] {
        useRate(m_view.timesRate_Hz.value_or(0.0), false,
            tr("the time column is right, the header is not"));
    });
    connect(m_useHeader, &QPushButton::clicked, this, [this] {
        useRate(m_view.headerRate_Hz.value_or(0.0), true,
            tr("the header is right, the time column is not"));
    });
    row->addWidget(new QLabel(tr("Sample rate"), box));
    row->addWidget(m_rate);
    row->addWidget(m_rateSource);
    row->addWidget(m_reason, 1);
    row->addStretch(0);
    row->addWidget(m_useTimes);
    row->addWidget(m_useHeader);
    return box;
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
    showText();
    showRate();
    m_datasets->setDatasets(m_view.datasets, m_view.channels);
    m_channels->setChannels(m_view.channels, m_settings.channelDetails);
    showVerdict();
    offerProfile();
}

void ImportDialog::showSettings()
{
    m_format->setCurrentIndex(
        std::max(0, m_format->findData(QString::fromStdString(m_settings.format))));
    m_separator->setCurrentIndex(positionIn(kSeparators, m_settings.separator));
    m_decimal->setCurrentIndex(positionIn(kDecimals, m_settings.decimal));
    {
        const QSignalBlocker quiet(m_header);
        m_header->setValue(static_cast<int>(m_settings.skipRows.value_or(kAutomatic)));
    }
    if (!m_reason->hasFocus())
        m_reason->setText(QString::fromStdString(m_settings.sampleRateReason));
}

/// "automatic" says what it found.
void ImportDialog::showText()
{
    m_text->setVisible(m_view.text || m_view.format == "text");
    m_preview->setVisible(m_view.text.has_value());
    m_counts->setVisible(m_view.text.has_value());
    if (!m_view.text)
        return;
    const TextPreview &text = *m_view.text;
    m_separator->setItemText(0, tr("automatic: %1").arg(separatorName(text.separator)));
    m_decimal->setItemText(0, tr("automatic: %1").arg(decimalName(text.decimal)));
    m_header->setSpecialValueText(tr("automatic: %1").arg(text.headerLines));
    m_time->clear();
    const auto titleOf = [&](Index column) {
        return QString::fromStdString(text.columnTitles[static_cast<std::size_t>(column)]);
    };
    m_time->addItem(!leavesTimesOut(m_settings) && text.timeColumn
            ? tr("automatic: %1").arg(titleOf(*text.timeColumn))
            : tr("automatic"));
    m_time->addItem(tr("no column: the rate is given"));
    for (Index column = 0; column < static_cast<Index>(text.columnTitles.size()); ++column)
        m_time->addItem(tr("column %1: %2").arg(column + 1).arg(titleOf(column)));
    const auto time = m_settings.columns.find("time");
    m_time->setCurrentIndex(time != m_settings.columns.end()
            ? TimeFirstColumn + static_cast<int>(time->second)
            : (leavesTimesOut(m_settings) ? TimeNone : TimeAuto));
    m_preview->setPreview(text);
    m_counts->setText(tr("%1 rows looked at, unreadable cells: %2. Text: %3.")
                          .arg(text.dataRows)
                          .arg(text.unreadableCells)
                          .arg(QString::fromStdString(text.encoding)));
}

void ImportDialog::showRate()
{
    const std::optional<double> found
        = m_view.sampleRate_Hz > 0.0 ? std::optional(m_view.sampleRate_Hz) : std::nullopt;
    m_reason->setVisible(needsReason());
    m_rate->setEmptyText(tr("not stated"));
    m_rate->set(m_settings.sampleRate_Hz, found);
    const bool contradiction = m_view.headerRate_Hz && m_view.timesRate_Hz;
    m_useTimes->setVisible(contradiction);
    m_useHeader->setVisible(contradiction);
    if (contradiction) {
        m_useTimes->setText(
            tr("Use the time column: %1").arg(shownQuantity(*m_view.timesRate_Hz, "Hz")));
        m_useHeader->setText(
            tr("Use the header: %1").arg(shownQuantity(*m_view.headerRate_Hz, "Hz")));
    }
    if (!found)
        m_rateSource->setText(m_settings.sampleRate_Hz ? tr("as typed") : QString());
    else if (m_view.text && m_view.text->timeColumn)
        m_rateSource->setText(tr("from the time column: %1").arg(shownQuantity(*found, "Hz")));
    else
        m_rateSource->setText(tr("the file states %1").arg(shownQuantity(*found, "Hz")));
}

/// One sentence: what stands in the way, or what to look at, or that all is well.
void ImportDialog::showVerdict()
{
    const bool nameMissing = m_keep->isChecked() && !isProfileName(m_keepName->text());
    const bool complete = m_looked && m_view.isComplete(m_settings);
    const bool reasonMissing = needsReason() && m_settings.sampleRateReason.empty();
    m_import->setEnabled(complete && !nameMissing && !reasonMissing);
    const auto duts = std::ranges::count(m_view.channels, ChannelRole::Dut, &ImportChannel::role);
    QString said;
    if (!m_looked)
        said = tr("Reading the file...");
    else if (m_view.headerRate_Hz && m_view.timesRate_Hz)
        said = QStringLiteral("■ ")
            + tr("The header says %1, the time column %2. Which one is right?")
                  .arg(shownQuantity(*m_view.headerRate_Hz, "Hz"),
                      shownQuantity(*m_view.timesRate_Hz, "Hz"));
    else if (m_view.problem)
        said = QStringLiteral("■ ") + translated(m_view.problem->message);
    else if (m_view.text && m_view.text->unreadableCells > 0)
        said = QStringLiteral("■ ")
            + tr("Cells that are no numbers are marked; change separator, decimal mark or header "
                 "rows.");
    else if (!complete && m_view.text && m_view.text->decimalAmbiguous)
        said = QStringLiteral("■ ")
            + tr("The numbers can be read in two ways: choose the decimal mark; the table shows "
                 "the effect.");
    else if (!complete && m_view.sampleRate_Hz <= 0.0 && !m_settings.sampleRate_Hz)
        said = QStringLiteral("■ ") + tr("The file does not say its sample rate: type it.");
    else if (reasonMissing)
        said = QStringLiteral("■ ")
            + tr("The rate typed differs from that of the file: say why the file is wrong. The "
                 "results record it.");
    else if (duts == 0)
        said = QStringLiteral("■ ") + tr("Choose which channel is the sensor under test (DUT).");
    else if (duts > 1)
        said = QStringLiteral("■ ") + tr("Only one channel can be the sensor under test (DUT).");
    else if (nameMissing)
        said = QStringLiteral("■ ") + tr("Give the profile a name that a file can have.");
    else if (m_view.text && *m_view.text->remark.text)
        said = QStringLiteral("▲ ") + translated(m_view.text->remark);
    else
        said = QStringLiteral("● ") + tr("The file can be imported.");
    // The name is in the title: its folder would only make the sentence long.
    m_verdict->setText(said.replace(m_path, QFileInfo(m_path).fileName()));
}

/// As the rules of import have it.
bool ImportDialog::needsReason() const
{
    const double tolerance = 0.01 * CheckSettings{}.rateMismatch_percent;
    return m_settings.sampleRate_Hz && m_view.sampleRate_Hz > 0.0
        && std::abs(*m_settings.sampleRate_Hz / m_view.sampleRate_Hz - 1.0) > tolerance;
}

/// A reader of HDF5 takes what is named and nothing else, or what it guesses: once one dataset is
/// named, so are the others that are read now.
void ImportDialog::nameChannelsRead()
{
    for (const ImportChannel &channel : m_view.channels)
        m_settings.channels.emplace(channel.name, channelRoleName(channel.role));
}

/// No role: it is not read.
void ImportDialog::chooseDataset(const QString &channel, std::optional<ChannelRole> role)
{
    nameChannelsRead();
    const std::string name = channel.toStdString();
    if (role == ChannelRole::Dut) // there is one only
        for (auto &[other, otherRole] : m_settings.channels)
            if (channelRoleFromName(otherRole) == ChannelRole::Dut)
                otherRole = channelRoleName(ChannelRole::Other);
    if (role)
        m_settings.channels[name] = channelRoleName(*role);
    else
        m_settings.channels.erase(name);
    look();
}

void ImportDialog::chooseRole(int channel, ChannelRole role)
{
    if (!m_view.datasets.empty())
        nameChannelsRead();
    const ImportChannel chosen = m_view.channels[static_cast<std::size_t>(channel)];
    if (role == ChannelRole::Dut) // there is one only
        for (const ImportChannel &other : m_view.channels)
            if (other.role == ChannelRole::Dut && other.name != chosen.name)
                m_settings.channels[other.name] = channelRoleName(ChannelRole::Other);
    m_settings.channels[chosen.name] = channelRoleName(role);
    if (leavesTimesOut(m_settings)) {
        m_settings.columns.clear();
        applyRoles(m_view, m_settings);
        nameSampleColumns();
        look();
    }
    applyRoles(m_view, m_settings);
    m_datasets->setDatasets(m_view.datasets, m_view.channels);
    m_channels->setChannels(m_view.channels, m_settings.channelDetails);
    showVerdict();
}

void ImportDialog::chooseTime(int choice)
{
    m_settings.columns.clear();
    if (choice == TimeNone)
        nameSampleColumns();
    else if (choice >= TimeFirstColumn)
        m_settings.columns["time"] = choice - TimeFirstColumn;
    look();
}

/// Naming the columns of samples is how the recipe leaves a column of times out.
void ImportDialog::nameSampleColumns()
{
    for (const ImportChannel &channel : m_view.channels)
        if (channel.column && channel.role != ChannelRole::Other)
            m_settings.columns.emplace(channelRoleName(channel.role), *channel.column);
    const auto first = std::ranges::find_if(
        m_view.channels, [](const ImportChannel &channel) { return channel.column.has_value(); });
    if (m_settings.columns.empty() && first != m_view.channels.end())
        m_settings.columns.emplace(channelRoleName(ChannelRole::Other), *first->column);
}

void ImportDialog::useRate(double rate_Hz, bool withoutTimes, const QString &reason)
{
    m_settings.sampleRate_Hz = rate_Hz;
    m_settings.sampleRateReason = reason.toStdString();
    chooseTime(withoutTimes ? TimeNone : TimeAuto);
}

void ImportDialog::useProfile(const QString &name)
{
    const Result<ImportSettings> profile = m_profiles.load(name);
    if (!profile) {
        m_verdict->setText(QStringLiteral("■ ") + translated(profile.error().message));
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
            m_verdict->setText(QStringLiteral("■ ") + translated(saved.error().message));
            return;
        }
    }
    QDialog::accept();
}

} // namespace dyncal
