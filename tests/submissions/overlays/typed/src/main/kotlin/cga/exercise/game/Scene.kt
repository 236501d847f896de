package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightManager
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val ground: Renderable
    private val cycle: Renderable
    private val camera = TronCamera()
    private val lights = LightManager()
    private val cycleLight: PointLight

    // the camera hangs on this, and it on the motorcycle
    private val boom = Transformable()
    private var previousX = Double.NaN

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glEnable(GL_DEPTH_TEST)

        ground = loadGround()
        cycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: error("motorcycle.obj is missing")
        cycle.scaleLocal(Vector3f(0.8f))

        boom.parent = cycle
        camera.parent = boom
        camera.translateLocal(Vector3f(0.0f, 2.0f, 4.0f))
        camera.rotateLocal(toRadians(-25.0f), 0.0f, 0.0f)

        cycleLight = PointLight(Vector3f(0.0f, 1.8f, 0.3f), Vector3f(1.0f))
        cycleLight.parent = cycle
        lights += cycleLight

        val headlight = SpotLight(Vector3f(0.0f, 0.9f, -1.9f), Vector3f(3.5f, 3.5f, 3.0f), toRadians(14.0f), toRadians(26.0f))
        headlight.rotateLocal(toRadians(-8.0f), 0.0f, 0.0f)
        headlight.parent = cycle
        lights += headlight

        val colors = arrayOf(Vector3f(6.0f, 0.0f, 1.0f), Vector3f(0.0f, 6.0f, 1.0f), Vector3f(1.0f, 0.0f, 6.0f), Vector3f(5.0f, 5.0f, 0.0f))
        val places = arrayOf(Vector3f(14.0f, 2.0f, 14.0f), Vector3f(14.0f, 2.0f, -14.0f), Vector3f(-14.0f, 2.0f, -14.0f), Vector3f(-14.0f, 2.0f, 14.0f))
        for (i in colors.indices) lights += PointLight(places[i], colors[i])
    }

    private fun loadGround(): Renderable {
        val (diff, emit, spec) = listOf("diff", "emit", "spec").map {
            val texture = Texture2D("assets/textures/ground_$it.png", true)
            texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            texture
        }
        val mesh = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val attributes = arrayOf(VertexAttribute(3, stride, 0), VertexAttribute(2, stride, 3 * 4), VertexAttribute(3, stride, 5 * 4))
        val material = Material(diff, emit, spec, 60.0f, Vector2f(64.0f))
        return Renderable(mutableListOf(Mesh(mesh.vertexData, mesh.indexData, attributes, material)))
    }

    private fun colorAt(t: Float) = Vector3f(0.6f + 0.4f * sin(t), 0.6f + 0.4f * cos(1.3f * t), 0.6f + 0.4f * sin(0.7f * t + 1.0f))

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val color = colorAt(t)
        cycleLight.color = color

        shader.use()
        camera.bind(shader)
        lights.bindAll(shader, camera)
        draw(ground, Vector3f(0.0f, 1.0f, 0.0f))
        draw(cycle, color)
    }

    private fun draw(thing: Renderable, emission: Vector3f) {
        shader.setUniform("u_emission", emission)
        thing.render(shader, camera.getCalculateViewMatrix())
    }

    fun update(dt: Float, t: Float) {
        val forward = axis(GLFW_KEY_W, GLFW_KEY_S)
        val side = axis(GLFW_KEY_A, GLFW_KEY_D)
        if (forward == 0.0f) return
        cycle.rotateLocal(0.0f, side * forward * dt, 0.0f)
        cycle.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * forward * dt))
    }

    private fun axis(plus: Int, minus: Int): Float {
        var value = 0.0f
        if (window.getKeyState(plus)) value += 1.0f
        if (window.getKeyState(minus)) value -= 1.0f
        return value
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (!previousX.isNaN()) {
            boom.rotateLocal(0.0f, (0.002 * (previousX - xpos)).toFloat(), 0.0f)
        }
        previousX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        cycle.cleanup()
        shader.cleanup()
    }
}
