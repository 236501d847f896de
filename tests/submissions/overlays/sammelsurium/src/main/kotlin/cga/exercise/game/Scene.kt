package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.EckLicht
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
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private var ground: Renderable
    private var lightCycle: Renderable
    private var camera: TronCamera

    private var pointLight: PointLight
    private var frontLight: SpotLight
    private var eckLichter: ArrayList<EckLicht> = ArrayList()

    // Farben fuer die Emission
    private val bodenFarbe = Vector3f(0f, 1f, 0f)
    private val cycleColor = Vector3f(1f, 1f, 1f)

    // mouse, from learnopengl
    private var firstMouse = true
    private var lastX = 0.0

    //scene setup
    init {
        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val texture_diff = Texture2D("assets/textures/ground_diff.png", true)
        texture_diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val texture_emit = Texture2D("assets/textures/ground_emit.png", true)
        texture_emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val texture_spec = Texture2D("assets/textures/ground_spec.png", true)
        texture_spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(texture_diff, texture_emit, texture_spec, 60f, Vector2f(64f, 64f))

        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val vertexAttributes = arrayOf(
            VertexAttribute(3, 32, 0), // position
            VertexAttribute(2, 32, 12), // texture
            VertexAttribute(3, 32, 20) // normal
        )
        ground = Renderable()
        ground.meshes.add(Mesh(groundObj.vertexData, groundObj.indexData, vertexAttributes, groundMaterial))

        // Motorrad
        lightCycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
            ?: throw IllegalArgumentException("Could not load the light cycle")
        lightCycle.scale(Vector3f(0.8f))

        // Kamera
        camera = TronCamera()
        camera.parent = lightCycle
        camera.rotate(Math.toRadians(-35f), 0f, 0f)
        camera.translate(Vector3f(0f, 0f, 4f))

        // lights
        pointLight = PointLight(Vector3f(0f, 1.6f, 0.2f), cycleColor)
        pointLight.parent = lightCycle

        frontLight = SpotLight(Vector3f(0f, 1f, -2f), Vector3f(12f, 12f, 11f), Math.toRadians(16f), Math.toRadians(28f))
        frontLight.rotate(Math.toRadians(-12f), 0f, 0f)
        frontLight.parent = lightCycle

        var nr = 0
        for (x in listOf(-12f, 12f)) {
            for (z in listOf(-12f, 12f)) {
                val farbe = when (nr) {
                    0 -> Vector3f(14f, 1f, 1f)
                    1 -> Vector3f(1f, 2f, 16f)
                    2 -> Vector3f(13f, 12f, 1f)
                    else -> Vector3f(12f, 1f, 13f)
                }
                eckLichter.add(EckLicht(nr, Vector3f(x, 1.5f, z), farbe))
                nr++
            }
        }
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        cycleColor.set(0.55f + 0.45f * sin(t), 0.55f + 0.45f * sin(0.7f * t + 2f), 0.55f + 0.45f * sin(1.3f * t + 4f))

        staticShader.use()
        camera.bind(staticShader)

        // Lichter VOR den Objekten binden!
        pointLight.bind(staticShader)
        frontLight.bind(staticShader, camera.getCalculateViewMatrix())
        eckLichter.forEach { it.bind(staticShader) }

        staticShader.setUniform("farbe", bodenFarbe)
        ground.render(staticShader)

        staticShader.setUniform("farbe", cycleColor)
        lightCycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            if (window.getKeyState(GLFW_KEY_A)) lightCycle.rotate(0f, 1.5f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) lightCycle.rotate(0f, -1.5f * dt, 0f)
            lightCycle.translate(Vector3f(0f, 0f, -5f * dt))
        } else if (window.getKeyState(GLFW_KEY_S)) {
            lightCycle.translate(Vector3f(0f, 0f, 3f * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }
        val xoffset = lastX - xpos
        lastX = xpos
        camera.rotateAroundPoint(0f, (xoffset * 0.002).toFloat(), 0f, Vector3f(0f, 0f, 0f))
    }

    fun cleanup() {
        ground.cleanup()
        lightCycle.cleanup()
        staticShader.cleanup()
    }
}
