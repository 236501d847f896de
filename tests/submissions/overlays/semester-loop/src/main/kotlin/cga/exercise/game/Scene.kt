package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.*
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera = TronCamera()

    // slot 0: light of the motorcycle, slot 1: headlight, from slot 2 on: corners
    private val bikeLight = PointLight(Vector3f(0f, 1.8f, 0f), Vector3f(1f), 0)
    private val headlight = SpotLight(
        Vector3f(0f, 0.95f, -1.9f), Vector3f(1f, 0.95f, 0.85f), 1, 14f, Math.toRadians(13f), Math.toRadians(26f)
    )
    private val cornerLights = ArrayList<PointLight>()

    private val green = Vector3f(0f, 1f, 0f)
    private val bikeColor = Vector3f()

    private var firstMouse = true
    private var oldMousePosX = 0.0

    init {
        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        ground = createGround()

        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
        motorcycle.scale(Vector3f(0.8f))

        camera.parent = motorcycle
        camera.rotate(Math.toRadians(-30f), 0f, 0f)
        camera.translate(Vector3f(0f, 0f, 4.2f))

        bikeLight.parent = motorcycle
        headlight.parent = motorcycle
        headlight.rotate(Math.toRadians(-11f), 0f, 0f)

        val colors = arrayOf(
            Vector3f(1f, 0.1f, 0.1f), Vector3f(0.1f, 0.2f, 1f), Vector3f(1f, 0.8f, 0.1f), Vector3f(0.9f, 0.1f, 1f)
        )
        val places = arrayOf(
            Vector3f(-18f, 2f, -18f), Vector3f(18f, 2f, -18f), Vector3f(18f, 2f, 18f), Vector3f(-18f, 2f, 18f)
        )
        for (i in 0..3) {
            cornerLights.add(PointLight(places[i], colors[i], 2 + i, 22f))
        }
    }

    private fun createGround(): Renderable {
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        val mesh = Mesh(obj.vertexData, obj.indexData, attributes, Material(diff, emit, spec, 60f, Vector2f(64f)))
        return Renderable(mutableListOf(mesh))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        bikeColor.set(abs(sin(t)), abs(sin(0.6f * t + 1f)), abs(cos(0.4f * t)))
        bikeLight.lightColor.set(bikeColor)

        staticShader.use()
        camera.bind(staticShader)
        bikeLight.bind(staticShader)
        headlight.bind(staticShader, camera.getCalculateViewMatrix())
        for (light in cornerLights) {
            light.bind(staticShader)
        }

        ground.render(staticShader, green)
        motorcycle.render(staticShader, bikeColor)
    }

    fun update(dt: Float, t: Float) {
        var speed = 0f
        if (window.getKeyState(GLFW_KEY_W)) speed = 6f
        if (window.getKeyState(GLFW_KEY_S)) speed = -3f

        if (speed != 0f) {
            var yaw = 0f
            if (window.getKeyState(GLFW_KEY_A)) yaw = 1.2f
            if (window.getKeyState(GLFW_KEY_D)) yaw = -1.2f
            motorcycle.rotate(0f, yaw * dt, 0f)
            motorcycle.translate(Vector3f(0f, 0f, -speed * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            firstMouse = false
        } else {
            val yaw = (oldMousePosX - xpos).toFloat() * 0.002f
            camera.rotateAroundPoint(0f, yaw, 0f, Vector3f(0f))
        }
        oldMousePosX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
