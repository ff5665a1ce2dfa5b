// Shaders: text to programs, and a compiler's messages to lines of the user's own files.

const triangle = `#version 300 es
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`;

const copy = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
out vec4 color;
void main() { color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }`;

function makeShader(gl, type, text) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  return shader;
}

// A program whose link may still be under way.
function startProgram(gl, fragmentText, vertexText = triangle) {
  const program = gl.createProgram();
  const vertex = makeShader(gl, gl.VERTEX_SHADER, vertexText);
  const fragment = makeShader(gl, gl.FRAGMENT_SHADER, fragmentText);
  gl.attachShader(program, vertex);
  gl.attachShader(program, fragment);
  gl.linkProgram(program);
  return { program, vertex, fragment };
}

// Lets the page breathe until the driver is done, where it can say so.
async function finished(gl, started) {
  const parallel = gl.getExtension('KHR_parallel_shader_compile');
  while (parallel && !gl.isContextLost() && !gl.getProgramParameter(started.program, parallel.COMPLETION_STATUS_KHR))
    await new Promise((resolve) => setTimeout(resolve, 10));
  return gl.getProgramParameter(started.program, gl.LINK_STATUS);
}

// runs: [count, file, line] for consecutive lines of the body; file -1 is text that the host supplied.
function placeOf(runs, index) {
  let last = null;
  for (const [count, file, line] of runs) {
    if (index < count) return { file, line: line + index };
    index -= count;
    last = { file, line: line + count - 1 };
  }
  return last; // what is noticed behind the text, a missing brace say, belongs to its last line
}

// source: of the pass's fragments or of its vertex shader.
function mappedLog(project, pass, source, log) {
  const lines = log.replace(/\0/g, '').split('\n').filter((line) => line.trim() !== '');
  return lines.map((line) => {
    const [, severity, number, text] = /^(ERROR|WARNING): \d+:(\d+): (.*)/.exec(line) ?? [];
    const index = Number(number) - source.first_line;
    const place = index >= 0 ? placeOf(source.lines, index) : null;
    if (!place || place.file < 0) return `${pass.name}: ${line}`;
    return `${project.files[place.file]}:${place.line}: ${severity.toLowerCase()}: ${text}`;
  });
}

// Compiles all passes at once. Sets pass.program; gives the messages of those that fail.
async function compilePasses(gl, project) {
  const started = project.passes.map((pass) => startProgram(gl, pass.source.text, pass.vertex ? pass.vertex.text : triangle));
  const messages = [];
  for (const [i, pass] of project.passes.entries()) {
    pass.program = started[i].program;
    if (await finished(gl, started[i])) continue;
    const vertexLog = pass.vertex && gl.getShaderInfoLog(started[i].vertex);
    const log = gl.getShaderInfoLog(started[i].fragment) || gl.getProgramInfoLog(pass.program) || 'error';
    messages.push(...mappedLog(project, pass, vertexLog ? pass.vertex : pass.source, vertexLog || log));
  }
  return messages;
}
