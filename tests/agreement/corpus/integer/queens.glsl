// Counts by bits how many ways the first queens leave, row by row.
int count(int n, int forced) {
  int total = 0, row = 0;
  int cols[8], left[8], right[8], open[8];
  cols[0] = left[0] = right[0] = 0;
  open[0] = 1 << forced;
  for (int guard = 0; guard < 4000 && row >= 0; ++guard) {
    if (open[row] == 0) { row--; continue; }
    int bit = open[row] & -open[row];
    open[row] ^= bit;
    if (row == n - 1) { total++; continue; }
    cols[row + 1] = cols[row] | bit;
    left[row + 1] = (left[row] | bit) << 1;
    right[row + 1] = (right[row] | bit) >> 1;
    row++;
    open[row] = ((1 << n) - 1) & ~(cols[row] | left[row] | right[row]);
  }
  return total;
}
void mainImage(out vec4 color, in vec2 p) {
  int column = int(p.x / iResolution.x * 6.0);
  color = vec4(vec3(count(6, column), count(5, column % 5), column) / 4.0, 1.0);
}
