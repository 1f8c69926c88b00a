// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/certificate_template.h"

#include "core/base/json_text.h"
#include "core/project/document_languages.h"
#include "core/project/json_codec.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace dyncal {
namespace {

using Names = std::vector<std::string>;

constexpr const char *kTemplateSchema = "dyncal-template/1";
constexpr std::size_t kLongestTitle = 120; ///< bytes; one line of the first page, two at most
constexpr const char *kFigures = "figures";
constexpr const char *kKeyResults = "key-results";

bool hasName(const Names &names, std::string_view name)
{
    return std::ranges::find(names, name) != names.end();
}

/// The schema is checked and written, but not part of the template.
Field<CertificateTemplate> templateSchema()
{
    const Codec<std::string> codec = oneOf({kTemplateSchema});
    return {"schema", "",
        [codec](const JsonAt &at, CertificateTemplate &) -> Result<void> {
            return codec.read(at).map([](const std::string &) {});
        },
        [](const CertificateTemplate &) { return Json(kTemplateSchema); }, {}, true};
}

Codec<std::string> titleText()
{
    const std::string needs
        = "a text of 1 to " + std::to_string(kLongestTitle) + " bytes without line breaks";
    const auto read = [needs](const JsonAt &at) -> Result<std::string> {
        const std::string text = at.value.is_string() ? at.value.get<std::string>() : "";
        if (text.find_first_not_of(" \t") == text.npos || text.size() > kLongestTitle
            || text.find_first_of("\r\n") != text.npos)
            return mismatch(at, needs);
        return text;
    };
    return {needs, read, [](const std::string &text) { return Json(text); }};
}

/// The languages that a title may be in.
std::vector<RecipeKey> languageKeys()
{
    std::vector<RecipeKey> keys;
    for (const std::string &code : documentLanguageCodes())
        keys.push_back({code, ""});
    return keys;
}

/// The logo lies beside the template, so that both are moved and kept together.
bool isImageName(std::string_view name)
{
    constexpr std::size_t kLongestName = 120;
    const bool isImage = name.ends_with(".png") || name.ends_with(".svg");
    return isImage && name.size() > 4 && name.size() <= kLongestName
        && name.find_first_of(std::string_view("/\\\0", 3)) == name.npos;
}

const Codec<CertificateTemplate> &templateCodec()
{
    using S = CertificateTemplate;
    static const Codec<S> codec = object<S>({
        templateSchema(),
        field("title", &S::title, dictionary(titleText(), "a language", languageKeys())),
        field("sections", &S::sections, list(oneOf(templateSections()), 1)),
        field(kFigures, &S::figures, list(oneOf(templateFigures()))),
        field("quantities", &S::quantities, orNull(list(oneOf(templateQuantities()), 1))),
        field("languages", &S::languages, orNull(documentLanguageList())),
        field("logo", &S::logo,
            formedTextOrNull(
                "the name of a file beside the template that ends in .png or .svg, or null",
                isImageName)),
    });
    return codec;
}

const Names &templateKeys()
{
    static const Names paths = [] {
        Names found;
        for (const RecipeKey &key : templateCodec().keys)
            found.push_back(key.path.substr(1)); // without the leading dot
        return found;
    }();
    return paths;
}

/// The codecs speak of keys of a recipe.
Error ofTemplate(Error error)
{
    constexpr std::array<std::pair<std::string_view, const char *>, 2> kSentences{{
        {"Recipe key %1 is %2; it needs %3.",
            DYNCAL_TEXT("core", "Template key %1 is %2; it needs %3.")},
        {"Recipe key %1 is unknown; the nearest known key is %2.",
            DYNCAL_TEXT("core", "Template key %1 is unknown; the nearest known key is %2.")},
    }};
    for (const auto &[ofRecipe, sentence] : kSentences)
        if (error.message.text == ofRecipe)
            error.message.text = sentence;
    return error;
}

tl::unexpected<Error> refused(Message message)
{
    return fail(ErrorKind::Usage, std::move(message));
}

Result<void> checkNamedOnce(const char *key, const Names &names)
{
    std::set<std::string> seen;
    for (const std::string &name : names)
        if (!seen.insert(name).second)
            return refused(
                {DYNCAL_TEXT("core",
                     "Template key %1 names \"%2\" twice; name it once, where it is to stand."),
                    {key, name}});
    return {};
}

Result<void> checkRequired(const CertificateTemplate &layout)
{
    for (const std::string &section : requiredSections())
        if (!hasName(layout.sections, section))
            return refused(
                {DYNCAL_TEXT("core",
                     "Template key sections leaves out \"%1\", which every calibration certificate must have (ISO/IEC 17025, 7.8.2 and 7.8.4); add it."),
                    {section}});
    for (const std::string &quantity : requiredQuantities())
        if (!layout.states(quantity))
            return refused(
                {DYNCAL_TEXT("core",
                     "Template key quantities leaves out \"%1\", which every certificate states where it is determined; add it."),
                    {quantity}});
    return {};
}

/// The first page begins with laboratory and item, and goes on with the key results at the latest.
Result<void> checkFirstPage(const CertificateTemplate &layout)
{
    for (const std::string &section : layout.sections) {
        if (section == kKeyResults)
            break;
        if (section != "administrative" && section != "item")
            return refused(
                {DYNCAL_TEXT("core",
                     "Template key sections has \"%1\" before \"key-results\", which belong on the first page; put \"key-results\" before it, with at most \"administrative\" and \"item\" above."),
                    {section}});
    }
    return {};
}

Result<void> checkFigures(const CertificateTemplate &layout)
{
    if (layout.figures.empty() || hasName(layout.sections, kFigures))
        return {};
    return refused(
        {DYNCAL_TEXT("core",
             "Template key figures names %1, and sections has no \"figures\" where they could stand; add that section, or name no figures ([])."),
            {std::to_string(layout.figures.size())}});
}

Result<void> checkWhole(const CertificateTemplate &layout)
{
    const Names none;
    for (const Result<void> &checked :
        {checkNamedOnce("sections", layout.sections), checkNamedOnce(kFigures, layout.figures),
            checkNamedOnce("quantities", layout.quantities.value_or(none)),
            checkNamedOnce("languages", layout.languages.value_or(none)), checkRequired(layout),
            checkFirstPage(layout), checkFigures(layout)})
        if (!checked)
            return checked;
    return {};
}

} // namespace

