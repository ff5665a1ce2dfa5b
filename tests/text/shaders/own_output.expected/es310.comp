runs as fragments: the shader declares its own output
