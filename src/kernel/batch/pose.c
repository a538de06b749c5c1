/* SPDX-License-Identifier: MIT */
/* Poses of records to component arrays, and back. */
#include "lane/strict.h"

#include "batch/pose.h"
#include "batch/record_rows.h"

NKW_LOOPS_POSE(NKW_DECLARE_LOOP)

NKW_LOOP(nkwi_pose_from_trs)(const nkw_trs *trs, size_t n, float *rows, size_t stride)
{
    rows_from_records(trs, n, rows, stride);
}

NKW_LOOP(nkwi_trs_from_pose)(const float *rows, size_t stride, size_t n, nkw_trs *trs)
{
    records_from_rows(rows, stride, n, trs);
}
