// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/comparison/source_panel.h"

#include "core/reference/certified_source.h"
#include "core/reference/chain_response.h"
#include "core/reference/reference_source.h"
#include "ui/stages/comparison/comparison_words.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace dyncal {

namespace {

/// The section names this file from now on, and it is read; "" = it names none.
template <typename Settings>
void takeSource(Settings &section, const std::string &path)
{
    section.source = path;
    section.sha256.clear();
    section.quantityId.clear();
    loadSource({}, section);
}

template <typename Settings>
std::string contentOf(const Settings &section)
{
    return section.loaded ? section.loaded->content : std::string();
}

Result<CertifiedReference> readReference(const Recipe &recipe)
{
    const ComparisonSettings &s = recipe.comparison;
    return readCertifiedSource({"comparison", s.source, s.sha256, s.quantityId, s.unit, s.loaded});
}

Result<CertifiedReference> readChain(const Recipe &recipe)
{
    Result<std::optional<ChainResponse>> chain = chainResponse(recipe.chain);
    if (!chain)
        return tl::unexpected(chain.error());
    return CertifiedReference{std::move((*chain)->relative), std::move((*chain)->certificate)};
}

void takeReference(Recipe &recipe, const std::string &path)
{
    takeSource(recipe.comparison, path);
    if (!path.empty())
        recipe.comparison.model.reset();
    else if (!recipe.comparison.model)
        dropReference(recipe);
}

/// Of a certificate, its lists that have frequencies; of a table none.
std::vector<std::string> listsIn(const std::string &content)
{
    return content.empty() ? std::vector<std::string>() : listsOverFrequency(content);
}

} // namespace

void useModel(Recipe &recipe, const ReferenceModel &model)
{
    takeSource(recipe.comparison, {});
    recipe.comparison.model = model;
}

void dropReference(Recipe &recipe)
{
    takeSource(recipe.comparison, {});
    recipe.comparison.model.reset();
    recipe.comparison.enabled = false;
    if (recipe.response.isByTransducer())
        recipe.response.reference = ResponseSettings().reference;
}

SourceSection referenceSection()
{
    return {"reference", [](const Recipe &r) { return r.comparison.source; },
        [](const Recipe &r) { return r.comparison.quantityId; },
        [](const Recipe &r) { return contentOf(r.comparison); }, readReference, takeReference,
        [](Recipe &r, const std::string &id) { r.comparison.quantityId = id; },
        [](const Recipe &r) { return r.comparison.unit; },
        [](Recipe &r) -> std::string & { return r.comparison.certificate; }};
}

SourceSection chainSection()
{
    return {"chain", [](const Recipe &r) { return r.chain.source; },
        [](const Recipe &r) { return r.chain.quantityId; },
        [](const Recipe &r) { return contentOf(r.chain); }, readChain,
        [](Recipe &r, const std::string &path) { takeSource(r.chain, path); },
        [](Recipe &r, const std::string &id) { r.chain.quantityId = id; },
        [](const Recipe &) { return std::string("1"); },
        [](Recipe &r) -> std::string & { return r.chain.certificate; }};
}

