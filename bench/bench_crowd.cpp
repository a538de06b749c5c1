/* SPDX-License-Identifier: MIT */
/*
 * Many characters of one skeleton of 67 joints. An element is a character, whose result, for the check, is the matrix
 * of one of its joints. The time of two threads is that of the one that works longer, on its processor: on a shared
 * machine the clock on the wall would tell how long they had to wait for processors. To start and to join the other one
 * is part of the first one's time, to sleep until it ends is not.
 */
#include <algorithm>
#include <memory>
#include <thread>

#include <time.h>

#include "bench.h"
#include "from_trs.h"
#include "scene.h"
#include "views.h"

using namespace bench;

static const size_t joints = 67, most = 10000;
static const std::vector<size_t> sizes = {1, 16, 256, 1000, most};

/* One for all, drawn at first use: clip, skeleton, the binds, and where the palettes of all characters go. */
struct stage {
    std::shared_ptr<scene> clip = draw_scene(joints, 301);
    std::vector<int32_t> parents = draw_parents(joints);
    std::vector<nkw_mat4> palettes, models;
    std::vector<nkw_trs> trs;
    std::vector<float> poses, lanes, model_lanes;

    nkw_skeleton skeleton() const
    {
        return {parents.data(), joints};
    }
    const nkw_mat4 *binds() const
    {
        return rigid.at;
    }
    /* Characters are apart in time. */
    float time(size_t character) const
    {
        return time_at(asking::random, character, clip->times.back());
    }
    nkw_mat4 *palette(size_t character)
    {
        return &palettes[character * joints];
    }
};

static stage &the()
{
    static stage s;
    return s;
}

/* The joint whose matrix is compared. */
static size_t shown(size_t character)
{
    return character % joints;
}

static void truth_models(size_t character, size_t joint, double *out)
{
    const stage &s = the();
    double local[16];
    truth::matrix(s.clip->joint_at(joint, s.time(character)), local);
    if (s.parents[joint] < 0) {
        std::copy_n(local, 16, out);
        return;
    }
    double above[16];
    truth_models(character, static_cast<size_t>(s.parents[joint]), above);
    truth::product(above, local, 4, out);
}

/* ---- from a time to a palette ---- */

static void one_by_one(size_t from, size_t to)
{
    stage &s = the();
    const nkw_skeleton skeleton = s.skeleton();
    const nkw_clip *clip = s.clip->clip(0);
    float pose[NKW_POSE_FLOATS(joints)];
    nkw_mat4 models[joints];
    for (size_t c = from; c < to; c++) {
        nkw_clip_sample(clip, s.time(c), nullptr, nkw_pose_span{pose, joints}, nullptr);
        nkw_skeleton_models_from_pose(&skeleton, nkw_pose_view{pose, skeleton.joint_count}, nullptr, nullptr, models);
        palette_from_models(models, joints, nullptr, s.binds(), nullptr, joints, s.palette(c));
    }
}

static void sixteen(size_t from, size_t to)
{
    stage &s = the();
    const nkw_skeleton skeleton = s.skeleton();
    const nkw_clip *clip = s.clip->clip(0);
    alignas(64) float poses[NKW_CROWD][NKW_POSE_FLOATS(joints)];
    alignas(64) float crowd[NKW_CROWD_POSE_FLOATS(joints)], models[NKW_CROWD_MATRIX_FLOATS(joints)];
    const float *pose[NKW_CROWD];
    nkw_mat4 *out[NKW_CROWD];
    for (size_t c = from; c < to; c += NKW_CROWD) {
        for (size_t i = 0; i < NKW_CROWD; i++) {
            pose[i] = c + i < to ? poses[i] : nullptr;
            out[i] = c + i < to ? s.palette(c + i) : nullptr;
            if (pose[i])
                nkw_clip_sample(clip, s.time(c + i), nullptr, nkw_pose_span{poses[i], joints}, nullptr);
        }
        crowd_from_poses(pose, joints, crowd);
        crowd_models_from_pose(&skeleton, crowd, nullptr, models);
        crowd_palette_from_models(models, joints, nullptr, s.binds(), joints, models);
        matrices_from_crowd(models, joints, out);
    }
}

#ifdef BENCH_GLM
static void by_hand(size_t from, size_t to)
{
    stage &s = the();
    const glm::mat4 *binds = reinterpret_cast<const glm::mat4 *>(s.binds());
    glm::mat4 models[joints];
    for (size_t c = from; c < to; c++) {
        glm::mat4 *out = reinterpret_cast<glm::mat4 *>(s.palette(c));
        float time = s.time(c);
        for (size_t j = 0; j < joints; j++) {
            glm::mat4 local = glm_matrix(joint_by_hand(*s.clip, j, time));
            models[j] = s.parents[j] < 0 ? local : models[s.parents[j]] * local;
            out[j] = models[j] * binds[j];
        }
    }
}
#endif

using work = void (*)(size_t from, size_t to);

