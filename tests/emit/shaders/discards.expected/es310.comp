runs as fragments: the shader uses discard
