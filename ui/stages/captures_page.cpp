// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/captures_page.h"

#include "core/capture/step_levels.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/plot/widget/overview_strip.h"
#include "ui/session/capture_edit.h"
#include "ui/session/capture_reading.h"
#include "ui/stages/channel_roles.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/position_in.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableWidget>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

enum Column { Use, Level, File, Rate, Samples, Unit, Hash, ColumnCount };

constexpr std::array kRoles{ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver,
    ChannelRole::Trigger, ChannelRole::Reference, ChannelRole::Other};
constexpr std::array kPlottedRoles{ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver};
constexpr std::array kLevels{ShotLevel::None, ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
const std::array<std::string, 3> kReferences{"", "gauge", "absolute"};

/// Marks where the records of a role hold invalid or saturated samples.
std::vector<PlotMark> faultMarks(
    const PreparedCaptures &captures, ChannelRole role, const std::string &unit)
{
    std::vector<PlotMark> marks;
    for (const Finding &finding : captures.findings) {
        const bool isInvalid = finding.id == "CAP-006";
        const auto at = static_cast<std::size_t>(finding.shot - 1);
        if ((!isInvalid && finding.id != "CAP-007") || !finding.time_s
            || at >= captures.set.shots.size())
            continue;
        const Channel *channel = captures.set.shots[at].channelWithRole(role);
        if (channel && channel->name == finding.channel && channel->unit == unit)
            marks.push_back({*finding.time_s,
                (isInvalid ? CapturesPage::tr("shot %1: invalid")
                           : CapturesPage::tr("shot %1: saturated"))
                    .arg(finding.shot),
                CurveRole::UnstablePole});
    }
    return marks;
}

} // namespace

CapturesPage::CapturesPage(Session &session, Prompts &prompts)
    : StagePage(session,
        {"capturesPage", tr("Captures"),
            tr("Add the recordings of one sensor and say what each channel is.")},
        Page::Captures)
    , m_prompts(prompts)
    , m_table(new QTableWidget(this))
{
    auto *split = new QSplitter(Qt::Vertical, this);
    split->setChildrenCollapsible(false);
    m_split = split;
    m_overview = new OverviewStrip(this);
    m_overview->setObjectName("recordOverview");
    for (const ChannelRole role : kPlottedRoles)
        plotOf(role, 0);
    content()->addWidget(m_overview);
    connect(&session.envelopes(), &EnvelopeStore::changed, this, [this] {
        if (isVisible())
            showPlots();
    });
    m_table->setObjectName("shotTable");
    m_table->setAccessibleName(tr("Shots"));
    m_table->setColumnCount(ColumnCount);
    m_table->setHorizontalHeaderLabels({tr("Shot"), tr("Level"), tr("File"), tr("Rate"),
        tr("Samples"), tr("DUT unit"), tr("SHA-256")});
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false); // Tab leaves it
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(File, QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(
        m_table->horizontalHeader()->sectionSizeHint(File));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setMinimumHeight(110);
    split->addWidget(m_table);
    content()->addWidget(split);
    connect(m_table, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem *item) {
        if (item->column() == Use)
            setIncluded(item->row() + 1, item->checkState() == Qt::Checked);
    });
    buildInspector();
}

