// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/built_in_templates.h"
#include "core/project/certificate_template.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QTest>

#include <algorithm>
#include <random>

using namespace dyncal;
using Json = nlohmann::json;
using Names = std::vector<std::string>;

namespace {

/// The default as JSON, one key of it changed; null: taken out.
std::string with(const char *key, const Json &value)
{
    Json json = Json::parse(templateJson({}));
    json[key] = value;
    return json.dump();
}

std::string refusal(const std::string &json)
{
    const Result<CertificateTemplate> read = parseTemplate(json);
    return read ? std::string("(read)") : english(read.error().message);
}

bool isWithin(const Names &some, const Names &all)
{
    return std::ranges::all_of(
        some, [&](const std::string &one) { return std::ranges::find(all, one) != all.end(); });
}

Names without(Names names, const std::string &name)
{
    std::erase(names, name);
    return names;
}

} // namespace

/// The files of templates: the built-in ones, and what is refused.
class TestTemplateFile : public QObject
{
    Q_OBJECT

private slots:
    void builtIn_allAreRead_andHaveWhatIsRequired();
    void builtIn_first_isTheDefault();
    void written_isReadAgain();
    void minimum_isTheDefault();
    void requiredSection_leftOut_isRefusedByName();
    void requiredQuantity_leftOut_isRefusedByName();
    void anyChoice_isReadOnlyWithAllThatIsRequired();
    void keyResults_standOnTheFirstPage();
    void faults_areSaid_data();
    void faults_areSaid();
    void logo_isAFileBeside_data();
    void logo_isAFileBeside();
    void damaged_neverCrashes();
};

void TestTemplateFile::builtIn_allAreRead_andHaveWhatIsRequired()
{
    QCOMPARE(builtInTemplates().size(), std::size_t(4));
    for (const BuiltInTemplate &known : builtInTemplates()) {
        const Result<CertificateTemplate> layout = parseTemplate(known.json);
        QVERIFY2(layout, (known.name + ": " + refusal(known.json)).c_str());
        QVERIFY2(isWithin(requiredSections(), layout->sections), known.name.c_str());
        for (const std::string &quantity : requiredQuantities())
            QVERIFY2(layout->states(quantity), known.name.c_str());
    }
}

void TestTemplateFile::builtIn_first_isTheDefault()
{
    QCOMPARE(builtInTemplates().front().name, std::string("accredited"));
    const Result<CertificateTemplate> layout = parseTemplate(builtInTemplates().front().json);
    QVERIFY(layout && *layout == CertificateTemplate());
}

void TestTemplateFile::written_isReadAgain()
{
    CertificateTemplate layout;
    layout.title = {{"en", "Certificate"}, {"sv", "Bevis"}};
    layout.sections = without(layout.sections, "shots");
    layout.figures = {"phase", "bic"};
    layout.quantities = Names{"sensitivity", "f0_hz", "damping_ratio"};
    layout.languages = Names{"sv", "en"};
    layout.logo = "logo.svg";
    const Result<CertificateTemplate> again = parseTemplate(templateJson(layout));
    QVERIFY(again && *again == layout);
}

void TestTemplateFile::minimum_isTheDefault()
{
    const Result<CertificateTemplate> layout = parseTemplate(R"({"schema": "dyncal-template/1"})");
    QVERIFY(layout && *layout == CertificateTemplate());
}

void TestTemplateFile::requiredSection_leftOut_isRefusedByName()
{
    for (const std::string &section : requiredSections()) {
        const std::string said
            = refusal(with("sections", without(CertificateTemplate().sections, section)));
        QVERIFY2(said.find("leaves out \"" + section + "\"") != said.npos, said.c_str());
        QVERIFY2(said.find("17025") != said.npos, said.c_str());
    }
}

void TestTemplateFile::requiredQuantity_leftOut_isRefusedByName()
{
    for (const std::string &quantity : requiredQuantities()) {
        const std::string said
            = refusal(with("quantities", without(templateQuantities(), quantity)));
        QVERIFY2(said.find("leaves out \"" + quantity + "\"") != said.npos, said.c_str());
    }
}

/// Whatever sections a laboratory chooses, in whatever order: what is read has all that is required
/// and begins with the key results; what has both is read.
void TestTemplateFile::anyChoice_isReadOnlyWithAllThatIsRequired()
{
    std::mt19937 random(17);
    int read = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        Names names = templateSections();
        std::shuffle(names.begin() + (trial % 4), names.end(), random);
        names.resize(names.size() - random() % 4);
        const auto key = std::ranges::find(names, "key-results");
        const bool isFirst = std::all_of(names.begin(), key,
            [](const std::string &name) { return name == "administrative" || name == "item"; });
        const bool hasAll = isWithin(requiredSections(), names);
        Json json = Json::parse(with("sections", names));
        json["figures"] = Json::array();
        const bool isRead = parseTemplate(json.dump()).has_value();
        QCOMPARE(isRead, hasAll && isFirst);
        read += isRead ? 1 : 0;
    }
    QVERIFY(read > 20);
}

