// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace dyncal {

/// Controls whose words go on in a second line where the inspector is too narrow for them: no
/// language and no size of letters cuts them.
class WrappedCheckBox : public QCheckBox
{
    Q_OBJECT

public:
    explicit WrappedCheckBox(const QString &text, QWidget *parent = nullptr);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    bool hitButton(const QPoint &position) const override { return rect().contains(position); }

private:
    int besideText() const;
};

class WrappedButton : public QPushButton
{
    Q_OBJECT

public:
    explicit WrappedButton(const QString &text, QWidget *parent = nullptr);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    int besideText() const;
};

class WrappedComboBox : public QComboBox
{
    Q_OBJECT

public:
    explicit WrappedComboBox(QWidget *parent = nullptr);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QRect textRect(const QRect &all) const;
};

/// Words in one line as long as there is room, else in several; never narrower than its longest
/// word.
class FormLabel : public QLabel
{
    Q_OBJECT

public:
    explicit FormLabel(const QString &text, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
};

/// What to type, in a field that is wide enough to show it whole.
void setWholePlaceholder(QLineEdit &field, const QString &text);

/// A row whose label goes above its field where both have no room.
void addWrappedRow(QFormLayout &form, const QString &label, QWidget *field);

} // namespace dyncal
