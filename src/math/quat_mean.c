/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>

#include "lane/quat_mean.h"
#include "lane/quat.h"

nkw_quat nkw_quat_mean(const nkw_quat *rotations, size_t count, const float *weights)
{
    lane_f64_form m = {{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}};
    for (size_t i = 0; i < count; i++) {
        double weight = weights ? (double)weights[i] : 1.0;
        lane_f64_quat q = lane_f64_quat_from(rotations[i]);
        m = lane_f64_form_added(&m, lane_f64_quat_scale(q, weight < 0.0 ? 0.0 : weight), q);
    }
    if (lane_f64_form_trace(&m) == 0.0)
        return nkw_quat_identity();
    lane_f64_quat mean = lane_f64_form_axis(m);
    double sign = lane_f64_quat_dot(mean, lane_f64_quat_from(rotations[0])) < 0.0 ? -1.0 : 1.0;
    return lane_quat_from_f64(lane_f64_quat_scale(mean, sign));
}
