void mainImage(out vec4 O,vec2 U){O.xy=U/iResolution.xy;O=O.yxyx*O.xxyy+O.xyxy*.25;O.zw=O.wz,O.a=1.;O.rgb=O.bgr;}
