// SPDX-License-Identifier: MIT
// Springs that follow a goal: the goal jumps at three times, and each spring is computed exactly.
import * as N from 'nakawari/all';
import { list, literal, program } from '../../kit/code';
import { html } from '../../kit/html';
import { legend } from '../../kit/legend';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import type { Handle } from '../../kit/points';
import { remembered, samples } from '../../kit/samples';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { fields, goalTimes, type ModeOf, mostGoals, type State } from './state';
import { words } from './words';

const own = {
  note: {
    en: 'Play and drag the goal up and down, or drag its points: the goal jumps, the velocity does not. Steps of ' +
      '1/30 s and of 1/60 s differ by rounding only.',
    ja: '再生しながら目標を上下にドラッグするか、各点をドラッグしてください。目標が不連続に変わっても、速度は連続です。' +
      '1/30 秒刻みと1/60 秒刻みの違いは丸め誤差だけです。',
  },
  goal: { en: 'goal', ja: '目標' },
  goalNow: { en: 'goal from now on', ja: '現在からの目標' },
  reset: { en: 'Three goals again', ja: '目標を3つに戻す' },
  chosen: { en: 'chosen damping ratio', ja: '選んだ減衰比' },
  critical: { en: 'critically damped (1)', ja: '臨界減衰（1）' },
  over: { en: 'overdamped (2)', ja: '過減衰（2）' },
  position: { en: 'Position', ja: '位置' },
  velocity: { en: 'Velocity (1/s)', ja: '速度（1/s）' },
  now: { en: 'Now: position, velocity', ja: '現在の位置と速度' },
  steps: { en: 'Chosen damping ratio, in steps: position, velocity', ja: '選んだ減衰比で、刻みごとに計算した位置と速度' },
  whole: { en: 'one step for each goal', ja: '目標ごとに1ステップ' },
  thirty: { en: 'steps of 1/30 s', ja: '1/30 秒刻み' },
  sixty: { en: 'steps of 1/60 s', ja: '1/60 秒刻み' },
  constants: { en: 'Stiffness (1/s²), damping (1/s)', ja: 'ばね定数（1/s²）、減衰係数（1/s）' },
  half: { en: 'half-life (s)', ja: '半減期（秒）' },
  ratio: { en: 'damping ratio', ja: '減衰比' },
} satisfies Record<string, Text>;
const kinds = ['chosen', 'critical', 'over'] as const, colours = ['c0', 'c2', 'c3'], end = 3;
const F = Math.fround;

const ratios = ({ ratio }: State) => [ratio, 1, 2];
const springOf = (state: State, kind: number) => N.springFromHalfLife([0, 0], state.half, ratios(state)[kind]);

/** The motion at a time: from rest at 0, in steps of h at most, which end where the goal jumps. */
function motionAt({ goals }: State, spring: number[], time: number, h: number): number[] {
  const motion = [0, 0], times = goalTimes(goals);
  times.forEach((start, k) => {
    const stop = Math.min(F(time), F(times[k + 1] ?? Infinity));
    for (let t = F(start); t < stop; t = F(t + F(h)))
      N.springStep(motion, spring, motion, [goals[2 * k + 1], 0], Math.min(F(h), F(stop - t)));
  });
  return motion;
}

const goalAt = ({ goals }: State, time: number) => goals[2 * goalTimes(goals).filter(t => t <= time).length - 1] ?? 0;

/** Positions and velocities, of the goal and of each spring. */
const curves = remembered((state: State) => {
  const all = samples(t => {
    const motions = kinds.map((_, i) => motionAt(state, springOf(state, i), t, Infinity));
    return [goalAt(state, t), ...motions.map(m => m[0]), NaN, ...motions.map(m => m[1])];
  }, 0, end);
  return { positions: { x: all.x, y: all.y.slice(0, 4) }, velocities: { x: all.x, y: all.y.slice(4) } };
});

/** The goals with goal k moved. */
function moved({ goals }: State, k: number, time: number, value: number): Partial<State> {
  const least = (goals[2 * k - 2] ?? -0.05) + 0.05, most = (goals[2 * k + 2] ?? end + 0.05) - 0.05;
  const round = (x: number, low: number, high: number) => clamp(Math.round(x * 100) / 100, low, high);
  const [t, v] = [round(time, least, most), round(value, -2, 2)];
  return { goals: goals.map((x, i) => i === 2 * k ? t : i === 2 * k + 1 ? v : x) };
}

