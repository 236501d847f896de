package cga.inspect.doctor

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.ShaderSource
import cga.exercise.game.DriveScript
import cga.exercise.game.Scene
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.inspect.view.InspectedProgram
import cga.inspect.view.Look
import cga.inspect.view.Traffic
import cga.testing.Offscreen
import cga.testing.Slow
import org.joml.Matrix3fc
import org.joml.Matrix4d
import org.joml.Vector2fc
import org.joml.Vector3f
import org.joml.Vector3fc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.writeText

/** Every cause of a dark picture, provoked. */
@ExtendWith(Offscreen::class)
@Slow
class SceneDoctorTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `a sound scene has no cause at any step that has lights, and is lit`() {
        for (step in Step.entries.filter { it != Step.EMISSION }) {
            val evidence = evidence(step)
            assertEquals(emptyList<String>(), Diagnosis.of(evidence).map { it.found }, "$step")
            assertTrue(!evidence.isBlack && !evidence.isUnlit) { "$step: black ${evidence.isBlack}, unlit ${evidence.isUnlit}" }
        }
    }

    @Test
    fun `a step without lights`() {
        val evidence = evidence(Step.EMISSION)
        assertTrue(evidence.isUnlit && !evidence.isBlack)
        assertFirst("No light shines at this step", evidence)
    }

    @Test
    fun `the program is not in use`() {
        val evidence = evidence {
            object : Program(it) {
                override fun use() = Unit
            }
        }
        assertTrue(evidence.isBlack)
        assertEquals(listOf("No shader program is in use when the scene is drawn."), Diagnosis.of(evidence).map { it.found })
    }

    @Test
    fun `no light is bound`() {
        val evidence = evidence {
            object : Program(it) {
                override fun setUniform(
                    name: String,
                    value: Vector3fc,
                ) = if (name.startsWith("light")) Unit else super.setUniform(name, value)

                override fun setUniform(name: String, value: Vector2fc) = if (name.startsWith(
                        "light",
                    )
                ) {
                    Unit
                } else {
                    super.setUniform(name, value)
                }
            }
        }
        assertTrue(evidence.isUnlit)
        assertFirst("No light is bound: nobody sends light[0].", evidence)
    }

    @Test
    fun `a uniform has another name in the shader`() {
        val evidence = evidence(fragment = { it.replace(Regex("\\blight\\["), "ligth[") })
        assertFirst("The shader uses ligth[0].", evidence)
        assertTrue("The nearest name that is sent is light." in Diagnosis.of(evidence).first().found) { found(evidence) }
    }

    @Test
    fun `a uniform is sent under a name that no shader has`() {
        val evidence = evidence {
            object : Program(it) {
                override fun setUniform(
                    name: String,
                    value: Vector3fc,
                ) = super.setUniform(name.replace("emissiveTint", "emissivTint"), value)
            }
        }
        assertTrue(Diagnosis.of(evidence).any { "emissiveTint" in it.found && "emissivTint" in it.found }) { found(evidence) }
    }

    @Test
    fun `the lights are black`() {
        val evidence = evidence(change = { scene ->
            scene.lights.shining.forEach { it.lightColor = Vector3f() }
            scene.motorcycleColor = Vector3f()
        })
        assertTrue(evidence.isUnlit)
        assertFirst("Every light is black", evidence)
    }

    @Test
    fun `K is 0`() {
        val evidence = evidence {
            object : Program(it) {
                override fun setUniform(name: String, value: Vector3fc) = super.setUniform(
                    name,
                    if ("attenuation" in
                        name
                    ) {
                        Vector3f()
                    } else {
                        value
                    },
                )
            }
        }
        assertFirst("light[0].attenuation and 5 more: K is (0, 0, 0)", evidence)
    }

    @Test
    fun `normals are 0 for want of a matrix, or in the mesh`() {
        val noMatrix = evidence {
            object : Program(it) {
                override fun setUniform(name: String, value: Matrix3fc, transpose: Boolean) = Unit
            }
        }
        assertTrue(noMatrix.isUnlit)
        assertFirst("normalMatrix is 0", noMatrix)
        val flat = evidence(change = { scene ->
            val vertices = scene.ground.meshes.first().vertexdata
            for (i in vertices.indices) if (i % 8 >= 5) vertices[i] = 0f
        })
        assertFirst("All normals of mesh 0 are 0", flat)
    }

    @Test
    fun `NaN is sent, or made in the shader`() {
        val sent = evidence {
            object : Program(it) {
                override fun setUniform(name: String, value: Vector3fc) = super.setUniform(
                    name,
                    if (name ==
                        "ambient"
                    ) {
                        Vector3f(Float.NaN)
                    } else {
                        value
                    },
                )
            }
        }
        assertTrue(sent.isBlack)
        assertFirst("ambient is NaN", sent)
        val made = evidence(fragment = { it.replace("fragColor = vec4(", "fragColor = sqrt(-1.0 - emissive.r) * vec4(") })
        assertTrue(made.isBlack)
        assertTrue(Regex("""\d+ pixels of 14400 are NaN""").containsMatchIn(found(made))) { found(made) }
    }

    @Test
    fun `a light is in the ground, or under it`() {
        for (y in listOf(0f, -0.5f, -3f)) {
            val evidence = evidence(change = { scene ->
                val corner = scene.lights.shining[1]
                corner.setLocalModelMatrix(corner.getLocalModelMatrix().setTranslation(3f, y, 3f))
            })
            assertFirst("light[1] is in or under the ground", evidence)
        }
    }

    @Test
    fun `the camera is inside of the motorcycle, or under the ground`() {
        val sound = evidence()
        for ((y, z) in listOf(0.45 to 0.0, -1.0 to 2.0)) {
            val view = Matrix4d().translation(0.0, -y, -z)
            val frame = with(sound.frame) { Frame(view, projection, ambient, specularModel, gamma, lights, draws) }
            val evidence = with(sound) { Evidence(program, uniforms, samplers, sent, warnings, frame, picture, withoutLights) }
            assertFirst("The camera is inside an object or under the ground", evidence)
        }
    }

    @Test
    fun `two samplers share a unit, and one has no texture`() {
        val shared = evidence {
            object : Program(it) {
                override fun setUniform(name: String, value: Int) = super.setUniform(name, if (name == "material.specular") 0 else value)
            }
        }
        assertTrue(
            Regex("""material\.\w+ and material\.\w+ read the same texture unit, 0""").containsMatchIn(found(shared)),
        ) { found(shared) }
        val empty = evidence {
            object : Program(it) {
                override fun setUniform(name: String, value: Int) = super.setUniform(name, if (name == "material.diffuse") 9 else value)
            }
        }
        assertTrue("material.diffuse reads black: no texture is bound to unit 9" in found(empty)) { found(empty) }
    }

    /** A program whose parts a test spoils. */
    private open class Program(made: Made) : InspectedProgram(made.vertex, made.fragment, made.constants, made.look, made.traffic)

    private class Made(val vertex: String, val fragment: String, val constants: Map<String, Int>, val look: Look, val traffic: Traffic)

    private fun evidence(
        step: Step = Step.FINAL,
        fragment: (String) -> String = { it },
        change: (Scene) -> Unit = {},
        program: (Made) -> ShaderProgram = { Program(it) },
    ): Evidence {
        val look = Look()
        val traffic = Traffic()
        val source = folder.resolve("scene.frag")
        source.writeText(fragment(ShaderSource.read("shaders/scene.frag").text))
        val player =
            ScriptedScene(160, 90, step, DriveScript.NONE) { v, _, constants -> program(Made(v, "$source", constants, look, traffic)) }
        player.advanceTo(ScriptedScene.PRETTY_TIME)
        change(player.scene)
        return try {
            EvidenceReader(player.scene, look, traffic).read()
        } finally {
            player.scene.cleanup()
        }
    }

    private fun assertFirst(expected: String, evidence: Evidence) {
        val first = Diagnosis.of(evidence).firstOrNull()?.found.orEmpty()
        assertTrue(first.startsWith(expected)) { "should begin with \"$expected\":\n${found(evidence)}" }
    }

    private fun found(evidence: Evidence) = Diagnosis.of(evidence).joinToString("\n") { it.found }
}
