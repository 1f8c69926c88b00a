// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/preview_panel.h"

#include "core/results/publication.h"
#include "ui/report/report_logo.h"
#include "ui/stages/certificate/page_images.h"
#include "ui/stages/certificate/page_stack.h"
#include "ui/stages/frame/layout_scale.h"
#include "ui/text/core_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

using namespace std::chrono_literals;

constexpr auto kAfterAChange = 300ms; ///< a word is typed faster
constexpr auto kAfterAResize = 150ms;
constexpr int kLeastColumns = 28; ///< letters
constexpr int kLeastRows = 14;
constexpr double kWidthOfA4_inch = 210.0 / 25.4;
/// In percent of the paper; 0: as wide as there is room.
constexpr std::array<int, 5> kZooms{0, 75, 100, 150, 200};

} // namespace

PreviewPanel::PreviewPanel(Session &session, CurrentUtc currentUtc, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_currentUtc(std::move(currentUtc))
    , m_note(new QLabel(this))
    , m_zoom(new QComboBox(this))
    , m_scroll(new QScrollArea(this))
    , m_stack(new PageStack)
    , m_drawing(this)
    , m_rendering(this)
{
    setObjectName("certificatePreview");
    m_stack->setObjectName("previewPages");
    setMinimumSize(
        kLeastColumns * fontMetrics().averageCharWidth(), kLeastRows * fontMetrics().lineSpacing());
    m_note->setObjectName("previewNote");
    m_note->setWordWrap(true);
    m_zoom->setObjectName("previewZoom");
    m_zoom->setAccessibleName(tr("Size of the preview"));
    for (const int percent : kZooms)
        m_zoom->addItem(percent == 0 ? tr("Page width") : tr("%1 %").arg(percent), percent);
    m_scroll->setObjectName("previewScroll");
    m_scroll->setWidget(m_stack);
    m_scroll->viewport()->installEventFilter(this);
    m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // the width decides the height
    auto *head = new QHBoxLayout;
    head->addWidget(m_note, 1);
    head->addWidget(m_zoom);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(head);
    column->addWidget(m_scroll, 1);
    m_wait.setSingleShot(true);
    m_settle.setSingleShot(true);
    connect(&m_wait, &QTimer::timeout, this, &PreviewPanel::draw);
    connect(&m_settle, &QTimer::timeout, this, &PreviewPanel::showPages);
    connect(m_zoom, &QComboBox::activated, this, &PreviewPanel::showPages);
    connect(m_scroll->verticalScrollBar(), &QScrollBar::valueChanged, this, &PreviewPanel::sayPage);
    connect(&m_drawing, &DrawingSteps::drawn, this, &PreviewPanel::take);
    connect(&m_drawing, &DrawingSteps::failed, this,
        [this](const Error &error) { say(translated(error.message)); });
}

bool PreviewPanel::isCurrent() const
{
    return !m_pdf.empty() && !m_wait.isActive() && !m_drawing.isRunning()
        && !m_rendering.isRunning() && !m_stack->isPale();
}

void PreviewPanel::follow()
{
    m_drawing.cancel();
    m_rendering.cancel();
    m_stack->setPale(true);
    m_wait.start(kAfterAChange);
    emit outdated();
}

void PreviewPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_wait.stop();
    m_drawing.cancel();
    m_rendering.cancel();
}

/// What an export would be refused for; empty: nothing.
QString PreviewPanel::refusal() const
{
    if (!m_session.isUpToDate()) // its results will come with another follow()
        return tr("The document follows when the results are computed.");
    const std::optional<Error> obstacle
        = publicationObstacle({m_session.results(), m_session.error(), m_session.failedStage()});
    if (obstacle)
        return translated(obstacle->message);
    const Result<void> memory = DrawingSteps::checkMemory();
    return memory ? QString() : translated(memory.error().message);
}

void PreviewPanel::draw()
{
    if (const QString why = refusal(); !why.isEmpty()) {
        say(why);
        return;
    }
    const Recipe &recipe = m_session.recipe();
    const Result<ChosenTemplate> chosen = drawableTemplate(recipe.certificate.templateName);
    const Result<std::string> now = m_currentUtc();
    if (!chosen || !now) {
        say(translated(chosen ? now.error().message : chosen.error().message));
        return;
    }
    say(tr("The document is being drawn..."));
    m_drawing.start(std::make_unique<ReportDrawing>(
        m_session.results(), recipe, *now, ReportParts::Certificate, *chosen));
    emit begun(*now, *chosen);
}

void PreviewPanel::take(const std::vector<DrawnFile> &files)
{
    if (files.empty())
        return;
    m_pdf = files.front().bytes;
    m_shownWidth = 0;
    showPages();
}

/// As many pixels as a page is to be wide, and no scroll bar hides any.
int PreviewPanel::pageWidth() const
{
    const int percent = m_zoom->currentData().toInt();
    return percent == 0 ? m_scroll->viewport()->width()
                        : static_cast<int>(kWidthOfA4_inch * logicalDpiX() * percent / 100.0);
}

void PreviewPanel::showPages()
{
    const int width = std::max(pageWidth(), 1);
    m_stack->resize(width, std::max(m_stack->heightOfPages(width), 1));
    if (m_pdf.empty() || m_drawing.isRunning() || width == m_shownWidth)
        return;
    const int pixels = static_cast<int>(width * devicePixelRatioF());
    m_rendering.start<std::vector<QImage>>(
        [pdf = m_pdf, pixels](
            const JobControl &control) { return pageImages(pdf, pixels, control); },
        [this, width](Result<std::vector<QImage>> pages) {
            if (!pages) {
                say(translated(pages.error().message));
                return;
            }
            m_shownWidth = width;
            m_stack->setPages(std::move(*pages));
            m_stack->resize(width, m_stack->heightOfPages(width));
            m_stack->setPale(m_wait.isActive());
            sayPage();
        });
}

void PreviewPanel::say(const QString &text)
{
    m_note->setText(text);
}

void PreviewPanel::sayPage()
{
    if (m_stack->isPale() || m_stack->pageCount() == 0)
        return;
    // From the first line at the top to the last one at the bottom.
    const QScrollBar *bar = m_scroll->verticalScrollBar();
    const int most = std::max(bar->maximum(), 1);
    const int at = bar->value() + m_scroll->viewport()->height() * bar->value() / most;
    say(tr("Page %1 of %2, as it would be exported now")
            .arg(m_stack->pageAt(at) + 1)
            .arg(m_stack->pageCount()));
}

void PreviewPanel::setZoom(int step)
{
    const int next = std::clamp(m_zoom->currentIndex() + step, 0, m_zoom->count() - 1);
    m_zoom->setCurrentIndex(next);
    showPages();
}

/// Control and the wheel change the size, as in other programs that show pages.
bool PreviewPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        m_settle.start(kAfterAResize);
    if (event->type() != QEvent::Wheel)
        return QWidget::eventFilter(watched, event);
    const auto *wheel = static_cast<QWheelEvent *>(event);
    if (!(wheel->modifiers() & Qt::ControlModifier))
        return false;
    setZoom(wheel->angleDelta().y() > 0 ? 1 : -1);
    return true;
}

void PreviewPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (m_zoom->currentData().toInt() == 0)
        m_stack->resize(m_scroll->viewport()->width(), m_stack->height());
}

} // namespace dyncal