SourcePanel::SourcePanel(Session &session, Prompts &prompts, InspectorForm &form,
    const SourceSection &section, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_prompts(prompts)
    , m_section(section)
{
    build(form);
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
    connect(m_browse, &QPushButton::clicked, this, &SourcePanel::browse);
    connect(m_remove, &QPushButton::clicked, this, [this] { take({}); });
    connect(m_list, &QComboBox::activated, this, &SourcePanel::chooseList);
    connect(m_number, &QLineEdit::editingFinished, this, &SourcePanel::setNumber);
}

void SourcePanel::build(InspectorForm &form)
{
    const auto button = [&](const QString &text, const char *what) {
        auto *made = new WrappedButton(text);
        made->setObjectName(m_section.name + what);
        form.addWide(made);
        return made;
    };
    m_file = form.addReadout(tr("File"), m_section.name + "File");
    m_browse = button(tr("Choose a file..."), "Browse");
    m_remove = button(tr("Use no file"), "Remove");
    m_list = form.addChoice(tr("List in the certificate"), m_section.name + "List", {});
    m_number = form.add(tr("Certificate number"), m_section.name + "Certificate", new QLineEdit);
    m_stated = form.addNote(m_section.name + "Stated");
}

void SourcePanel::browse()
{
    const std::string now = m_section.path(m_session.recipe());
    const auto &inputs = m_session.state().captures->inputs;
    const QString beside = !now.empty() ? rawText(now)
        : inputs.empty()                ? QString()
                                        : rawText(inputs.front().path);
    const QString path = m_prompts.openFile(m_browse, tr("Response over frequency"),
        tr("Tables and certificates (*.csv *.txt *.xml);;All files (*)"), QFileInfo(beside).path());
    if (!path.isEmpty())
        take(QFileInfo(path).absoluteFilePath());
}

/// A certificate with several lists is taken where one of them will do: which, is then chosen.
QString SourcePanel::faultOf(const Recipe &recipe) const
{
    const Result<CertifiedReference> read = m_section.read(recipe);
    if (read)
        return {};
    const std::vector<std::string> lists = listsIn(m_section.content(recipe));
    const bool isOneGood = std::ranges::any_of(lists, [&](const std::string &id) {
        Recipe with = recipe;
        m_section.choose(with, id);
        return lists.size() > 1 && m_section.read(with).has_value();
    });
    return isOneGood ? QString() : translated(read.error().message);
}

void SourcePanel::take(const QString &path)
{
    Recipe next = m_session.recipe();
    m_section.take(next, path.toStdString());
    const QString fault = path.isEmpty() ? QString() : faultOf(next);
    showRefusal(m_browse, fault);
    if (!fault.isEmpty())
        return;
    m_session.apply(
        next, path.isEmpty() ? tr("Use no file") : tr("Choose %1").arg(QFileInfo(path).fileName()));
}

void SourcePanel::chooseList()
{
    const std::string id = m_list->currentData().toString().toStdString();
    changeRecipe(m_session, tr("Choose the list in the certificate"),
        [&](Recipe &r) { m_section.choose(r, id); });
}

void SourcePanel::setNumber()
{
    if (!m_number->isModified())
        return;
    m_number->setModified(false);
    const std::string number = m_number->text().trimmed().toStdString();
    changeRecipe(m_session, tr("Change the number of the certificate"),
        [&](Recipe &r) { m_section.certificate(r) = number; });
}

void SourcePanel::showRecipe(const Recipe &recipe)
{
    Recipe copy = recipe;
    if (!m_number->isModified())
        m_number->setText(rawText(m_section.certificate(copy)));
    const std::string path = m_section.path(recipe);
    const std::string content = m_section.content(recipe);
    m_file->setText(path.empty() ? tr("none") : shownText(QFileInfo(rawText(path)).fileName()));
    m_file->setToolTip(shownText(path));
    m_remove->setEnabled(!path.empty());
    const std::string shown = path + '\n' + std::to_string(std::hash<std::string>()(content)) + '\n'
        + m_section.list(recipe) + '\n' + m_section.unit(recipe);
    if (shown == std::exchange(m_shown, shown))
        return; // a certificate is not read again at every change of the recipe
    showLists(recipe);
    m_stated->setText(path.empty() ? QString() : stated(recipe));
}

void SourcePanel::showLists(const Recipe &recipe)
{
    const QSignalBlocker quiet(m_list);
    const std::vector<std::string> lists = listsIn(m_section.content(recipe));
    const std::string chosen = m_section.list(recipe);
    m_list->clear();
    m_list->addItem(lists.size() > 1 ? tr("to be chosen") : tr("the only one"), QString());
    for (const std::string &id : lists)
        if (!id.empty())
            m_list->addItem(withoutMnemonic(shownText(id)), rawText(id));
    if (m_list->findData(rawText(chosen)) < 0)
        m_list->addItem(withoutMnemonic(shownText(chosen)), rawText(chosen));
    m_list->setCurrentIndex(m_list->findData(rawText(chosen)));
    m_list->setEnabled(!lists.empty());
}

QString SourcePanel::stated(const Recipe &recipe) const
{
    const Result<CertifiedReference> read = m_section.read(recipe);
    return read ? sourceSentence(*read, m_section.unit(recipe))
                : QStringLiteral("■ ") + translated(read.error().message);
}

} // namespace dyncal