bool CertificateTemplate::states(const std::string &quantity) const
{
    return !quantities || hasName(*quantities, quantity);
}

const Names &templateSections()
{
    static const Names names = [] {
        Names all = CertificateTemplate().sections;
        for (const char *wanted : {kHistorySection, kSignatureSection}) // only by a laboratory
            all.emplace_back(wanted);
        return all;
    }();
    return names;
}

const Names &requiredSections()
{
    static const Names names{"administrative", "item", kKeyResults, "method", "conditions",
        "results", "frequency-response", "remarks", "statements"};
    return names;
}

const Names &templateFigures()
{
    static const Names names{"raw-dut", "raw-driven-side", "raw-driver", "responses",
        "responses-start", "spectrum", "explained", "reconstruction", "residuals",
        "residual-autocovariance", "residual-spectrum", "average", "model-input", "singular-values",
        "bic", "model-data", "model-error", "pole-zero", "step", "magnitude", "phase",
        "comparison"};
    return names;
}

const Names &templateQuantities()
{
    static const Names names{"sensitivity", "f0_hz", "damping_ratio", "q", "resonance_hz",
        "resonance_gain", "magnitude_at_resonance", "within_5_percent_hz", "within_10_percent_hz",
        "minus_3_db_hz", "rise_time_s", "overshoot_percent", "settling_time_s"};
    return names;
}

const Names &requiredQuantities()
{
    static const Names names{"sensitivity", "f0_hz", "damping_ratio"};
    return names;
}

Result<CertificateTemplate> parseTemplate(const std::string &json)
{
    const Result<Json> document = parseStrictJson(json, "The template");
    if (!document)
        return tl::unexpected<Error>(document.error());
    Result<CertificateTemplate> layout = templateCodec().read({*document, "", templateKeys()});
    if (!layout)
        return tl::unexpected<Error>(ofTemplate(layout.error()));
    if (const Result<void> checked = checkWhole(*layout); !checked)
        return tl::unexpected<Error>(checked.error());
    return layout;
}

std::string templateJson(const CertificateTemplate &layout)
{
    return jsonText(templateCodec().write(layout));
}

} // namespace dyncal
