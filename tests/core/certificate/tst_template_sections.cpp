// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"
#include "core/certificate/certificate_figures.h"
#include "core/certificate/certificate_issue.h"
#include "tests/support/certificate_text.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace dyncal;
using Names = std::vector<std::string>;

namespace {

constexpr const char *kCreated = "2026-11-21T12:00:00Z";

Recipe exampleRecipe()
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    return recipe;
}

CertificateData certificateBy(const ChosenTemplate &chosen, const Recipe &recipe = exampleRecipe())
{
    return makeCertificate(example::calibration(), recipe, kCreated, chosen);
}

Names sectionsOf(const CertificateData &data)
{
    Names ids;
    for (const CertificateSection &section : data.sections)
        ids.push_back(section.id);
    return ids;
}

Names figuresOf(const CertificateData &data)
{
    Names ids;
    if (const CertificateSection *section = data.section("figures"))
        for (const CertificateFigure &figure : section->figures)
            ids.push_back(figure.id);
    return ids;
}

/// Taken by name: a section is a part of its certificate and ends with it.
std::size_t rowsOfKeyResults(const CertificateData &data)
{
    std::size_t count = 0;
    for (const CertificateTable &table : data.section("key-results")->tables)
        count += table.rows.size();
    return count;
}

/// Every word and number, in order.
std::string textOf(const CertificateData &data)
{
    std::string text = english(data.title) + data.language + data.secondLanguage + data.number;
    for (const CertificateSection &section : data.sections) {
        text += section.id + english(section.title);
        for (const Message &paragraph : section.paragraphs)
            text += english(paragraph) + '\n';
        for (const CertificateField &field : section.fields)
            text += english(field.label) + ": " + english(field.value) + '\n';
        for (const CertificateTable &table : section.tables)
            for (const std::vector<Message> &row : table.rows)
                for (const Message &cell : row)
                    text += english(cell) + '|';
        for (const Message &note : section.notes)
            text += english(note) + '\n';
        for (const CertificateFigure &figure : section.figures)
            text += figure.id + english(figure.caption) + '\n';
    }
    return text;
}

bool isWithin(const Names &some, const Names &all)
{
    return std::ranges::all_of(
        some, [&](const std::string &one) { return std::ranges::find(all, one) != all.end(); });
}

Recipe withDecision()
{
    Recipe recipe = exampleRecipe();
    recipe.certificate.decision
        = DecisionSettings{.within_percent = 5.0, .from_Hz = 1e3, .to_Hz = 1e5};
    return recipe;
}

} // namespace

