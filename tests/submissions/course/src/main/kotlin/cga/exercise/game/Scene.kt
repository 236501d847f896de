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
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = Renderable()
    private val motorcycle: Renderable
    private val camera = TronCamera()

    private val bikeLight: PointLight
    private val headlight: SpotLight
    private val cornerLights: List<PointLight>

    private val groundColor = Vector3f(0.0f, 1.0f, 0.0f)
    private val bikeColor = Vector3f(1.0f)

    private var mouseKnown = false
    private var oldMouseX = 0.0

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // ground
        val groundMaterial = Material(
            loadTexture("assets/textures/ground_diff.png"),
            loadTexture("assets/textures/ground_emit.png"),
            loadTexture("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        ground.meshes.add(Mesh(groundObj.vertexData, groundObj.indexData, attributes, groundMaterial))

        // motorcycle
        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalArgumentException("the motorcycle could not be loaded")
        motorcycle.scaleLocal(Vector3f(0.8f))

        // camera
        camera.parent = motorcycle
        camera.rotateLocal(toRadians(-35.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        // lights
        bikeLight = PointLight(Vector3f(0.0f, 1.5f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        bikeLight.parent = motorcycle

        headlight = SpotLight(Vector3f(0.0f, 1.0f, -1.8f), Vector3f(3.0f, 3.0f, 2.8f), toRadians(12.0f), toRadians(25.0f))
        headlight.rotateLocal(toRadians(-10.0f), 0.0f, 0.0f)
        headlight.parent = motorcycle

        cornerLights = listOf(
            PointLight(Vector3f(-15.0f, 1.5f, -15.0f), Vector3f(8.0f, 0.5f, 0.5f)),
            PointLight(Vector3f(15.0f, 1.5f, -15.0f), Vector3f(0.5f, 0.5f, 8.0f)),
            PointLight(Vector3f(-15.0f, 1.5f, 15.0f), Vector3f(7.0f, 6.0f, 0.5f)),
            PointLight(Vector3f(15.0f, 1.5f, 15.0f), Vector3f(7.0f, 0.5f, 7.0f))
        )
        GLError.checkThrow("in Scene.init")
    }

    private fun loadTexture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        bikeColor.set(abs(sin(t)), abs(sin(t / 2)), abs(sin(t / 3)))
        bikeLight.lightColor.set(bikeColor)

        staticShader.use()
        camera.bind(staticShader)
        bikeLight.bind(staticShader, "bike")
        headlight.bind(staticShader, "spot", camera.getCalculateViewMatrix())
        for ((i, light) in cornerLights.withIndex()) light.bind(staticShader, "corner" + (i + 1))

        staticShader.setUniform("tint", groundColor)
        ground.render(staticShader)
        staticShader.setUniform("tint", bikeColor)
        motorcycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        val speed = when {
            window.getKeyState(GLFW_KEY_W) -> 5.0f
            window.getKeyState(GLFW_KEY_S) -> -5.0f
            else -> 0.0f
        }
        if (speed == 0.0f) return
        if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, 0.3f * speed * dt, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -0.3f * speed * dt, 0.0f)
        motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val deltaX = xpos - oldMouseX
        oldMouseX = xpos
        if (mouseKnown) camera.rotateAroundPoint(0.0f, (-deltaX * 0.002).toFloat(), 0.0f, Vector3f(0.0f))
        mouseKnown = true
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
