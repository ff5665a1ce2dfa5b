// What all passes share.
#define TAU 6.2831853
float wave(float t, float hertz) { return sin(TAU * hertz * t); }
