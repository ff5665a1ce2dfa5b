runs as fragments: the shader uses dFdx
