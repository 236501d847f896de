package cga.measure.mutation

import org.joml.Vector3f

private const val POWER = "pow(cosine, material.shininess)"
private const val NORMAL = "normalMatrix * normal"
private const val EMISSION = "emissive * emissiveTint"
private const val ENCODED = "inverseGamma == 1.0 ? color : pow(max(color, 0.0), vec3(inverseGamma))"

internal val SHADING_MUTANTS: List<Mutant> =
    with(Part.SHADING) {
        listOf(
            lighting("specular power +5 %", POWER, "pow(cosine, 1.05 * material.shininess)"),
            lighting("specular power −5 %", POWER, "pow(cosine, 0.95 * material.shininess)"),
            lighting("specular light missing", POWER, "0.0"),
            lighting("Phong and Blinn-Phong swapped", "return blinnPhong", "return !blinnPhong"),
            lighting("half vector not normalised", "normalizeOrZero(sum)", "sum"),
            lighting("reflected vector with the wrong sign", "n : reflect(-toLight, n)", "n : reflect(toLight, n)"),
            fragment("view vector with the wrong sign", "normalizeOrZero(toCameraView)", "normalizeOrZero(-toCameraView)"),
            fragment("normal not normalised", "normalizeOrZero(inRange(normalView))", "normalView"),
            vertex("normal not transformed", NORMAL, "normal"),
            vertex("normal transformed by the transpose", NORMAL, "normal * normalMatrix"),
            vertex("normal transformed by mat3(modelView)", NORMAL, "mat3(modelView) * normal"),
            lighting("surfaces lit from behind", "clamp(dot(n, toLight), 0.0, 1.0)", "abs(dot(n, toLight))"),
            fragment("emission +5 %", EMISSION, "1.05 * $EMISSION"),
            fragment("emission without its tint", EMISSION, "emissive"),
            Mutant(this, "ambient light 0.01 added", beforeRender = { it.ambient = Vector3f(0.01f) }),
            fragment("gamma where none is wanted", ENCODED, "pow(max(color, 0.0), vec3(inverseGamma / 2.2))"),
            fragment("gamma applied twice", ENCODED, "pow(max(color, 0.0), vec3(inverseGamma * inverseGamma))"),
            fragment("gamma missing", ENCODED, "color"),
        )
    }