void TestTemplateFile::keyResults_standOnTheFirstPage()
{
    Names late = CertificateTemplate().sections;
    std::swap(late[2], late[3]); // behind the method
    const std::string said = refusal(with("sections", late));
    QVERIFY2(said.find("\"method\" before \"key-results\"") != said.npos, said.c_str());
    Names first = CertificateTemplate().sections;
    std::rotate(first.begin(), first.begin() + 2, first.begin() + 3);
    QVERIFY(parseTemplate(with("sections", first)));
}

void TestTemplateFile::faults_areSaid_data()
{
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("said");
    const auto row = [](const char *name, const std::string &json, const char *said) {
        QTest::newRow(name) << QString::fromStdString(json) << QString(said);
    };
    row("no JSON", "{\"schema\": }", "The template is not valid JSON: line 1, column 12");
    row("empty", "", "The template is not valid JSON");
    row("a list", "[]", "Template key (the whole) is []; it needs an object.");
    row("no schema", "{}", "it needs the key \"schema\"");
    row("other schema", R"({"schema": "dyncal-recipe/1"})",
        "Template key schema is \"dyncal-recipe/1\"; it needs \"dyncal-template/1\".");
    row("key twice", R"({"schema": "dyncal-template/1", "logo": null, "logo": null})",
        "holds the key \"logo\" twice");
    row("unknown key", with("section", Json::array()),
        "Template key section is unknown; the nearest known key is sections.");
    row("unknown section", with("sections", {"administrative", "items"}),
        "Template key sections[1] is \"items\"; it needs one of \"administrative\", \"item\"");
    row("unknown figure", with("figures", {"magnitudes"}), "Template key figures[0]");
    row("unknown quantity", with("quantities", {"mass"}), "Template key quantities[0]");
    row("no quantities", with("quantities", Json::array()), "a list that is not empty");
    row("section twice",
        with("sections",
            [] {
                Names twice = templateSections();
                twice.push_back("shots");
                return twice;
            }()),
        "Template key sections names \"shots\" twice");
    row("figure twice", with("figures", {"phase", "phase"}),
        "Template key figures names \"phase\" twice");
    row("language twice", with("languages", {"sv", "sv"}),
        "Template key languages names \"sv\" twice");
    row("unknown language", with("languages", {"fr"}), "it needs one of \"en\", \"sv\", \"de\".");
    row("three languages", with("languages", {"en", "sv", "de"}),
        "a list of one language, or of two that stand side by side");
    row("figures without place",
        with("sections", without(CertificateTemplate().sections, "figures")),
        "Template key figures names 9, and sections has no \"figures\"");
    row("title is empty", with("title", {{"en", "  "}}), "Template key title.en is \"  \"");
    row("title in lines", with("title", {{"en", "a\nb"}}), "without line breaks");
    row("title too long", with("title", {{"sv", std::string(121, 'x')}}), "1 to 120 bytes");
    row("title of other language", with("title", {{"fr", "x"}}),
        "Template key title.fr is unknown");
    row("title is a text", with("title", "x"), "it needs an object from a language");
}

void TestTemplateFile::faults_areSaid()
{
    QFETCH(QString, json);
    QFETCH(QString, said);
    const std::string found = refusal(json.toStdString());
    QVERIFY2(QString::fromStdString(found).contains(said), found.c_str());
}

void TestTemplateFile::logo_isAFileBeside_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isTaken");
    QTest::newRow("svg") << "logo.svg" << true;
    QTest::newRow("png with blanks") << "our logo 2.png" << true;
    QTest::newRow("no picture") << "logo.pdf" << false;
    QTest::newRow("no name") << ".png" << false;
    QTest::newRow("empty") << "" << false;
    QTest::newRow("elsewhere") << "../logo.svg" << false;
    QTest::newRow("absolute") << "/etc/logo.svg" << false;
    QTest::newRow("backslash") << "a\\logo.svg" << false;
    QTest::newRow("too long") << QString(130, 'x') + ".svg" << false;
}

void TestTemplateFile::logo_isAFileBeside()
{
    QFETCH(QString, name);
    QFETCH(bool, isTaken);
    QCOMPARE(parseTemplate(with("logo", name.toStdString())).has_value(), isTaken);
}

void TestTemplateFile::damaged_neverCrashes()
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 3000; ++trial) {
        std::string json = builtInTemplates()[random() % 4].json;
        for (unsigned change = 0; change < 1 + random() % 3; ++change)
            json[random() % json.size()] = static_cast<char>(random() % 256);
        if (const auto read = parseTemplate(json))
            QVERIFY(isWithin(requiredSections(), read->sections));
        else
            QVERIFY(!english(read.error().message).empty());
    }
}

DYNCAL_TEST(TestTemplateFile)
#include "tst_template_file.moc"
