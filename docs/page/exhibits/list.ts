// SPDX-License-Identifier: MIT
// The exhibits, in the order of the list on the page. The first one is in the first script of the page; the modules of
// import() are in the second (build.mjs).
import type { Entry } from '../shell/exhibit';
import { exercise } from './exercise';

export const exhibits = [
  { id: 'exercise', title: { en: 'The exercise', ja: 'キーフレームアニメーション演習' }, open: async () => exercise },
  { id: 'keys', title: { en: 'The keys', ja: 'キーと曲線' }, open: async () => (await import('./keys')).keys },
  { id: 'time', title: { en: 'Time is not the parameter', ja: '時刻はパラメータではない' },
    open: async () => (await import('./time')).time },
  { id: 'rotations', title: { en: 'Two rotations', ja: '2つの回転' },
    open: async () => (await import('./rotations')).rotations },
  { id: 'splines', title: { en: 'Many rotations', ja: '多数の回転' },
    open: async () => (await import('./splines')).splines },
  { id: 'pole', title: { en: 'The pole', ja: '特異点（ジンバルロック）' }, open: async () => (await import('./pole')).pole },
  { id: 'joints', title: { en: 'Joints', ja: '関節' }, open: async () => (await import('./joints')).jointChain },
  { id: 'twist', title: { en: 'Twist', ja: 'ねじり' }, open: async () => (await import('./twist')).twist },
  { id: 'blend', title: { en: 'Blend and change', ja: 'ブレンドと切り替え' },
    open: async () => (await import('./blend')).blend },
  { id: 'loop', title: { en: 'Loop and events', ja: 'ループとイベント' }, open: async () => (await import('./loop')).loop },
  { id: 'crowd', title: { en: 'A crowd', ja: '群衆' }, open: async () => (await import('./crowd')).crowd },
  { id: 'bits', title: { en: 'The same bits', ja: 'どこでも同じビット列' }, open: async () => (await import('./bits')).bits },
  { id: 'file', title: { en: 'Your file', ja: '手元のファイル' }, open: async () => (await import('./file')).file },
] as unknown as Entry[];
