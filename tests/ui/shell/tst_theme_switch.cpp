// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "tests/support/allocated_memory.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/shell/window_bench.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/session/example.h"
#include "ui/shell/preferences/theme_style.h"
#include "ui/stages/frame/stage_page.h"

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyleOption>
#include <QtTest>

#include <map>

using namespace dyncal;

namespace {

constexpr double kDuration_s = 0.006;
constexpr int kPatience_ms = 120'000;
constexpr QSize kSize(1400, 900);

/// A steep edge of a record is drawn a pixel to the left or right, as the plot came to its width.
constexpr double kMostOther = 1e-3;

double otherPixels(const QImage &a, const QImage &b)
{
    if (a.size() != b.size())
        return 1.0;
    int others = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            others += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return static_cast<double>(others) / static_cast<double>(a.width() * a.height());
}

} // namespace

/// A theme chosen while the program runs looks like one chosen before it was started.
class TestThemeSwitch : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void switched_looksLikeStarted_data();
    void switched_looksLikeStarted();
    void picturesOfTheStyle_areNotKept();
    void cleanup() { useTheme(ThemeKind::Light); }

private:
    std::unique_ptr<test::WindowBench> opened() const
    {
        auto bench = std::make_unique<test::WindowBench>(
            [cache = m_cache](const std::shared_ptr<const CaptureSet> &captures,
                const Recipe &recipe, ResultCache &, StageId last, const JobControl &control) {
                return runPipeline(captures, recipe, *cache, last, control);
            });
        bench->window->resize(kSize);
        bench->window->show();
        bench->window->session().reset({m_example, {}});
        return bench;
    }
    /// The picture that does not change any more: a page is laid out again when plots know their
    /// room.
    static QImage atRest(MainWindow &window)
    {
        constexpr int kMostTries = 40;
        QImage last;
        for (int i = 0; i < kMostTries; ++i) {
            QTest::qWait(100);
            QImage now = window.grab().toImage();
            if (now == last)
                return now;
            last = std::move(now);
        }
        return last;
    }
    /// Every page, long enough to be drawn.
    static void visitPages(MainWindow &window)
    {
        for (std::size_t page = 0; page < window.pages().size(); ++page) {
            window.showPage(static_cast<int>(page));
            QTest::qWait(50);
        }
    }
    static std::vector<QImage> pictures(MainWindow &window)
    {
        std::vector<QImage> all;
        for (std::size_t page = 0; page < window.pages().size(); ++page) {
            window.showPage(static_cast<int>(page));
            if (QWidget *focused = window.focusWidget())
                focused->clearFocus(); // a cursor that blinks
            all.push_back(atRest(window));
        }
        return all;
    }

    std::shared_ptr<const CaptureSet> m_example;
    std::shared_ptr<ResultCache> m_cache = std::make_shared<ResultCache>();
    std::map<int, std::vector<QImage>> m_started; ///< by theme, of a window started in it
};

void TestThemeSwitch::initTestCase()
{
    auto example = exampleCaptures({}, kDuration_s);
    QVERIFY(example);
    m_example = std::make_shared<const CaptureSet>(std::move(*example));
}

void TestThemeSwitch::switched_looksLikeStarted_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    const auto switches = static_cast<std::size_t>(trials::count(2, std::ssize(kThemeKinds)));
    for (std::size_t i = 0; i < switches; ++i) {
        const ThemeKind from = kThemeKinds[i];
        const ThemeKind to = kThemeKinds[(i + 1) % std::size(kThemeKinds)];
        QTest::addRow("%s to %s", qPrintable(themeName(from)), qPrintable(themeName(to)))
            << static_cast<int>(from) << static_cast<int>(to);
    }
}

void TestThemeSwitch::switched_looksLikeStarted()
{
    QFETCH(int, from);
    QFETCH(int, to);
    useTheme(static_cast<ThemeKind>(from));
    auto bench = opened();
    QTRY_VERIFY_WITH_TIMEOUT(!bench->window->session().isComputing(), kPatience_ms);
    if (m_started.contains(from))
        visitPages(*bench->window);
    else
        m_started[from] = pictures(*bench->window);
    bench->find<QAction>("themeAction_" + themeName(static_cast<ThemeKind>(to)))->trigger();
    const std::vector<QImage> switched = pictures(*bench->window);
    if (!m_started.contains(to)) {
        bench = opened();
        QTRY_VERIFY_WITH_TIMEOUT(!bench->window->session().isComputing(), kPatience_ms);
        m_started[to] = pictures(*bench->window);
    }
    const std::vector<QImage> &started = m_started[to];
    for (std::size_t page = 0; page < started.size(); ++page) {
        QVERIFY(m_started[from][page] != switched[page]);
        if (const QString shots = qEnvironmentVariable("DYNCAL_SHOTS");
            !shots.isEmpty() && switched[page] != started[page]) {
            switched[page].save(QString("%1/theme %2 switched.png").arg(shots).arg(page));
            started[page].save(QString("%1/theme %2 started.png").arg(shots).arg(page));
        }
        const double share = otherPixels(switched[page], started[page]);
        QVERIFY2(share < kMostOther, qPrintable(QString("page %1: %2").arg(page).arg(share)));
    }
}

/// Fusion keeps a picture of every control in every size that it ever had.
void TestThemeSwitch::picturesOfTheStyle_areNotKept()
{
    constexpr double kMost_MiB = 0.5; // 11.5 where they are kept, 4 where just their names are
    useTheme(ThemeKind::Light);
    const double before_MiB = testing::allocated_MiB();
    QImage picture(1000, 100, QImage::Format_ARGB32_Premultiplied);
    for (int width = 40; width < 1000; ++width) {
        QPainter painter(&picture);
        QStyleOptionComboBox option;
        option.rect = QRect(0, 0, width, 30);
        option.state = QStyle::State_Enabled;
        option.subControls = QStyle::SC_All;
        QApplication::style()->drawComplexControl(QStyle::CC_ComboBox, &option, &painter);
    }
    const double kept_MiB = testing::allocated_MiB() - before_MiB;
    QVERIFY2(kept_MiB < kMost_MiB, qPrintable(QString::number(kept_MiB)));
}

DYNCAL_TEST(TestThemeSwitch)
#include "tst_theme_switch.moc"
