#iChannel0 "self"
#iKeyboard
void mainImage(out vec4 c, in vec2 p)
{
    c = int(p.x) == iFrame ? vec4(isKeyDown(Key_A), isKeyPressed(Key_A), isKeyToggled(Key_A), isKeyReleased(Key_A)) : texelFetch(iChannel0, ivec2(p), 0);
}
