// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/refusal_note.h"

#include <QAccessible>
#include <QLabel>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kReading_ms = 12000;
constexpr int kWidth_px = 300;
constexpr int kPadding_px = 6;

class RefusalNote : public QLabel
{
public:
    RefusalNote(QWidget *window, QWidget *field)
        : QLabel(window)
        , m_field(field)
    {
        setObjectName("refusalNote");
        setTextFormat(Qt::PlainText);
        setWordWrap(true);
        setAutoFillBackground(true);
        setFrameShape(QFrame::Box);
        setMargin(kPadding_px);
        setForegroundRole(QPalette::ToolTipText);
        setBackgroundRole(QPalette::ToolTipBase);
        QTimer::singleShot(kReading_ms, this, &QObject::deleteLater);
    }
    bool isOf(const QWidget *field) const { return m_field == field; }

    /// Below the field, or above it where the window ends.
    void place()
    {
        const QWidget *window = parentWidget();
        const int width = std::min(kWidth_px, window->width());
        const int inside = width - 2 * (margin() + frameWidth());
        const int height
            = fontMetrics()
                  .boundingRect(0, 0, inside, window->height(), Qt::TextWordWrap, text())
                  .height();
        resize(width, height + 2 * (margin() + frameWidth()));
        const QPoint below = m_field->mapTo(window, QPoint(0, m_field->height()));
        const int x = std::clamp(below.x(), 0, std::max(0, window->width() - width));
        const bool fits = below.y() + this->height() <= window->height();
        move(x, fits ? below.y() : std::max(0, below.y() - m_field->height() - this->height()));
    }

private:
    QPointer<QWidget> m_field;
};

RefusalNote *noteIn(const QWidget *window)
{
    for (QObject *child : window->children())
        if (auto *note = dynamic_cast<RefusalNote *>(child))
            return note;
    return nullptr;
}

} // namespace

void showRefusal(QWidget *field, const QString &sentence)
{
    QWidget *window = field->window();
    delete noteIn(window);
    if (sentence.isEmpty() || window == field)
        return;
    auto *note = new RefusalNote(window, field);
    note->setText(sentence);
    note->place();
    note->show();
    note->raise();
    QAccessibleEvent alert(note, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void hideRefusal(QWidget *field)
{
    RefusalNote *note = noteIn(field->window());
    if (note && note->isOf(field))
        delete note;
}

QString refusalOnShow(const QWidget *field)
{
    const RefusalNote *note = noteIn(field->window());
    return note ? note->text() : QString();
}

} // namespace dyncal
