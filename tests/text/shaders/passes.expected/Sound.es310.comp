runs as fragments: the pass is not a picture
