#define LET float
#define BE =
#define AND ;
#define END ; }
#define BEGIN {
#define main_image void mainImage(out vec4 c, in vec2 p)
main_image BEGIN LET x BE p.x / iResolution.x AND LET y BE p.y / iResolution.y AND c BE vec4(x * y, step(x, y), step(.5, x), 1) END
