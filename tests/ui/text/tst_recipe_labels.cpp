// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/recipe_labels.h"

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

using namespace dyncal;

namespace {

QString contentOf(const QString &path)
{
    QFile file(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/" + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The first column of the table of keys in docs/recipe.md.
QStringList recipeKeys()
{
    const QString page = contentOf("docs/recipe.md");
    const QString keys = page.mid(page.indexOf("\n## Keys")).section("\n## ", 1, 1);
    static const QRegularExpression row("^\\| `([^`]+)` \\|", QRegularExpression::MultilineOption);
    QStringList found;
    for (auto match = row.globalMatch(keys); match.hasNext();)
        found << match.next().captured(1);
    return found;
}

struct Sentence
{
    QByteArray source;
    QString swedish;
    bool ofCore = false;
};

/// All sentences of the program, as the translators have them.
std::vector<Sentence> sentences()
{
    std::vector<Sentence> found;
    const QString catalogue = contentOf("translations/dyncal_sv.ts");
    QXmlStreamReader xml(catalogue);
    bool ofCore = false;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == QLatin1String("name"))
            ofCore = xml.readElementText() == QLatin1String("core");
        else if (xml.name() == QLatin1String("source"))
            found.push_back({xml.readElementText().toUtf8(), {}, ofCore});
        else if (xml.name() == QLatin1String("translation") && !found.empty())
            found.back().swedish = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    }
    return found;
}

/// The keys that are no ordinary words, and their last parts where these are none.
QStringList wordsOfKeys()
{
    QStringList words;
    for (const QString &key : recipeKeys()) {
        if (key.contains('.'))
            words << key;
        if (key.section('.', -1).contains('_'))
            words << key.section('.', -1);
    }
    words.removeDuplicates();
    return words;
}

/// Any of them, as a word of its own.
QRegularExpression anyOf(QStringList words)
{
    for (QString &word : words)
        word = QRegularExpression::escape(word);
    const QString inside = QStringLiteral("[A-Za-z0-9_]");
    return QRegularExpression(
        QStringLiteral("(?<!%1)(?<!%1\\.)(?:%2)(?!%1)").arg(inside, words.join('|')));
}

/// The first of them in a sentence; empty if there is none.
QString keyIn(const QString &sentence, const QRegularExpression &words)
{
    return words.match(sentence).captured();
}

} // namespace

/// The window speaks of its fields, never of the recipe's keys.
class TestRecipeLabels : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void everyKey_hasALabel();
    void everySentence_isFreeOfKeys();
    void sentence_namesTheField();
    void foreignWords_stay();
    void swedishNumbers_haveAComma();
    void swedishTerms_areOne();
};

void TestRecipeLabels::everyKey_hasALabel()
{
    const QStringList keys = recipeKeys();
    QVERIFY(keys.size() > 100);
    const auto check = [&] {
        const QRegularExpression words = anyOf(wordsOfKeys());
        for (const QString &key : keys) {
            const QString label = recipeLabel(key);
            QVERIFY2(!label.isEmpty(), qPrintable(key));
            QVERIFY2(keyIn(label, words).isEmpty(), qPrintable(label));
        }
        QCOMPARE(recipeLabel("import.exclude[12].shot"), recipeLabel("import.exclude[].shot"));
        QCOMPARE(recipeLabel("import.channels{DUT 1}.unit"), recipeLabel("import.channels{}.unit"));
        QCOMPARE(recipeLabel("window.endd_s"), QString());
    };
    check();
    const test::InSwedish swedish;
    check();
    QCOMPARE(recipeLabel("shock.velocity_m_s"), QString("stötvågens hastighet"));
}

