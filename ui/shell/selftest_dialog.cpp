// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/selftest_dialog.h"

#include "core/base/writing/folder_write.h"
#include "core/selftest/selftest_files.h"
#include "core/selftest/step_words.h"
#include "ui/report/document_pdf.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/value_table.h"
#include "ui/text/core_text.h"
#include "ui/text/progress_format.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr QSize kSelfTestSize(1100, 720);
constexpr int kProgressSteps = 1000; ///< of the progress bar
constexpr int kCheckDigits = 10;
constexpr int kToleranceDigits = 2;

} // namespace

SelfTestDialog::SelfTestDialog(CurrentUtc currentUtc, Prompts &prompts, Preferences &preferences,
    QString language, QWidget *parent)
    : QDialog(parent)
    , m_currentUtc(std::move(currentUtc))
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_language(std::move(language))
    , m_verdict(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_table(new ValueTable("selfTestTable", tr("Checks"), this))
    , m_job(this)
{
    setObjectName("selfTestDialog");
    setWindowTitle(tr("Self-test of the installation"));
    m_verdict->setObjectName("selfTestVerdict");
    m_verdict->setWordWrap(true);
    m_progress->setObjectName("selfTestProgress");
    m_progress->setRange(0, kProgressSteps);
    m_progress->setFormat(progressFormat());
    m_progress->setAccessibleName(tr("Progress of the self-test"));
    auto *buttons = new QDialogButtonBox(this);
    m_again = buttons->addButton(tr("&Test again"), QDialogButtonBox::ActionRole);
    m_again->setObjectName("selfTestAgain");
    m_save = buttons->addButton(tr("&Save report..."), QDialogButtonBox::ActionRole);
    m_save->setObjectName("selfTestSave");
    m_save->setToolTip(tr("selftest.pdf and selftest.json, into a folder"));
    m_close = buttons->addButton(QDialogButtonBox::Close);
    m_close->setObjectName("selfTestClose");
    connect(m_again, &QPushButton::clicked, this, [this] { start(); });
    connect(m_save, &QPushButton::clicked, this, &SelfTestDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &SelfTestDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_verdict);
    column->addWidget(m_progress);
    column->addWidget(m_table, 1);
    column->addWidget(buttons);
    resize(kSelfTestSize);
    showRunning(false);
}

void SelfTestDialog::start(Index calibrations)
{
    const Result<std::string> created = m_currentUtc();
    if (!created) {
        m_prompts.showProblem(this, translated(created.error().message));
        return;
    }
    m_createdUtc = *created;
    m_report.reset();
    m_table->setRowCount(0);
    m_progress->setValue(0);
    m_verdict->setText(tr(
        "Every step of the method is being compared with what is known of it. This takes some seconds."));
    showRunning(true);
    m_job.start<SelfTestReport>(
        [calibrations](const JobControl &control) {
            return runSelfTest({calibrations, {{"Qt", qVersion()}}}, control);
        },
        [this](Result<SelfTestReport> outcome) { showOutcome(std::move(outcome)); },
        [this](double fraction) {
            m_progress->setValue(static_cast<int>(kProgressSteps * fraction));
        });
}

void SelfTestDialog::reject()
{
    if (!isRunning()) {
        QDialog::reject();
        return;
    }
    m_job.cancel();
    m_verdict->setText(tr("The self-test was stopped; nothing is known of this installation."));
    showRunning(false);
}

void SelfTestDialog::showRunning(bool isRunning)
{
    m_progress->setVisible(isRunning);
    m_again->setEnabled(!isRunning);
    m_save->setEnabled(!isRunning && m_report.has_value());
    m_close->setText(isRunning ? tr("&Cancel") : tr("&Close"));
}

void SelfTestDialog::showOutcome(Result<SelfTestReport> outcome)
{
    if (outcome) {
        m_report = std::move(*outcome);
        m_verdict->setText(translated(m_report->verdict()));
        showTable();
    } else {
        m_verdict->setText(translated(outcome.error().message));
    }
    showRunning(false);
}

/// What deviates stands first: nobody should have to look for it.
void SelfTestDialog::showTable()
{
    QVector<QStringList> deviating, holding;
    for (const SelfCheck &check : m_report->checks)
        (check.holds() ? holding : deviating) << QStringList{
            check.holds() ? tr("holds") : tr("deviates"), translated(stepWords(check.step)),
            translated(check.name), shownNumber(check.expected, kCheckDigits),
            shownNumber(check.found, kCheckDigits), shownNumber(check.tolerance, kToleranceDigits),
            shownNumber(check.sensitivity, kToleranceDigits), translated(check.source)};
    m_table->setValues({tr("Verdict"), tr("Step"), tr("What"), tr("Expected"), tr("Found"),
                           tr("Tolerance"), tr("Change for 10⁻¹²"), tr("Known from")},
        deviating + holding);
    m_table->horizontalHeaderItem(6)->setToolTip(
        tr("How far the result moves when all data change by a part in 10^12"));
}

Result<void> SelfTestDialog::writeReport(const QString &folder) const
{
    Result<FolderWrite> target = FolderWrite::begin(selfTestFolder(folder.toStdString()));
    if (!target)
        return tl::unexpected<Error>(target.error());
    const Result<std::string> pdf
        = documentPdf(selfTestDocument(*m_report, m_createdUtc, m_language.toStdString()));
    if (!pdf)
        return tl::unexpected<Error>(pdf.error());
    const std::string json = selfTestJson(*m_report, m_createdUtc);
    return target->commit({{kSelfTestJson, json}, {kSelfTestPdf, *pdf}});
}

void SelfTestDialog::save()
{
    const QString folder = m_prompts.folder(
        this, tr("Save the report of the self-test into a folder"), m_preferences.lastFolder());
    if (folder.isEmpty())
        return;
    if (const Result<void> written = writeReport(folder); !written)
        m_prompts.showProblem(this, translated(written.error().message));
    else
        m_verdict->setText(translated(m_report->verdict()) + QLatin1Char('\n')
            + tr("Written: %1").arg(shownText(folder)));
}

} // namespace dyncal
