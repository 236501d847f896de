package cga.measure.mutation

private const val FALLOFF = "1.0 / max(k.x + k.y * sqrt(squared) + k.z * squared, 1.0 / MAX_ATTENUATION)"
private const val CONE = "float width = cone.y - cone.x;"
private const val SPOT_TERM = "reflected(n, toLight, toCamera, diffuse, specular, f * spotLight[i].color)"

private val SPECULAR_OUTSIDE_OF_CONE =
    """
    reflected(n, toLight, toCamera, diffuse, vec3(0.0), f * spotLight[i].color)
        + reflected(n, toLight, toCamera, vec3(0.0), specular,
            attenuationFactor(toSpotLightView[i], spotLight[i].attenuation) * spotLight[i].color)
    """.trimIndent()

/** What the light looks like whose world position was sent where one in view space was meant, seen by the camera at rest: 35° down. */
private val LIGHTS_IN_WORLD_SPACE =
    listOf("point", "spot").map { kind ->
        val position = "${kind}Light[i].position"
        val world = "(mat3(1.0, 0.0, 0.0, 0.0, 0.81915, -0.57358, 0.0, 0.57358, 0.81915) * ($position + vec3(0.0, 0.0, 3.2)))"
        TextEdit("shaders/scene.vert", "$position - positionView", "$world - positionView")
    }

internal val LIGHT_MUTANTS: List<Mutant> =
    with(Part.LIGHTS) {
        listOf(
            fragment("point lights 1 % brighter", "f * pointLight[i].color", "1.01 * f * pointLight[i].color"),
            fragment("point lights 5 % brighter", "f * pointLight[i].color", "1.05 * f * pointLight[i].color"),
            fragment("spotlight 1 % darker", "f * spotLight[i].color", "0.99 * f * spotLight[i].color"),
            fragment("spotlight's red and blue swapped", "f * spotLight[i].color", "f * spotLight[i].color.bgr"),
            // In these two not 0: a compiler that removed the light would remove its uniforms, and the program would warn of that.
            fragment("spotlight missing", "f * spotLight[i].color", "1e-9 * f * spotLight[i].color"),
            fragment("last corner light missing", "f * pointLight[i].color", "(i == 4 ? 1e-9 : 1.0) * f * pointLight[i].color"),
            fragment(
                "later lights use the first one's direction",
                "normalizeOrZero(toPointLightView[i])",
                "normalizeOrZero(toPointLightView[0])",
            ),
            vertex("later lights stand where the first one does", "= pointLight[i].position", "= pointLight[0].position"),
            Mutant(this, "lights in world space", LIGHTS_IN_WORLD_SPACE),
            fragment("attenuation missing", FALLOFF, "1.0"),
            fragment("attenuation without its quadratic part", FALLOFF, "1.0 / (k.x + k.y * sqrt(squared))"),
            fragment("attenuation's quadratic part 1 % off", "k.z * squared", "1.01 * k.z * squared"),
            fragment("attenuation by d² where d is meant", "k.y * sqrt(squared)", "k.y * squared"),
            fragment("cone's inner and outer angle swapped", "(cone.y - versine) / width", "(versine - cone.x) / width"),
            fragment("cone with a hard edge", "if (width > 0.0)", "if (width < 0.0)"),
            fragment(
                "cone with a smooth step for an edge",
                "clamp((cone.y - versine) / width, 0.0, 1.0)",
                "1.0 - smoothstep(cone.x, cone.y, versine)",
            ),
            fragment("cone's angles 1 % too wide", CONE, "cone *= 1.0201; $CONE"),
            fragment("specular light outside of the cone", SPOT_TERM, SPECULAR_OUTSIDE_OF_CONE),
        )
    }
