// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A laboratory's profile with name and version: what it may hold, how it joins a recipe, and what
// the recipe remembers of it.

#include "core/project/laboratory_profile.h"
#include "core/project/recipe.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using dyncal::testing::ScratchFolder;

namespace {

constexpr const char *kProfile = R"({"schema": "dyncal-profile/1", "name": "Tube 2",
    "version": "7", "shock": {"driven_length_m": 0.97}, "uncertainty": {
    "budget": [{"quantity": "t1_k", "u": 0.3, "certificate": "C 12", "due": "2027-01-31"},
               {"quantity": "gain_relative", "u": 0.001}],
    "cmc": [{"of": "sensitivity", "expanded": 0.02}]}})";

} // namespace

class TestLaboratoryProfile : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;

    std::string written(const char *name, const std::string &text) const
    {
        return m_folder.write(name, text.data(), text.size());
    }
    Result<Recipe> joined(const std::string &recipe, const std::string &profile) const
    {
        return readRecipeFiles(written("r.json", recipe), written("p.json", profile));
    }
    std::string faultOf(const std::string &profile) const
    {
        const auto read = joined("{}", profile);
        return read ? "" : english(read.error().message);
    }

private slots:
    void everyPart_reachesTheRecipe()
    {
        const Recipe recipe = joined("{}", kProfile).value();
        QCOMPARE(recipe.shock.drivenLength_m, std::optional(0.97));
        QCOMPARE(recipe.uncertainty.budget.size(), 2);
        QCOMPARE(recipe.uncertainty.budget[0].certificate, "C 12");
        QCOMPARE(recipe.uncertainty.budget[0].due, "2027-01-31");
        QCOMPARE(recipe.uncertainty.cmc.size(), 1);
        QCOMPARE(recipe.profile->name, "Tube 2");
        QCOMPARE(recipe.profile->version, "7");
        QCOMPARE(recipe.profile->sha256.size(), 64);
        QVERIFY(changedFromProfile(recipe).empty());
        QVERIFY(parseRecipe(recipeJson(recipe)).value() == recipe);
    }

    /// A recipe that says everything, as the program writes it, leaves the laboratory's lines.
    void linesOfTheBudget_joinByName()
    {
        const Recipe recipe = joined(R"({"uncertainty": {"budget": [
            {"quantity": "t1_k", "u": 0.5}, {"quantity": "p1_pa", "u": 9}]}})",
            kProfile)
                                  .value();
        QCOMPARE(recipe.uncertainty.budget.size(), 3);
        QCOMPARE(recipe.uncertainty.budget[0].quantity, "gain_relative");
        QCOMPARE(recipe.uncertainty.budget[1].u, 0.5);
        QVERIFY(recipe.uncertainty.budget[1].certificate.empty());
        const Recipe all = joined(recipeJson(Recipe()), kProfile).value();
        QCOMPARE(all.uncertainty.budget.size(), 2);
        QCOMPARE(all.uncertainty.cmc.size(), 1);
    }

    /// A pair is one, whichever of the two is written first.
    void correlations_joinByPair()
    {
        const std::string profile = R"({"schema": "dyncal-profile/1", "name": "Tube 2",
            "version": "8", "uncertainty": {"correlations": [
            {"quantity": "gain_relative", "with": "reference_gain_relative", "r": 0.9},
            {"quantity": "t1_k", "with": "p1_pa", "r": 0.2}]}})";
        const Recipe recipe = joined(R"({"uncertainty": {"correlations": [
            {"quantity": "p1_pa", "with": "t1_k", "r": 0.5}]}})",
            profile)
                                  .value();
        QCOMPARE(recipe.uncertainty.correlations.size(), 2);
        QCOMPARE(recipe.uncertainty.correlations[0].coefficient, 0.9);
        QCOMPARE(recipe.uncertainty.correlations[1].coefficient, 0.5);
        QCOMPARE(changedFromProfile(recipe),
            std::vector<std::string>{"uncertainty.correlations{p1_pa, t1_k}"});
    }

    void whatDiffers_isNamed()
    {
        const Recipe recipe = joined(R"({"shock": {"driven_length_m": 1.5},
            "uncertainty": {"budget": [{"quantity": "t1_k", "u": 0.5}], "cmc": [
            {"of": "sensitivity", "expanded": 0.01}]}})",
            kProfile)
                                  .value();
        const std::vector<std::string> expected{
            "shock.driven_length_m", "uncertainty.budget{t1_k}", "uncertainty.cmc{sensitivity}"};
        QCOMPARE(changedFromProfile(recipe), expected);
        Recipe later = joined("{}", kProfile).value();
        later.uncertainty.budget.erase(later.uncertainty.budget.begin());
        QCOMPARE(changedFromProfile(later), std::vector<std::string>{"uncertainty.budget{t1_k}"});
    }

    void putOverARecipe_profileWins()
    {
        Recipe recipe;
        recipe.shock.drivenLength_m = 1.5;
        recipe.shock.p1_Pa = 5e4;
        recipe.uncertainty.budget = {{"t1_k", 0.5}, {"p1_pa", 9.0}};
        const Recipe with = withProfile(recipe, written("p.json", kProfile)).value();
        QCOMPARE(with.shock.drivenLength_m, std::optional(0.97));
        QCOMPARE(with.shock.p1_Pa, recipe.shock.p1_Pa);
        QCOMPARE(with.uncertainty.budget.size(), 3);
        QVERIFY(changedFromProfile(with).empty());
        const Recipe again = withProfile(with, written("p.json", kProfile)).value();
        QVERIFY(again.profile == with.profile);
        QCOMPARE(again.uncertainty.budget.size(), 3);
    }

    void anotherProfile_isRefused()
    {
        const std::string first = recipeJson(joined("{}", kProfile).value());
        QVERIFY(joined(first, kProfile));
        const std::string second
            = R"({"schema": "dyncal-profile/1", "name": "Tube 3", "version": "1"})";
        const auto refused = joined(first, second);
        QVERIFY(!refused);
        QVERIFY(refused.error().kind == ErrorKind::Usage);
        QVERIFY(english(refused.error().message).find("Tube 2") != std::string::npos);
        const auto changed = withProfile(parseRecipe(first).value(), written("p.json", second));
        QCOMPARE(changed.value().profile->name, "Tube 3");
    }

    void fault_saysWhere_data()
    {
        QTest::addColumn<QByteArray>("profile");
        QTest::addColumn<QByteArray>("word");
        const auto row = [](const char *name, const char *profile, const char *word) {
            QTest::newRow(name) << QByteArray(profile) << QByteArray(word);
        };
        row("name", R"({"schema": "dyncal-profile/1", "version": "1"})", "\"name\"");
        row("version", R"({"schema": "dyncal-profile/1", "name": "x", "version": ""})", "version");
        row("number", R"({"schema": "dyncal-profile/1", "name": 1, "version": "1"})", "name");
        row("shot's", R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "shock": {"p1_pa": 1e5}})",
            "shock.p1_pa");
        row("section", R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "realization": {"order": 2}})",
            "realization");
        row("unknown key", R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "checks": {"min_code": 2}})",
            "min_codes");
        row("schema", R"({"schema": "dyncal-profile/2", "name": "x", "version": "1"})", "schema");
        row("date", R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "uncertainty": {"budget": [{"quantity": "t1_k", "u": 1, "due": "2026-02-30"}]}})",
            "due");
        row("cmc without size", R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "uncertainty": {"cmc": [{"of": "f0_hz"}]}})",
            "expanded");
        row("cmc of an empty band", R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "uncertainty": {"cmc": [{"of": "magnitude", "expanded": 1, "from_hz": 9, "to_hz": 8}]}})",
            "from 9 to 8 Hz");
        row("no object", "[1]", "object");
    }

    void fault_saysWhere()
    {
        QFETCH(QByteArray, profile);
        QFETCH(QByteArray, word);
        const std::string said = faultOf(profile.toStdString());
        QVERIFY2(said.find(word.toStdString()) != std::string::npos, said.c_str());
    }

    /// However either of them writes the same thing.
    void sameSettingWrittenOtherwise_isNoChange_data()
    {
        QTest::addColumn<QByteArray>("profile");
        QTest::addColumn<QByteArray>("recipe");
        QTest::newRow("role") << QByteArray(R"("import": {"channels": {"A": "dut"}})")
                              << QByteArray(R"({"import": {"channels": {"A": {"role": "dut"}}}})");
        QTest::newRow("number") << QByteArray(R"("checks": {"min_codes": 8})")
                                << QByteArray(R"({"checks": {"min_codes": 8.0}})");
        QTest::newRow("default") << QByteArray(R"("uncertainty": {"budget": [
            {"quantity": "t1_k", "u": 1}]})")
                                 << QByteArray(R"({"uncertainty": {"budget": [
            {"quantity": "t1_k", "u": 1, "distribution": "normal", "dof": null}]}})");
        QTest::newRow("order of lines") << QByteArray(R"("uncertainty": {"budget": [
            {"quantity": "t1_k", "u": 1}, {"quantity": "p1_pa", "u": 2}]})")
                                        << QByteArray(R"({"uncertainty": {"budget": [
            {"quantity": "p1_pa", "u": 2}]}})");
    }
    void sameSettingWrittenOtherwise_isNoChange()
    {
        QFETCH(QByteArray, profile);
        QFETCH(QByteArray, recipe);
        const std::string whole = R"({"schema": "dyncal-profile/1", "name": "x", "version": "1", )"
            + profile.toStdString() + "}";
        const Recipe made = joined(recipe.toStdString(), whole).value();
        const auto changed = changedFromProfile(made);
        QVERIFY2(changed.empty(), changed.empty() ? "" : changed.front().c_str());
        QVERIFY(changedFromProfile(parseRecipe(recipeJson(made)).value()).empty());
    }

    void withoutName_itLeavesNoMark()
    {
        const Recipe recipe = joined("{}", R"({"checks": {"min_codes": 8}})").value();
        QVERIFY(!recipe.profile);
        QVERIFY(changedFromProfile(recipe).empty());
    }

    /// A recipe that names a file of its own means the one beside itself.
    /// What a laboratory demands of a certificate is remembered with the profile and no part of the
    /// recipe.
    void demands_areRemembered()
    {
        const std::string demanding
            = std::string(kProfile).replace(1, 0, R"("issue": {"second_name": true}, )");
        const Recipe recipe = joined("{}", demanding).value();
        QVERIFY(demandsSecondName(*recipe.profile));
        QVERIFY(changedFromProfile(recipe).empty());
        const Recipe again = parseRecipe(recipeJson(recipe)).value();
        QVERIFY(again == recipe && demandsSecondName(*again.profile));
        QVERIFY(!demandsSecondName(*joined("{}", kProfile)->profile));
        for (const char *wrong : {R"("issue": true, )", R"("issue": {"second_name": 1}, )",
                 R"("issue": {"third_name": true}, )"})
            QVERIFY(!faultOf(std::string(kProfile).replace(1, 0, wrong)).empty());
        QVERIFY(!joined(R"({"issue": {"second_name": true}})", "{}")); // not of a recipe
    }

    void chainOfTheRecipe_isReadBesideTheRecipe()
    {
        const ScratchFolder elsewhere;
        written("amp.csv", "of the recipe");
        elsewhere.write("amp.csv", "of the profile", 14);
        const std::string profile = R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "chain": {"source": "amp.csv"}})";
        const std::string path = elsewhere.write("p.json", profile.data(), profile.size());
        const Recipe own
            = readRecipeFiles(written("r.json", R"({"chain": {"source": "amp.csv"}})"), path)
                  .value();
        QCOMPARE(own.chain.loaded->content, "of the recipe");
        const Recipe lab = readRecipeFiles(written("r.json", "{}"), path).value();
        QCOMPARE(lab.chain.loaded->content, "of the profile");
        QCOMPARE(lab.chain.sha256, lab.chain.loaded->sha256); // pinned for the next time
        const std::string run = recipeJson(lab); // beside which another file has this name
        const Recipe repeated = readRecipeFiles(written("run.json", run), path).value();
        QCOMPARE(repeated.chain.loaded->content, "of the profile");
        QVERIFY(repeated == lab);
        const Recipe again = withProfile(own, path).value(); // not with the hash of another file
        QCOMPARE(again.chain.loaded->content, "of the profile");
        QCOMPARE(again.chain.sha256, again.chain.loaded->sha256);
    }

    /// The chain's file stands beside the profile, wherever the recipe is.
    void chain_isReadBesideTheProfile()
    {
        written("amp.csv", "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad\n");
        const std::string profile = R"({"schema": "dyncal-profile/1", "name": "x", "version": "1",
            "chain": {"source": "amp.csv"}})";
        const Recipe recipe = readRecipeFiles({}, written("p.json", profile)).value();
        QVERIFY(recipe.chain.loaded != nullptr);
        QVERIFY(withProfile(Recipe(), written("p.json", profile)).value().chain == recipe.chain);
    }
};

DYNCAL_TEST(TestLaboratoryProfile)
#include "tst_laboratory_profile.moc"
