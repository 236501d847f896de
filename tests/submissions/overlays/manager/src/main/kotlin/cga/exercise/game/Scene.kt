package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightSet
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val camera = TronCamera()
    private val ground = createGround()
    private val bike = createBike()
    private val lights = LightSet(ambient = Vector3f(0.04f, 0.04f, 0.05f))
    private val bikeLight = PointLight(Vector3f(0f, 1.4f, 0.4f), Vector3f(1f, 1f, 1f))
    private val headlight = SpotLight(Vector3f(0f, 1.1f, -1.6f), Vector3f(4f, 4f, 3.6f), toRadians(15f), toRadians(28f))
    private val cornerLights = arrayOf(
        PointLight(Vector3f(18f, 1.8f, 18f), Vector3f(8f, 2f, 0f)),
        PointLight(Vector3f(18f, 1.8f, -18f), Vector3f(0f, 5f, 6f)),
        PointLight(Vector3f(-18f, 1.8f, -18f), Vector3f(6f, 0f, 6f)),
        PointLight(Vector3f(-18f, 1.8f, 18f), Vector3f(2f, 2f, 8f)),
        PointLight(Vector3f(-4f, 2.2f, -7f), Vector3f(3f, 0.5f, 1f))
    )
    private var mouseX: Double? = null

    init {
        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)

        bike.scaleLocal(Vector3f(0.8f))
        ground.emissionColor = Vector3f(0f, 1f, 0f)

        // everything that moves with the motorcycle
        bikeLight.parent = bike
        headlight.parent = bike
        headlight.rotateLocal(toRadians(-9f), 0f, 0f)
        camera.parent = bike
        camera.translateLocal(Vector3f(0f, 2.4f, 3.6f))
        camera.rotateLocal(toRadians(-28f), 0f, 0f)

        lights.add(bikeLight)
        lights.add(headlight)
        for (light in cornerLights) {
            lights.add(light)
        }
        GLError.checkThrow()
    }

    private fun createGround(): Renderable {
        val textures = arrayOf("diff", "emit", "spec").map { Texture2D("assets/textures/ground_$it.png", true) }
        textures.forEach { it.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR) }
        val material = Material(textures[0], textures[1], textures[2], 60f, Vector2f(64f, 64f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, layout, material)))
    }

    private fun createBike(): Renderable =
        ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f) ?: throw Exception("no motorcycle")

    private fun rainbow(t: Float) = Vector3f(sin(t), sin(t + 2.1f), sin(t + 4.2f)).mul(0.5f).add(0.5f, 0.5f, 0.5f)

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val color = rainbow(0.8f * t)
        bike.emissionColor = color
        bikeLight.color = color

        shader.use()
        camera.bind(shader)
        lights.upload(shader)

        ground.render(shader)
        bike.render(shader)
        GLError.checkThrow()
    }

    fun update(dt: Float, t: Float) {
        var way = 0f
        if (window.getKeyState(GLFW_KEY_W)) way -= 4f * dt
        if (window.getKeyState(GLFW_KEY_S)) way += 4f * dt
        if (way != 0f) {
            if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0f, 1.2f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0f, -1.2f * dt, 0f)
            bike.translateLocal(Vector3f(0f, 0f, way))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val old = mouseX ?: xpos
        camera.orbit(-0.002f * (xpos - old).toFloat())
        mouseX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
