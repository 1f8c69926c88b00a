// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe.h"
#include "tests/support/test_program.h"

#include "tests/core/project/full_recipe.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

/// The path of a file of that content.
std::string written(const QTemporaryDir &folder, const char *name, const char *text)
{
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly))
        qFatal("cannot write");
    file.write(text);
    return folder.filePath(name).toStdString();
}

} // namespace

class TestRecipe : public QObject
{
    Q_OBJECT

private:
    static Recipe parsed(const std::string &json)
    {
        const Result<Recipe> recipe = parseRecipe(json);
        if (!recipe)
            qWarning("%s", english(recipe.error().message).c_str());
        return recipe.value_or(Recipe());
    }

    static std::string fileText(const char *inTree)
    {
        QFile file(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + '/' + inTree);
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }

    static std::string refusal(const std::string &json)
    {
        const Result<Recipe> recipe = parseRecipe(json);
        if (recipe)
            return "(accepted)";
        return recipe.error().kind == ErrorKind::Usage ? english(recipe.error().message)
                                                       : "(wrong kind)";
    }

private slots:
    void emptyObject_isTheDefaultRecipe()
    {
        const Result<Recipe> recipe = parseRecipe("{}");
        QVERIFY(recipe.has_value());
        QVERIFY(*recipe == Recipe());
    }

    void roundTrip_ofDefaults_isIdentical()
    {
        const std::string json = recipeJson(Recipe());
        QVERIFY(parsed(json) == Recipe());
        QCOMPARE(recipeJson(parsed(json)), json);
    }

    void roundTrip_ofEveryFieldSet_isIdentical()
    {
        const Recipe full = fullRecipe();
        QVERIFY(!(full == Recipe()));
        const std::string json = recipeJson(full);
        QVERIFY(parsed(json) == full);
        QCOMPARE(recipeJson(parsed(json)), json);
    }

    void roundTrip_ofEveryAlternative_isIdentical()
    {
        std::vector<Recipe> recipes(13);
        recipes[0].window.start_s = {0.0125};
        recipes[1].window.subtractBaseline = false;
        recipes[2].window.endAtPlateau = true;
        recipes[3].spectrum.searchResonance = false; // "none"
        recipes[4].response.grid = "linear";
        recipes[4].response.linearCount = 77;
        recipes[5].response.grid = "list";
        recipes[5].response.frequencies_Hz = {1e3, 2e3};
        recipes[6].uncertainty.monteCarloTrials = 0; // "adaptive"
        recipes[7].input.treatment = ResponseTreatment::Impulse;
        recipes[8].input.treatment = ResponseTreatment::Differenced;
        recipes[9].import.levels = {"low", "", "high"};
        recipes[10].import.polarity = -1;
        recipes[11].input.combine = CombineMethod::Stacked;
        recipes[12].window.ownEnds_s = {1e-3, Auto<double>(), 2e-3};
        for (const Recipe &recipe : recipes)
            QVERIFY2(parsed(recipeJson(recipe)) == recipe, recipeJson(recipe).c_str());
    }

    void roundTrip_ofRandomNumbers_isExact()
    {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> exponent(-300.0, 300.0);
        for (int i = 0; i < 200; ++i) {
            Recipe recipe;
            recipe.shock.p1_Pa = std::pow(10.0, exponent(random));
            recipe.import.scale = std::pow(10.0, exponent(random));
            QVERIFY(parsed(recipeJson(recipe)) == recipe);
        }
    }

    void json_isSortedIndentedAndEndsWithALineFeed()
    {
        const QByteArray json = QByteArray::fromStdString(recipeJson(fullRecipe()));
        QVERIFY(json.startsWith("{\n  \"acknowledge\": ["));
        QVERIFY(json.endsWith("}\n"));
        QVERIFY(!json.contains('\r') && !json.contains('\t'));
        const QJsonDocument document = QJsonDocument::fromJson(json); // an independent reader
        QVERIFY(document.isObject());
        QCOMPARE(document["schema"].toString(), QStringLiteral("dyncal-recipe/1"));
        QCOMPARE(document["window"]["baseline_s"][0].toDouble(), -2e-4);
        const QList<QByteArray> lines = json.split('\n');
        QByteArray before;
        for (const QByteArray &line : lines) {
            if (!line.startsWith("  \"")) // keys of the first level
                continue;
            QVERIFY(before < line);
            before = line;
        }
    }

