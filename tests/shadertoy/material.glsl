// A material of a type with (color, roughness) and what else it takes: the index, and the absorption or edge tint.
Material probeMaterial(int type, vec3 color, float roughness, float index, vec3 extra)
{
    if (type == METAL) {
        return createMetalMaterial(color, roughness);
    } else if (type == DIELECTRIC) {
        return createDielectricMaterial(extra, index, roughness);
    } else if (type == CONDUCTOR) {
        return createConductorMaterial(color, extra, roughness);
    } else if (type == PLASTIC) {
        return createPlasticMaterial(color, roughness);
    }
    return createDiffuseMaterial(color);
}
