
function buildClip() {
  throw new Error('nakawari/player opens clips only: nakawari/clips builds them');
}
