// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QGenericPlugin>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QSocketNotifier>
#include <QTableWidget>
#include <QTest>

#include <cstdio>
#include <unistd.h>

/// Operates the built program: a Qt plugin that is loaded by an environment variable
/// (QT_QPA_GENERIC_PLUGINS). It takes one command a line from stdin and answers with one line.
///   title                the title of the window, with the mark of unsaved changes
///   text NAME            the text of a label or line edit; "-" if it is not on show
///   list NAME            all items of a list or table, in one line
///   click NAME           presses a button
///   trigger NAME         chooses an action of a menu
///   start NAME           chooses an action or presses a button, not waiting for the dialog that
///   opens accept               presses OK in a message box; answers its text, or "-" without a box
///   type NAME WORDS      replaces the text of a line edit and presses Return
///   key KEYS             presses a shortcut, such as Alt+9
class WindowDriver : public QObject
{
    Q_OBJECT

public:
    WindowDriver()
        : m_input(STDIN_FILENO, QSocketNotifier::Read)
    {
        connect(&m_input, &QSocketNotifier::activated, this, &WindowDriver::read);
    }

private:
    void read()
    {
        char bytes[4096];
        const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof bytes);
        if (count <= 0) {
            m_input.setEnabled(false);
            return;
        }
        m_read.append(bytes, count);
        for (qsizetype end = m_read.indexOf('\n'); end >= 0; end = m_read.indexOf('\n')) {
            const QString line = QString::fromUtf8(m_read.left(end));
            m_read.remove(0, end + 1);
            const QByteArray answer
                = obey(line.section(' ', 0, 0), line.section(' ', 1, 1), line.section(' ', 2));
            std::printf("%s\n", answer.constData());
            std::fflush(stdout);
        }
    }

    static QWidget *window()
    {
        for (QWidget *widget : QApplication::topLevelWidgets())
            if (widget->objectName() == QLatin1String("mainWindow"))
                return widget;
        return nullptr;
    }

    static QByteArray obey(const QString &verb, const QString &name, const QString &words)
    {
        QWidget *top = window();
        if (!top)
            return "-";
        if (verb == "title")
            return (top->windowTitle() + (top->isWindowModified() ? " modified" : "")).toUtf8();
        if (verb == "accept")
            return acceptBox().toUtf8();
        if (verb == "key") {
            QTest::keySequence(top, QKeySequence(name));
            return "done";
        }
        if (auto *action = top->findChild<QAction *>(name); verb == "trigger" && action) {
            action->trigger();
            return "done";
        }
        if (auto *action = top->findChild<QAction *>(name); verb == "start" && action) {
            QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
            return "done";
        }
        auto *widget = top->findChild<QWidget *>(name);
        if (!widget || !widget->isVisible())
            return "-";
        if (verb == "list")
            return itemsOf(widget).toUtf8();
        if (verb == "text")
            return textOf(widget).toUtf8();
        if (auto *button = qobject_cast<QAbstractButton *>(widget); verb == "start" && button)
            QMetaObject::invokeMethod(button, &QAbstractButton::click, Qt::QueuedConnection);
        else if (button && verb == "click")
            button->click();
        else if (auto *edit = qobject_cast<QLineEdit *>(widget); verb == "type" && edit)
            type(edit, words);
        else
            return "-";
        return "done";
    }

    static QString acceptBox()
    {
        for (QWidget *widget : QApplication::topLevelWidgets()) {
            auto *box = qobject_cast<QMessageBox *>(widget);
            if (!box || !box->isVisible())
                continue;
            QMetaObject::invokeMethod(box, &QDialog::accept, Qt::QueuedConnection);
            return box->text().simplified();
        }
        return QStringLiteral("-");
    }

    static QString textOf(QWidget *widget)
    {
        if (const auto *label = qobject_cast<QLabel *>(widget))
            return label->text();
        const auto *edit = qobject_cast<QLineEdit *>(widget);
        return edit ? edit->text() : QString("-");
    }

    static QString itemsOf(const QWidget *widget)
    {
        QStringList items;
        const auto *list = qobject_cast<const QListWidget *>(widget);
        for (int i = 0; list && i < list->count(); ++i)
            items << list->item(i)->text().simplified();
        const auto *table = qobject_cast<const QTableWidget *>(widget);
        for (int i = 0; table && i < table->rowCount() * table->columnCount(); ++i)
            if (const auto *item = table->item(i / table->columnCount(), i % table->columnCount()))
                items << item->text().simplified();
        return items.join(" | ");
    }

    static void type(QLineEdit *edit, const QString &words)
    {
        edit->selectAll();
        QTest::keyClicks(edit, words);
        QTest::keyClick(edit, Qt::Key_Return);
    }

    QSocketNotifier m_input;
    QByteArray m_read;
};

class WindowDriverPlugin : public QGenericPlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "window_driver.json")

public:
    QObject *create(const QString &, const QString &) override { return new WindowDriver; }
};

#include "window_driver.moc"