void CapturesPage::buildInspector()
{
    InspectorForm *form = inspector();
    auto *add = new WrappedButton(tr("Add captures..."));
    add->setObjectName("addCaptures");
    connect(add, &QPushButton::clicked, this, &CapturesPage::addRequested);
    form->addWide(add);
    auto *import = new WrappedButton(tr("Import settings..."));
    import->setObjectName("importSettings");
    connect(import, &QPushButton::clicked, this, &CapturesPage::requestImport);
    form->addWide(import);
    m_remove = new WrappedButton(tr("Remove selected shot"));
    m_remove->setObjectName("removeShot");
    connect(m_remove, &QPushButton::clicked, this, &CapturesPage::removeSelected);
    form->addWide(m_remove);
    m_tag = new WrappedButton(tr("Tag by step height"));
    m_tag->setObjectName("tagByStepHeight");
    m_tag->setToolTip(tr("Low, medium and high by the step that each shot's sensor read."));
    connect(m_tag, &QPushButton::clicked, this, &CapturesPage::tagByStepHeight);
    form->addWide(m_tag);

    form->addSection(tr("Channel roles (all shots)"));
    m_channels = new QWidget;
    new QFormLayout(m_channels);
    m_channels->layout()->setContentsMargins(0, 0, 0, 0);
    form->addWide(m_channels);
    m_otherRoles = form->addNote("otherRoles");

    form->addSection(tr("Sensor under test"));
    m_unit = form->add(tr("Unit"), "dutUnit", new QLineEdit);
    connect(m_unit, &QLineEdit::editingFinished, this, [this] {
        const std::string unit = m_unit->text().trimmed().toStdString();
        change(tr("Change the DUT's unit"),
            [&](Recipe &r) { r.import.unit = unit.empty() ? std::nullopt : std::optional(unit); });
    });
    m_scale = form->add(tr("Factor"), "dutScale", new QuantityEdit({}, 1e-9, 1e12, 9));
    connect(m_scale, &QuantityEdit::edited, this, [this](double factor) {
        change(tr("Change the DUT's factor"), [&](Recipe &r) { r.import.scale = factor; });
    });
    m_inverted = new WrappedCheckBox(tr("Inverted polarity"));
    m_inverted->setObjectName("dutInverted");
    form->addWide(m_inverted);
    connect(m_inverted, &QCheckBox::clicked, this, [this](bool on) {
        change(
            tr("Change the DUT's polarity"), [&](Recipe &r) { r.import.polarity = on ? -1 : 1; });
    });
    m_reference = form->addChoice(
        tr("Pressure"), "dutReference", {tr("as recorded"), tr("gauge"), tr("absolute")});
    connect(m_reference, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change gauge or absolute"),
            [&](Recipe &r) { r.import.reference = kReferences[static_cast<std::size_t>(choice)]; });
    });
    m_rate = form->add(tr("Sample rate"), "sampleRate", new OptionalEdit({"MHz", 1e6}, 1e-3, 1e12));
    connect(m_rate, &OptionalEdit::edited, this,
        [this](const std::optional<double> &rate_Hz) { changeRate(rate_Hz); });
}

const CaptureSet &CapturesPage::shownSet() const
{
    const auto &prepared = results().captures;
    // Results of another set of recordings may still be on the screen for a moment.
    const CaptureSet &raw = *session().state().captures;
    return prepared && prepared->set.shots.size() == raw.shots.size() ? prepared->set : raw;
}

void CapturesPage::showResults()
{
    showPlots();
    showTable();
    showChannels();
    m_tag->setEnabled(results().window != nullptr);
}

void CapturesPage::showPlots()
{
    EnvelopeStore &envelopes = session().envelopes();
    envelopes.want(longRecords(shownSet()));
    const auto envelopeOf = [&](const Channel &channel) { return envelopes.find(channel); };
    for (const ChannelRole role : kPlottedRoles) {
        const std::vector<std::string> units = unitsOf(shownSet(), role);
        const bool present = std::ranges::any_of(shownSet().shots,
            [role](const Shot &shot) { return shot.channelWithRole(role) != nullptr; });
        const std::size_t count = std::max(units.size(), m_plots[role].size());
        for (std::size_t unit = 0; unit < count; ++unit) {
            PlotWidget *plot = plotOf(role, unit);
            const bool isUsed = unit < units.size() || (unit == 0 && present);
            plot->setVisible(isUsed || (unit == 0 && role == ChannelRole::Dut));
            if (!isUsed)
                continue;
            PlotContent content = rawCurves(shownSet(), role, envelopeOf,
                unit < units.size() ? std::optional(units[unit]) : std::nullopt);
            if (results().captures && unit < units.size())
                content.marks = faultMarks(*results().captures, role, units[unit]);
            content.growing = envelopes.isBusy();
            if (content.growing)
                content.title += tr(" (reading the recordings: %1 %)")
                                     .arg(static_cast<int>(100.0 * envelopes.progress()));
            plot->setContent(content);
        }
    }
}

