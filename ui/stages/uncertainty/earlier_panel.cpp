// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/earlier_panel.h"

#include "core/base/calendar_date.h"
#include "ui/session/session.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>

namespace dyncal {

namespace {

constexpr int kDigitsOfEn = 2;

} // namespace

EarlierPanel::EarlierPanel(Session &session, Prompts &prompts, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_prompts(prompts)
    , m_choose(new QPushButton(tr("Lay over...")))
    , m_remove(new QPushButton(tr("Take away")))
    , m_job(this)
{
    form.addSection(tr("Earlier result"));
    m_choose->setObjectName("earlierChoose");
    m_choose->setToolTip(tr(
        "A results.json of an earlier run, or a digital calibration certificate (DCC) of any laboratory: its S(f) is drawn beside this one, and nothing is changed by it"));
    m_remove->setObjectName("earlierRemove");
    for (QPushButton *button : {m_choose, m_remove})
        form.addWide(button);
    m_note = form.addNote("earlierNote");
    connect(m_choose, &QPushButton::clicked, this, &EarlierPanel::askForFile);
    connect(m_remove, &QPushButton::clicked, this, [this] { setEarlier(std::nullopt, QString()); });
    setEarlier(std::nullopt, QString());
}

QString EarlierPanel::name() const
{
    if (m_earlier->serial.empty() && !m_earlier->certificate.empty())
        return tr("Certificate %1, %2")
            .arg(shownText(m_earlier->certificate), shownText(dayOfMoment(m_earlier->time)));
    const QString serial = shownText(m_earlier->serial);
    const QString day = shownText(dayOfMoment(m_earlier->time));
    return serial.isEmpty() ? tr("Earlier, %1").arg(day) : tr("Sensor %1, %2").arg(serial, day);
}

void EarlierPanel::askForFile()
{
    const auto &captures = m_session.state().captures;
    const bool isOpen = captures && !captures->inputs.empty();
    const QString beside = isOpen ? rawText(captures->inputs.front().path) : QString();
    const QString path = m_prompts.openFile(m_choose, tr("Earlier result"),
        tr("Results and certificates (*.json *.xml);;All files (*)"), QFileInfo(beside).path());
    if (path.isEmpty())
        return;
    m_job.start<EarlierResponse>(
        [file = path.toStdString()](const JobControl &) { return readEarlierResponse(file); },
        [this](Result<EarlierResponse> read) { take(std::move(read)); });
}

void EarlierPanel::take(Result<EarlierResponse> read)
{
    if (read)
        setEarlier(std::move(*read), QString());
    else
        setEarlier(std::nullopt, translated(read.error().message));
}

void EarlierPanel::setEarlier(std::optional<EarlierResponse> earlier, const QString &sentence)
{
    m_earlier = std::move(earlier);
    m_remove->setEnabled(m_earlier.has_value());
    m_note->setText(sentence);
    m_note->setVisible(!sentence.isEmpty());
    emit changed();
}

void EarlierPanel::compareWith(const std::vector<ResponseRow> &present, const std::string &unit)
{
    if (!m_earlier)
        return;
    QString sentence;
    const bool isInUnit = toUnit(*m_earlier, unit);
    const ResponseAgreement agreement = agreementOf(present, m_earlier->rows);
    if (!isInUnit)
        sentence = tr("%1: in %2, which this result is not; it is not drawn.")
                       .arg(name(), shownText(m_earlier->unit));
    else if (agreement.compared == 0)
        sentence = tr("%1: no frequency is stated with U by both.").arg(name());
    else
        sentence = tr(
            "%1: %2 of %3 rows agree within U; the largest |Eₙ| is %4, at %5. What both share, tube, references and method, is in both U: an |Eₙ| below 1 does not show that nothing changed.")
                       .arg(name(), QString::number(agreement.agreeing),
                           QString::number(agreement.compared),
                           shownNumber(std::abs(agreement.largestEn), kDigitsOfEn),
                           shownQuantity(agreement.at_Hz, QStringLiteral("Hz")));
    m_note->setText(sentence + notAssigned());
    m_note->show();
}

QString EarlierPanel::notAssigned() const
{
    QString text;
    for (const Message &one : m_earlier->notAssigned)
        text += '\n' + translated(one);
    return text.isEmpty() ? text : "\n\n" + tr("Not taken from the certificate:") + text;
}

} // namespace dyncal
