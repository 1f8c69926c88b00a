// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate_page.h"

#include "ui/text/finding_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>

#include <array>

namespace dyncal {

namespace {

struct Field
{
    const char *key; ///< of recipe certificate.fields
    const char *label;
    int group;
    bool required; ///< ISO/IEC 17025 7.8.2
};

constexpr std::array<const char *, 3> kGroups{
    QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Laboratory and customer"),
    QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Sensor"),
    QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Certificate"),
};

constexpr std::array<Field, 15> kFields{{
    {"laboratory", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Laboratory"), 0, true},
    {"laboratory_address", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Laboratory's address"), 0,
        true},
    {"customer", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Customer"), 0, true},
    {"customer_address", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Customer's address"), 0,
        true},
    {"sensor_manufacturer", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Manufacturer"), 1, false},
    {"sensor_model", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Model"), 1, true},
    {"sensor_serial", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Serial number"), 1, true},
    {"sensor_description", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Description"), 1, false},
    {"certificate_number", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Certificate number"), 2,
        true},
    {"date_received", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Date received"), 2, true},
    {"date_performed", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Date performed"), 2, true},
    {"date_issued", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Date issued"), 2, true},
    {"operator", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Operator"), 2, true},
    {"method_id", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Method"), 2, true},
    {"remarks", QT_TRANSLATE_NOOP("dyncal::CertificatePage", "Remarks"), 2, false},
}};

constexpr const char *kRemarks = "remarks";

} // namespace

CertificatePage::CertificatePage(Session &session)
    : StagePage(session,
        {"certificatePage", tr("Certificate"),
            tr("Fill in what is not measured, then export the certificate.")},
        {StageId::Response})
{
    buildForm();
    buildInspector();
}

void CertificatePage::buildForm()
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    std::vector<QFormLayout *> forms;
    for (const char *title : kGroups) {
        auto *group = new QGroupBox(tr(title), page);
        forms.push_back(new QFormLayout(group));
        column->addWidget(group);
    }
    for (const Field &field : kFields) {
        const QString label = tr(field.label);
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
            if (std::string_view(field.key).starts_with("date_"))
                line->setPlaceholderText(tr("2026-01-31"));
            connect(line, &QLineEdit::editingFinished, this,
                [this, line, key = field.key] { setField(key, line->text().trimmed(), {}); });
            m_edits.emplace_back(field.key, line);
            edit = line;
        }
        edit->setObjectName(QString("field_%1").arg(field.key));
        edit->setAccessibleName(label);
        forms[static_cast<std::size_t>(field.group)]->addRow(
            field.required ? label + " *" : label, edit);
    }
    column->addStretch(1);
    auto *scroll = new QScrollArea(this);
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    content()->addWidget(scroll);
}

void CertificatePage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Document"));
    m_language = form->addChoice(tr("Language"), "certificateLanguage",
        {QStringLiteral("English"), QStringLiteral("Svenska")});
    connect(m_language, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change the certificate's language"),
            [&](Recipe &r) { r.certificate.languages = {choice == 1 ? "sv" : "en"}; });
    });
    auto *button = new QPushButton(tr("Export certificate PDF..."));
    button->setObjectName("exportCertificate");
    form->addWide(button);
    connect(button, &QPushButton::clicked, this, &CertificatePage::exportRequested);
    form->addSection(tr("Checklist"));
    m_missing = form->addNote("missingFields");
    m_cautions = form->addNote("cautionCount");
}

QString CertificatePage::field(const std::string &key) const
{
    const auto &fields = recipe().certificate.fields;
    const auto found = fields.find(key);
    return found == fields.end() ? QString() : QString::fromStdString(found->second);
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
    const auto &languages = recipe().certificate.languages;
    m_language->setCurrentIndex(!languages.empty() && languages.front() == "sv" ? 1 : 0);
    showMissing();
}

void CertificatePage::showMissing()
{
    QStringList missing;
    for (const Field &each : kFields)
        if (each.required && field(each.key).isEmpty())
            missing << tr(each.label);
    m_missing->setText(missing.isEmpty()
            ? tr("● All required fields are filled in.")
            : tr("■ %n required field(s) empty: %1.", nullptr, static_cast<int>(missing.size()))
                  .arg(missing.join(", ")));
}

void CertificatePage::showResults()
{
    int cautions = 0;
    int blocks = 0;
    for (const Finding &finding : session().findings()) {
        cautions += finding.severity == Severity::Caution;
        blocks += finding.severity == Severity::Block;
    }
    m_cautions->setText(severityGlyph(blocks > 0 ? Severity::Block : Severity::Caution) + " "
        + tr("%1 findings that block, %2 cautions.").arg(blocks).arg(cautions));
}

} // namespace dyncal