/// The plot for records of a role in one of their units; there is one until there are more.
PlotWidget *CapturesPage::plotOf(ChannelRole role, std::size_t unit)
{
    std::vector<PlotWidget *> &plots = m_plots[role];
    while (plots.size() <= unit) {
        const QString name = QString("rawPlot_%1").arg(channelRoleName(role));
        auto *plot = makePlot(plots.empty() ? name : name + QString("_%1").arg(plots.size() + 1),
            tr("Recordings: %1").arg(roleText(role)));
        const int at = plots.empty() ? m_shownPlots : m_split->indexOf(plots.back()) + 1;
        m_split->insertWidget(at, plot);
        m_split->setStretchFactor(at, role == ChannelRole::Dut ? 3 : 2);
        m_overview->follow(plot);
        shareCursors(CursorAxis::RecordTime, {plot});
        plots.push_back(plot);
        ++m_shownPlots;
    }
    return plots[unit];
}

void CapturesPage::showTable()
{
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(static_cast<int>(shownSet().shots.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        fillRow(row, shownSet().shots[static_cast<std::size_t>(row)]);
}

void CapturesPage::fillRow(int row, const Shot &shot)
{
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    const auto &inputs = shownSet().inputs;
    const auto input = static_cast<std::size_t>(dut ? inputOf(shot, *dut) : shot.input);
    const QString hash = input < inputs.size() ? shownText(inputs[input].sha256) : "";
    const QStringList texts{QString::number(row + 1), {},
        input < inputs.size() ? shownText(inputs[input].file) : QString(),
        dut ? shownQuantity(dut->sampleRate_Hz, "Hz") : tr("no DUT"),
        dut ? QString::number(dut->samples.size()) : QString(),
        dut ? shownText(dut->unit) : QString(), hash.left(10)};
    for (int column = 0; column < ColumnCount; ++column) {
        auto *item = new QTableWidgetItem(texts[column]);
        if (column == Use)
            item->setCheckState(shot.included ? Qt::Checked : Qt::Unchecked);
        if (column == Use && !shot.included)
            item->setToolTip(tr("Excluded: %1").arg(shownText(shot.excludeReason)));
        if (column == Hash)
            item->setToolTip(hash);
        if (column == Rate || column == Samples)
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_table->setItem(row, column, item);
    }
    auto *level = new QComboBox(m_table);
    level->setObjectName(QString("levelOfShot%1").arg(row + 1));
    level->setAccessibleName(tr("Level of shot %1").arg(row + 1));
    for (const ShotLevel choice : kLevels)
        level->addItem(levelText(choice));
    level->setCurrentIndex(positionIn(kLevels, shot.level));
    connect(level, &QComboBox::activated, this,
        [this, row](int choice) { setLevel(row + 1, kLevels[static_cast<std::size_t>(choice)]); });
    m_table->setCellWidget(row, Level, level);
}

void CapturesPage::showChannels()
{
    QStringList names;
    for (const Shot &shot : shownSet().shots)
        for (const Channel &channel : shot.channels)
            names << rawText(channel.name);
    names.removeDuplicates();
    auto *layout = static_cast<QFormLayout *>(m_channels->layout());
    if (names != m_channelNames) {
        while (layout->rowCount() > 0)
            layout->removeRow(0);
        m_roles.clear();
        m_channelNames = names;
        for (const QString &name : names) {
            auto *box = new WrappedComboBox(m_channels);
            box->setObjectName("roleOf_" + name);
            box->setAccessibleName(tr("Role of channel %1").arg(shownText(name)));
            for (const ChannelRole role : kRoles)
                box->addItem(roleText(role));
            connect(box, &QComboBox::activated, this, [this, name](int choice) {
                setRole(name, kRoles[static_cast<std::size_t>(choice)]);
            });
            addWrappedRow(*layout, withoutMnemonic(shownText(name)), box);
            m_roles.push_back(box);
        }
    }
    for (const Shot &shot : shownSet().shots)
        for (const Channel &channel : shot.channels) {
            const auto at = m_channelNames.indexOf(rawText(channel.name));
            m_roles[static_cast<std::size_t>(at)]->setCurrentIndex(
                positionIn(kRoles, usualRole(shownSet().shots, channel.name)));
        }
    const QString others = otherRoles(shownSet().shots);
    m_otherRoles->setText(others);
    m_otherRoles->setVisible(!others.isEmpty());
}

void CapturesPage::setRole(const QString &channel, ChannelRole role)
{
    change(tr("Change the role of %1").arg(shownText(channel)), [&](Recipe &r) {
        if (std::ranges::any_of(shownSet().inputs, readsOnlyNamedChannels))
            for (const Shot &shot : shownSet().shots)
                for (const Channel &other : shot.channels)
                    r.import.channels.emplace(other.name, channelRoleName(other.role));
        r.import.channels[channel.toStdString()] = channelRoleName(role);
        for (ShotImport &own : r.import.shots) // it is chosen for all shots
            own.channels.erase(channel.toStdString());
        std::erase_if(r.import.shots, [](const ShotImport &own) { return own.channels.empty(); });
    });
}

void CapturesPage::showRecipe()
{
    const ImportSettings &import = recipe().import;
    const Channel *dut = shownSet().shots.empty()
        ? nullptr
        : shownSet().shots.front().channelWithRole(ChannelRole::Dut);
    const QString unit = rawText(import.unit.value_or(""));
    if (!m_unit->hasFocus() || !m_unit->isModified() || m_unit->text().trimmed() == unit)
        m_unit->setText(unit); // else it is being typed
    m_unit->setPlaceholderText(dut ? shownText(dut->unit) : QString());
    m_scale->setSi(import.scale);
    m_inverted->setChecked(import.polarity < 0);
    m_reference->setCurrentIndex(positionIn(kReferences, import.reference));
    m_rate->set(import.sampleRate_Hz, dut ? std::optional(dut->sampleRate_Hz) : std::nullopt);
}

void CapturesPage::setIncluded(Index shot, bool included)
{
    std::optional<std::string> reason;
    if (!included) {
        const std::optional<QString> given
            = m_prompts.sentence(this, tr("Exclude shot %1").arg(shot),
                tr("Why is this shot not used? The certificate prints the reason."));
        if (!given) {
            showTable();
            return;
        }
        reason = given->toStdString();
    }
    change(included ? tr("Use shot %1").arg(shot) : tr("Exclude shot %1").arg(shot),
        [&](Recipe &r) { setShotExcluded(r.import, shot, reason); });
}

void CapturesPage::setLevel(Index shot, ShotLevel level)
{
    change(tr("Change the level of shot %1").arg(shot), [&](Recipe &r) {
        r.import.levels.clear();
        for (const Shot &each : shownSet().shots)
            r.import.levels.push_back(shotLevelName(each.level));
        r.import.levels[static_cast<std::size_t>(shot - 1)] = shotLevelName(level);
    });
}

/// Writes every level into the recipe, so that the operator can change each of them.
void CapturesPage::tagByStepHeight()
{
    std::vector<std::optional<double>> heights(shownSet().shots.size());
    for (const WindowedResponse &response : results().window->responses)
        if (response.shot >= 1 && response.shot <= std::ssize(heights))
            heights[static_cast<std::size_t>(response.shot - 1)] = response.step;
    change(tr("Tag shots by step height"), [&](Recipe &r) {
        r.import.levels.clear();
        for (const ShotLevel level : levelsByStepHeight(heights))
            r.import.levels.push_back(shotLevelName(level));
    });
}

/// A rate that is not the file's needs a reason.
void CapturesPage::changeRate(const std::optional<double> &rate_Hz)
{
    ImportSettings next = recipe().import;
    next.sampleRate_Hz = rate_Hz;
    next.sampleRateReason.clear();
    if (rate_Hz) {
        const std::optional<QString> reason = m_prompts.sentence(this, tr("Change the sample rate"),
            tr("Why is the rate in the file wrong? The results record the reason."));
        if (!reason) {
            showRecipe();
            return;
        }
        next.sampleRateReason = reason->toStdString();
    }
    emit importChanged(next, tr("Change the sample rate"));
}

/// Asks for the import of the file that the selected shot comes from, or of the first.
void CapturesPage::requestImport()
{
    const CaptureSet &set = *session().state().captures;
    const auto row = static_cast<std::size_t>(std::max(0, m_table->currentRow()));
    if (row >= set.shots.size())
        return;
    const auto input = static_cast<std::size_t>(set.shots[row].input);
    if (input < set.inputs.size())
        emit importRequested(rawText(set.inputs[input].path));
}

void CapturesPage::removeSelected()
{
    if (m_table->currentRow() < 0)
        return;
    const Index shot = m_table->currentRow() + 1;
    session().applyState(withoutShot(session().state(), shot), tr("Remove shot %1").arg(shot));
}

} // namespace dyncal
