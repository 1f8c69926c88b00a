// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/project/template_choice.h"

#include <QImage>

#include <memory>

class QPainter;
class QRectF;
class QSvgRenderer;

namespace dyncal {

/// The laboratory's picture, ready to be drawn: an SVG as vectors, a PNG on white, so that the
/// document has no transparency.
class ReportLogo
{
public:
    explicit ReportLogo(const CertificateLogo &logo);

    bool isDrawable() const;
    /// Into the right end of the area, as large as fits.
    void draw(QPainter &painter, const QRectF &area) const;

private:
    QSizeF size() const;

    QImage m_image;
    std::shared_ptr<QSvgRenderer> m_drawing;
};

/// chooseTemplate() for whoever draws with it. Fails (Usage) also where Qt cannot draw its logo.
Result<ChosenTemplate> drawableTemplate(const std::string &name);

} // namespace dyncal