/** The goals with another one from now on. One that is as new as a twenty-fifth of a second is changed instead. */
function recorded({ goals, time }: State, value: number): Partial<State> {
  const round = (x: number) => Math.round(x * 100) / 100, starts = goalTimes(goals), now = round(time);
  const kept = starts.filter(t => t < now - 0.04 || t > now + 0.04);
  const near = starts.find(t => t >= now - 0.04 && t <= now);
  if (kept.length >= mostGoals)
    return {};
  const all = kept.map(t => [t, goals[2 * starts.indexOf(t) + 1]]);
  return { goals: [...all, [near ?? now, round(clamp(value, -2, 2))]].sort((a, b) => a[0] - b[0]).flat() };
}

function goalHandles(room: Room<State>): Handle[] {
  const { goals, time } = room.state, small = goals.length > 12;
  const list = goalTimes(goals).map((x, k) => ({ label: own.goal, x, y: goals[2 * k + 1], small,
    move: (t: number, value: number) => room.set(moved(room.state, k, t, value)) }));
  return [{ label: own.goalNow, x: time, y: goalAt(room.state, time), small: true,
    move: (_, value) => room.set(recorded(room.state, value)) }, ...list];
}

function plots(room: Room<State>) {
  const time = () => room.state.time;
  const series = legend(room, [{ name: 'goal', label: own.goal, colour: 'soft', dash: [6, 4] },
    ...kinds.map((name, i) => ({ name, label: own[name], colour: colours[i], width: i ? 1.5 : 2.5 }))], 'hidden');
  plot(room, {
    label: own.position, time, series, data: () => curves(room.state).positions,
    handles: () => goalHandles(room),
    marks: () => kinds.map((_, i) => ({ x: time(), colour: colours[i],
      y: motionAt(room.state, springOf(room.state, i), time(), Infinity)[0] })),
  });
  plot(room, { label: own.velocity, x: words.seconds, time, series, data: () => curves(room.state).velocities });
}

const stepsOf = [['whole', Infinity], ['thirty', 1 / 30], ['sixty', 1 / 60]] as const;

function mount(room: Room<State>) {
  room.stage.append(html('p', say(own.note), { class: 'note' }));
  plots(room);
  numberTable(room, own.now, () => kinds.map((name, i) => ({ name, label: own[name],
    values: motionAt(room.state, springOf(room.state, i), room.state.time, Infinity) })));
  numberTable(room, own.steps, () => stepsOf.map(([name, h]) => ({ name, label: own[name], digits: 7,
    values: motionAt(room.state, springOf(room.state, 0), room.state.time, h) })));
  numberTable(room, own.constants, () => [{ name: 'spring', label: own.chosen, digits: 3,
    values: springOf(room.state, 0) }]);
  const made = panel(room, words.springs);
  made.slider('half', own.half, 0.02, 1, 0.01);
  made.slider('ratio', own.ratio, 0, 3, 0.05);
  made.action(own.reset, () => room.set({ goals: fields.goals.initial }));
}

const code = (state: State) => program(`
enum { GOALS = ${state.goals.length / 2} };
static const float starts[GOALS] = ${list(goalTimes(state.goals))};
static const float goals[GOALS] = ${list(state.goals.filter((_, i) => i % 2))};
static const float ratios[] = ${list([...ratios(state), state.ratio, state.ratio, state.ratio])};
static const float steps[] = {1e9f, 1e9f, 1e9f, 1e9f, 1.0f / 30.0f, 1.0f / 60.0f};
static const char *const names[] = {"chosen", "critical", "over", "whole", "thirty", "sixty"};
const float time = ${literal(state.time)}, half_life = ${literal(state.half)};
for (int i = 0; i < 6; i++) {
    const nkw_spring spring = nkw_spring_from_half_life(half_life, ratios[i]);
    nkw_state motion = {0.0f, 0.0f};
    for (int k = 0; k < GOALS; k++) {
        const nkw_state goal = {goals[k], 0.0f};
        const float stop = k + 1 < GOALS && starts[k + 1] < time ? starts[k + 1] : time;
        for (float t = starts[k]; t < stop; t += steps[i])
            motion = nkw_spring_step(spring, motion, goal, steps[i] < stop - t ? steps[i] : stop - t);
    }
    show(names[i], 0, (double)motion.value);
    show(names[i], 1, (double)motion.velocity);
}
const nkw_spring chosen = nkw_spring_from_half_life(half_life, ratios[0]);
show("spring", 0, (double)chosen.stiffness);
show("spring", 1, (double)chosen.damping);
`);

export const springs: ModeOf = { mount, end: () => end, code };
