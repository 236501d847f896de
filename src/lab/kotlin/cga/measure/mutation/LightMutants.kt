package cga.measure.mutation

private const val FALLOFF = "1.0 / max(k.x + k.y * sqrt(squared) + k.z * squared, 1.0 / MAX_ATTENUATION)"
private const val CONE = "float width = cone.y - cone.x;"
private const val SUM = "reflected * (f * light[i].color)"

/** What is true of the spotlight alone: a point light's cone is wider than any angle. */
private const val IS_SPOT = "light[i].cone.x < 2.0"

private const val SPECULAR_OUTSIDE_OF_CONE =
    "(diffuse * diffuseFactor(n, toLight) * f + specular * specularFactor(n, toLight, toCamera) * " +
        "attenuationFactor(toLightView[i], light[i].attenuation)) * light[i].color"

/** What the light looks like whose world position was sent where one in view space was meant, seen by the camera at rest: 35° down. */
private const val WORLD_POSITION =
    "(mat3(1.0, 0.0, 0.0, 0.0, 0.81915, -0.57358, 0.0, 0.57358, 0.81915) * (light[i].position + vec3(0.0, 0.0, 3.2)))"

private const val COLOR = "f * light[i].color"

internal val LIGHT_MUTANTS: List<Mutant> =
    with(Part.LIGHTS) {
        listOf(
            fragment("point lights 1 % brighter", COLOR, "($IS_SPOT ? 1.0 : 1.01) * $COLOR"),
            fragment("point lights 5 % brighter", COLOR, "($IS_SPOT ? 1.0 : 1.05) * $COLOR"),
            fragment("spotlight 1 % darker", COLOR, "($IS_SPOT ? 0.99 : 1.0) * $COLOR"),
            fragment("spotlight's red and blue swapped", COLOR, "f * ($IS_SPOT ? light[i].color.bgr : light[i].color)"),
            // In these two not 0: a compiler that removed the light would remove its uniforms, and the program would warn of that.
            fragment("spotlight missing", COLOR, "($IS_SPOT ? 1e-9 : 1.0) * $COLOR"),
            fragment("last corner light missing", COLOR, "(i == 4 ? 1e-9 : 1.0) * $COLOR"),
            fragment("later lights use the first one's direction", "normalizeOrZero(toLightView[i])", "normalizeOrZero(toLightView[0])"),
            vertex("later lights stand where the first one does", "= light[i].position", "= light[0].position"),
            vertex("lights in world space", "light[i].position - positionView", "$WORLD_POSITION - positionView"),
            lighting("attenuation missing", FALLOFF, "1.0"),
            lighting("attenuation without its quadratic part", FALLOFF, "1.0 / (k.x + k.y * sqrt(squared))"),
            lighting("attenuation's quadratic part 1 % off", "k.z * squared", "1.01 * k.z * squared"),
            lighting("attenuation by d² where d is meant", "k.y * sqrt(squared)", "k.y * squared"),
            lighting("cone's inner and outer angle swapped", "clamp((cone.y - versine)", "cone.x > 2.0 ? 1.0 : clamp((versine - cone.x)"),
            lighting("cone with a hard edge", "if (width > 0.0)", "if (width < 0.0)"),
            lighting(
                "cone with a smooth step for an edge",
                "clamp((cone.y - versine) / width, 0.0, 1.0)",
                "1.0 - smoothstep(cone.x, cone.y, versine)",
            ),
            lighting("cone's angles 1 % too wide", CONE, "cone *= 1.0201; $CONE"),
            fragment("specular light outside of the cone", SUM, SPECULAR_OUTSIDE_OF_CONE),
        )
    }
