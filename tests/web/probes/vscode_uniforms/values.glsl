#iUniform float strength = 0.5 in { 0.0, 2.0 }
#iUniform vec2 place = vec2(2.0, 3.0)
#iUniform int count = 4 in { 0, 9 }
#ifdef SHADER_TOY
void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(strength, place.y, count, saturate(iGlobalTime + 2.0));
}
#endif