    void exampleOfTheInterface_isUnderstood()
    {
        const Recipe recipe = parsed(fileText("tests/core/project/interface_example.json"));
        QCOMPARE(recipe.import.columns.at("dut"), Index(1));
        QCOMPARE(recipe.import.channels.at("Acceleration_1"), std::string("dut"));
        QCOMPARE(recipe.import.reference, std::string("gauge"));
        QCOMPARE(recipe.import.exclude.front().shot, Index(2));
        QCOMPARE(*recipe.shock.p1_Pa, 101100.0);
        QCOMPARE(recipe.shock.driverGas.molarMass_kg_mol, 0.028014);
        QCOMPARE(recipe.shock.arrivalSensors.front().distanceToEndWall_m, 0.8);
        QCOMPARE(recipe.window.start_s.size(), std::size_t(3));
        QCOMPARE(recipe.window.baseline_s.value->begin, -2e-4);
        QVERIFY(recipe.window.endAtPlateau);
        QVERIFY(recipe.spectrum.taper == Taper::Hann);
        QVERIFY(recipe.spectrum.method == SpectrumMethod::Welch);
        QVERIFY(!recipe.spectrum.searchResonance);
        QCOMPARE(recipe.spectrum.resonances_Hz.front(), 2.33e6);
        QCOMPARE(*recipe.input.samples.value, Index(1000));
        QVERIFY(recipe.input.treatment == ResponseTreatment::StepAsImpulse);
        QVERIFY(recipe.input.combine == CombineMethod::PcaAverage);
        QCOMPARE(*recipe.realization.order.value, Index(3));
        QCOMPARE(recipe.response.grid, std::string("linear"));
        QCOMPARE(recipe.response.linearCount, Index(50));
        QCOMPARE(recipe.uncertainty.monteCarloTrials, Index(0));
        QCOMPARE(recipe.acknowledge.front().shot, Index(3));
        QCOMPARE(recipe.certificate.fields.at("customer"), std::string("Åsa Ström AB"));
    }

