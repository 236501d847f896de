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
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.sin

/**
 * Blatt 4, Gruppe Dienstag
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram
    private val ground: Renderable
    private val motorrad: Renderable
    private val camera: TronCamera

    // Lichter
    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val ecke1: PointLight
    private val ecke2: PointLight
    private val ecke3: PointLight
    private val ecke4: PointLight

    // Maus
    private var oldMousePosX = 0.0
    private var firstMove = true

    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden (Blatt 2 und 3)
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f, 64.0f))

        val stride = 8 * 4
        val attrPos = VertexAttribute(3, stride, 0)
        val attrTC = VertexAttribute(2, stride, 3 * 4)
        val attrNorm = VertexAttribute(3, stride, 5 * 4)
        val objMesh = OBJLoader.loadOBJ("assets/models/ground.obj")
        val groundMesh = Mesh(objMesh.vertexData, objMesh.indexData, arrayOf(attrPos, attrTC, attrNorm), groundMaterial)
        ground = Renderable(mutableListOf(groundMesh))
        ground.emitColor = Vector3f(0.0f, 1.0f, 0.0f)

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Motorrad konnte nicht geladen werden")
        motorrad.translateGlobal(Vector3f(3.0f, 0.0f, 2.0f))
        motorrad.rotateLocal(0.0f, Math.toRadians(25.0).toFloat(), 0.0f)
        motorrad.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        // Kamera
        camera = TronCamera()
        camera.rotateLocal(Math.toRadians(-35.0).toFloat(), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))
        camera.parent = motorrad

        // Aufgabe 4.2
        pointLight = PointLight(Vector3f(0.0f, 1.7f, 0.2f), Vector3f(1.0f, 1.0f, 1.0f))
        pointLight.parent = motorrad

        // Aufgabe 4.3
        spotLight = SpotLight(Vector3f(0.0f, 0.9f, -1.7f), Vector3f(3.0f, 3.0f, 3.0f), 15.0f, 27.0f)
        spotLight.rotateLocal(Math.toRadians(-12.0).toFloat(), 0.0f, 0.0f)
        spotLight.parent = motorrad

        // Aufgabe 4.6
        ecke1 = PointLight(Vector3f(18.0f, 1.5f, 18.0f), Vector3f(8.0f, 0.0f, 0.0f))
        ecke2 = PointLight(Vector3f(18.0f, 1.5f, -18.0f), Vector3f(0.0f, 0.0f, 8.0f))
        ecke3 = PointLight(Vector3f(-18.0f, 1.5f, 18.0f), Vector3f(7.0f, 7.0f, 0.0f))
        ecke4 = PointLight(Vector3f(-18.0f, 1.5f, -18.0f), Vector3f(7.0f, 0.0f, 7.0f))

        println("Scene ok, Meshes Motorrad: " + motorrad.meshes.size)
        //println(spotLight.getWorldZAxis())
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        motorrad.emitColor = Vector3f(abs(sin(t * 0.9f)), abs(sin(t * 0.6f + 1.0f)), abs(sin(t * 0.4f + 2.0f)))
        pointLight.lightColor = motorrad.emitColor

        staticShader.use()
        camera.bind(staticShader)
        pointLight.bind(staticShader, "pointLight")
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())
        ecke1.bind(staticShader, "ecke1")
        ecke2.bind(staticShader, "ecke2")
        ecke3.bind(staticShader, "ecke3")
        ecke4.bind(staticShader, "ecke4")

        motorrad.render(staticShader)
        ground.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) {
                motorrad.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                motorrad.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, 3.0f * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMove) {
            firstMove = false
            oldMousePosX = xpos
        }
        val differenz = (oldMousePosX - xpos) * 0.002
        camera.rotateAroundPoint(0.0f, differenz.toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
        oldMousePosX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
