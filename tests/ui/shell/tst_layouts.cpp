// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/support/layout_faults.h"
#include "tests/ui/support/long_words.h"
#include "tests/ui/support/still.h"
#include "ui/session/example.h"
#include "ui/shell/main_window.h"
#include "ui/shell/preferences/theme_style.h"
#include "ui/stages/frame/stage_page.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr double kDuration_s = 0.006; ///< a third of the full example
constexpr int kPatience_ms = 120'000;
constexpr QSize kSizes[] = {{1280, 720}, {1600, 1000}};

/// One way to look at the program.
struct Look
{
    QString language; ///< "long": the words of a language that is 40 % longer than English
    int font_percent = 100;
    ThemeKind theme = ThemeKind::Light;

    QString name() const
    {
        return QString("%1 %2 %3").arg(language).arg(font_percent).arg(themeName(theme));
    }
};

std::vector<Look> looks()
{
    std::vector<Look> all;
    for (const QString &language : {QString("en"), QString("sv"), QString("long")})
        for (const int percent : {100, 150, 200})
            for (const ThemeKind theme : kThemeKinds)
                all.push_back({language, percent, theme});
    if (trials::count(0, 1) > 0)
        return all;
    return {{"en", 100, ThemeKind::Light}, {"sv", 200, ThemeKind::HighContrast},
        {"long", 150, ThemeKind::Dark}};
}

/// The pipeline with one cache for all windows: what one computed is there for the next.
Session::Pipeline sharedPipeline(const std::shared_ptr<ResultCache> &cache)
{
    return [cache](const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
               ResultCache &, StageId last, const JobControl &control) {
        return runPipeline(captures, recipe, *cache, last, control);
    };
}

/// A plot that was drawn may ask for more room, and so on; a title tells how far a reading is.
void waitUntilLaidOut(const MainWindow &window)
{
    const auto look = [&window] {
        QList<QRect> places;
        QStringList titles;
        for (const PlotWidget *plot : window.findChildren<PlotWidget *>()) {
            if (!plot->isVisible())
                continue;
            places << plot->geometry() << plot->axesRect();
            titles << plot->content().title;
        }
        return std::pair(places, titles);
    };
    test::waitUntilStill(look, kPatience_ms);
}

/// Gives every shot its own record once more, as that of a reference transducer with 94 % of the
/// sensitivity, so that step and transducer contradict each other; and the recipe for it.
Recipe withReference(CaptureSet &set)
{
    for (Shot &shot : set.shots) {
        Channel reference = *shot.channelWithRole(ChannelRole::Dut);
        reference.name = "Reference";
        reference.role = ChannelRole::Reference;
        shot.channels.push_back(std::move(reference));
    }
    Recipe recipe;
    recipe.comparison.enabled = true;
    recipe.comparison.model = {4.7e-6, 1e-8, 2.33e6, 1e3, 0.02, 0.001};
    recipe.uncertainty.cmc = {{"sensitivity", 0.02}, {"magnitude", 0.02, true, 1e3, 1e5}};
    recipe.certificate.decision = DecisionSettings{DecisionRule::GuardBand, 10.0, 2e3, 1e5};
    return recipe;
}

/// What of the window cannot be read before anything is open.
QStringList startPageFaults(MainWindow &window)
{
    QStringList faults;
    for (const QSize &size : kSizes) {
        window.resize(size);
        QTest::qWait(40);
        const test::LayoutFaults found(window);
        for (const QString &fault : found.found())
            faults << QString("%1x%2 start: ").arg(size.width()).arg(size.height()) + fault;
    }
    return faults;
}

} // namespace

/// Every page with the example computed, as it stands on small and large screens, in short and long
/// languages, with large letters, in every theme.
class TestLayouts : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup();
    void longWords_are40PercentLonger();
    void pages_everyLook_canBeRead_data();
    void pages_everyLook_canBeRead();

private:
    std::shared_ptr<const CaptureSet> m_example;
    Recipe m_recipe; ///< compares, claims and has a CMC, so that no page is empty
    std::shared_ptr<ResultCache> m_cache = std::make_shared<ResultCache>();
    QFont m_font;
};

void TestLayouts::initTestCase()
{
    m_font = QApplication::font();
    auto example = exampleCaptures({}, kDuration_s);
    QVERIFY(example);
    m_recipe = withReference(*example);
    m_example = std::make_shared<const CaptureSet>(std::move(*example));
}

void TestLayouts::cleanup()
{
    QApplication::setFont(m_font);
}

void TestLayouts::longWords_are40PercentLonger()
{
    QCOMPARE(test::LongWords::longer("Open %1 of <b>four</b> files"),
        QString::fromUtf8("Öpénéé %1 öfé <b>föüréé</b> fïléséé"));
}

void TestLayouts::pages_everyLook_canBeRead_data()
{
    QTest::addColumn<int>("number");
    const std::vector<Look> all = looks();
    for (std::size_t i = 0; i < all.size(); ++i)
        QTest::newRow(qPrintable(all[i].name())) << static_cast<int>(i);
}

void TestLayouts::pages_everyLook_canBeRead()
{
    QFETCH(int, number);
    const Look look = looks()[static_cast<std::size_t>(number)];
    useTheme(look.theme);
    QFont font = m_font;
    font.setPointSizeF(m_font.pointSizeF() * look.font_percent / 100.0);
    QApplication::setFont(font);
    const QTemporaryDir folder;
    Preferences preferences(folder.filePath("settings.ini"));
    Prompts prompts;
    prompts.setScripted();
    Language language;
    language.install(look.language == "sv" ? "sv" : "en");
    test::LongWords longWords;
    if (look.language == "long")
        QCoreApplication::installTranslator(&longWords);
    const auto noon = [] { return Result<std::string>("2026-01-31T12:00:00Z"); };
    MainWindow window(sharedPipeline(m_cache), noon, preferences, prompts, language);
    window.show();
    QStringList faults = startPageFaults(window);
    window.session().reset({m_example, m_recipe});
    QTRY_VERIFY_WITH_TIMEOUT(!window.session().isComputing(), kPatience_ms);
    QVERIFY(!window.session().error());

    for (const QSize &size : kSizes) {
        window.resize(size);
        for (std::size_t row = 0; row < window.pages().size(); ++row) {
            window.showPage(static_cast<int>(row));
            waitUntilLaidOut(window);
            const QString place = QString("%1x%2 %3")
                                      .arg(window.width())
                                      .arg(window.height())
                                      .arg(window.pages()[row]->objectName());
            const test::LayoutFaults found(window);
            for (const QString &fault : found.found())
                faults << place + ": " + fault;
            if (const QString shots = qEnvironmentVariable("DYNCAL_SHOTS"); !shots.isEmpty())
                window.grab().save(QString("%1/%2 %3.png").arg(shots, look.name(), place));
        }
    }
    QCoreApplication::removeTranslator(&longWords);
    for (const QString &fault : faults)
        qInfo().noquote() << fault; // a message of a check is shortened
    QCOMPARE(faults.size(), 0);
}

DYNCAL_TEST(TestLayouts)
#include "tst_layouts.moc"
