// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/project/template_choice.h"
#include "core/reference/reference_source.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace dyncal;

namespace {

constexpr const char *kLogo = "<svg viewBox='0 0 1 1'/>";

struct Folder
{
    QTemporaryDir folder;

    std::string path(const std::string &name) const
    {
        return folder.filePath(QString::fromStdString(name)).toStdString();
    }
    void put(const std::string &name, const std::string &bytes) const
    {
        const QString place = QString::fromStdString(path(name));
        QVERIFY(QFileInfo(place).dir().mkpath("."));
        QFile file(place);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes.data(), static_cast<qint64>(bytes.size())), qint64(bytes.size()));
    }
    /// Whatever a run would keep.
    void putKept(const ChosenTemplate &chosen) const
    {
        for (const auto &[name, bytes] : keptTemplateFiles(chosen))
            put(name, bytes);
    }
};

CertificateTemplate withLogo()
{
    CertificateTemplate layout;
    layout.figures = {"phase"};
    layout.logo = "logo.svg";
    return layout;
}

std::string refusal(const std::string &name)
{
    const Result<ChosenTemplate> chosen = chooseTemplate(name);
    return chosen ? std::string("(chosen)") : english(chosen.error().message);
}

} // namespace

/// A template by name or from a file, and the copies that a run keeps of it.
class TestTemplateChoice : public QObject
{
    Q_OBJECT

private slots:
    void names_areTheBuiltInOnes()
    {
        for (const char *name : {"accredited", "full", "short", "research"}) {
            const Result<ChosenTemplate> chosen = chooseTemplate(name);
            QVERIFY2(chosen && chosen->file.empty() && chosen->logo.empty(), name);
            QVERIFY(keptTemplateFiles(*chosen).empty());
            Recipe recipe;
            recipe.certificate.templateName = name;
            QVERIFY(withKeptTemplate(recipe, *chosen) == recipe);
        }
        QVERIFY(chooseTemplate("accredited")->layout == CertificateTemplate());
    }
    void unknownName_isRefusedWithTheKnownOnes()
    {
        const Result<ChosenTemplate> chosen = chooseTemplate("fancy");
        QVERIFY(!chosen && chosen.error().kind == ErrorKind::Usage);
        QCOMPARE(refusal("fancy"),
            std::string(
                "There is no template \"fancy\" (certificate.template); it needs one of accredited, full, short, research, or a file that ends in .json."));
        QVERIFY(refusal("") != "(chosen)");
    }
    void file_isReadWithItsLogo()
    {
        const Folder folder;
        folder.put("lab.json", templateJson(withLogo()));
        folder.put("logo.svg", kLogo);
        const Result<ChosenTemplate> chosen = chooseTemplate(folder.path("lab.json"));
        QVERIFY2(chosen, refusal(folder.path("lab.json")).c_str());
        QVERIFY(chosen->layout == withLogo());
        QCOMPARE(chosen->logo, std::string(kLogo));
        QCOMPARE(chosen->file, folder.path("lab.json"));
    }
    void fileThatIsNone_isNamed()
    {
        const Folder folder;
        const std::string path = folder.path("lab.json");
        QCOMPARE(chooseTemplate(path).error().kind, ErrorKind::FileUnreadable);
        QVERIFY(refusal(path).find(path) != std::string::npos);
        folder.put("lab.json", "{\"schema\": \"dyncal-template/1\", \"sections\": []}");
        QVERIFY(refusal(path).starts_with(path + ": Template key sections"));
        folder.put("lab.json", std::string(300000, ' '));
        QVERIFY(refusal(path).find("larger than 256 KiB") != std::string::npos);
        folder.put("lab.json", templateJson(withLogo()));
        QVERIFY(refusal(path).find("logo.svg") != std::string::npos); // it is not there
        folder.put("logo.svg", "<svg><image href='a'/></svg>");
        QVERIFY(refusal(path).find("stands by itself") != std::string::npos);
        folder.put("logo.svg", std::string((1 << 20) + 1, ' '));
        QVERIFY(refusal(path).find("larger than 1024 KiB") != std::string::npos);
        QVERIFY(refusal(folder.folder.path().toStdString() + "/.json") != "(chosen)");
    }
    void located_isSeenFromTheRecipe()
    {
        Recipe recipe;
        locateTemplate("/lab/recipes/r.json", recipe);
        QCOMPARE(recipe.certificate.templateName, std::string("accredited"));
        recipe.certificate.templateName = "lab.json";
        locateTemplate("", recipe);
        QCOMPARE(recipe.certificate.templateName, std::string("lab.json"));
        locateTemplate("/lab/recipes/r.json", recipe);
        QCOMPARE(recipe.certificate.templateName, std::string("/lab/recipes/lab.json"));
        locateTemplate("/elsewhere/r.json", recipe);
        QCOMPARE(recipe.certificate.templateName, std::string("/lab/recipes/lab.json"));
    }
    /// The copies say the same as what they were made of, and copies of copies are the same files.
    void kept_repeatsItself()
    {
        const Folder folder;
        folder.put("lab.json", templateJson(withLogo()));
        folder.put("logo.svg", kLogo);
        const ChosenTemplate chosen = *chooseTemplate(folder.path("lab.json"));
        const auto files = keptTemplateFiles(chosen);
        QCOMPARE(files.size(), std::size_t(2));
        for (const auto &[name, bytes] : files)
            QVERIFY2(isKeptSourceName(name), name.c_str());
        QCOMPARE(files.at(keptSourceName("logo.svg", sha256Hex(std::string_view(kLogo)))),
            std::string(kLogo));
        const Recipe kept = withKeptTemplate({}, chosen);
        QVERIFY(files.contains(kept.certificate.templateName));
        const Folder other;
        other.putKept(chosen);
        Recipe again = kept;
        locateTemplate(other.path("recipe.json"), again);
        const Result<ChosenTemplate> read = chooseTemplate(again.certificate.templateName);
        QVERIFY2(read, refusal(again.certificate.templateName).c_str());
        QCOMPARE(read->logo, chosen.logo);
        CertificateTemplate same = read->layout;
        same.logo = chosen.layout.logo;
        QVERIFY(same == chosen.layout);
        QVERIFY(keptTemplateFiles(*read) == files);
        QVERIFY(withKeptTemplate(again, *read) == kept);
    }
    void kept_otherLogo_isAnotherTemplate()
    {
        const Folder folder;
        folder.put("lab.json", templateJson(withLogo()));
        folder.put("logo.svg", kLogo);
        const Recipe one = withKeptTemplate({}, *chooseTemplate(folder.path("lab.json")));
        folder.put("logo.svg", std::string(kLogo) + "\n");
        const Recipe other = withKeptTemplate({}, *chooseTemplate(folder.path("lab.json")));
        QVERIFY(!(one == other));
    }
    void languages_areTheTemplatesOrTheRecipes()
    {
        Recipe recipe;
        recipe.certificate.languages = {"sv"};
        ChosenTemplate chosen;
        QCOMPARE(documentLanguages(chosen, recipe), std::vector<std::string>{"sv"});
        chosen.layout.languages = std::vector<std::string>{"en", "sv"};
        QCOMPARE(documentLanguages(chosen, recipe), (std::vector<std::string>{"en", "sv"}));
    }
};

DYNCAL_TEST(TestTemplateChoice)
#include "tst_template_choice.moc"