/// What a template shows of a certificate.
class TestTemplateSections : public QObject
{
    Q_OBJECT

private slots:
    void accredited_isWhatIsPrintedWithoutAChoice()
    {
        const CertificateData plain
            = makeCertificate(example::calibration(), exampleRecipe(), kCreated);
        QCOMPARE(textOf(certificateBy(*chooseTemplate("accredited"))), textOf(plain));
        QCOMPARE(sectionsOf(plain),
            (Names{"administrative", "item", "key-results", "method", "conditions", "results",
                "shots", "model", "frequency-response", "remarks", "records", "statements",
                "figures"}));
        QCOMPARE(figuresOf(plain),
            (Names{"singular-values", "model-data", "model-error", "step", "magnitude", "phase",
                "spectrum", "pole-zero"})); // "step" shows the overshoot that is stated
        QVERIFY(plain.logo.bytes.empty() && plain.secondLanguage.empty());
    }
    void builtIn_haveWhatTheySay()
    {
        const CertificateData little = certificateBy(*chooseTemplate("short"));
        QCOMPARE(sectionsOf(little),
            (Names{"administrative", "item", "key-results", "method", "conditions", "results",
                "frequency-response", "remarks", "records", "statements"}));
        const CertificateData full = certificateBy(*chooseTemplate("full"));
        QVERIFY(isWithin({"raw-dut", "explained", "reconstruction", "residuals", "average",
                             "singular-values", "pole-zero", "magnitude", "phase"},
            figuresOf(full)));
        const CertificateData research = certificateBy(*chooseTemplate("research"));
        QVERIFY(isWithin(figuresOf(full), figuresOf(research)));
        QVERIFY(isWithin(
            {"bic", "step", "responses-start", "residual-autocovariance"}, figuresOf(research)));
        QCOMPARE(english(research.title), std::string("Certificate with research annex"));
        QCOMPARE(english(full.title), std::string("Certificate of dynamic calibration"));
    }
    void mapOfPoles_saysWhatItCannotShow()
    {
        CalibrationResults results = example::calibration();
        const auto caption = [&] {
            const CertificateData data = makeCertificate(results, exampleRecipe(), kCreated);
            return english(data.section("figures")->figures.back().caption);
        };
        SensorModel &model = testing::writable(results.model);
        model.zeros = {{0.5, 0.0}};
        const std::string counts = "Poles and zeros of the model in the z-plane; poles: "
            + std::to_string(model.poles.size()) + ", zeros: ";
        QCOMPARE(caption(), counts + "1");
        model.zeros.push_back({3.7, 0.0});
        QCOMPARE(caption(), counts + "2; further out than shown: 1");
    }
    /// A section says the same under every template, but for what is chosen in it.
    void sameSection_saysTheSame()
    {
        const CertificateData usual = certificateBy({});
        for (const char *name : {"full", "short", "research"}) {
            CertificateData other = certificateBy(*chooseTemplate(name));
            for (const CertificateSection &section : other.sections) {
                if (section.id == "key-results" || section.id == "figures")
                    continue;
                CertificateData one, same;
                one.sections = {section};
                same.sections = {*usual.section(section.id)};
                QVERIFY2(textOf(one) == textOf(same), section.id.c_str());
            }
        }
    }
    void quantities_areThoseChosen()
    {
        const CertificateData all = certificateBy({});
        ChosenTemplate chosen;
        chosen.layout.quantities = requiredQuantities();
        const CertificateData few = certificateBy(chosen);
        const auto key = [](const CertificateData &data, const char *label) {
            return testing::keyResult(data, label);
        };
        for (const char *label : {"Undamped natural frequency", "Damping ratio",
                 "Sensitivity at the onset of the step, mean of the shots"}) {
            QVERIFY2(key(all, label) != "no row", label);
            QCOMPARE(key(few, label), key(all, label));
        }
        for (const char *label : {"Magnitude within 5 % up to", "Overshoot"}) {
            QVERIFY2(key(all, label) != "no row", label);
            QCOMPARE(key(few, label), std::string("no row"));
        }
    }
    /// Each quantity of templateQuantities() names a row or none; together they are all rows.
    void quantities_nameEveryRow()
    {
        const auto rows = [](const Names &quantities) {
            ChosenTemplate chosen;
            chosen.layout.quantities = quantities;
            return rowsOfKeyResults(certificateBy(chosen));
        };
        std::size_t sum = 0;
        for (const std::string &quantity : templateQuantities())
            sum += rows({quantity});
        QCOMPARE(rows(templateQuantities()), sum);
        QCOMPARE(sum, rowsOfKeyResults(certificateBy({})));
    }
    void figures_haveCaptions_inTheOrderAskedFor()
    {
        CalibrationResults results = example::calibration();
        Names wanted = templateFigures();
        std::ranges::reverse(wanted);
        const CertificateSection section = figuresSection(results, exampleRecipe(), wanted);
        Names found;
        for (const CertificateFigure &figure : section.figures) {
            QVERIFY2(!english(figure.caption).empty(), figure.id.c_str());
            found.push_back(figure.id);
        }
        std::erase(wanted, "comparison"); // no reference transducer
        QCOMPARE(found, wanted);
        QVERIFY(figuresSection({}, {}, templateFigures()).figures.empty());
        QVERIFY(figuresSection(results, {}, {}).figures.empty());
    }
    void conformity_standsBehindTheKeyResultsOfEveryTemplate()
    {
        for (const char *name : {"accredited", "full", "short", "research"}) {
            const Names ids = sectionsOf(certificateBy(*chooseTemplate(name), withDecision()));
            const auto key = std::ranges::find(ids, "key-results");
            QVERIFY(key + 1 != ids.end());
            QCOMPARE(*(key + 1), std::string("conformity"));
        }
    }
    /// Whatever is left out and however it is ordered: what must be there is there, an issued one
    /// says so, and it asks for the same fields.
    void anyTemplate_hasAllThatIsRequired()
    {
        std::mt19937 random(5);
        const auto missing = makeCertificate({}, {}, kCreated).missingFields();
        int tried = 0;
        while (tried < 60) {
            ChosenTemplate chosen;
            Names &sections = chosen.layout.sections;
            std::shuffle(sections.begin() + 3, sections.end(), random);
            sections.resize(sections.size() - random() % 4);
            chosen.layout.figures.clear();
            if (!parseTemplate(templateJson(chosen.layout)))
                continue;
            ++tried;
            CertificateData data = certificateBy(chosen);
            QVERIFY(isWithin(requiredSections(), sectionsOf(data)));
            markIssued({"17", {}, {}, "head", "results"}, data);
            QVERIFY(data.section("issue"));
            QCOMPARE(
                makeCertificate({}, {}, kCreated, chosen).missingFields().size(), missing.size());
        }
    }
    void languages_titleAndLogo_areTheTemplates()
    {
        ChosenTemplate chosen;
        chosen.layout.title = {{"en", "Certificate of ours"}, {"sv", "Vårt bevis"}};
        chosen.layout.logo = "logo.svg";
        chosen.logo = "<svg/>";
        CertificateData data = certificateBy(chosen);
        QCOMPARE(english(data.title), std::string("Certificate of ours"));
        QVERIFY(data.logo.isSvg && data.logo.bytes == "<svg/>");
        chosen.layout.languages = Names{"sv", "en"};
        data = certificateBy(chosen);
        QCOMPARE(data.language, std::string("sv"));
        QCOMPARE(data.secondLanguage, std::string("en"));
        QCOMPARE(english(data.title), std::string("Vårt bevis / Certificate of ours"));
        chosen.layout.languages = Names{"sv"};
        chosen.layout.title.erase("sv"); // no title in Swedish: that of the calibration
        QCOMPARE(english(certificateBy(chosen).title),
            std::string("Certificate of dynamic calibration"));
    }
    void recipeInTwoLanguages_hasTheSecondBeside()
    {
        Recipe recipe = exampleRecipe();
        recipe.certificate.languages = {"en", "sv"};
        QCOMPARE(certificateBy({}, recipe).secondLanguage, std::string("sv"));
        recipe.certificate.languages = {"en", "en"};
        QCOMPARE(certificateBy({}, recipe).secondLanguage, std::string());
    }
};

DYNCAL_TEST(TestTemplateSections)
#include "tst_template_sections.moc"
