// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/template_panel.h"

#include "core/project/document_languages.h"
#include "ui/report/report_logo.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <map>

namespace dyncal {

namespace {

using Languages = std::vector<std::string>;

/// In the order of the choice.
const std::vector<Languages> &languageChoices()
{
    static const std::vector<Languages> choices = [] {
        std::vector<Languages> made;
        for (const std::string &code : documentLanguageCodes())
            made.push_back({code});
        for (const std::string &first : documentLanguageCodes())
            for (const std::string &second : documentLanguageCodes())
                if (first != second)
                    made.push_back({first, second});
        return made;
    }();
    return choices;
}

/// Languages by their own names.
QStringList languageNames()
{
    static const std::map<std::string, QString> names{{"en", QStringLiteral("English")},
        {"sv", QStringLiteral("Svenska")}, {"de", QStringLiteral("Deutsch")}};
    QStringList shown;
    for (const Languages &choice : languageChoices()) {
        QStringList words;
        for (const std::string &code : choice)
            words << names.at(code);
        shown << words.join(QStringLiteral(" / "));
    }
    return shown;
}

struct BuiltInWords
{
    const char *name;
    const char *label;
    const char *note; ///< what it shows
};

constexpr std::array<BuiltInWords, 4> kBuiltIn{{
    {"accredited", QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "Standard"),
        QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "The certificate of an accredited laboratory.")},
    {"full", QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "Full"),
        QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "With all figures of the method.")},
    {"short", QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "Short"),
        QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "Without shots, model and figures.")},
    {"research", QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "Research"),
        QT_TRANSLATE_NOOP("dyncal::TemplatePanel", "With every figure there is.")},
}};

/// What is wrong with a template, or what a built-in one shows.
QString noteOf(const std::string &name, const Result<ChosenTemplate> &chosen)
{
    if (!chosen)
        return QStringLiteral("■ ") + translated(chosen.error().message);
    const auto known = std::ranges::find(kBuiltIn, name, &BuiltInWords::name);
    return known == kBuiltIn.end() ? QString() : TemplatePanel::tr(known->note);
}

} // namespace

TemplatePanel::TemplatePanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    build(form);
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
    connect(m_template, &QComboBox::activated, this, &TemplatePanel::chooseTemplateAt);
    connect(m_languages, &QComboBox::activated, this, &TemplatePanel::chooseLanguages);
}

void TemplatePanel::build(InspectorForm &form)
{
    m_template = form.addChoice(tr("Template"), "certificateTemplate", {});
    auto *browse = new WrappedButton(tr("Choose a template's file..."));
    browse->setObjectName("templateBrowse");
    form.addWide(browse);
    m_browse = browse;
    connect(browse, &QPushButton::clicked, this, &TemplatePanel::browseRequested);
    m_note = form.addNote("templateNote");
    m_languages = form.addChoice(tr("Language"), "certificateLanguage", languageNames());
}

void TemplatePanel::chooseTemplateAt(int choice)
{
    const std::string name = m_template->itemData(choice).toString().toStdString();
    changeRecipe(m_session, tr("Change the certificate's template"),
        [&](Recipe &r) { r.certificate.templateName = name; });
}

void TemplatePanel::chooseLanguages(int choice)
{
    changeRecipe(m_session, tr("Change the certificate's language"), [&](Recipe &r) {
        r.certificate.languages = languageChoices().at(static_cast<std::size_t>(choice));
    });
}

void TemplatePanel::take(const QString &path)
{
    const std::string name = QFileInfo(path).absoluteFilePath().toStdString();
    const Result<ChosenTemplate> chosen = drawableTemplate(name);
    showRefusal(m_browse, chosen ? QString() : translated(chosen.error().message));
    if (chosen)
        changeRecipe(m_session, tr("Choose %1").arg(QFileInfo(path).fileName()),
            [&](Recipe &r) { r.certificate.templateName = name; });
}

void TemplatePanel::showRecipe(const Recipe &recipe)
{
    showTemplate(recipe.certificate.templateName);
    showLanguages(recipe);
}

/// The built-in ones, and what the recipe names if it is none of them.
void TemplatePanel::showTemplate(const std::string &name)
{
    const QSignalBlocker quiet(m_template);
    m_template->clear();
    for (const BuiltInWords &known : kBuiltIn)
        m_template->addItem(tr(known.label), QString::fromLatin1(known.name));
    if (m_template->findData(rawText(name)) < 0)
        m_template->addItem(
            withoutMnemonic(shownText(QFileInfo(rawText(name)).fileName())), rawText(name));
    m_template->setCurrentIndex(m_template->findData(rawText(name)));
}

void TemplatePanel::showLanguages(const Recipe &recipe)
{
    const Result<ChosenTemplate> chosen = drawableTemplate(recipe.certificate.templateName);
    m_note->setText(noteOf(recipe.certificate.templateName, chosen));
    const bool isOfTemplate = chosen && chosen->layout.languages;
    const Languages &shown
        = chosen ? documentLanguages(*chosen, recipe) : recipe.certificate.languages;
    const auto &choices = languageChoices();
    const auto found = std::ranges::find(choices, shown);
    m_languages->setCurrentIndex(
        found == choices.end() ? -1 : static_cast<int>(found - choices.begin()));
    m_languages->setEnabled(!isOfTemplate); // the template says it
}

} // namespace dyncal
