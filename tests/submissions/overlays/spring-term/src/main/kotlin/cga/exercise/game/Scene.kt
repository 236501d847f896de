package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2d
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
        ?: throw IllegalStateException("motorcycle not found")
    private val camera = TronCamera()

    private val groundGlow = Vector3f(0f, 1f, 0f)
    private val bikeGlow = Vector3f(1f, 1f, 1f)

    // shares its colour with the motorcycle
    private val bikeLight = PointLight(Vector3f(0f, 1.3f, 0.4f), bikeGlow, 0)
    private val pointLights = listOf(
        bikeLight,
        PointLight(Vector3f(-14f, 2f, -14f), Vector3f(22f, 3f, 1f), 1),
        PointLight(Vector3f(14f, 2f, -14f), Vector3f(2f, 20f, 8f), 2),
        PointLight(Vector3f(14f, 2f, 14f), Vector3f(4f, 4f, 26f), 3),
        PointLight(Vector3f(-14f, 2f, 14f), Vector3f(18f, 2f, 18f), 4)
    )
    private val spotLight = SpotLight(Vector3f(0f, 1.1f, -1.8f), Vector3f(14f, 14f, 12f), 5, Math.toRadians(14f), Math.toRadians(26f))

    private var oldMouse: Vector2d? = null

    init {
        glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(
            VertexAttribute(3, 8 * 4, 0),
            VertexAttribute(2, 8 * 4, 3 * 4),
            VertexAttribute(3, 8 * 4, 5 * 4)
        )
        val groundMaterial = Material(
            groundTexture("ground_diff"), groundTexture("ground_emit"), groundTexture("ground_spec"), 60f, Vector2f(64f)
        )
        ground = Renderable(mutableListOf(Mesh(groundObj.vertexData, groundObj.indexData, attributes, groundMaterial)))

        motorcycle.scale(Vector3f(0.8f))

        bikeLight.parent = motorcycle
        spotLight.rotate(Math.toRadians(-12f), 0f, 0f)
        spotLight.parent = motorcycle

        camera.parent = motorcycle
        camera.preTranslate(Vector3f(0f, 2.4f, 3.6f))
        camera.rotate(Math.toRadians(-30f), 0f, 0f)
    }

    private fun groundTexture(name: String) = Texture2D("assets/textures/$name.png", true).apply {
        setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        bikeGlow.x = 0.6f + 0.4f * sin(0.9f * t)
        bikeGlow.y = 0.6f + 0.4f * cos(1.4f * t)
        bikeGlow.z = 0.6f - 0.4f * sin(0.5f * t)

        staticShader.use()
        camera.bind(staticShader)
        for (light in pointLights) light.bind(staticShader)
        spotLight.bind(staticShader, camera.getCalculateViewMatrix())

        ground.render(staticShader, groundGlow)
        motorcycle.render(staticShader, bikeGlow)
    }

    fun update(dt: Float, t: Float) {
        var drive = 0f
        if (window.getKeyState(GLFW_KEY_W)) drive -= 5f
        if (window.getKeyState(GLFW_KEY_S)) drive += 5f

        var turn = 0f
        if (window.getKeyState(GLFW_KEY_A)) turn += 1f
        if (window.getKeyState(GLFW_KEY_D)) turn -= 1f

        if (drive != 0f) {
            motorcycle.rotate(0f, turn * dt, 0f)
            motorcycle.translate(Vector3f(0f, 0f, drive * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val mouse = Vector2d(xpos, ypos)
        oldMouse?.let { old ->
            val yaw = ((old.x - mouse.x) * 0.002).toFloat()
            camera.rotateAroundPoint(0f, yaw, 0f, Vector3f())
        }
        oldMouse = mouse
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
