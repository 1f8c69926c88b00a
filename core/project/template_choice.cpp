// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/template_choice.h"

#include "core/base/content_hash.h"
#include "core/project/built_in_templates.h"
#include "core/project/template_logo.h"
#include "core/reference/reference_source.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestTemplate = std::size_t(256) << 10U;
constexpr std::size_t kLargestLogo = std::size_t(1) << 20U;

std::string builtInNames()
{
    std::string names;
    for (const BuiltInTemplate &known : builtInTemplates())
        names += (names.empty() ? "" : ", ") + known.name;
    return names;
}

Result<ChosenTemplate> builtIn(const std::string &name)
{
    const std::vector<BuiltInTemplate> &known = builtInTemplates();
    const auto found = std::ranges::find(known, name, &BuiltInTemplate::name);
    if (found != known.end())
        return parseTemplate(found->json).map([](CertificateTemplate layout) {
            return ChosenTemplate{std::move(layout), {}, {}};
        });
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "There is no template \"%1\" (certificate.template); it needs one of %2, or a file that ends in .json."),
            {name, builtInNames()}});
}

Result<std::string> contentOf(const std::string &path, std::size_t most)
{
    const auto source = sourceAt({}, path);
    if (source && source->content.size() <= most)
        return source->content;
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The file %1 of the certificate's template cannot be read, or is larger than %2 KiB; put it there, or choose another template."),
            {path, std::to_string(most >> 10U)}});
}

/// A sentence about the content of a file begins with the file's name.
Error inFile(const std::string &path, Error error)
{
    error.message = {DYNCAL_TEXT("core", "%1: %M1"), {path}, {error.message}};
    return error;
}

Result<ChosenTemplate> fromFile(const std::string &path)
{
    const Result<std::string> text = contentOf(path, kLargestTemplate);
    if (!text)
        return tl::unexpected<Error>(text.error());
    Result<CertificateTemplate> layout = parseTemplate(*text);
    if (!layout)
        return tl::unexpected<Error>(inFile(path, layout.error()));
    ChosenTemplate chosen{std::move(*layout), path, {}};
    if (chosen.layout.logo.empty())
        return chosen;
    const std::string place = (fs::path(path).parent_path() / chosen.layout.logo).string();
    Result<std::string> logo = contentOf(place, kLargestLogo);
    if (!logo)
        return tl::unexpected<Error>(logo.error());
    if (const Result<void> checked = checkLogo(chosen.layout.logo, *logo); !checked)
        return tl::unexpected<Error>(inFile(path, checked.error()));
    chosen.logo = std::move(*logo);
    return chosen;
}

/// The name of a copy of these bytes; a copy of a copy has the same name.
std::string keptName(const std::string &path, const std::string &bytes)
{
    const std::string hash = sha256Hex(std::string_view(bytes));
    const std::string kept = keptSourceName({}, hash); // "sources/HASH-"
    const std::string prefix = fs::path(kept).filename().string();
    const std::string name = fs::path(path).filename().string();
    return kept + (name.starts_with(prefix) ? name.substr(prefix.size()) : name);
}

/// The copy of the template itself.
std::pair<std::string, std::string> keptTemplate(const ChosenTemplate &chosen)
{
    CertificateTemplate layout = chosen.layout;
    if (!layout.logo.empty())
        layout.logo = fs::path(keptName(layout.logo, chosen.logo)).filename().string();
    std::string json = templateJson(layout);
    return {keptName(chosen.file, json), std::move(json)};
}

} // namespace

bool isTemplateFile(const std::string &name)
{
    return name.ends_with(".json");
}

void locateTemplate(const std::string &recipePath, Recipe &recipe)
{
    std::string &name = recipe.certificate.templateName;
    if (isTemplateFile(name))
        name = (fs::path(recipePath).parent_path() / name).string();
}

Result<ChosenTemplate> chooseTemplate(const std::string &name)
{
    return isTemplateFile(name) ? fromFile(name) : builtIn(name);
}

const std::vector<std::string> &documentLanguages(
    const ChosenTemplate &chosen, const Recipe &recipe)
{
    return chosen.layout.languages ? *chosen.layout.languages : recipe.certificate.languages;
}

std::map<std::string, std::string> keptTemplateFiles(const ChosenTemplate &chosen)
{
    std::map<std::string, std::string> files;
    if (chosen.file.empty())
        return files;
    files.insert(keptTemplate(chosen));
    if (!chosen.layout.logo.empty())
        files[keptName(chosen.layout.logo, chosen.logo)] = chosen.logo;
    return files;
}

Recipe withKeptTemplate(Recipe recipe, const ChosenTemplate &chosen)
{
    if (!chosen.file.empty())
        recipe.certificate.templateName = keptTemplate(chosen).first;
    return recipe;
}

} // namespace dyncal
