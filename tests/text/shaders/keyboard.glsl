// The extension's names of keys.
#iKeyboard
#iUniform float speed = 1.5 in { 0.0, 2.0 }
void mainImage(out vec4 c, in vec2 p) { c = vec4(isKeyDown(Key_A) ? speed : 0.0, isKeyToggled(Key_Enter), 0, 1); }
