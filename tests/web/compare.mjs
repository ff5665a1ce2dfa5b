// How far two pictures are apart, in several numbers: a picture may be noisy in a few pixels, or slightly off in all.

// a and b: { width, height, rgba }. A pixel's difference is the largest of its channels'.
export function compare(a, b, channels = 4) {
  if (a.width !== b.width || a.height !== b.height)
    throw new Error(`sizes differ: ${a.width}x${a.height} and ${b.width}x${b.height}`);
  const pixels = a.width * a.height;
  const result = { pixels, worst: 0, mean: 0, equal: 0, above: (limit) => over.filter((d) => d > limit).length };
  const over = [];
  for (let i = 0; i < pixels; ++i) {
    let difference = 0;
    for (let c = 0; c < channels; ++c) {
      const x = a.rgba[4 * i + c];
      const y = b.rgba[4 * i + c];
      if (Object.is(x, y) || x === y || (x !== x && y !== y)) continue;
      const d = Math.abs(x - y);
      difference = Math.max(difference, d === d ? d : Infinity);
    }
    if (difference === 0) result.equal += 1;
    else over.push(difference);
    result.mean += difference / pixels;
    if (difference > result.worst) Object.assign(result, { worst: difference, at: [i % a.width, Math.floor(i / a.width)] });
  }
  return result;
}
