#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
layout(location = 0) out vec4 shadertoy_out_color;

uniform vec3 iResolution ;
uniform float iTime ;
uniform float iTimeDelta ;
uniform int iFrame ;
uniform vec4 iDate ;
uniform vec4 iMouse ;
uniform float iSampleRate ;
uniform vec4 iMouseButton ;
uniform mat4 iViewMatrix ;
uniform vec3 iChannelResolution [ 10 ] ;
uniform sampler2D iChannel0 ;
uniform sampler2D iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
uniform sampler2D iChannel4 ;
uniform sampler2D iChannel5 ;
uniform sampler2D iChannel6 ;
uniform sampler2D iChannel7 ;
uniform sampler2D iChannel8 ;
uniform sampler2D iChannel9 ;
uniform sampler2D iKeyboard ;











uniform float speed ;
const int Key_Backspace = 8 ;
const int Key_Tab = 9 ;
const int Key_Enter = 13 ;
const int Key_Shift = 16 ;
const int Key_Ctrl = 17 ;
const int Key_Alt = 18 ;
const int Key_Pause = 19 ;
const int Key_Caps = 20 ;
const int Key_Escape = 27 ;
const int Key_PageUp = 33 ;
const int Key_PageDown = 34 ;
const int Key_End = 35 ;
const int Key_Home = 36 ;
const int Key_LeftArrow = 37 ;
const int Key_UpArrow = 38 ;
const int Key_RightArrow = 39 ;
const int Key_DownArrow = 40 ;
const int Key_Insert = 45 ;
const int Key_Delete = 46 ;
const int Key_LeftWindow = 91 ;
const int Key_RightWindows = 92 ;
const int Key_Select = 93 ;
const int Key_NumpadMultiply = 106 ;
const int Key_NumpadAdd = 107 ;
const int Key_NumpadSubtract = 109 ;
const int Key_NumpadPeriod = 110 ;
const int Key_NumpadDivide = 111 ;
const int Key_NumLock = 144 ;
const int Key_ScrollLock = 145 ;
const int Key_SemiColon = 186 ;
const int Key_Equal = 187 ;
const int Key_Comma = 188 ;
const int Key_Dash = 189 ;
const int Key_Period = 190 ;
const int Key_ForwardSlash = 191 ;
const int Key_GraveAccent = 192 ;
const int Key_OpenBracket = 219 ;
const int Key_BackSlash = 220 ;
const int Key_CloseBraket = 221 ;
const int Key_SingleQuote = 222 ;
const int Key_0 = 48 ;
const int Key_Numpad0 = 96 ;
const int Key_1 = 49 ;
const int Key_Numpad1 = 97 ;
const int Key_2 = 50 ;
const int Key_Numpad2 = 98 ;
const int Key_3 = 51 ;
const int Key_Numpad3 = 99 ;
const int Key_4 = 52 ;
const int Key_Numpad4 = 100 ;
const int Key_5 = 53 ;
const int Key_Numpad5 = 101 ;
const int Key_6 = 54 ;
const int Key_Numpad6 = 102 ;
const int Key_7 = 55 ;
const int Key_Numpad7 = 103 ;
const int Key_8 = 56 ;
const int Key_Numpad8 = 104 ;
const int Key_9 = 57 ;
const int Key_Numpad9 = 105 ;
const int Key_A = 65 ;
const int Key_B = 66 ;
const int Key_C = 67 ;
const int Key_D = 68 ;
const int Key_E = 69 ;
const int Key_F = 70 ;
const int Key_G = 71 ;
const int Key_H = 72 ;
const int Key_I = 73 ;
const int Key_J = 74 ;
const int Key_K = 75 ;
const int Key_L = 76 ;
const int Key_M = 77 ;
const int Key_N = 78 ;
const int Key_O = 79 ;
const int Key_P = 80 ;
const int Key_Q = 81 ;
const int Key_R = 82 ;
const int Key_S = 83 ;
const int Key_T = 84 ;
const int Key_U = 85 ;
const int Key_V = 86 ;
const int Key_W = 87 ;
const int Key_X = 88 ;
const int Key_Y = 89 ;
const int Key_Z = 90 ;
const int Key_F1 = 112 ;
const int Key_F2 = 113 ;
const int Key_F3 = 114 ;
const int Key_F4 = 115 ;
const int Key_F5 = 116 ;
const int Key_F6 = 117 ;
const int Key_F7 = 118 ;
const int Key_F8 = 119 ;
const int Key_F9 = 120 ;
const int Key_F10 = 121 ;
const int Key_F11 = 122 ;
const int Key_F12 = 123 ;
bool isKeyDown ( precise int key ) { precise bool shadertwin_test; precise bool shadertwin_result; return (shadertwin_result = (texture ( iKeyboard , vec2 ( float ( key ) / 255.0 , 0.125 ) ) . x > 0.0)) ; }
bool isKeyPressed ( precise int key ) { precise bool shadertwin_test; precise bool shadertwin_result; return (shadertwin_result = (texture ( iKeyboard , vec2 ( float ( key ) / 255.0 , 0.375 ) ) . x > 0.0)) ; }
bool isKeyToggled ( precise int key ) { precise bool shadertwin_test; precise bool shadertwin_result; return (shadertwin_result = (texture ( iKeyboard , vec2 ( float ( key ) / 255.0 , 0.625 ) ) . x > 0.0)) ; }
bool isKeyReleased ( precise int key ) { precise bool shadertwin_test; precise bool shadertwin_result; return (shadertwin_result = (texture ( iKeyboard , vec2 ( float ( key ) / 255.0 , 0.875 ) ) . x > 0.0)) ; }







void mainImage ( precise out vec4 c , precise in vec2 p ) { precise bool shadertwin_test; c = vec4 ( 0 ) ; c = vec4 ( 0 ) ; c = vec4 ( isKeyDown ( Key_A ) ? speed : 0.0 , isKeyToggled ( Key_Enter ) , 0 , 1 ) ; }
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }
