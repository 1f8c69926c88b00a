// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/capture_filter.h"

#include "core/capture/opening/format_registry.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace dyncal {

QString captureFilter()
{
    QStringList patterns;
    for (const CaptureFormat &format : captureFormats())
        for (const std::string &extension : format.extensions)
            patterns << "*." + rawText(extension);
    patterns.removeDuplicates();
    return QCoreApplication::translate("dyncal::FileActions", "Recordings (%1)")
               .arg(patterns.join(' '))
        + ";;" + QCoreApplication::translate("dyncal::FileActions", "All files (*)");
}

} // namespace dyncal
