// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/core_text.h"

#include <QCoreApplication>

namespace dyncal {

QString translated(const Message &message)
{
    const QString text = QCoreApplication::translate("core", message.text);
    return QString::fromStdString(fillPlaces(text.toStdString(), message.arguments));
}

} // namespace dyncal
