// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/certificate_page.h"

#include "core/certificate/certificate.h"
#include "core/certificate/certificate_data.h"
#include "core/dcc/iso_codes.h"
#include "ui/stages/certificate/dcc_panel.h"
#include "ui/stages/certificate/decision_panel.h"
#include "ui/stages/certificate/field_labels.h"
#include "ui/stages/certificate/preview_panel.h"
#include "ui/stages/certificate/template_panel.h"
#include "ui/stages/frame/calendar_button.h"
#include "ui/stages/frame/folding_splitter.h"
#include "ui/stages/frame/inspector_scroll.h"
#include "ui/stages/frame/status_text.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/shown_text.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <array>

namespace dyncal {

namespace {

constexpr std::array<const char *, 3> kGroups{
    QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Laboratory and customer"),
    QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Sensor"),
    QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Certificate"),
};

struct FormField
{
    const char *key; ///< of recipe certificate.fields
    std::size_t group;
};

constexpr std::array<FormField, 19> kFields{{
    {"laboratory", 0},
    {"laboratory_address", 0},
    {"laboratory_country", 0},
    {"place", 0},
    {"customer", 0},
    {"customer_address", 0},
    {"customer_country", 0},
    {"sensor_manufacturer", 1},
    {"sensor_model", 1},
    {"sensor_serial", 1},
    {"sensor_description", 1},
    {"certificate_number", 2},
    {"date_received", 2},
    {"date_performed", 2},
    {"date_issued", 2},
    {"operator", 2},
    {"approved_by", 2},
    {"method_id", 2},
    {"remarks", 2},
}};

constexpr int kFormsPart = 2; ///< of the width, to that of the preview
constexpr int kPreviewsPart = 3;
constexpr int kLeastOfField = 16; ///< letters; a field without that room goes below its label
constexpr const char *kRemarks = "remarks";

bool isDate(std::string_view key)
{
    return key.starts_with("date_");
}

bool isCountry(std::string_view key)
{
    return key.ends_with("_country");
}

} // namespace

CertificatePage::CertificatePage(Session &session, CurrentUtc currentUtc)
    : StagePage(session,
        {"certificatePage", tr("Certificate"),
            tr("Fill in what is not measured, then export the certificate.")},
        Page::Certificate)
{
    auto *split = new FoldingSplitter(this);
    m_form = builtForm();
    split->addWidget(m_form);
    m_preview = new PreviewPanel(session, std::move(currentUtc), split);
    split->addWidget(m_preview);
    split->setStretchFactor(0, kFormsPart);
    split->setStretchFactor(1, kPreviewsPart);
    split->setSizes(
        {1000 * kFormsPart, 1000 * kPreviewsPart}); // or the form takes what its hint wants
    split->setChildrenCollapsible(false);
    content()->addWidget(split);
    buildInspector();
}

InspectorScroll *CertificatePage::builtForm()
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    std::vector<QFormLayout *> forms;
    for (const char *title : kGroups) {
        auto *group = new QGroupBox(tr(title), page);
        forms.push_back(new QFormLayout(group));
        column->addWidget(group);
    }
    for (const FormField &field : kFields) {
        const CertificateField *printed = printedField(field.key);
        const QString label = fieldLabel(field.key);
        QWidget *edit = nullptr;
        if (field.key == std::string_view(kRemarks)) {
            m_remarks = new QPlainTextEdit(page);
            m_remarks->setMaximumHeight(80);
            m_remarks->setTabChangesFocus(true);
            connect(m_remarks, &QPlainTextEdit::textChanged, this,
                [this] { setField(kRemarks, m_remarks->toPlainText(), kRemarks); });
            edit = m_remarks;
        } else {
            auto *line = new QLineEdit(page);
            line->setMinimumWidth(kLeastOfField * fontMetrics().averageCharWidth());
            if (isDate(field.key))
                setWholePlaceholder(*line, tr("YYYY-MM-DD"));
            if (isCountry(field.key)) {
                setWholePlaceholder(*line, tr("e.g. SE"));
                line->setToolTip(tr("Two letters of ISO 3166-1, for the DCC; not printed"));
            }
            connect(line, &QLineEdit::editingFinished, this,
                [this, line, key = field.key] { setField(key, line->text().trimmed(), {}); });
            m_edits.emplace_back(field.key, line);
            edit = line;
        }
        edit->setObjectName(QString("field_%1").arg(field.key));
        edit->setAccessibleName(label);
        const QString heading = printed && printed->missing ? label + " *" : label;
        addWrappedRow(*forms[field.group], heading,
            isDate(field.key) || isCountry(field.key) ? withNote(field.key, m_edits.back().second)
                                                      : edit);
    }
    column->addStretch(1);
    return new InspectorScroll(page);
}

