// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"
#include "tests/system/quick_recipe.h"

#include <QRegularExpression>
#include <QtTest>

namespace {

constexpr const char *kLogo
    = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10"><path d="M0 0h20v10z"/></svg>)";

/// Of a laboratory: other figures, few key results, a logo.
QByteArray ownTemplate()
{
    return R"({"schema": "dyncal-template/1", "title": {"en": "Certificate of our laboratory"},
        "figures": ["phase"], "quantities": ["sensitivity", "f0_hz", "damping_ratio"],
        "logo": "our logo.svg"})";
}

QString pages(const QString &pdf, const QStringList &more = {})
{
    QProcess text;
    text.start("pdftotext", QStringList{"-layout"} + more + QStringList{pdf, "-"});
    return text.waitForFinished() ? QString::fromUtf8(text.readAllStandardOutput()) : QString();
}

qsizetype figuresOn(const QString &text)
{
    return text.count(QRegularExpression("Figure \\d+\\."));
}

} // namespace

/// What `--template` and certificate.template do to the certificates of the built program.
class TestTemplates : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    Answer run(const QString &output, const QStringList &more = {}) const
    {
        return runDyncal(QStringList{"run", path("shot.h5"), "-o", path(output)} + more
                + (more.contains("--recipe") ? QStringList() : quickly()),
            {"SOURCE_DATE_EPOCH=1767225600"});
    }
    void putTemplate(const QString &folder) const
    {
        QVERIFY(QDir(path(".")).mkpath(folder));
        QVERIFY(writeBytes(path(folder + "/lab.json"), ownTemplate()));
        QVERIFY(writeBytes(path(folder + "/our logo.svg"), kLogo));
    }
    QString templateOf(const QString &folder) const
    {
        return fileJson(path(folder + "/recipe.json"))["certificate"]
            .toObject()["template"]
            .toString();
    }

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(path("shot.h5"), 7)); }

    void builtIn_everyOneSaysWhatItMust();
    void default_isAccredited_andChangesNothing();
    void ownFile_isKeptAndRepeated();
    void ownFile_ofTheRecipe_liesBesideIt();
    void wrongOnes_areRefusedBeforeAnythingIsWritten();
    void twoLanguages_standSideBySide();
    void issued_holdsItsTemplate();
    void issued_unknownName_takesNoNumber();
};

void TestTemplates::builtIn_everyOneSaysWhatItMust()
{
    QMap<QString, QString> texts;
    for (const QString name : {"accredited", "full", "short", "research"}) {
        const Answer answer = run(name, {"--template", name});
        QVERIFY2(answer.exitCode == 0 || answer.exitCode == 1, answer.err);
        const QString first = pages(path(name + "/certificate.pdf"), {"-l", "1"});
        QVERIFY2(first.contains("Key results"), qPrintable(name));
        texts[name] = pages(path(name + "/certificate.pdf"));
        for (const char *words : {"Customer", "Serial number", "Method", "Conditions",
                 "Results in detail", "Frequency response", "Remarks", "Statements",
                 "shall not be reproduced except in full", "Calibrated by", "Approved by"})
            QVERIFY2(texts[name].contains(words), qPrintable(name + ": " + words));
        QCOMPARE(templateOf(name), name);
    }
    QVERIFY(!texts["short"].contains("Model of the sensor"));
    QCOMPARE(figuresOn(texts["short"]), 0);
    QVERIFY(figuresOn(texts["accredited"]) > 4);
    QVERIFY(figuresOn(texts["full"]) > figuresOn(texts["accredited"]));
    QVERIFY(figuresOn(texts["research"]) > figuresOn(texts["full"]));
    QVERIFY(texts["research"].contains("Certificate with research annex"));
}

void TestTemplates::default_isAccredited_andChangesNothing()
{
    run("plain");
    QCOMPARE(bytesBelow(path("plain")), bytesBelow(path("accredited")));
    QVERIFY(!QDir(path("plain/sources")).exists());
}

void TestTemplates::ownFile_isKeptAndRepeated()
{
    putTemplate("lab");
    run("own", {"--template", path("lab/lab.json")});
    const QString text = pages(path("own/certificate.pdf"));
    QVERIFY(text.contains("Certificate of our laboratory"));
    QCOMPARE(figuresOn(text), 1);
    QVERIFY(!text.contains("Magnitude within 5 %"));
    QCOMPARE(QDir(path("own/sources")).entryList(QDir::Files).size(), 2);
    QVERIFY(QFile::exists(path("own/" + templateOf("own"))));
    for (const QByteArray &bytes : bytesBelow(path("own")))
        QVERIFY(!bytes.contains(m_folder.path().toUtf8()));
    // The folder alone is enough to make the same again.
    QVERIFY(QDir(path("lab")).removeRecursively());
    QVERIFY(run("again", {"--recipe", path("own/recipe.json")}).exitCode < 2);
    QCOMPARE(bytesBelow(path("again")), bytesBelow(path("own")));
}

