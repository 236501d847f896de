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
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin


/**
 * Blatt 4, Gruppe 7 (Szene und Shader: L., Lichter und Maus: M.)
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram

    //objects
    private val ground: Renderable
    private val bike: Renderable
    private val camera = TronCamera()

    //Lichter
    private val bikeLight: PointLight
    private val spotLight: SpotLight
    private val ecken = ArrayList<PointLight>()

    //mouse
    private var oldMouseX = 0.0
    private var firstMouse = true

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

        //ground
        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val texEmit = Texture2D("assets/textures/ground_emit.png", true)
        val texDiff = Texture2D("assets/textures/ground_diff.png", true)
        val texSpec = Texture2D("assets/textures/ground_spec.png", true)
        texEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(texDiff, texEmit, texSpec, 60f, Vector2f(64f, 64f))
        val attrPos = VertexAttribute(3, 8 * 4, 0)
        val attrTC = VertexAttribute(2, 8 * 4, 3 * 4)
        val attrNorm = VertexAttribute(3, 8 * 4, 5 * 4)
        val groundMesh = Mesh(res.vertexData, res.indexData, arrayOf(attrPos, attrTC, attrNorm), groundMaterial)
        ground = Renderable(mutableListOf(groundMesh))

        //bike
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
        bike.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        //camera
        camera.parent = bike
        camera.translateLocal(Vector3f(0f, 0.6f, 0f))
        camera.rotateLocal(Math.toRadians(-28f), 0f, 0f)
        camera.translateLocal(Vector3f(0f, 0f, 4.2f))

        //Punktlicht ueber dem Motorrad
        bikeLight = PointLight(Vector3f(0f, 2f, 0f), Vector3f(1f, 1f, 1f))
        bikeLight.parent = bike

        //Scheinwerfer vorne, leicht nach unten geneigt
        spotLight = SpotLight(Vector3f(0f, 1f, -2f), Vector3f(3f, 3f, 3f), Math.toRadians(15f), Math.toRadians(30f))
        spotLight.rotateLocal(Math.toRadians(-12f), 0f, 0f)
        spotLight.parent = bike

        //Ecken
        val positionen = listOf(Vector3f(-12f, 2f, -12f), Vector3f(12f, 2f, -12f), Vector3f(12f, 2f, 12f), Vector3f(-12f, 2f, 12f))
        val farben = listOf(Vector3f(8f, 0f, 0f), Vector3f(0f, 0f, 8f), Vector3f(6f, 6f, 0f), Vector3f(0f, 6f, 6f))
        for (i in 0..3) {
            ecken.add(PointLight(positionen[i], farben[i]))
        }
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        camera.bind(staticShader)

        //Motorrad und Licht bekommen dieselbe Farbe
        val bikeFarbe = Vector3f(abs(sin(t)), abs(sin(t * 0.7f + 1f)), abs(cos(t * 0.5f)))
        bikeLight.farbe = bikeFarbe

        bikeLight.bind(staticShader, "u_bikeLight")
        spotLight.bind(staticShader, "u_spotLight", camera.getCalculateViewMatrix())
        for (i in 0..3) {
            ecken[i].bind(staticShader, "u_ecke[$i]")
        }

        staticShader.setUniform("u_farbe", Vector3f(0f, 1f, 0f))
        ground.render(staticShader)
        staticShader.setUniform("u_farbe", bikeFarbe)
        bike.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW.GLFW_KEY_W)) {
            bike.translateLocal(Vector3f(0f, 0f, -5f * dt))
            if (window.getKeyState(GLFW.GLFW_KEY_A)) bike.rotateLocal(0f, 1.5f * dt, 0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) bike.rotateLocal(0f, -1.5f * dt, 0f)
        }
        if (window.getKeyState(GLFW.GLFW_KEY_S)) {
            bike.translateLocal(Vector3f(0f, 0f, 5f * dt))
            if (window.getKeyState(GLFW.GLFW_KEY_A)) bike.rotateLocal(0f, -1.5f * dt, 0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) bike.rotateLocal(0f, 1.5f * dt, 0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        //sonst springt die Kamera beim ersten Mal
        if (firstMouse) {
            oldMouseX = xpos
            firstMouse = false
        }
        val diffX = oldMouseX - xpos
        oldMouseX = xpos
        camera.rotateAroundPoint(0f, (diffX * 0.002).toFloat(), 0f, Vector3f(0f))
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        staticShader.cleanup()
    }
}
