// The end of every probe: fetches the inputs of a case, calls the probe's own
//
//   void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
//
// and writes one of the results. Case i stands in column i % width. Its inputs are INPUTS texels above one another in
// iChannel9, its results OUTPUTS pixels above one another. iFrame says which of the file's functions is asked for.

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    ivec2 pixel = ivec2(fragCoord);
    int row = pixel.y / OUTPUTS;
    vec4 x[INPUTS];
    for (int i = 0; i < INPUTS; i++) {
        x[i] = texelFetch(iChannel9, ivec2(pixel.x, row * INPUTS + i), 0);
    }
    vec4 y[OUTPUTS];
    for (int i = 0; i < OUTPUTS; i++) {
        y[i] = vec4(0.0);
    }
    probe(uint(row * int(iResolution.x) + pixel.x), x, y);
    fragColor = y[pixel.y - row * OUTPUTS];
}