/// A date with a calendar beside it, or a country, and room below it for what is wrong with it.
QWidget *CertificatePage::withNote(const std::string &key, QLineEdit *edit)
{
    auto *box = new QWidget;
    box->setFocusProxy(edit);
    auto *column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    auto *note = new QLabel(isDate(key)
            ? tr("■ This is not a date. Write it as 2026-01-31.")
            : tr("■ This is no country. Write its two letters of ISO 3166-1, as SE."),
        box);
    note->setObjectName("note_" + rawText(key));
    note->setWordWrap(true);
    note->hide();
    if (isDate(key))
        column->addLayout(rowWithCalendar(*edit, "calendar_" + rawText(key)));
    else
        column->addWidget(edit);
    column->addWidget(note);
    m_notes.emplace_back(key, note);
    return box;
}

void CertificatePage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Document"));
    m_template = new TemplatePanel(session(), *form, this);
    connect(
        m_template, &TemplatePanel::browseRequested, this, &CertificatePage::templateFileRequested);
    auto *button = new WrappedButton(tr("Export certificate PDF..."));
    button->setObjectName("exportCertificate");
    form->addWide(button);
    connect(button, &QPushButton::clicked, this, &CertificatePage::exportRequested);
    m_decision = new DecisionPanel(session(), *form, this);
    form->addSection(tr("Checklist"));
    m_missing = form->addNote("missingFields");
    m_cautions = form->addNote("cautionCount");
    m_dcc = new DccPanel(session(), *form, this);
    connect(m_preview, &PreviewPanel::outdated, m_dcc, &DccPanel::wait);
    connect(m_preview, &PreviewPanel::begun, m_dcc, &DccPanel::check);
    connect(m_dcc, &DccPanel::fieldRequested, this, &CertificatePage::goTo);
}

/// To a field of the form.
void CertificatePage::goTo(const std::string &key)
{
    for (const auto &[field, edit] : m_edits)
        if (field == key) {
            m_form->ensureWidgetVisible(edit);
            edit->setFocus(Qt::OtherFocusReason);
        }
}

void CertificatePage::takeTemplate(const QString &path)
{
    m_template->take(path);
}

QString CertificatePage::field(const std::string &key) const
{
    const auto &fields = recipe().certificate.fields;
    const auto found = fields.find(key);
    return found == fields.end() ? QString() : rawText(found->second);
}

void CertificatePage::setField(const std::string &key, const QString &text, const QString &mergeKey)
{
    if (text == field(key))
        return;
    change(
        tr("Fill in the certificate"),
        [&](Recipe &r) {
            if (text.isEmpty())
                r.certificate.fields.erase(key);
            else
                r.certificate.fields[key] = text.toStdString();
        },
        mergeKey);
}

void CertificatePage::showRecipe()
{
    for (const auto &[key, edit] : m_edits)
        if (!edit->hasFocus() || !edit->isModified() || edit->text().trimmed() == field(key))
            edit->setText(field(key));
    const QSignalBlocker quiet(m_remarks);
    if (m_remarks->toPlainText() != field(kRemarks))
        m_remarks->setPlainText(field(kRemarks));
    showMissing();
    m_preview->follow();
}

/// The list that the document itself prints in red.
void CertificatePage::showMissing()
{
    const CertificateData printedData = makeCertificate(session().results(), recipe(), {});
    for (const auto &[key, edit] : m_edits) // what the captures know needs no typing
        if (const CertificateField *printed = fieldOf(printedData, key);
            printed && !printed->missing && key.starts_with("sensor_"))
            edit->setPlaceholderText(translated(printed->value));
    for (const auto &[key, note] : m_notes) {
        const CertificateField *printed = fieldOf(printedData, key);
        const QString typed = field(key);
        note->setVisible(isCountry(key) ? !typed.isEmpty() && !isCountryCode(typed.toStdString())
                                        : printed && printed->wrong);
    }
    QStringList missing;
    for (const Message &label : printedData.missingFields())
        missing << translated(label);
    m_missing->setText(missing.isEmpty() ? tr("● All required fields are filled in.")
                                         : tr("■ %n required field(s) to be filled in: %1.",
                                             nullptr, static_cast<int>(missing.size()))
                                               .arg(missing.join(", ")));
}

void CertificatePage::showResults()
{
    showMissing();
    m_preview->follow();
    m_decision->showOutcome();
    int cautions = 0;
    int blocks = 0;
    for (const Finding &finding : session().findings()) {
        cautions += finding.severity == Severity::Caution;
        blocks += finding.severity == Severity::Block;
    }
    const QString sign = blocks > 0 ? severityGlyph(Severity::Block)
        : cautions > 0              ? severityGlyph(Severity::Caution)
                                    : statusGlyph(StageStatus::Done);
    m_cautions->setText(sign + " " + tr("%n finding(s) that block", nullptr, blocks) + ", "
        + tr("%n caution(s).", nullptr, cautions));
}

} // namespace dyncal