/* Seconds that this thread has worked. */
static double worked()
{
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/* Characters 0 .. n - 1 shared out in whole crowds; gives the seconds of the thread that worked longer. */
static double share(work f, size_t n)
{
    double begin = worked(), other = 0;
    size_t half = std::min(n, (n + 2 * NKW_CROWD - 1) / (2 * NKW_CROWD) * NKW_CROWD);
    std::thread second([&] {
        f(half, n);
        other = worked();
    });
    f(0, half);
    second.join();
    return std::max(worked() - begin, other);
}

static void rows_of(const operation &all, const char *who, work f, size_t threads)
{
    for (size_t n : sizes) {
        operation op = all;
        op.sizes = {n};
        auto show = [=] {
            for (size_t c = 0; c < n; c++)
                answer.at[c] = the().palette(c)[shown(c)];
        };
        if (threads == 1) {
            whole(
                op, who, layout::structs, [=] { f(0, n); }, show);
            continue;
        }
        auto check = [=](size_t) {
            share(f, n);
            show();
        };
        auto time = [=](benchmark::State &state) {
            for (auto _ : state)
                state.SetIterationTime(share(f, n));
        };
        add(op, who, layout::structs, n, check, time, passing::told);
    }
}

static void time_to_palette(size_t threads)
{
    the().palettes.resize(most * joints);
    operation op = {"crowd",
                    threads == 1 ? "time to palette" : "time to palette, 2 threads",
                    16,
                    joints * 144.0,
                    joints * 288.0,
                    [](size_t i, double *out) {
                        double model[16], bind[16];
                        truth_models(i, shown(i), model);
                        std::copy_n(the().binds()[shown(i)].m, 16, bind);
                        truth::product(model, bind, 4, out);
                    },
                    128};
    rows_of(op, "nkw sixteen", sixteen, threads);
    rows_of(op, "nkw one by one", one_by_one, threads);
#ifdef BENCH_GLM
    rows_of(op, "upper_bound, glm", by_hand, threads);
#endif
}

/* ---- local to model alone, of characters that all have their own memory ---- */

static void draw_poses()
{
    stage &s = the();
    s.poses.resize(most * NKW_POSE_FLOATS(joints));
    size_t crowds = most / NKW_CROWD;
    s.lanes.resize(crowds * NKW_CROWD_POSE_FLOATS(joints));
    s.model_lanes.resize(crowds * NKW_CROWD_MATRIX_FLOATS(joints));
    s.models.resize(most * joints);
    s.trs.resize(most * joints);
    for (size_t c = 0; c < most; c++) {
        float *pose = &s.poses[c * NKW_POSE_FLOATS(joints)];
        nkw_clip_sample(s.clip->clip(0), s.time(c), nullptr, nkw_pose_span{pose, joints}, nullptr);
        nkw_trs_from_pose(nkw_pose_view{pose, joints}, &s.trs[c * joints]);
    }
    for (size_t k = 0; k < crowds; k++) {
        const float *pose[NKW_CROWD];
        for (size_t i = 0; i < NKW_CROWD; i++)
            pose[i] = &s.poses[(k * NKW_CROWD + i) * NKW_POSE_FLOATS(joints)];
        crowd_from_poses(pose, joints, &s.lanes[k * NKW_CROWD_POSE_FLOATS(joints)]);
    }
}

static void show_lanes(size_t n)
{
    const stage &s = the();
    for (size_t c = 0; c < n; c++) {
        const float *m = &s.model_lanes[c / NKW_CROWD * NKW_CROWD_MATRIX_FLOATS(joints) + shown(c) * 12 * NKW_CROWD];
        for (size_t k = 0; k < 16; k++)
            answer.at[c].m[k] = k % 4 < 3 ? m[(k / 4 * 3 + k % 4) * NKW_CROWD + c % NKW_CROWD] : k == 15;
    }
}

static void local_to_model()
{
    operation all = {"crowd",
                     "local to model",
                     16,
                     joints * 104.0,
                     joints * 100.0,
                     [](size_t i, double *out) { truth_models(i, shown(i), out); },
                     128};
    draw_poses();
    for (size_t n : sizes) {
        operation op = all;
        op.sizes = {n};
        whole(
            op, "nkw sixteen", layout::components,
            [=] {
                stage &s = the();
                nkw_skeleton skeleton = s.skeleton();
                for (size_t k = 0; k < (n + NKW_CROWD - 1) / NKW_CROWD; k++)
                    crowd_models_from_pose(&skeleton, &s.lanes[k * NKW_CROWD_POSE_FLOATS(joints)], nullptr,
                                           &s.model_lanes[k * NKW_CROWD_MATRIX_FLOATS(joints)]);
            },
            [=] {
                show_lanes(n);
                for (size_t c = 0; c < n; c++)
                    for (size_t k = 0; k < 16; k++)
                        answer.part[k][c] = answer.at[c].m[k];
            });
        auto show = [=] {
            for (size_t c = 0; c < n; c++)
                answer.at[c] = the().models[c * joints + shown(c)];
        };
        whole(
            op, "nkw one by one", layout::structs,
            [=] {
                stage &s = the();
                nkw_skeleton skeleton = s.skeleton();
                for (size_t c = 0; c < n; c++)
                    nkw_skeleton_models_from_pose(
                        &skeleton, nkw_pose_view{&s.poses[c * NKW_POSE_FLOATS(joints)], skeleton.joint_count}, nullptr,
                        nullptr, &s.models[c * joints]);
            },
            show);
#ifdef BENCH_GLM
        whole(
            op, "glm", layout::structs,
            [=] {
                stage &s = the();
                for (size_t c = 0; c < n; c++) {
                    const nkw_trs *trs = &s.trs[c * joints];
                    glm::mat4 *model = reinterpret_cast<glm::mat4 *>(&s.models[c * joints]);
                    for (size_t j = 0; j < joints; j++)
                        model[j] = s.parents[j] < 0 ? glm_matrix(trs[j]) : model[s.parents[j]] * glm_matrix(trs[j]);
                }
            },
            show);
#endif
    }
}

static const suite all([] {
    time_to_palette(1);
    time_to_palette(2);
    local_to_model();
});
