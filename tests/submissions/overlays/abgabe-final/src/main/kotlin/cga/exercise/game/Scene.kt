package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SceneLights
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
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val camera = TronCamera()
    private val ground = Renderable()
    private val cycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
        ?: throw Exception("Renderable can't be NULL!")

    private val lights = SceneLights()
    private val cycleLight = PointLight(Vector3f(0f, 1.4f, 0f), Vector3f(1f, 1f, 1f))
    private val headLight = SpotLight(Vector3f(0f, 1f, -2f), Vector3f(4f, 4f, 3.6f), toRadians(16f), toRadians(24f))

    private var speed = 0f
    private var oldX: Double? = null

    init {
        setupGL()
        setupGround()

        cycle.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        camera.rotateLocal(toRadians(-32f), 0f, 0f)
        camera.translateLocal(Vector3f(0f, 0f, 4f))
        camera.parent = cycle

        cycleLight.parent = cycle
        headLight.parent = cycle
        headLight.rotateLocal(toRadians(-9f), 0f, 0f)
        lights.add(cycleLight)
        lights.add(headLight)

        // 4.6
        lights.add(PointLight(Vector3f(16f, 2f, 16f), Vector3f(9f, 4f, 0f)))
        lights.add(PointLight(Vector3f(-16f, 2f, 16f), Vector3f(0f, 8f, 8f)))
        lights.add(PointLight(Vector3f(16f, 2f, -16f), Vector3f(9f, 0f, 2f)))
        lights.add(PointLight(Vector3f(-16f, 2f, -16f), Vector3f(1f, 1f, 10f)))

        // the lamp of the cycle always has the colour of the cycle
        cycleLight.color = cycle.emissionColor
        GLError.checkThrow()
        println("Scene ready, camera at ${camera.getWorldPosition()}")
    }

    private fun setupGL() {
        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
    }

    private fun setupGround() {
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        for (tex in listOf(emit, diff, spec)) {
            tex.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }
        val material = Material(diff, emit, spec, 60f, Vector2f(64f, 64f))

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        ground.meshes.add(Mesh(obj.vertexData, obj.indexData, attributes, material))
        ground.emissionColor = Vector3f(0f, 1f, 0f)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()

        cycle.emissionColor.set(wave(t), wave(t * 0.7f + 2f), wave(t * 1.3f + 4f))

        camera.bind(staticShader)
        lights.bind(staticShader, camera)
        ground.render(staticShader)
        cycle.render(staticShader)
    }

    private fun wave(x: Float) = 0.55f + 0.45f * sin(x)

    fun update(dt: Float, t: Float) {
        speed = 0f
        if (window.getKeyState(GLFW_KEY_W)) speed += 6f
        if (window.getKeyState(GLFW_KEY_S)) speed -= 3f

        var steering = 0f
        if (window.getKeyState(GLFW_KEY_A)) steering += 0.25f
        if (window.getKeyState(GLFW_KEY_D)) steering -= 0.25f

        cycle.rotateLocal(0f, steering * speed * dt, 0f)
        cycle.translateLocal(Vector3f(0f, 0f, -speed * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_P && action == GLFW_PRESS) println("cycle at ${cycle.getWorldPosition()}")
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        val last = oldX ?: xpos
        val angle = ((last - xpos) * 0.002).toFloat()
        oldX = xpos
        camera.rotateAroundPoint(0f, angle, 0f, Vector3f(0f, 0f, 0f))
    }

    fun cleanup() {
        ground.cleanup()
        cycle.cleanup()
        staticShader.cleanup()
    }
}
