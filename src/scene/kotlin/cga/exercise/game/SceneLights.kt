package cga.exercise.game

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4dc
import org.joml.Vector3f
import org.joml.Vector3fc

/** The lights of the scene, and which of them shine at which [Step]. */
public class SceneLights(motorcycle: Transformable) {
    // solution 4.2.2: a point light, child of the motorcycle, high enough to light the ground
    // solution 4.3.2: a spotlight at the front of the motorcycle, turned down a little
    // solution 4.6: more point lights of different colours, for example in the corners of the ground
    private val pointLight = PointLight(Vector3f(0f, 1.6f, 0f), WHITE).apply { parent = motorcycle }
    private val spotLight =
        SpotLight(Vector3f(0f, 0.64f, -1.8f), Vector3f(1.3f, 1.3f, 1.17f), radians(13f), radians(66f)).apply {
            rotateLocal(radians(-14f), 0f, 0f)
            parent = motorcycle
        }
    private val cornerLights =
        listOf(
            corner(-1, -1, Vector3f(16f, 1f, 0.5f)),
            corner(1, -1, Vector3f(0.5f, 2f, 16f)),
            corner(-1, 1, Vector3f(14f, 9f, 0.5f)),
            corner(1, 1, Vector3f(13f, 0.5f, 10f)),
        )
    private val attenuated = (cornerLights + pointLight + spotLight).associateWith { Vector3f(it.attenuation) }
    // end of solution

    /** The lights that shine, in the shaders' order; changed by [switchTo]. */
    public var shining: List<PointLight> = emptyList()
        private set

    public fun switchTo(step: Step) {
        shining = lights(step)
        // solution 4.3.4: no attenuation, which is (1, 0, 0), before its step
        for ((light, k) in attenuated) light.attenuation = if (step.attenuation) k else CONSTANT
        // end of solution
    }

    /** The colour of the motorcycle's own light. */
    public fun setMotorcycleColor(color: Vector3fc) {
        // solution 4.4: the point light of the motorcycle has its colour
        pointLight.lightColor = color
        // end of solution
    }

    /** How many lights shine at [step], by the name of the shaders' constant. */
    public fun count(step: Step): Map<String, Int> = mapOf("LIGHTS" to lights(step).size)

    /** Sends the lights that shine to the program in use. */
    public fun bind(
        shaderProgram: ShaderProgram,
        view: Matrix4dc,
    ) {
        // solution 4.2.2: bind the lights, by their names
        for (i in shining.indices) shining[i].bind(shaderProgram, NAMES[i], view)
        // end of solution
    }

    // solution 4.2.2: the lights that shine at this step: the point light; 4.3.2: and the spotlight; 4.6: and the further ones
    // instead: private fun lights(step: Step): List<PointLight> = emptyList()
    private fun lights(step: Step): List<PointLight> =
        buildList {
            if (step.pointLight) add(pointLight)
            if (step.cornerLights) addAll(cornerLights)
            if (step.spotLight) add(spotLight)
        }
    // end of solution

    private companion object {
        // solution
        const val CORNER = 16f

        // end of solution
        val WHITE: Vector3fc = Vector3f(1f)
        val CONSTANT: Vector3fc = Vector3f(1f, 0f, 0f)

        // As many as a driver surely has varyings for.
        val NAMES = Array(10) { "light[$it]" }

        fun radians(degrees: Float): Float = Math.toRadians(degrees.toDouble()).toFloat()

        // solution
        fun corner(
            x: Int,
            z: Int,
            color: Vector3fc,
        ) = PointLight(Vector3f(x * CORNER, 1.2f, z * CORNER), color)
        // end of solution
    }
}
