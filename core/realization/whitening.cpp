// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/whitening.h"

namespace dyncal {

Eigen::VectorXd autoregressiveModel(const Eigen::Ref<const Eigen::VectorXd> &noise, Index order)
{
    const Index n = noise.size();
    if (n < 10 * (order + 1))
        return {};
    const Eigen::VectorXd x = noise.array() - noise.mean();
    Eigen::VectorXd r(order + 1);
    for (Index lag = 0; lag <= order; ++lag)
        r[lag] = x.head(n - lag).dot(x.tail(n - lag));
    if (!(r[0] > 0.0))
        return {};

    Eigen::VectorXd a = Eigen::VectorXd::Zero(order);
    double error = r[0];
    for (Index p = 0; p < order; ++p) {
        double reflection = r[p + 1];
        for (Index i = 0; i < p; ++i)
            reflection += a[i] * r[p - i];
        reflection = -reflection / error;
        Eigen::VectorXd next = a;
        for (Index i = 0; i < p; ++i)
            next[i] = a[i] + reflection * a[p - 1 - i];
        next[p] = reflection;
        a = next;
        error *= 1.0 - reflection * reflection;
    }
    return a;
}

Eigen::VectorXd whitened(const Eigen::Ref<const Eigen::VectorXd> &x, const Eigen::VectorXd &a)
{
    const Index p = a.size();
    const Index count = x.size() - p;
    Eigen::VectorXd result = x.tail(count);
    for (Index i = 0; i < p; ++i)
        result += a[i] * x.segment(p - 1 - i, count);
    return result;
}

} // namespace dyncal
