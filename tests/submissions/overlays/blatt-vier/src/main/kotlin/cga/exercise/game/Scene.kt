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
import kotlin.math.sin

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram

    private val ground: Renderable
    private val cycle: Renderable

    private val camera: TronCamera

    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val eckLights = arrayListOf<PointLight>()

    private var oldMousePosX = -1.0
    private var oldMousePosY = -1.0
    private var firstMouseMove = true

    //scene setup
    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // ---------- Boden ----------
        val texEmit = Texture2D("assets/textures/ground_emit.png", true)
        val texDiff = Texture2D("assets/textures/ground_diff.png", true)
        val texSpec = Texture2D("assets/textures/ground_spec.png", true)
        texEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(texDiff, texEmit, texSpec, 60.0f, Vector2f(64.0f, 64.0f))

        val stride = 8 * 4
        val attrPos = VertexAttribute(3, stride, 0)
        val attrTC = VertexAttribute(2, stride, 3 * 4)
        val attrNorm = VertexAttribute(3, stride, 5 * 4)
        val vertexAttributes = arrayOf(attrPos, attrTC, attrNorm)

        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val groundMesh = Mesh(groundObj.vertexData, groundObj.indexData, vertexAttributes, groundMaterial)
        ground = Renderable(mutableListOf(groundMesh))

        // ---------- Motorrad ----------
        val geladen = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        if (geladen == null) {
            println("Motorrad konnte nicht geladen werden!")
            throw IllegalArgumentException("Could not load the model")
        }
        cycle = geladen
        cycle.scaleLocal(Vector3f(0.8f))

        // ---------- Kamera ----------
        camera = TronCamera()
        camera.parent = cycle
        camera.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        // ---------- Lichter ----------
        pointLight = PointLight(Vector3f(0.0f, 1.5f, 0.5f), Vector3f(1.0f, 1.0f, 1.0f))
        pointLight.parent = cycle

        spotLight = SpotLight(Vector3f(0.0f, 1.1f, -1.7f), Vector3f(2.0f, 2.0f, 1.8f), Math.toRadians(15.0f), Math.toRadians(27.0f))
        spotLight.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        spotLight.parent = cycle

        // Ecken der Plane
        eckLights.add(PointLight(Vector3f(18.0f, 2.0f, 18.0f), Vector3f(9.0f, 0.0f, 0.0f)))
        eckLights.add(PointLight(Vector3f(18.0f, 2.0f, -18.0f), Vector3f(0.0f, 2.0f, 9.0f)))
        eckLights.add(PointLight(Vector3f(-18.0f, 2.0f, -18.0f), Vector3f(8.0f, 6.0f, 0.0f)))
        eckLights.add(PointLight(Vector3f(-18.0f, 2.0f, 18.0f), Vector3f(6.0f, 0.0f, 8.0f)))
        println("Lichter: " + eckLights.size)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        staticShader.use()
        camera.bind(staticShader)

        // Farbe abhaengig von der Zeit
        val cycleFarbe = Vector3f(abs(sin(t)), abs(sin(t * 0.7f + 1.0f)), abs(sin(t * 0.4f + 2.0f)))
        pointLight.lightCol = cycleFarbe

        // erst die Lichter, dann die Objekte
        pointLight.bind(staticShader, "pointLight")
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())
        for (i in 0 until eckLights.size) {
            eckLights[i].bindArray(staticShader, "eckLight", i)
        }

        staticShader.setUniform("farbe", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)

        staticShader.setUniform("farbe", cycleFarbe)
        cycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        // Blatt 3
        if (window.getKeyState(GLFW_KEY_W)) {
            cycle.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) {
                cycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                cycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            cycle.translateLocal(Vector3f(0.0f, 0.0f, 5.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) {
                cycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                cycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        // beim ersten Mal gibt es noch keine alte Position
        if (firstMouseMove) {
            oldMousePosX = xpos
            oldMousePosY = ypos
            firstMouseMove = false
        }
        val deltaX = xpos - oldMousePosX
        //val deltaY = ypos - oldMousePosY
        oldMousePosX = xpos
        oldMousePosY = ypos

        val yaw = (deltaX * 0.002).toFloat()
        camera.rotateAroundPoint(0.0f, -yaw, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        cycle.cleanup()
        staticShader.cleanup()
    }
}
