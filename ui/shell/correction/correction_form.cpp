// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/correction/correction_form.h"

#include "ui/stages/frame/optional_edit.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QFileInfo>

namespace dyncal {

namespace {

constexpr double kMostFrequency_Hz = 1e12;
constexpr double kMostTime_s = 1e6;
constexpr double kMostPressure_Pa = 1e12;

ShownUnit kilohertz()
{
    return {QStringLiteral("kHz"), 1e3};
}

ShownUnit milliseconds()
{
    return {QStringLiteral("ms"), 1e-3};
}

QString namesOf(const QStringList &paths)
{
    QStringList names;
    for (const QString &path : paths)
        names << shownText(QFileInfo(path).fileName());
    return names.isEmpty() ? CorrectionForm::tr("none yet") : names.join(QStringLiteral("\n"));
}

} // namespace

CorrectionForm::CorrectionForm(QWidget *parent)
    : InspectorForm(parent)
{
    setObjectName("correctionForm");
    addCalibration();
    addRecordings();
    addFilter();
    addStretches();
    showChoice();
}

void CorrectionForm::addCalibration()
{
    addSection(tr("Calibration of the sensor"));
    m_from = addChoice(
        tr("Taken from"), "correctionFrom", {tr("the open project"), tr("a results.json")});
    m_results = addReadout(tr("File"), "correctionResults");
    m_chooseResults = new WrappedButton(tr("Choose a results.json..."));
    m_chooseResults->setObjectName("correctionChooseResults");
    addWide(m_chooseResults);
    connect(m_from, &QComboBox::activated, this, [this](int row) {
        m_choice.isOfProject = row == 0;
        showChoice();
        emit edited();
    });
    connect(m_chooseResults, &QPushButton::clicked, this, &CorrectionForm::resultsWanted);
}

void CorrectionForm::addRecordings()
{
    addSection(tr("Recordings to correct"));
    m_recordings = addReadout(tr("Files"), "correctionRecordings");
    auto *choose = new WrappedButton(tr("Choose recordings..."));
    choose->setObjectName("correctionChooseRecordings");
    addWide(choose);
    m_channel = addChoice(tr("Channel of the sensor"), "correctionChannel", {});
    m_asProject = new WrappedCheckBox(tr("Read them as the recordings of the project"));
    m_asProject->setObjectName("correctionAsProject");
    m_asProject->setToolTip(
        tr("With the import settings of the open project: columns, units, scale, gain"));
    addWide(m_asProject);
    connect(choose, &QPushButton::clicked, this, &CorrectionForm::recordingsWanted);
    connect(m_channel, &QComboBox::activated, this, [this](int row) {
        m_choice.channel = row == 0 ? QString() : m_choice.channels.value(row - 1);
        emit edited();
    });
    connect(m_asProject, &QCheckBox::clicked, this, [this](bool isOn) {
        m_choice.isReadAsProject = isOn;
        emit readingEdited();
    });
}

OptionalEdit *CorrectionForm::addNumber(const QString &label, const QString &objectName,
    OptionalEdit *edit, const QString &empty,
    const std::function<std::optional<double> &(CorrectionChoice &)> &of)
{
    add(label, objectName, edit);
    edit->setEmptyText(empty);
    connect(edit, &OptionalEdit::edited, this, [this, of](const std::optional<double> &value) {
        of(m_choice) = value;
        emit edited();
    });
    m_shows.emplace_back([this, edit, of] { edit->set(of(m_choice)); });
    return edit;
}

void CorrectionForm::addFilter()
{
    addSection(tr("Filter"));
    addNumber(
        tr("Band up to"), "correctionBand", new OptionalEdit(kilohertz(), 0.0, kMostFrequency_Hz),
        tr("the widest possible"),
        [](CorrectionChoice & choice) -> auto & { return choice.filter.band_Hz; });
    addNumber(
        tr("Nothing beyond"), "correctionEdge",
        new OptionalEdit(kilohertz(), 0.0, kMostFrequency_Hz), tr("1.5 times the band"),
        [](CorrectionChoice & choice) -> auto & { return choice.filter.edge_Hz; });
    addNumber(
        tr("Delay"), "correctionDelay",
        new OptionalEdit({QStringLiteral("µs"), 1e-6}, 0.0, kMostTime_s), tr("the shortest"),
        [](CorrectionChoice & choice) -> auto & { return choice.filter.delay_s; });
    m_lowPass = addChoice(
        tr("Low-pass"), "correctionLowPass", {tr("Gaussian, no phase"), tr("two equal poles")});
    connect(m_lowPass, &QComboBox::activated, this, [this](int row) {
        m_choice.filter.lowPass = row == 0 ? LowPassKind::Gaussian : LowPassKind::TwoPole;
        emit edited();
    });
}

void CorrectionForm::addStretches()
{
    const auto time = [] { return new OptionalEdit(milliseconds(), -kMostTime_s, kMostTime_s); };
    addSection(tr("Stretches of the recording"));
    addNumber(
        tr("Corrected from"), "correctionWindowBegin", time(), tr("its begin"),
        [](CorrectionChoice & choice) -> auto & { return choice.window.begin_s; });
    addNumber(
        tr("Corrected to"), "correctionWindowEnd", time(), tr("its end"),
        [](CorrectionChoice & choice) -> auto & { return choice.window.end_s; });
    addNumber(
        tr("No pressure from"), "correctionQuietBegin", time(), tr("its begin"),
        [](CorrectionChoice & choice) -> auto & { return choice.quiet.begin_s; });
    addNumber(
        tr("No pressure to"), "correctionQuietEnd", time(), tr("before the start"),
        [](CorrectionChoice & choice) -> auto & { return choice.quiet.end_s; });
    addNumber(
        tr("Beyond the band at most"), "correctionBeyond",
        new OptionalEdit({QStringLiteral("kPa"), 1e3}, 0.0, kMostPressure_Pa),
        tr("from the recording"),
        [](CorrectionChoice & choice) -> auto & { return choice.beyond_Pa; });
}

void CorrectionForm::setChoice(const CorrectionChoice &choice)
{
    m_choice = choice;
    showChoice();
}

void CorrectionForm::showChoice()
{
    m_from->setCurrentIndex(m_choice.isOfProject ? 0 : 1);
    m_results->setText(m_choice.isOfProject ? tr("the run on show")
            : m_choice.results.isEmpty()    ? tr("none yet")
                                            : shownText(QFileInfo(m_choice.results).fileName()));
    m_results->setToolTip(m_choice.isOfProject ? QString() : shownText(m_choice.results));
    m_chooseResults->setEnabled(!m_choice.isOfProject);
    m_recordings->setText(namesOf(m_choice.recordings));
    m_channel->clear();
    m_channel->addItem(tr("as the recordings say"));
    for (const QString &name : m_choice.channels)
        m_channel->addItem(shownText(name));
    m_channel->setCurrentIndex(1 + static_cast<int>(m_choice.channels.indexOf(m_choice.channel)));
    m_asProject->setChecked(m_choice.isReadAsProject);
    m_lowPass->setCurrentIndex(m_choice.filter.lowPass == LowPassKind::Gaussian ? 0 : 1);
    for (const auto &show : m_shows)
        show();
}

QString withFieldLabels(QString sentence)
{
    const std::pair<const char *, QString> labels[]{{"--band", CorrectionForm::tr("Band up to")},
        {"--edge", CorrectionForm::tr("Nothing beyond")}, {"--delay", CorrectionForm::tr("Delay")},
        {"--window", CorrectionForm::tr("Corrected from")},
        {"--quiet", CorrectionForm::tr("No pressure from")},
        {"--beyond", CorrectionForm::tr("Beyond the band at most")}};
    for (const auto &[option, label] : labels)
        sentence.replace(QLatin1String(option), QLatin1Char('"') + label + QLatin1Char('"'));
    return sentence;
}

} // namespace dyncal