void TestTemplates::ownFile_ofTheRecipe_liesBesideIt()
{
    putTemplate("recipes");
    QVERIFY(writeBytes(path("recipes/r.json"),
        R"({"schema": "dyncal-recipe/1", "certificate": {"template": "lab.json"},
            "uncertainty": {"monte_carlo_trials": 100}})"));
    QVERIFY(run("beside", {"--recipe", path("recipes/r.json")}).exitCode < 2);
    QVERIFY(pages(path("beside/certificate.pdf")).contains("Certificate of our laboratory"));
    QVERIFY(run("other", {"--recipe", path("recipes/r.json"), "--template", "short"}).exitCode < 2);
    QVERIFY(!pages(path("other/certificate.pdf")).contains("Certificate of our laboratory"));
}

void TestTemplates::wrongOnes_areRefusedBeforeAnythingIsWritten()
{
    putTemplate("wrong");
    const auto refused = [&](const QString &name) {
        const Answer answer = run("nothing", {"--template", name});
        return answer.complaints().size() == 1 && !QFile::exists(path("nothing"))
            ? QByteArray::number(answer.exitCode) + ' ' + answer.err
            : "not refused: " + answer.err;
    };
    QByteArray said = refused("fancy");
    QVERIFY2(said.startsWith("4 ") && said.contains("accredited, full, short, research"), said);
    said = refused(path("wrong/none.json"));
    QVERIFY2(said.startsWith("3 ") && said.contains("none.json"), said);
    QVERIFY(writeBytes(path("wrong/little.json"),
        R"({"schema": "dyncal-template/1", "sections": ["administrative", "item", "key-results"]})"));
    said = refused(path("wrong/little.json"));
    QVERIFY2(said.startsWith("4 ") && said.contains("leaves out \"method\""), said);
    QVERIFY(writeBytes(path("wrong/our logo.svg"), "<svg><image href='/etc/hostname'/></svg>"));
    said = refused(path("wrong/lab.json"));
    QVERIFY2(said.startsWith("4 ") && said.contains("our logo.svg"), said);
    QVERIFY(writeBytes(path("wrong/our logo.svg"), "<svg"));
    said = refused(path("wrong/lab.json"));
    QVERIFY2(said.startsWith("4 ") && said.contains("cannot be drawn"), said);
    said = refused("");
    QVERIFY2(said.startsWith("4 "), said);
}

void TestTemplates::twoLanguages_standSideBySide()
{
    QVERIFY(writeBytes(path("two.json"),
        R"({"schema": "dyncal-recipe/1", "certificate": {"languages": ["en", "sv"]}})"));
    QVERIFY(run("two", {"--recipe", path("two.json")}).exitCode < 2);
    const QString text = pages(path("two/certificate.pdf"));
    QVERIFY(text.contains("Customer / Kund"));
    QVERIFY(text.contains("shall not be reproduced except in full"));
    QVERIFY(writeBytes(path("german.json"),
        R"({"schema": "dyncal-recipe/1", "certificate": {"languages": ["en", "de"]}})"));
    QVERIFY(run("german", {"--recipe", path("german.json")}).exitCode < 2);
    QVERIFY(pages(path("german/certificate.pdf")).contains("Customer / Auftraggeber"));
}

void TestTemplates::issued_holdsItsTemplate()
{
    putTemplate("issue");
    const IssuedJob job;
    QVERIFY(job.begin(path("shot.h5")));
    const Answer answer = job.issue({"--template", path("issue/lab.json")});
    QVERIFY2(answer.exitCode == 0, answer.err + answer.out);
    const QString folder = job.output() + "/1";
    QCOMPARE(QDir(folder + "/sources").entryList(QDir::Files).size(), 2);
    const QString text = pages(folder + "/certificate.pdf");
    QVERIFY(text.contains("Certificate of our laboratory") && text.contains("No. 1"));
    QCOMPARE(job.verify({folder}).exitCode, 1); // unsigned
    for (const QByteArray &bytes : bytesBelow(folder))
        QVERIFY(!bytes.contains(m_folder.path().toUtf8()));
    // The same order is the same certificate; another template is another job.
    QCOMPARE(job.issue({"--template", path("issue/lab.json")}).json()["number"].toInt(), 1);
    QCOMPARE(job.issue({"--template", "short"}).exitCode, 4);
    QByteArray damaged = bytesOf(folder + "/sources/"
        + QDir(folder + "/sources").entryList({"*.json"}, QDir::Files).first());
    damaged.replace("phase", "magni");
    QVERIFY(writeBytes(
        folder + "/sources/" + QDir(folder + "/sources").entryList({"*.json"}, QDir::Files).first(),
        damaged));
    QCOMPARE(job.verify({folder}).exitCode, 2);
}

void TestTemplates::issued_unknownName_takesNoNumber()
{
    const IssuedJob job;
    QVERIFY(job.begin(path("shot.h5")));
    QCOMPARE(job.issue({"--template", "fancy"}).exitCode, 4);
    QVERIFY(job.numbers().isEmpty());
    QVERIFY(!QFile::exists(job.output()));
    QCOMPARE(job.issue({"--languages", "sv,en"}).exitCode, 0);
    QVERIFY(pages(job.output() + "/1/certificate.pdf").contains("Kund / Customer"));
}

DYNCAL_TEST(TestTemplates)
#include "tst_templates.moc"
