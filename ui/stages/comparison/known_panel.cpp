// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/comparison/known_panel.h"

#include "ui/stages/comparison/known_words.h"
#include "ui/stages/frame/entry_edits.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/text/shown_text.h"

#include <QLineEdit>

namespace dyncal {

namespace {

constexpr double kLeastKnown = 1e-30; ///< above 0
constexpr double kMostKnown = 1e12; ///< as typed numbers elsewhere
constexpr double kFactorOfCertificate = 2.0; ///< k that U is typed with

std::optional<double> ifTyped(double value)
{
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

} // namespace

KnownPanel::KnownPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    form.addSection(tr("Values of other calibrations"));
    m_list = new EntryList(form, "known", tr("Values of other calibrations"), this);
    buildFields(form);
    m_list->addButtons(form);
    connect(m_list, &EntryList::selected, this, &KnownPanel::showEntry);
    const auto entries
        = [](Recipe &recipe) -> std::vector<KnownSensitivity> & { return recipe.response.known; };
    connectEdits<KnownSensitivity>(session, *m_list,
        {entries, [this] { return m_typed; }, tr("Add a value of another calibration"),
            tr("Change a value of another calibration"),
            tr("Remove a value of another calibration")});
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
    showTyped();
}

QLineEdit *KnownPanel::addLine(
    InspectorForm &form, const QString &label, const char *name, std::string *text)
{
    QLineEdit *line = form.add(label, name, new QLineEdit);
    connect(line, &QLineEdit::textChanged, this, [this, line, text] {
        *text = line->text().trimmed().toStdString();
        allowWhatIsComplete();
    });
    return line;
}

void KnownPanel::buildFields(InspectorForm &form)
{
    m_label = addLine(form, tr("Name"), "knownLabel", &m_typed.label);
    m_certificate = addLine(form, tr("Certificate"), "knownCertificate", &m_typed.certificate);
    const ShownUnit kilohertz{QStringLiteral("kHz"), 1e3};
    m_frequency
        = form.add(tr("Frequency"), "knownFrequency", new OptionalEdit(kilohertz, 0.0, kMostKnown));
    m_frequency->setEmptyText(tr("static"));
    m_unit = addLine(form, tr("Unit of the value"), "knownUnit", &m_typed.unit);
    m_magnitude
        = form.add(tr("Value"), "knownMagnitude", new OptionalEdit({}, kLeastKnown, kMostKnown));
    m_expanded = form.add(tr("U (k = 2)"), "knownU", new OptionalEdit({}, kLeastKnown, kMostKnown));
    for (OptionalEdit *needed : {m_magnitude, m_expanded})
        needed->setEmptyText(tr("needed"));
    connect(m_frequency, &OptionalEdit::edited, this,
        [this](const std::optional<double> &f_Hz) { m_typed.frequency_Hz = f_Hz.value_or(0.0); });
    connect(m_magnitude, &OptionalEdit::edited, this, [this](const std::optional<double> &value) {
        m_typed.magnitude = value.value_or(0.0);
        allowWhatIsComplete();
    });
    connect(m_expanded, &OptionalEdit::edited, this, [this](const std::optional<double> &U) {
        m_typed.u = U.value_or(0.0) / kFactorOfCertificate;
        allowWhatIsComplete();
    });
}

void KnownPanel::showRecipe(const Recipe &recipe)
{
    QStringList entries;
    for (const KnownSensitivity &stated : recipe.response.known)
        entries.append(knownText(stated));
    m_list->show(entries);
    allowWhatIsComplete();
}

void KnownPanel::suggestUnit()
{
    const auto &response = m_session.resultsOnShow().response;
    if (response && m_typed.unit.empty() && response->unit != "1")
        m_unit->setText(rawText(response->unit));
}

void KnownPanel::showEntry(int row)
{
    const auto &known = m_session.recipe().response.known;
    if (row < 0 || static_cast<std::size_t>(row) >= known.size())
        return;
    const KnownSensitivity stated = known[static_cast<std::size_t>(row)];
    m_label->setText(rawText(stated.label));
    m_certificate->setText(rawText(stated.certificate));
    m_unit->setText(rawText(stated.unit));
    m_typed = stated;
    showTyped();
}

void KnownPanel::showTyped()
{
    m_frequency->set(ifTyped(m_typed.frequency_Hz));
    m_magnitude->set(ifTyped(m_typed.magnitude));
    m_expanded->set(ifTyped(kFactorOfCertificate * m_typed.u));
    allowWhatIsComplete();
}

void KnownPanel::allowWhatIsComplete()
{
    m_list->allow(!m_typed.label.empty() && !m_typed.unit.empty() && m_typed.magnitude > 0.0
        && m_typed.u > 0.0);
}

} // namespace dyncal
