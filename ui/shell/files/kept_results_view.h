// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/kept_results.h"

#include <QDialog>

class QTreeWidget;
class QTreeWidgetItem;

namespace dyncal {

/// What a project kept of its results, section by section: to be read, while its recordings are
/// missing. A window of its own, beside which work goes on.
class KeptResultsView : public QDialog
{
    Q_OBJECT

public:
    KeptResultsView(const KeptResults &kept, const QString &project, QWidget *parent);

private:
    void addSection(const CertificateSection &section);
    void fitColumns();
    static void addTable(QTreeWidgetItem *parent, const CertificateTable &table);

    KeptResults m_kept;
    QTreeWidget *m_tree;
};

} // namespace dyncal
