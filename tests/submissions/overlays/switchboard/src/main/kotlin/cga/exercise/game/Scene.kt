package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.*
import cga.exercise.components.light.*
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.pow
import kotlin.math.sin

/**
 * Keys: WASD drive, 1 the light of the motorcycle, 2 headlight, 3 to 6 corners, 7 sun, 8 ambient light, L all lighting, T toon, F fog.
 */
class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/uber.vert", "assets/shaders/uber.frag")
    private val camera = TronCamera()
    private val ground: Renderable
    private val motorcycle: Renderable
    private val bulb = sphereMesh()

    private val bikeLamp = PointLight(Vector3f(0.0f, 1.9f, 0.2f), Vector3f(1.0f))
    private val torch = SpotLight(Vector3f(0.0f, 0.8f, -1.9f), Vector3f(3.2f, 3.2f, 2.8f), toRadians(15.0f), toRadians(27.0f))
    private val corners = listOf(
        PointLight(Vector3f(-14.0f, 1.8f, -14.0f), Vector3f(7.0f, 1.0f, 0.5f)),
        PointLight(Vector3f(14.0f, 1.8f, -14.0f), Vector3f(0.5f, 1.5f, 8.0f)),
        PointLight(Vector3f(14.0f, 1.8f, 14.0f), Vector3f(5.0f, 5.0f, 0.5f)),
        PointLight(Vector3f(-14.0f, 1.8f, 14.0f), Vector3f(5.5f, 0.5f, 6.0f))
    )
    private val lamps = listOf(bikeLamp) + corners
    private val sun = Sunlight(Vector3f(0.5f, 1.0f, 0.3f), Vector3f(0.16f, 0.15f, 0.12f))
    private val ambience = Ambience(Vector3f(0.03f), Vector3f(0.05f, 0.06f, 0.09f), Vector3f(0.03f, 0.03f, 0.02f))

    private var lit = true
    private var toon = false
    private var fog = false
    private var mouseX: Double? = null
    private var mouseY = 0.0

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glEnable(GL_DEPTH_TEST)

        val model = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        val material = Material(groundMap("diff"), groundMap("emit"), groundMap("spec"), 60.0f, Vector2f(64.0f))
        ground = Renderable(mutableListOf(Mesh(model.vertexData, model.indexData, layout, material)))
        ground.tint.set(0.0f, 1.0f, 0.0f)

        motorcycle = requireNotNull(ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f))
        motorcycle.scaleLocal(Vector3f(0.8f))

        camera.parent = motorcycle
        bikeLamp.parent = motorcycle
        torch.rotateLocal(toRadians(-7.0f), 0.0f, 0.0f)
        torch.parent = motorcycle
        GLError.checkThrow()
    }

    private fun groundMap(kind: String) = Texture2D("assets/textures/ground_$kind.png", true).apply {
        setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        motorcycle.tint.set(sin(1.1f * t).pow(2), sin(0.8f * t + 1.0f).pow(2), sin(0.5f * t + 2.0f).pow(2))
        bikeLamp.color.set(motorcycle.tint)

        val view = camera.getCalculateViewMatrix()
        shader.use()
        camera.bind(shader)
        shader.setUniform("uLit", lit)
        shader.setUniform("uToon", toon)
        shader.setUniform("uFog", fog)
        shader.setUniform("uFogRange", Vector2f(8.0f, 40.0f))

        lamps.forEachIndexed { i, lamp -> lamp.bind(shader, "uLamps[$i]", view) }
        shader.setUniform("uLampCount", lamps.size)
        torch.bind(shader, "uTorch", view)
        sun.bind(shader, view)
        ambience.bind(shader, view)

        ground.render(shader, view)
        motorcycle.render(shader, view)
        drawBulbs(view)
    }

    /** Small spheres where the lights are, without lighting. */
    private fun drawBulbs(view: Matrix4f) {
        shader.setUniform("uLit", false)
        for (lamp in lamps + torch) {
            if (!lamp.on) continue
            val size = if (lamp in corners) 0.2f else 0.06f
            val sphere = Renderable(mutableListOf(bulb))
            sphere.translateLocal(lamp.getWorldPosition())
            sphere.scaleLocal(Vector3f(size))
            sphere.tint.set(lamp.color).div(maxOf(1.0f, lamp.color.get(lamp.color.maxComponent())))
            sphere.render(shader, view)
        }
    }

    fun update(dt: Float, t: Float) {
        val gas = when {
            window.getKeyState(GLFW_KEY_W) -> 6.0f
            window.getKeyState(GLFW_KEY_S) -> -4.0f
            else -> return
        }
        val steer = when {
            window.getKeyState(GLFW_KEY_A) -> 1.0f
            window.getKeyState(GLFW_KEY_D) -> -1.0f
            else -> 0.0f
        }
        motorcycle.rotateLocal(0.0f, 0.25f * gas * steer * dt, 0.0f)
        motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -gas * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (action != GLFW_PRESS) return
        when (key) {
            GLFW_KEY_L -> lit = !lit
            GLFW_KEY_T -> toon = !toon
            GLFW_KEY_F -> fog = !fog
            in GLFW_KEY_1..GLFW_KEY_8 -> {
                val switch = (listOf<Switchable>(bikeLamp, torch) + corners + sun + ambience)[key - GLFW_KEY_1]
                switch.on = !switch.on
            }
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        mouseX?.let { x ->
            camera.orbit(((x - xpos) * SENSITIVITY).toFloat(), ((mouseY - ypos) * SENSITIVITY).toFloat())
        }
        mouseX = xpos
        mouseY = ypos
    }

    fun cleanup() {
        listOf(ground, motorcycle).forEach { it.cleanup() }
        bulb.cleanup()
        shader.cleanup()
    }

    companion object {
        private const val SENSITIVITY = 0.002
    }
}
