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
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    // Objekte
    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera: TronCamera

    // Lichter
    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val cornerLights: Array<PointLight>

    // Farben für die Emission
    private val groundColor = Vector3f(0f, 1f, 0f)
    private val motorcycleColor = Vector3f(1f, 1f, 1f)

    // letzte Mausposition, NaN = es gab noch keine
    private var lastX = Double.NaN

    init {
        glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        ground = createGround()

        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
            ?: error("Motorrad konnte nicht geladen werden")
        motorcycle.scale(Vector3f(0.8f))

        camera = TronCamera()
        camera.rotate(Math.toRadians(-32f), 0f, 0f)
        camera.translate(Vector3f(0f, 0.3f, 4.2f))
        camera.parent = motorcycle

        pointLight = PointLight(Vector3f(0f, 1.6f, 0.2f), motorcycleColor)
        pointLight.parent = motorcycle

        spotLight = SpotLight(Vector3f(0f, 1f, -1.8f), Vector3f(16f, 15f, 13f), Math.toRadians(15f), Math.toRadians(26f))
        spotLight.rotate(Math.toRadians(-12f), 0f, 0f)
        spotLight.parent = motorcycle

        // vier Ecken, Anzahl muss zu CORNER_LIGHTS in tron_frag.glsl passen!
        cornerLights = arrayOf(
            PointLight(Vector3f(-17f, 1.8f, -17f), Vector3f(22f, 2f, 2f)),
            PointLight(Vector3f(17f, 1.8f, -17f), Vector3f(2f, 6f, 24f)),
            PointLight(Vector3f(-17f, 1.8f, 17f), Vector3f(18f, 2f, 20f)),
            PointLight(Vector3f(17f, 1.8f, 17f), Vector3f(20f, 15f, 1f))
        )
    }

    private fun createGround(): Renderable {
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        listOf(diff, emit, spec).forEach { it.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR) }
        val material = Material(diff, emit, spec, 60f, Vector2f(64f, 64f))

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        return Renderable(mutableListOf(Mesh(res.vertexData, res.indexData, attributes, material)))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        staticShader.use()
        camera.bind(staticShader)

        pointLight.bind(staticShader)
        spotLight.bind(staticShader, camera.getCalculateViewMatrix())
        bindCornerLights()

        staticShader.setUniform("emissionColor", groundColor)
        ground.render(staticShader)

        staticShader.setUniform("emissionColor", motorcycleColor)
        motorcycle.render(staticShader)
    }

    private fun bindCornerLights() {
        for (i in cornerLights.indices) {
            staticShader.setUniform("cornerLightPositions[$i]", cornerLights[i].getWorldPosition())
            staticShader.setUniform("cornerLightColors[$i]", cornerLights[i].lightColor)
        }
    }

    fun update(dt: Float, t: Float) {
        // Regenbogen, eine Runde in 12 Sekunden
        // motorcycleColor.set(abs(sin(t)), abs(sin(t * 0.5f)), abs(sin(t * 0.3f)))
        motorcycleColor.set(hsvToRgb(t / 12f, 0.8f, 1f))
        pointLight.lightColor = motorcycleColor

        var speed = 0f
        if (window.getKeyState(GLFW_KEY_W)) speed = 6f
        if (window.getKeyState(GLFW_KEY_S)) speed = -3f

        if (speed != 0f) {
            val steering = Math.toRadians(15f) * speed * dt
            if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotate(0f, steering, 0f)
            if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotate(0f, -steering, 0f)
            motorcycle.translate(Vector3f(0f, 0f, -speed * dt))
        }
    }

    // alle Werte 0..1, h darf auch größer sein
    private fun hsvToRgb(h: Float, s: Float, v: Float): Vector3f {
        fun channel(n: Int): Float {
            val k = (h * 6f + n) % 6f
            return v * (1f - s + s * (abs(k - 3f) - 1f).coerceIn(0f, 1f))
        }
        return Vector3f(channel(0), channel(4), channel(2))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (!lastX.isNaN()) {
            val angle = (lastX - xpos) * 0.002
            // Kamera ist Child vom Motorrad => Motorrad liegt im Ursprung
            camera.rotateAroundPoint(0f, angle.toFloat(), 0f, Vector3f(0f))
        }
        lastX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
