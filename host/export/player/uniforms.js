// Sliders for the uniforms that a shader offers (#iUniform).

function addRow(panel, label, input, shown) {
  const name = document.createElement('label');
  const value = document.createElement('output');
  name.textContent = label;
  const update = () => (value.textContent = shown());
  input.addEventListener('input', update);
  update();
  panel.append(name, input, value);
}

function colorInput(uniform, changed) {
  const hex = (x) => Math.round(255 * Math.min(Math.max(x, 0), 1)).toString(16).padStart(2, '0');
  const input = Object.assign(document.createElement('input'), { type: 'color' });
  input.value = `#${uniform.value.slice(0, 3).map(hex).join('')}`;
  input.addEventListener('input', () => {
    for (let i = 0; i < 3; ++i) uniform.value[i] = parseInt(input.value.slice(1 + 2 * i, 3 + 2 * i), 16) / 255;
    changed();
  });
  return input;
}

function numberInput(uniform, i, changed) {
  const input = document.createElement('input');
  input.type = uniform.range ? 'range' : 'number';
  if (uniform.range) Object.assign(input, { min: uniform.min[i], max: uniform.max[i] });
  input.step = uniform.step[i] || 'any';
  input.value = uniform.value[i];
  input.addEventListener('input', () => {
    if (!Number.isFinite(input.valueAsNumber)) return;
    uniform.value[i] = input.valueAsNumber;
    changed();
  });
  return input;
}

function showUniforms(uniforms, changed) {
  const panel = find('uniforms');
  panel.hidden = uniforms.length === 0;
  for (const uniform of uniforms) {
    if (uniform.color) {
      addRow(panel, uniform.name, colorInput(uniform, changed), () => '');
      continue;
    }
    const count = customSetters[uniform.type][1];
    for (let i = 0; i < count; ++i) {
      const label = count > 1 ? `${uniform.name}.${'xyzw'[i]}` : uniform.name;
      addRow(panel, label, numberInput(uniform, i, changed), () => Number(uniform.value[i].toPrecision(4)));
    }
  }
}
