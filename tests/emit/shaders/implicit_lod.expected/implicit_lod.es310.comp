runs as fragments: the shader uses texture on an input with mipmaps
