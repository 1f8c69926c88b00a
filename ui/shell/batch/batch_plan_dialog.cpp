// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_plan_dialog.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr int kWidth = 720;

} // namespace

BatchPlanDialog::BatchPlanDialog(Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QDialog(parent)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_eachFile(new QCheckBox(tr("&Every recording is a sensor of its own"), this))
{
    setObjectName("batchPlanDialog");
    setWindowTitle(tr("Plan a batch"));
    auto *what = new QLabel(
        tr("Every folder below the folder of recordings that holds recordings is a sensor. A recipe.json in it wins over the common recipe. The results go beside the plan."),
        this);
    what->setWordWrap(true);
    auto *form = new QFormLayout;
    addPaths(*form);
    m_eachFile->setObjectName("batchEachFile");
    form->addRow(m_eachFile);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept = buttons->addButton(tr("Make the &plan"), QDialogButtonBox::AcceptRole);
    m_accept->setObjectName("batchMakePlan");
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->addWidget(what);
    column->addLayout(form);
    column->addStretch();
    column->addWidget(buttons);
    resize(kWidth, sizeHint().height());
    showReadiness();
}

void BatchPlanDialog::addPaths(QFormLayout &form)
{
    m_root = addPath(form, "batchRoot", tr("&Folder of recordings"), tr("needed"), [this] {
        return m_prompts.folder(this, tr("Folder of recordings"), m_preferences.lastFolder());
    });
    m_recipe = addPath(form, "batchRecipe", tr("&Recipe"), tr("none: the defaults"),
        [this] { return askForJson(tr("Common recipe")); });
    m_profile = addPath(form, "batchProfile", tr("Pr&ofile of the laboratory"), tr("none"),
        [this] { return askForJson(tr("Profile of the laboratory")); });
    m_plan = addPath(form, "batchPlanFile", tr("P&lan"), tr("needed, outside the folder"), [this] {
        return m_prompts.saveFile(this, tr("Plan to write"), tr("Plans (*.jsonl)"),
            m_preferences.lastFolder() + "/batch.jsonl", "jsonl");
    });
}

QString BatchPlanDialog::askForJson(const QString &title)
{
    return m_prompts.openFile(this, title, tr("JSON (*.json)"), m_preferences.lastFolder());
}

/// A path to type or to choose.
QLineEdit *BatchPlanDialog::addPath(QFormLayout &form, const QString &name, const QString &label,
    const QString &hint, const std::function<QString()> &ask)
{
    auto *edit = new QLineEdit(this);
    edit->setObjectName(name);
    edit->setPlaceholderText(hint);
    auto *choose = new QPushButton(tr("Choose..."), this);
    choose->setObjectName(name + "Choose");
    choose->setAccessibleName(tr("Choose: %1").arg(QString(label).remove(QLatin1Char('&'))));
    connect(choose, &QPushButton::clicked, edit, [edit, ask] {
        if (const QString path = ask(); !path.isEmpty())
            edit->setText(path);
    });
    connect(edit, &QLineEdit::textChanged, this, &BatchPlanDialog::showReadiness);
    auto *row = new QHBoxLayout;
    row->addWidget(edit, 1);
    row->addWidget(choose);
    form.addRow(label, row);
    auto *text = qobject_cast<QLabel *>(form.labelForField(row));
    text->setBuddy(edit);
    return edit;
}

void BatchPlanDialog::showReadiness()
{
    m_accept->setEnabled(!m_root->text().isEmpty() && !m_plan->text().isEmpty());
}

BatchRequest BatchPlanDialog::request() const
{
    return {m_root->text().toStdString(), m_recipe->text().toStdString(),
        m_profile->text().toStdString(), m_eachFile->isChecked(), m_plan->text().toStdString()};
}

} // namespace dyncal
