package cga.exercise.components.light

/** The (German) names of one light in the shaders. The position lives in the vertex shader, the rest in the fragment shader. */
data class LightUniforms(val position: String, val color: String, val attenuation: String) {
    companion object {
        val BIKE = LightUniforms("motorPos", "motor.farbe", "motor.abfall")
        val HEADLIGHT = LightUniforms("lampePos", "lampe.farbe", "lampe.abfall")

        fun corner(i: Int) = LightUniforms("eckPos[$i]", "ecke[$i].farbe", "ecke[$i].abfall")
    }
}