    void channels_areRolesOrObjects()
    {
        const Recipe recipe = parsed(
            R"({"import": {"channels": {"a": "dut", "b": {"role": "driven_side", "unit": "mV",
                "sensitivity": 2e-8, "gain": 10}, "c": {"polarity": -1}}}})");
        const ImportSettings &import = recipe.import;
        const std::map<std::string, std::string> roles{{"a", "dut"}, {"b", "driven_side"}};
        QVERIFY(import.channels == roles);
        QCOMPARE(import.channelDetails.size(), std::size_t(2));
        QCOMPARE(import.channelDetails.at("b").unit.value(), std::string("mV"));
        QCOMPARE(import.channelDetails.at("b").sensitivity.value(), 2e-8);
        QCOMPARE(import.channelDetails.at("b").gain.value(), 10.0);
        QVERIFY(!import.channelDetails.at("b").scale);
        QCOMPARE(import.channelDetails.at("c").polarity.value(), -1);
        QVERIFY(parsed(recipeJson(recipe)) == recipe);
        // A role alone is written as it always was.
        QVERIFY(recipeJson(recipe).find("\"a\": \"dut\"") != std::string::npos);
    }

    void files_haveTheKeysOfImport()
    {
        const Recipe recipe = parsed(
            R"({"import": {"files": {"a.csv": {"unit": "psi", "sample_rate_hz": 1e6,
                "columns": {"dut": 3}, "channels": {"x": {"scale": 2}}}}}})");
        const FileImport &file = recipe.import.files.at("a.csv");
        QCOMPARE(file.unit.value(), std::string("psi"));
        QCOMPARE(file.sampleRate_Hz.value(), 1e6);
        QCOMPARE(file.columns.at("dut"), Index(3));
        QCOMPARE(file.channelDetails.at("x").scale.value(), 2.0);
        QVERIFY(!file.format && !file.polarity && file.decimal.empty());
        QVERIFY(parsed(recipeJson(recipe)) == recipe);
    }

    void readRecipeFiles_putsTheRecipeOverTheProfile()
    {
        QTemporaryDir folder;
        const auto write
            = [&](const char *name, const char *text) { return written(folder, name, text); };
        const std::string profile = write("profile.json",
            R"({"import": {"unit": "psi", "channels": {"a": "dut", "b": "driven_side"}},
                "checks": {"min_codes": 100}})");
        const std::string recipe = write("recipe.json",
            R"({"import": {"unit": null, "channels": {"b": "other"}}, "pca": {"components": 2}})");
        const Recipe merged = readRecipeFiles(recipe, profile).value_or(Recipe());
        QVERIFY(!merged.import.unit); // null is a value, not an absence
        QCOMPARE(merged.import.channels.at("a"), std::string("dut"));
        QCOMPARE(merged.import.channels.at("b"), std::string("other"));
        QCOMPARE(merged.checks.leastCodes, 100.0);
        QCOMPARE(merged.pca.components, Index(2));
        QCOMPARE(readRecipeFiles({}, profile)->import.unit.value(), std::string("psi"));
        QVERIFY(readRecipeFiles(recipe, {}).value() == readRecipeFile(recipe).value());
        QVERIFY(readRecipeFiles({}, {}).value() == Recipe());
        const auto refused = readRecipeFiles({}, recipe); // pca is no matter of a laboratory
        QCOMPARE(refused.error().kind, ErrorKind::Usage);
        QVERIFY(english(refused.error().message).find("\"pca\"") != std::string::npos);
        QCOMPARE(readRecipeFiles(recipe, "/none.json").error().kind, ErrorKind::FileUnreadable);
    }

    void comparison_isRead_withTheFileThatItNames()
    {
        QTemporaryDir folder;
        const auto write
            = [&](const char *name, const char *text) { return written(folder, name, text); };
        write("ref.csv", "abc");
        const std::string path = write("recipe.json",
            R"({"comparison": {"enabled": true, "source": "ref.csv", "u_delay_s": 1e-8,
                "correlation_with_step": -0.5}, "response": {"reference": "transducer"}})");
        const ComparisonSettings read = readRecipeFile(path).value().comparison;
        QVERIFY(read.enabled && read.loaded && read.channel.empty() && !read.model);
        QCOMPARE(read.loaded->content, std::string("abc"));
        QCOMPARE(read.u_delay_s.value(), 1e-8);
        QCOMPARE(read.correlationWithStep, -0.5);
        const Recipe modelled = parsed(
            R"({"comparison": {"channel": "Ref", "model": {"sensitivity": 2e-8, "u_sensitivity": 0,
                "f0_hz": 3e5, "u_f0_hz": 100, "zeta": 0.1, "u_zeta": 0.01}}})");
        QCOMPARE(modelled.comparison.model->f0_Hz, 3e5);
        QVERIFY(parsed(recipeJson(modelled)) == modelled);
        for (const char *bad : {R"({"comparison": {"sha256": "12"}})",
                 R"({"comparison": {"correlation_with_step": 2}})",
                 R"({"comparison": {"model": {"sensitivity": 1}}})",
                 R"({"comparison": {"source": 3}})"})
            QVERIFY2(!parseRecipe(bad), bad);
    }

    void gasNames_areTheNamedConstants()
    {
        const auto gas = [](const char *name) {
            return parsed(std::string("{\"shock\": {\"driven_gas\": \"") + name + "\"}}")
                .shock.drivenGas;
        };
        QCOMPARE(gas("air").gamma, 1.402); // thesis, table 4.1
        QCOMPARE(gas("air").molarMass_kg_mol, 0.028966);
        QCOMPARE(gas("n2").gamma, 1.4);
        QCOMPARE(gas("he").gamma, 5.0 / 3.0);
        QCOMPARE(gas("he").molarMass_kg_mol, 0.0040026);
        QCOMPARE(gas("ar").molarMass_kg_mol, 0.039948);
    }

    void wholeNumberWrittenAsFloat_isAccepted()
    {
        QCOMPARE(*parsed(R"({"input": {"samples": 1e3}})").input.samples.value, Index(1000));
        QCOMPARE(*parsed(R"({"input": {"samples": 1000.0}})").input.samples.value, Index(1000));
    }

    void unknownKey_namesPathAndNearest_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QByteArray>("unknown");
        QTest::addColumn<QByteArray>("nearest");
        const auto row = [](const char *json, const char *unknown, const char *nearest) {
            QTest::newRow(unknown)
                << QByteArray(json) << QByteArray(unknown) << QByteArray(nearest);
        };
        row(R"({"windw": {}})", "windw", "window");
        row(R"({"window": {"end": 1e-3}})", "window.end", "window.end_s");
        row(R"({"order": 3})", "order", "realization.order");
        row(R"({"input": {"sample_rate": 1e6}})", "input.sample_rate", "input.sample_rate_hz");
        row(R"({"shock": {"driven_gas": {"gama": 1.4}}})", "shock.driven_gas.gama",
            "shock.driven_gas.gamma");
        row(R"({"import": {"exclude": [{"shot": 1, "reason": "x"}, {"shoot": 1}]}})",
            "import.exclude[1].shoot", "import.exclude[].shot");
        row(R"({"import": {"columns": {"tme": 0}}})", "import.columns.tme", "import.columns.time");
        row(R"({"uncertainty": {"budget": [{"quantity": "a", "u": 1, "distrib": "normal"}]}})",
            "uncertainty.budget[0].distrib", "uncertainty.budget[].distribution");
        row(R"({"Window": {}})", "Window", "window");
    }

    void unknownKey_namesPathAndNearest()
    {
        QFETCH(QByteArray, json);
        QFETCH(QByteArray, unknown);
        QFETCH(QByteArray, nearest);
        QCOMPARE(QByteArray::fromStdString(refusal(json.toStdString())),
            "Recipe key " + unknown + " is unknown; the nearest known key is " + nearest + ".");
    }

    void badValue_namesKeyFoundAndNeeded_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const char *name, const char *json, const char *sentence) {
            QTest::newRow(name) << QByteArray(json) << QByteArray(sentence);
        };
        row("text for number", R"({"shock": {"p1_pa": "101"}})",
            "Recipe key shock.p1_pa is \"101\"; it needs null or a number above 0.");
        row("out of range", R"({"shock": {"relative_humidity": 50}})",
            "Recipe key shock.relative_humidity is 50; it needs null or a number between 0 and 1.");
        row("zero where above zero", R"({"shock": {"t1_k": 0}})",
            "Recipe key shock.t1_k is 0; it needs null or a number above 0.");
        row("half an order", R"({"realization": {"order": 2.5}})",
            "Recipe key realization.order is 2.5; it needs \"auto\" or a whole number between 1 and 2000.");
        row("word", R"({"input": {"treatment": "step"}})",
            "Recipe key input.treatment is \"step\"; it needs one of \"step-deflated\", \"step-as-impulse\", \"differenced\", \"impulse\".");
        row("polarity", R"({"import": {"polarity": 0}})",
            "Recipe key import.polarity is 0; it needs 1 or -1.");
        row("band backwards", R"({"window": {"settle_s": [2e-3, 1e-3]}})",
            "Recipe key window.settle_s is [0.002,0.001]; it needs a list of two numbers, the smaller first.");
        row("gas", R"({"shock": {"driven_gas": "steam"}})",
            "Recipe key shock.driven_gas is \"steam\"; it needs one of \"auto\", \"air\", \"n2\", \"he\", \"ar\", \"co2\", \"humid-air\", or an object with gamma and molar_mass_kg_mol.");
        row("missing in a list", R"({"import": {"exclude": [{"shot": 1}]}})",
            "Recipe key import.exclude[0] is {\"shot\":1}; it needs the key \"reason\".");
        row("section no object", R"({"window": 3})", "Recipe key window is 3; it needs an object.");
        row("root no object", "[]", "Recipe key (the whole) is []; it needs an object.");
        row("schema", R"({"schema": "dyncal-recipe/2"})",
            "Recipe key schema is \"dyncal-recipe/2\"; it needs \"dyncal-recipe/1\".");
        row("end", R"({"window": {"end_s": "later"}})",
            "Recipe key window.end_s is \"later\"; it needs \"plateau\" or \"auto\" or a number above 0, or a list with one of the last two per shot.");
        row("end of a shot", R"({"window": {"end_s": [1e-3, "plateau"]}})",
            "Recipe key window.end_s[1] is \"plateau\"; it needs \"auto\" or a number above 0.");
        row("no ends", R"({"window": {"end_s": []}})",
            "Recipe key window.end_s is []; it needs a list that is not empty, each value \"auto\" or a number above 0.");
        row("linear", R"({"response": {"frequencies_hz": "linear:1"}})",
            "Recipe key response.frequencies_hz is \"linear:1\"; it needs \"third-octave\", \"linear:N\" with N between 2 and 100000 or a list of frequencies in hertz.");
        row("list element", R"({"response": {"frequencies_hz": [100, -5]}})",
            "Recipe key response.frequencies_hz[1] is -5; it needs a number above 0.");
        row("order above max", R"({"realization": {"order": 200}})",
            "Recipe key realization.order is 200; it needs at most realization.max_order, which is 120.");
        row("channel's role", R"({"import": {"channels": {"A": "duty"}}})",
            "Recipe key import.channels{A} is \"duty\"; it needs one of \"dut\", \"driven_side\", \"driver\", \"trigger\", \"reference\", \"other\", \"velocity\", \"driver_static\".");
        row("channel's gain", R"({"import": {"channels": {"A": {"gain": 0}}}})",
            "Recipe key import.channels{A}.gain is 0; it needs null or a number above 0.");
        row("file's unit", R"({"import": {"files": {"a.csv": {"unit": 3}}}})",
            "Recipe key import.files{a.csv}.unit is 3; it needs null or a text that is not empty.");
        row("bool", R"({"remap": 1})", "Recipe key remap is 1; it needs true or false.");
    }

    void badValue_namesKeyFoundAndNeeded()
    {
        QFETCH(QByteArray, json);
        QFETCH(QByteArray, sentence);
        QCOMPARE(QByteArray::fromStdString(refusal(json.toStdString())), sentence);
    }

    void everyKey_refusesAForeignType()
    {
        // An object of one foreign key fits no key: sections refuse the key, values the type.
        for (const std::string &path : recipeKeyPaths()) {
            if (path.find("[]") != std::string::npos || path.find("{}") != std::string::npos)
                continue;
            std::string json = R"({"?": []})";
            QString rest = QString::fromStdString(path);
            for (QStringList parts = rest.split('.'); !parts.isEmpty(); parts.removeLast())
                json = "{\"" + parts.last().toStdString() + "\": " + json + "}";
            QVERIFY2(refusal(json).starts_with("Recipe key " + path)
                    || refusal(json).starts_with("Recipe key shock.")
                    || refusal(json).starts_with("Recipe key profile ")
                    || refusal(json).starts_with("Recipe key comparison.model ")
                    || refusal(json).starts_with("Recipe key certificate.decision "),
                (path + " -> " + refusal(json)).c_str());
        }
    }

    void hugeNumbers_areRefusedNotWrapped()
    {
        QVERIFY(refusal(R"({"uncertainty": {"seed": 18446744073709551615}})")
                    .starts_with("Recipe key uncertainty.seed"));
        QVERIFY(
            refusal(R"({"input": {"samples": 1e300}})").starts_with("Recipe key input.samples"));
        QVERIFY(refusal(R"({"input": {"samples": -9223372036854775808}})")
                    .starts_with("Recipe key input.samples"));
    }

    void longValues_areCutInTheSentence()
    {
        const std::string json = "{\"window\": {\"start\": \"" + std::string(1000000, 'x') + "\"}}";
        QVERIFY(refusal(json).size() < 300);
        const std::string key = "{\"" + std::string(1000000, 'x') + "\": 1}";
        QVERIFY(refusal(key).size() < 300);
    }

    void everyPrefixOfARecipe_isRefusedOrRead()
    {
        const std::string json = recipeJson(fullRecipe());
        for (std::size_t length = 0; length + 2 < json.size(); length += 7)
            QVERIFY(refusal(json.substr(0, length)) != "(accepted)");
    }

    void readRecipeFile_readsWhatWasWritten()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath("recipe å.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(recipeJson(fullRecipe())));
        file.close();
        const Result<Recipe> recipe = readRecipeFile(file.fileName().toStdString());
        QVERIFY(recipe.has_value());
        QVERIFY(*recipe == fullRecipe());
    }

    void readRecipeFile_thatIsMissingOrNoFile_isUnreadable()
    {
        for (const char *path : {"/nonexistent/recipe.json", "/", "/dev/zero"}) {
            const Result<Recipe> recipe = readRecipeFile(path);
            QVERIFY(!recipe.has_value());
            QVERIFY2(recipe.error().kind == ErrorKind::FileUnreadable, path);
            QVERIFY(english(recipe.error().message).find(path) != std::string::npos);
        }
    }
};

DYNCAL_TEST(TestRecipe)
#include "tst_recipe.moc"
