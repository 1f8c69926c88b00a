// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_rate_row.h"

#include "ui/session/import_choices.h"
#include "ui/shell/import/named_control.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace dyncal {

namespace {

constexpr int kRateChars = 44; ///< digits, the unit and the box that says whether it is known

} // namespace

ImportRateRow::ImportRateRow(QWidget *parent)
    : QWidget(parent)
    , m_rate(new OptionalEdit({"MHz", 1e6}, 1e-3, 1e12, this))
    , m_reason(named(new QLineEdit(this), "importRateReason", tr("Why the file is wrong")))
    , m_source(new QLabel(this))
    , m_useTimes(named(new QPushButton(this), "useTimes", {}))
    , m_useHeader(named(new QPushButton(this), "useHeader", {}))
{
    m_rate->setNames("importRate", tr("Sample rate"));
    m_rate->setMaximumWidth(kRateChars * fontMetrics().averageCharWidth());
    connect(m_rate, &OptionalEdit::edited, this, &ImportRateRow::rateTyped);
    m_reason->setPlaceholderText(m_reason->accessibleName());
    connect(m_reason, &QLineEdit::textEdited, this,
        [this](const QString &text) { emit reasonTyped(text.trimmed()); });
    m_source->setObjectName("importRateSource");
    connect(m_useTimes, &QPushButton::clicked, this,
        [this] { emit timesPreferred(tr("the time column is right, the header is not")); });
    connect(m_useHeader, &QPushButton::clicked, this,
        [this] { emit headerPreferred(tr("the header is right, the time column is not")); });
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(tr("Sample rate"), this));
    row->addWidget(m_rate);
    row->addWidget(m_source);
    row->addWidget(m_reason, 1);
    row->addStretch(0);
    row->addWidget(m_useTimes);
    row->addWidget(m_useHeader);
}

void ImportRateRow::showSettings(const ImportSettings &settings)
{
    if (!m_reason->hasFocus())
        m_reason->setText(rawText(settings.sampleRateReason));
}

void ImportRateRow::showView(const ImportView &view, const ImportSettings &settings)
{
    const std::optional<double> found
        = view.sampleRate_Hz > 0.0 ? std::optional(view.sampleRate_Hz) : std::nullopt;
    m_reason->setVisible(needsRateReason(settings, view));
    m_rate->setEmptyText(tr("not stated"));
    m_rate->set(settings.sampleRate_Hz, found);
    const bool contradiction = view.headerRate_Hz && view.timesRate_Hz;
    m_useTimes->setVisible(contradiction);
    m_useHeader->setVisible(contradiction);
    if (contradiction) {
        m_useTimes->setText(
            tr("Use the time column: %1").arg(shownQuantity(*view.timesRate_Hz, "Hz")));
        m_useHeader->setText(
            tr("Use the header: %1").arg(shownQuantity(*view.headerRate_Hz, "Hz")));
    }
    if (!found)
        m_source->setText(settings.sampleRate_Hz ? tr("as typed") : QString());
    else if (view.text && view.text->timeColumn)
        m_source->setText(tr("from the time column: %1").arg(shownQuantity(*found, "Hz")));
    else
        m_source->setText(tr("the file states %1").arg(shownQuantity(*found, "Hz")));
}

} // namespace dyncal
