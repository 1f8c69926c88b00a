// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "ui/report/page_flow.h"
#include "ui/report/report_figures.h"

namespace dyncal {

/// Fonts and colours of the certificate; sizes in pixels of a 96 dpi page, all colours opaque.
struct CertificateStyle
{
    QFont title, heading, body, bold, table, tableBold, small, mark;
    QColor text{"#111111"};
    QColor quiet{"#555555"};
    QColor rule{"#999999"};
    QColor tableHead{"#EEF1F4"};
    QColor missing{"#B00020"};
    QColor draftMark{"#EBEBEB"};

    CertificateStyle();
};

/// The certificate as blocks, in order, for a text area of the given width.
std::vector<FlowBlock> certificateBlocks(const CertificateData &data,
    const std::vector<ReportFigure> &figures, const CertificateStyle &style, double width,
    QPaintDevice *device);

/// Widths of table columns that sum to `width`: in proportion to the natural ones if these fit;
/// else each column keeps the width of its longest word (`least`), and what is above that shrinks
/// in proportion. `natural` >= `least`, both positive.
std::vector<double> columnWidths(
    const std::vector<double> &natural, const std::vector<double> &least, double width);

} // namespace dyncal
