struct Thing { float f; vec2 v; };
vec3 everywhere;

void mainImage(out vec4 c, in vec2 p)
{
    float x;
    Thing thing;
    float list[3];
    float sum = 0.0;
    for (int i = 0; i < 3; i++) {
        float inner;
        inner += p.x;
        sum += inner;
    }
    c = vec4(x + everywhere.y, thing.f + thing.v.y, list[iFrame], sum);
}
