// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_logo.h"

#include <QPainter>
#include <QSvgRenderer>

namespace dyncal {
namespace {

QByteArray bytesOf(const CertificateLogo &logo)
{
    return {logo.bytes.data(), static_cast<qsizetype>(logo.bytes.size())};
}

QImage onWhite(const QImage &image)
{
    if (image.isNull())
        return {};
    QImage opaque(image.size(), QImage::Format_RGB32);
    opaque.fill(Qt::white);
    QPainter painter(&opaque);
    painter.drawImage(0, 0, image);
    return opaque;
}

} // namespace

ReportLogo::ReportLogo(const CertificateLogo &logo)
{
    if (logo.isSvg)
        m_drawing = std::make_shared<QSvgRenderer>(bytesOf(logo));
    else
        m_image = onWhite(QImage::fromData(bytesOf(logo), "PNG"));
}

QSizeF ReportLogo::size() const
{
    return m_drawing ? m_drawing->viewBoxF().size() : QSizeF(m_image.size());
}

bool ReportLogo::isDrawable() const
{
    return (!m_drawing || m_drawing->isValid()) && !size().isEmpty();
}

void ReportLogo::draw(QPainter &painter, const QRectF &area) const
{
    const QSizeF fitting = size().scaled(area.size(), Qt::KeepAspectRatio);
    const QRectF place(QPointF(area.right() - fitting.width(), area.top()), fitting);
    if (m_drawing)
        m_drawing->render(&painter, place);
    else
        painter.drawImage(place, m_image);
}

Result<ChosenTemplate> drawableTemplate(const std::string &name)
{
    Result<ChosenTemplate> chosen = chooseTemplate(name);
    if (!chosen || chosen->logo.empty())
        return chosen;
    const std::string &logo = chosen->layout.logo;
    if (ReportLogo({chosen->logo, logo.ends_with(".svg")}).isDrawable())
        return chosen;
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The logo %1 of the template %2 cannot be drawn; save it anew as PNG or plain SVG."),
            {logo, name}});
}

} // namespace dyncal