void TestRecipeLabels::everySentence_isFreeOfKeys()
{
    const QRegularExpression words = anyOf(wordsOfKeys());
    const auto all = sentences();
    const auto check = [&] {
        int ofCore = 0;
        for (const Sentence &sentence : all) {
            if (!sentence.ofCore)
                continue;
            ++ofCore;
            const QString shown = translated({sentence.source.constData(), {}});
            QVERIFY2(
                keyIn(shown, words).isEmpty(), qPrintable(keyIn(shown, words) + " in: " + shown));
        }
        QVERIFY(ofCore > 300);
    };
    check();
    for (const Sentence &sentence : all) {
        if (sentence.ofCore)
            continue;
        QVERIFY2(keyIn(QString::fromUtf8(sentence.source), words).isEmpty(),
            sentence.source.constData());
        QVERIFY2(keyIn(sentence.swedish, words).isEmpty(), qPrintable(sentence.swedish));
    }
    const test::InSwedish swedish;
    check();
}

void TestRecipeLabels::sentence_namesTheField()
{
    const Message message{
        "Shot %1: the window ends %2 after the computed end of the plateau, %3 behind the start; move window.end_s.",
        {"2", "1.5 ms", "8.25 ms"}};
    QCOMPARE(translated(message),
        QString("Shot 2: the window ends 1.5 ms after the computed end of the plateau, 8.25 ms "
                "behind the start; move “end of the window”."));
    // What core writes for files and for the terminal keeps the key.
    QVERIFY(english(message).ends_with("move window.end_s."));
    QVERIFY(printed(message).endsWith("move window.end_s."));
    QCOMPARE(withRecipeLabels("See recipe.json and www.window.end_sx, or window.start."),
        QString("See recipe.json and www.window.end_sx, or “start”."));
}

void TestRecipeLabels::foreignWords_stay()
{
    // A channel may be called as a key is, or look like a number with a point.
    const Message message{
        "Channel '%1' of %2 in version %3.", {"window.end_s", "1.5.csv", "2.0.1"}};
    const QString as = "Channel 'window.end_s' of 1.5.csv in version 2.0.1.";
    QCOMPARE(translated(message), as);
    const test::InSwedish swedish;
    QCOMPARE(translated(message), as);
}

void TestRecipeLabels::swedishNumbers_haveAComma()
{
    const test::InSwedish swedish;
    for (const auto &[written, shown] : {std::pair("1.5 ms", "1,5 ms"), std::pair("-2.25", "-2,25"),
             std::pair("1.2e-05", "1,2e-05"), std::pair("99.9 %", "99,9 %"),
             std::pair("46.7 µV", "46,7 µV"), std::pair("5.02 µV/Pa", "5,02 µV/Pa"),
             std::pair("0.1 kHz to 2.5 MHz", "0,1 kHz to 2,5 MHz"), std::pair("2.0.1", "2.0.1"),
             std::pair("0.5.csv", "0.5.csv"), std::pair("7", "7")}) {
        const Message message{"%1", {written}};
        QCOMPARE(translated(message), QString::fromUtf8(shown));
        QCOMPARE(printed(message), QString::fromUtf8(written));
    }
    Finding finding{.id = "CAP-009"};
    finding.message = {"Shot %1: noise of %2.", {"1", "46.7 µV"}};
    QVERIFY(findingLine(finding).endsWith("46,7 µV."));
}

void TestRecipeLabels::swedishTerms_areOne()
{
    static const QRegularExpression variants(
        QStringLiteral("chockvåg|chockrör|stötfront|samplingshastighet|samplingstakt|"
                       "sampelfrekvens|samplingsrat|\\bsensor(n|er|erna|ns|s)?\\b"),
        QRegularExpression::CaseInsensitiveOption);
    int terms = 0;
    for (const Sentence &sentence : sentences()) {
        const auto match = variants.match(sentence.swedish);
        QVERIFY2(!match.hasMatch(), qPrintable(sentence.swedish));
        for (const char *term : {"stötvåg", "stötrör", "givare", "samplingsfrekvens"})
            terms += sentence.swedish.contains(QString::fromUtf8(term), Qt::CaseInsensitive);
    }
    QVERIFY(terms > 40);
}

DYNCAL_TEST(TestRecipeLabels)
#include "tst_recipe_labels.moc"
